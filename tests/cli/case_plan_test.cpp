#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

using ::testing::HasSubstr;

class CasePlanCommand : public PatientCommand {};

TEST_F(CasePlanCommand, ranks_paths_with_their_clearances_and_saves_one) {
  const std::string copy = (folder_ / "planned").string();
  std::filesystem::copy(patient(), copy, std::filesystem::copy_options::recursive);
  const Outcome said = bodkin("-q --json case plan " + copy + " --save 1");
  ASSERT_EQ(said.exit_code, 0) << said.text();
  const auto result = nlohmann::json::parse(said.output);
  ASSERT_FALSE(result.at("paths").empty());
  for (const auto& path : result.at("paths")) {
    EXPECT_GT(path.at("length_mm").get<double>(), 20.0);
    for (const auto& near : path.at("nearest"))
      EXPECT_GE(near.at("clearance_mm").get<double>(), near.at("margin_mm").get<double>() - 1e-6) << near;
  }
  EXPECT_EQ(bodkin("-q case check " + copy).exit_code, 0);
  const auto shown = nlohmann::json::parse(bodkin("-q --json profile " + copy + " -o " + copy + "/p").output);
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(shown.at("entry_mm")[axis].get<double>(), result["paths"][0]["entry_mm"][axis].get<double>(), 1e-4);
  const Outcome table = bodkin("-q case plan " + copy);
  EXPECT_THAT(table.output, HasSubstr("nearest"));
  EXPECT_THAT(table.output, HasSubstr("bone"));
}

TEST_F(CasePlanCommand, says_why_there_is_no_path) {
  const Outcome inside = bodkin("-q case plan " + patient() + " --target vertebrae_L3 --procedure ct_guided_biopsy");
  EXPECT_EQ(inside.exit_code, 3) << inside.text();
  EXPECT_THAT(inside.output, HasSubstr("bone"));
  const Outcome unknown = bodkin("-q case plan " + patient() + " --target spleen");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.errors, HasSubstr("'spleen'"));
  EXPECT_THAT(unknown.errors, HasSubstr("vertebrae_L3"));
}

TEST_F(CasePlanCommand, refuses_a_puncture_of_the_spine_above_its_levels) {
  const Outcome shown = bodkin("-q --json case show " + patient());
  ASSERT_EQ(shown.exit_code, 0) << shown.text();
  const auto landmarks = nlohmann::json::parse(shown.output).at("landmarks");
  if (!landmarks.contains("L1_L2")) GTEST_SKIP() << "the patient of these tests has no interspace L1/L2";
  const auto at = landmarks.at("L1_L2");
  const std::string point = std::to_string(at[0].get<double>()) + "," + std::to_string(at[1].get<double>()) + "," +
                            std::to_string(at[2].get<double>());
  const Outcome said = bodkin("-q case plan " + patient() + " --target " + point);
  EXPECT_EQ(said.exit_code, 3);
  EXPECT_THAT(said.output, HasSubstr("L1/L2"));
}

}  // namespace
}  // namespace bodkin_test
