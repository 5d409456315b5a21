#include <cstdlib>
#include <filesystem>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

// `bodkin experts` as a user runs it, in a data folder of its own.

namespace bodkin_test {
namespace {

using ::testing::HasSubstr;

class ExpertsCommand : public PatientCommand {
 protected:
  static void SetUpTestSuite() {
    PatientCommand::SetUpTestSuite();
    setenv("XDG_DATA_HOME", (folder_ / "data").c_str(), 1);
    if (made_.exit_code != 0) return;
    for (int seed = 1; seed <= 5; ++seed) {
      const std::string file = (folder_ / ("expert_" + std::to_string(seed) + ".bodkin")).string();
      bodkin("-q run " + patient() + " --operator expert --seed " + std::to_string(seed) + " --output " + file);
    }
  }
  static void TearDownTestSuite() {
    unsetenv("XDG_DATA_HOME");
    PatientCommand::TearDownTestSuite();
  }
};

TEST_F(ExpertsCommand, imported_sessions_are_what_score_and_report_compare_with_until_they_are_deleted) {
  const auto compared_with = [] {
    return nlohmann::json::parse(bodkin("--json score expert_1.bodkin").output).dump();
  };
  const std::string with_simulated = compared_with();
  const Outcome imported =
      bodkin("-q experts import expert_1.bodkin expert_2.bodkin expert_3.bodkin expert_4.bodkin expert_5.bodkin");
  ASSERT_EQ(imported.exit_code, 0) << imported.text();
  EXPECT_THAT(imported.output, HasSubstr("lumbar_puncture: 5 added, 0 known before, 5 in "));
  EXPECT_NE(compared_with(), with_simulated);
  EXPECT_THAT(bodkin("experts list").output, HasSubstr("imported: "));
  ASSERT_EQ(bodkin("-q report expert_1.bodkin -o report.html").exit_code, 0);
  EXPECT_THAT(text_of("report.html"), HasSubstr("5 attempts of experts"));
  EXPECT_THAT(bodkin("-q experts import expert_5.bodkin").output, HasSubstr("0 added, 1 known before, 5 in "));
  EXPECT_EQ(bodkin("-q experts delete lumbar_puncture").exit_code, 0);
  EXPECT_EQ(compared_with(), with_simulated);
  const Outcome again = bodkin("-q experts delete lumbar_puncture");
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_THAT(again.errors, HasSubstr("no experts were imported for lumbar_puncture"));
}

TEST_F(ExpertsCommand, an_attempt_that_failed_is_no_expert) {
  bodkin("-q run patient --operator expert --max-time 3 --output short.bodkin");
  const Outcome outcome = bodkin("experts import short.bodkin");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("left out"));
  EXPECT_THAT(outcome.errors, HasSubstr("there is no attempt to import"));
}

}  // namespace
}  // namespace bodkin_test
