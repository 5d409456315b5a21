#ifdef BODKIN_HAS_WARP
// bodkin case warp, on two synthetic patients of different build.
#include <fstream>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

using ::testing::HasSubstr;

class CaseWarpCommand : public PatientCommand {};

TEST_F(CaseWarpCommand, lays_a_patient_into_a_heavier_one_and_keeps_the_depth_of_the_path) {
  ASSERT_EQ(bodkin("-q case synthesize lumbar heavy --weight 110 --seed 5 --spacing 2").exit_code, 0);
  const Outcome outcome = bodkin("-q --json case warp " + patient() + " heavy warped");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text();
  const auto found = nlohmann::json::parse(outcome.output);
  EXPECT_GT(found.at("moved").at("rms_mm").get<double>(), 0.8);
  EXPECT_LT(found.at("bent").at("rms_mm").get<double>(), 0.4);
  EXPECT_EQ(bodkin("-q case check warped").exit_code, 0);
  const auto length = [](const std::string& folder) {
    const auto profile =
        nlohmann::json::parse(bodkin("-q --json profile " + folder + " -o " + folder + "_profile").output);
    double squares = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double side = profile.at("entry_mm")[axis].get<double>() - profile.at("target_mm")[axis].get<double>();
      squares += side * side;
    }
    return std::sqrt(squares);
  };
  EXPECT_NEAR(length("warped"), length(patient()), 1.5);
}

// The same patient, 5 mm aside: iterative closest points bring him back, and `bodkin register` can follow the file.
TEST_F(CaseWarpCommand, writes_where_the_patient_lies_before_he_is_bent) {
  std::ofstream(folder_ / "aside.json") << R"({"fixed_from_moving":[1,0,0,4,0,1,0,-3,0,0,1,0,0,0,0,1]})";
  const Outcome made = bodkin("-q --json case warp " + patient() + " " + patient() +
                              " laid --registration aside.json --placed moved.json");
  ASSERT_EQ(made.exit_code, 0) << made.text();
  const nlohmann::json placed = nlohmann::json::parse(text_of("moved.json"));
  EXPECT_EQ(placed["scale"], 1.0);
  EXPECT_NEAR(placed["fixed_from_moving"][3].get<double>(), 0.0, 1.0);
  EXPECT_NEAR(placed["fixed_from_moving"][7].get<double>(), 0.0, 1.0);
  // Input files are never overwritten.
  const Outcome refused =
      bodkin("-q case warp " + patient() + " " + patient() + " never --registration aside.json --placed aside.json");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "never"));
#ifdef BODKIN_HAS_TRACKING
  write("here.csv", "0,0,0\n90,0,0\n0,70,0\n0,0,60\n");
  const Outcome followed = bodkin("--json register here.csv here.csv --first moved.json");
  ASSERT_EQ(followed.exit_code, 0) << followed.text();
  EXPECT_NEAR(nlohmann::json::parse(followed.output)["fixed_from_moving"][3].get<double>(),
              placed["fixed_from_moving"][3].get<double>(), 1e-6);
#endif
}

TEST_F(CaseWarpCommand, refuses_a_registration_that_is_none_and_leaves_nothing_behind) {
  std::ofstream(folder_ / "scaled.json") << R"({"fixed_from_moving":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],"scale":1.2})";
  for (const auto& [options, words] : {std::pair{"--registration none.json", "none.json"},
                                       {"--registration scaled.json", "register without --scale"},
                                       {"--reach 10", "30"}}) {
    const Outcome refused = bodkin("-q case warp " + patient() + " " + patient() + " never " + options);
    EXPECT_EQ(refused.exit_code, 2) << options;
    EXPECT_THAT(refused.errors, HasSubstr(words)) << options;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "never")) << options;
  }
}

}  // namespace
}  // namespace bodkin_test
#endif
