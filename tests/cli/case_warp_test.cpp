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
