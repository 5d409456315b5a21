#include "session/session_file.h"
#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/case_folder.h"

namespace bodkin_test {
namespace {

using ::testing::HasSubstr;

class CaseBreatheCommand : public PatientCommand {};

TEST_F(CaseBreatheCommand, lets_a_patient_breathe_who_performs_replays_and_is_judged_as_before) {
  const std::string copy = (folder_ / "breathes").string();
  std::filesystem::copy(patient(), copy, std::filesystem::copy_options::recursive);
  const Outcome said = bodkin("-q --json case breathe " + copy + " --motion 0,-2,-8 --radius 60 --longest-hold 2");
  ASSERT_EQ(said.exit_code, 0) << said.text();
  const auto result = nlohmann::json::parse(said.output);
  EXPECT_NEAR(result.at("target_mm").get<double>(), std::sqrt(68.0), 1e-9);
  const auto path = bodkin::io::read_case_description(copy).procedure.path;
  const double far = path->length() / 60.0;
  const double entry = far < 1.0 ? std::sqrt(68.0) * std::pow(1.0 - far * far, 2) : 0.0;
  EXPECT_NEAR(result.at("entry_mm").get<double>(), entry, 1e-6);
  EXPECT_EQ(bodkin("-q case check " + copy).exit_code, 0);

  // Curves of tissue at rest are those of a patient who does not breathe.
  const std::string at_rest = bodkin("-q --json profile " + patient() + " -o " + copy + "/a").output;
  const std::string breathes = bodkin("-q --json profile " + copy + " -o " + copy + "/b").output;
  EXPECT_EQ(nlohmann::json::parse(at_rest).at("events"), nlohmann::json::parse(breathes).at("events"));

  // A simulated hand asks the patient to hold the breath for 2 s: its session replays to the bit.
  const std::string session = copy + "/s.bodkin";
  const Outcome ran = bodkin("-q run " + copy + " --operator expert --seed 3 -o " + session);
  ASSERT_EQ(ran.exit_code, 0) << ran.text();
  EXPECT_EQ(bodkin("-q replay " + session).exit_code, 0);
  const Outcome judged = bodkin("-q --json score " + session);
  EXPECT_EQ(judged.exit_code, 0) << judged.text();

  const Outcome off = bodkin("-q case breathe " + copy + " --off");
  EXPECT_EQ(off.exit_code, 0) << off.text();
  EXPECT_EQ(content_of(std::filesystem::path(copy) / "case.xml"),
            content_of(std::filesystem::path(patient()) / "case.xml"));
}

TEST_F(CaseBreatheCommand, refuses_what_cannot_be_and_leaves_the_case) {
  const std::string before = content_of(std::filesystem::path(patient()) / "case.xml");
  const Outcome folds = bodkin("-q case breathe " + patient() + " --motion 0,0,-30");
  EXPECT_EQ(folds.exit_code, 2);
  EXPECT_THAT(folds.errors, HasSubstr("longer than a third of radius_mm"));
  const Outcome unknown = bodkin("-q case breathe " + patient() + " --centre spleen");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.errors, HasSubstr("'spleen'"));
  EXPECT_THAT(unknown.errors, HasSubstr("vertebrae_L3"));
  const Outcome far = bodkin("-q case breathe " + patient() + " --motion 0,0,-100 --radius 500");
  EXPECT_EQ(far.exit_code, 2);
  EXPECT_THAT(far.errors, HasSubstr("feet_head_mm"));
  EXPECT_EQ(content_of(std::filesystem::path(patient()) / "case.xml"), before);
}

}  // namespace
}  // namespace bodkin_test
