// The window of the mouse on a display that nobody sees (Xvfb), driven as a person would (xdotool).
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "session/session_file.h"
#include "tests/cli/bodkin_command.h"
#include "tests/cli/mesher_rig.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

// Opens a display and the window in the background, does what `person` says, and waits for the end of the program.
std::string script(const std::string& person, const std::string& options, const std::string& display,
                   const std::string& device) {
  return R"(set -u
)" + ("Xvfb -displayfd 3 -screen 0 " + display) +
         R"( -nolisten tcp 3> display > xvfb.log 2>&1 &
xvfb=$!
trap 'kill $xvfb' EXIT
for wait in $(seq 100); do [ -s display ] && break; sleep 0.1; done
export DISPLAY=:$(cat display)
export ASAN_OPTIONS=${ASAN_OPTIONS:-}:detect_leaks=0  # of libraries that SDL loads, some gone again at the end
')" BODKIN_BUILD R"(/bin/bodkin' --json -q perform patient )" +
         device + " " + options + R"( --max-time 90 -o mouse.bodkin > said 2> errors &
window=$(timeout 60 xdotool search --sync --name '^Bodkin: ' | head -n 1)
sleep 2.5
)" + person +
         R"(
wait %2
echo $? > code
)";
}

class MouseWindow : public PatientCommand {
 protected:
  void SetUp() override {
    PatientCommand::SetUp();
    if (std::system("command -v Xvfb > /dev/null && command -v xdotool > /dev/null") != 0) {
      GTEST_SKIP() << "Xvfb or xdotool is not installed";
    }
    for (const char* left : {"mouse.bodkin", "display", "said", "errors", "code", "seen.png"}) {
      std::filesystem::remove(folder_ / left);
    }
  }
  static ::bodkin::session::Session session_of(const std::string& person, const std::string& options = "",
                                               const std::string& display = "1280x800x24",
                                               const std::string& device = "mouse") {
    write("person.sh", script(person, options, display, device));
    const std::string command = "cd '" + folder_.string() + "' && bash person.sh > log 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << text_of("log");
    EXPECT_EQ(text_of("code"), "0\n") << text_of("errors") << text_of("log");
    return ::bodkin::session::read_session(folder_ / "mouse.bodkin");
  }
  // mm from the planned entry, in the operator's axes: right, away, up.
  static ::bodkin::Vec3 from_entry(const ::bodkin::session::Session& session, std::size_t tick) {
    const ::bodkin::Vec3 tip = session.ticks.at(tick).input.needle.translation() - session.header.path.entry;
    return {-tip.x(), tip.z(), tip.y()};
  }
};

TEST_F(MouseWindow, the_wheel_pushes_the_needle_in_and_space_holds_it) {
  const ::bodkin::session::Session session = session_of(R"(
xdotool click --repeat 42 --delay 40 4
sleep 1
import -window root seen.png
identify -format '%k' seen.png > colours
xdotool key space
sleep 0.5
xdotool click --repeat 10 --delay 40 4
sleep 0.7
xdotool key Escape)");
  EXPECT_TRUE(session.finished);
  EXPECT_NEAR((from_entry(session, 0) - ::bodkin::Vec3(0, 0, 30)).norm(), 0.0, 1e-6);
  const std::size_t last = session.ticks.size() - 1;
  EXPECT_NEAR((from_entry(session, last) - ::bodkin::Vec3(0, 0, -12)).norm(), 0.0, 0.01)
      << from_entry(session, last).transpose();
  EXPECT_NEAR(session.ticks[last].output.depth, 12.0, 1.5);
  double peak = 0.0;
  bool punctured = false;
  for (const auto& tick : session.ticks) peak = std::max(peak, tick.output.requested.force.norm());
  for (const auto& event : session.events)
    punctured = punctured || event.event.kind == ::bodkin::forces::EventKind::puncture;
  EXPECT_GT(peak, 0.5);
  EXPECT_TRUE(punctured);
  // What comes in steps of 1 mm moves smoothly, even where a tick was late.
  for (std::size_t i = 1; i <= last; ++i) {
    ASSERT_LT((from_entry(session, i) - from_entry(session, i - 1)).norm(), 0.7) << i;
  }
  if (std::filesystem::exists(folder_ / "seen.png")) {
    EXPECT_GT(std::atoi(text_of("colours").c_str()), 50) << "the window shows nothing";
  }
}

TEST_F(MouseWindow, pointer_and_keys_move_sideways_and_tilt) {
  const ::bodkin::session::Session session = session_of(R"(
xdotool mousemove --window $window 480 300
sleep 0.3
xdotool mousemove_relative 100 0
sleep 0.3
xdotool keydown w; sleep 1; xdotool keyup w
sleep 0.3
xdotool keydown q; sleep 0.5; xdotool keyup q
sleep 0.5
xdotool key Escape)");
  const std::size_t last = session.ticks.size() - 1;
  const ::bodkin::Vec3 end = from_entry(session, last);
  EXPECT_NEAR(end.x(), 10.0, 0.2) << end.transpose();  // 0.1 mm a pixel
  EXPECT_LT(end.z(), 25.0);                            // some 10 mm of the key
  EXPECT_GT(end.z(), 5.0);
  const ::bodkin::Vec3 axis = ::bodkin::needle_axis(session.ticks[last].input.needle);
  EXPECT_GT(std::asin(axis.z()), 0.03) << "towards the head: " << axis.transpose();
  EXPECT_LT(axis.y(), -0.9);
}

TEST_F(MouseWindow, without_a_display_is_one_sentence) {
  for (const std::string display : {"", ":4711"}) {
    const std::string errors = (folder_ / "refusal").string();
    const std::string command = "cd '" + folder_.string() + "' && DISPLAY=" + display +
                                " WAYLAND_DISPLAY= ASAN_OPTIONS=detect_leaks=0 '" BODKIN_BUILD
                                "/bin/bodkin' -q perform patient mouse 2> " +
                                errors;
    const int status = std::system(command.c_str());
    EXPECT_EQ(WEXITSTATUS(status), 2);
    EXPECT_EQ(lines_of(content_of(errors)), 1) << content_of(errors);
    EXPECT_THAT(content_of(errors), HasSubstr("display"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "session-by-hand.bodkin"));
  }
}

TEST_F(MouseWindow, a_deformable_body_is_seen_and_felt_while_the_needle_goes_in) {
  BODKIN_NEEDS_MESHER();
  ASSERT_EQ(bodkin("-q case mesh patient --nodes 2000").exit_code, 0);
  const ::bodkin::session::Session session =
      session_of(R"(
import -window root seen.png
convert seen.png -crop 324x280+492+392 +repage before.png
xdotool click --repeat 45 --delay 40 4
sleep 1
import -window root seen.png
convert seen.png -crop 324x280+492+392 +repage after.png
compare -metric AE before.png after.png moved.png 2> difference
identify -format '%k' before.png > colours
xdotool key Escape)",
                 "--resistance 'embedded_needle capture_radius_mm=6' --constraint none");
  EXPECT_TRUE(session.finished);
  EXPECT_GT(std::stoi(text_of("colours")), 10);        // the tissues' borders are there
  EXPECT_GT(std::stod(text_of("difference")), 100.0);  // needle and skin have moved
  double peak = 0.0;
  for (const ::bodkin::simulation::TickRecord& tick : session.ticks) peak = std::max(peak, tick.output.resistance);
  EXPECT_GT(peak, 0.5);
  EXPECT_EQ(bodkin("-q replay mouse.bodkin").exit_code, 0);
}

// The pane of the ultrasound begins 948 pixels to the right; the window is 1508 wide in the middle of the screen.
TEST_F(MouseWindow, ultrasound_shows_needle_and_tissue_while_the_needle_goes_in) {
  BODKIN_NEEDS_MESHER();
  ASSERT_EQ(bodkin("-q case mesh patient --nodes 2000").exit_code, 0);
  const ::bodkin::session::Session session =
      session_of(R"(
sleep 3
import -window $window seen.png
convert seen.png -crop 420x400+1060+50 +repage before.png
xdotool click --repeat 38 --delay 40 4
sleep 1.5
import -window $window seen.png
convert seen.png -crop 420x400+1060+50 +repage after.png
compare -metric AE -fuzz 5% before.png after.png moved.png 2> difference
identify -format '%k' before.png > colours
xdotool key 4 4 4 4 4
sleep 1
import -window $window seen.png
convert seen.png -crop 420x300+1060+50 +repage sliders.png
convert after.png -crop 420x300+0+0 +repage top.png
compare -metric AE -fuzz 5% top.png sliders.png moved.png 2> brighter
xdotool key Escape)",
                 "--resistance 'embedded_needle capture_radius_mm=6' --constraint none "
                 "--ultrasound 'C5-2 view=transverse depth_mm=60'",
                 "1600x900x24");
  EXPECT_TRUE(session.finished);
  EXPECT_GT(std::stoi(text_of("colours")), 100);  // of grey
  EXPECT_GT(std::stod(text_of("difference")), 500.0) << "needle and tissue have not moved";
  EXPECT_GT(std::stod(text_of("brighter")), 300.0) << "a slider did nothing";
  // Two cores that others use, too, make 40 to 60 a second.
  const double seconds = static_cast<double>(session.ticks.size()) / 1000.0;
  EXPECT_GT(json::parse(text_of("said")).at("ultrasound_pictures").get<double>(), 8.0 * seconds);
  // What is seen changes nothing that is felt.
  EXPECT_EQ(bodkin("-q replay mouse.bodkin").exit_code, 0);
}

TEST_F(MouseWindow, ultrasound_beside_a_device_and_in_the_second_hand) {
  const ::bodkin::session::Session session =
      session_of("", "--ultrasound L14-5", "1600x900x24",
                 "simulated --settings 'depth_mm=5 wait_s=1' --second simulated "
                 "--second-as probe --second-settings 'depth_mm=3 wait_s=30'");
  EXPECT_TRUE(session.finished);
  EXPECT_GT(json::parse(text_of("said")).at("ultrasound_pictures").get<int>(), 10);
}

TEST_F(MouseWindow, words_that_say_no_ultrasound_are_one_sentence) {
  const std::vector<std::pair<std::string, std::string>> refused = {
      {"C9-9", "--ultrasound: "},
      {"C5-2 L14-5", "'L14-5' after the probe C5-2, expected SETTING=VALUE"},
      {"depth=5", "there is no setting 'depth', expected view, at, from, press_mm, depth_mm"},
      {"depth_mm=deep", "depth_mm is 'deep', expected a number of mm"},
      {"depth_mm=", "depth_mm is '', expected a number of mm"},
      {"gain_dB=50", "gain_dB is '50', expected -40 to 40"},
      {"gain_dB=nan", "gain_dB is 'nan', expected a number of dB"},
      {"C5-2 view=upside", "--view is 'upside'; expected "},
      {"C5-2 frequency_MHz=29", "--ultrasound: "}};
  for (const auto& [words, sentence] : refused) {
    const Outcome outcome = bodkin("-q perform patient simulated --ultrasound '" + words + "' -o refused.bodkin");
    EXPECT_EQ(outcome.exit_code, 2) << words << '\n' << outcome.text();
    EXPECT_THAT(outcome.errors, HasSubstr(sentence));
    EXPECT_EQ(lines_of(outcome.errors), 1) << outcome.errors;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "refused.bodkin"));
  }
}

}  // namespace
}  // namespace bodkin_test
