#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

using ::testing::HasSubstr;

class PlanCommand : public BodkinCommand {};

TEST_F(PlanCommand, shows_stages_criteria_and_aids) {
  const Outcome said = bodkin("-q plan show lumbar_puncture_first_steps");
  EXPECT_EQ(said.exit_code, 0) << said.text();
  EXPECT_THAT(said.output, HasSubstr("3. By feel and by the skin"));
  EXPECT_THAT(said.output, HasSubstr("until     2 passed in a row, or 10 attempts"));
  EXPECT_THAT(said.output, HasSubstr("aids      needle, sound\n"));
  const auto json = nlohmann::json::parse(bodkin("-q --json plan show lumbar_puncture_first_steps").output);
  EXPECT_EQ(json.at("stages")[1].at("aids").at("overlay"), false);
}

TEST_F(PlanCommand, checks_that_every_name_exists) {
  EXPECT_EQ(bodkin("-q plan check lumbar_puncture_mastery").exit_code, 0);
  write("plan.xml", "<plan version=\"1\" name=\"p\" title=\"P\"><stage title=\"a\" case=\"nowhere\"/></plan>");
  const Outcome said = bodkin("-q plan check plan.xml");
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_THAT(said.errors, HasSubstr("plan.xml: stage 'a': the case 'nowhere' is not a folder with a case.xml"));
  const Outcome shown = bodkin("-q plan show plan.xml");
  EXPECT_EQ(shown.exit_code, 2);
  EXPECT_EQ(shown.errors, said.errors) << "every command that uses a plan looks for the same names";
  EXPECT_THAT(bodkin("-q plan show nothing").errors, HasSubstr("there is no plan 'nothing', expected one of lumbar"));
}

TEST_F(PlanCommand, shows_how_far_a_trainee_is) {
  const Outcome said = bodkin("-q plan show lumbar_puncture_first_steps --trainee trainee-07 --store results.sqlite");
  EXPECT_THAT(said.output, HasSubstr("trainee-07: stage 1 of 3, 0 of 2 passed in a row, attempt 1 of 10"));
}

TEST_F(PlanCommand, says_errors_as_json_too) {
  const Outcome said = bodkin("-q --json plan show nothing");
  EXPECT_EQ(said.exit_code, 2);
  const auto json = nlohmann::json::parse(said.output);
  EXPECT_EQ(json.at("error").at("exit_code"), 2);
  EXPECT_THAT(json.at("error").at("sentence").get<std::string>(), HasSubstr("there is no plan 'nothing'"));
}

}  // namespace
}  // namespace bodkin_test
