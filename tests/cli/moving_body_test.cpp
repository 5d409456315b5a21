// A probe in the second hand presses the body while the first one inserts the needle, as run by a user.
#include <algorithm>
#include <utility>
#include <vector>

#include "session/session_file.h"
#include "tests/cli/bodkin_command.h"
#include "tests/cli/mesher_rig.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

using ::testing::HasSubstr;
using MovingBodyCommand = PatientCommand;

TEST_F(MovingBodyCommand, words_that_say_no_moving_body_are_one_sentence) {
  const std::string two = "simulated --second simulated --second-as probe --resistance embedded_needle ";
  const std::vector<std::pair<std::string, std::string>> refused = {
      {"simulated --body jelly", "--body is 'jelly'; expected static, or moving"},
      {"simulated --body 'static width_mm=3'", "expected static, or moving"},
      {"simulated --left 1,2,3", "--left is '1,2,3', expected entry and tip of a needle as x,y,z:x,y,z in mm"},
      {"simulated --left 1,2,3:4,5", "--left"},
      {"simulated --left 1,2,3:1,2,3.5", "needle 1 that was left in the body is 0.5 mm long"},
      {"simulated --body moving", "but no second device holds one; add --second DEVICE --second-as probe"},
      {"simulated --second simulated --body moving", "but no second device holds one"},
      {"simulated --second simulated --second-as probe --body moving", "add --resistance embedded_needle"},
      {two + "--body 'moving width=3'", "there is no setting 'width', expected width_mm, thickness_mm or radius_mm"},
      {two + "--body 'moving width_mm'", "width_mm is '', expected a number of mm"},
      {two + "--body 'moving width_mm=wide'", "width_mm is 'wide', expected a number of mm"},
      {two + "--body moving", "make one with: bodkin case mesh"}};
  for (const auto& [words, sentence] : refused) {
    const Outcome outcome = bodkin("-q perform patient " + words + " -o refused.bodkin");
    EXPECT_EQ(outcome.exit_code, 2) << words << '\n' << outcome.text();
    EXPECT_THAT(outcome.errors, HasSubstr(sentence));
    EXPECT_EQ(lines_of(outcome.errors), 1) << outcome.errors;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "refused.bodkin"));
  }
}

// The probe is down at 3 s, 25 mm beside the needle, which reaches the skin at 6.5 s.
TEST_F(MovingBodyCommand, a_probe_presses_the_body_and_moves_the_tissue_at_the_needle) {
  BODKIN_NEEDS_MESHER();
  ASSERT_EQ(bodkin("-q case mesh patient --nodes 1500 --merge-layers").exit_code, 0);
  const std::string two =
      "--resistance 'embedded_needle stiffness_scale=1' --constraint none "
      "--second simulated --second-as probe --second-settings 'speed_mm_s=40 depth_mm=15 lateral_mm=35 wait_s=30' ";
  const Outcome thin = bodkin("-q perform patient simulated --body 'moving width_mm=0.5' " + two + "-o thin.bodkin");
  EXPECT_EQ(thin.exit_code, 2) << thin.text();
  EXPECT_THAT(thin.errors, HasSubstr("face of the probe: width is 0.5 mm, expected 1 to 200 mm"));

  const Outcome outcome = bodkin(
      "--json perform patient simulated --settings 'speed_mm_s=15 start_mm=75 depth_mm=15 wait_s=0' "
      "--body 'moving width_mm=50 thickness_mm=40' " +
      two + "-o pressed.bodkin");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text();
  EXPECT_THAT(outcome.errors, HasSubstr("the body moved "));
  const ::bodkin::session::Session session = ::bodkin::session::read_session(folder_ / "pressed.bodkin");
  EXPECT_TRUE(session.finished);
  EXPECT_EQ(nlohmann::json::parse(session.header.moving_body).at("width_mm"), 50.0);
  EXPECT_TRUE(std::any_of(session.events.begin(), session.events.end(),
                          [](const ::bodkin::session::SessionEvent& event) {
                            return event.event.kind == ::bodkin::forces::EventKind::moving_body_met;
                          }))
      << outcome.text();
  double pressed = 0.0;
  for (const ::bodkin::session::SecondSample& sample : session.second) pressed = std::max(pressed, sample.force);
  EXPECT_GT(pressed, 0.5);

  const Outcome replay = bodkin("-q replay pressed.bodkin");
  EXPECT_EQ(replay.exit_code, 0) << replay.text();
  EXPECT_THAT(replay.output, HasSubstr("identical: "));
  EXPECT_FALSE(session.applied_body_steps.empty());
  EXPECT_EQ(bodkin("-q export pressed.bodkin --csv ticks.csv --second probe.csv").exit_code, 0);
  ASSERT_EQ(bodkin("-q report pressed.bodkin -o pressed.html").exit_code, 0);
  EXPECT_THAT(text_of("pressed.html"), HasSubstr("moving body"));
  EXPECT_THAT(text_of("pressed.html"), HasSubstr("the needle is in tissue that the probe has moved"));

  // If the needle enters no pressed tissue, its ticks are those of the static body.
  const Outcome beside = bodkin(
      "-q perform patient simulated --settings 'speed_mm_s=200 depth_mm=5 wait_s=0' --body 'moving width_mm=50' " +
      two + "-o beside.bodkin");
  ASSERT_EQ(beside.exit_code, 0) << beside.text();
  EXPECT_THAT(bodkin("-q replay beside.bodkin").output, HasSubstr("identical: "));
}

}  // namespace
}  // namespace bodkin_test
