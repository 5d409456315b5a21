#include <cstdlib>

#include "tests/cli/results_rig.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

class ResultsCommand : public ResultsRig {};

TEST_F(ResultsCommand, keeps_a_session_once_and_lists_it) {
  const Outcome first = bodkin("-q results add session.bodkin --trainee trainee-07");
  EXPECT_EQ(first.exit_code, 0) << first.text();
  EXPECT_THAT(first.output, HasSubstr("stored"));
  fs::copy(folder_ / "session.bodkin", folder_ / "copy.bodkin");
  EXPECT_THAT(bodkin("-q results add copy.bodkin --trainee trainee-07").output, HasSubstr("known before"));
  const auto list = nlohmann::json::parse(bodkin("-q --json results list").output);
  ASSERT_EQ(list.at("rows").size(), 1U);
  EXPECT_EQ(list.at("rows")[0].at("trainee"), "trainee-07");
  EXPECT_EQ(list.at("rows")[0].at("procedure"), "lumbar_puncture");
  EXPECT_EQ(list.at("rows")[0].at("passed"), 1);
  EXPECT_EQ(list.at("store"), (folder_ / "data/bodkin/results.sqlite").string());
}

TEST_F(ResultsCommand, shows_a_trainee_and_draws_the_learning_curve) {
  bodkin("-q results add session.bodkin --trainee trainee-07");
  const Outcome said = bodkin("-q results show trainee-07 -o curve.svg");
  EXPECT_EQ(said.exit_code, 0) << said.text();
  EXPECT_THAT(said.output, HasSubstr("Passed: the tip came to rest"));
  EXPECT_THAT(text_of("curve.svg"), HasSubstr("trainee-07: lumbar_puncture"));
  const Outcome nobody = bodkin("-q results show anna");
  EXPECT_EQ(nobody.exit_code, 2);
  EXPECT_THAT(nobody.errors, HasSubstr("has no trainee 'anna'; 'bodkin results list' names them"));
}

TEST_F(ResultsCommand, puts_an_attempt_into_the_stage_of_a_plan) {
  bodkin("-q results add session.bodkin --trainee trainee-07 --plan lumbar_puncture_first_steps");
  EXPECT_THAT(bodkin("-q plan show lumbar_puncture_first_steps --trainee trainee-07").output,
              HasSubstr("trainee-07: stage 1 of 3, 1 of 2 passed in a row, attempt 2 of 10"));
}

TEST_F(ResultsCommand, keeps_nothing_for_a_plan_that_names_what_does_not_exist) {
  const auto stage_with = [](const std::string& what) {
    return "<plan version=\"1\" name=\"p\" title=\"P\"><stage title=\"a\" " + what + "/></plan>";
  };
  for (const auto& [stage, said] : std::initializer_list<std::pair<std::string, std::string>>{
           {"case=\"nowhere\"", "the case 'nowhere' is not a folder with a case.xml"},
           {"case=\"built-in\" procedure=\"dance\"", "there is no procedure 'dance'"},
           {"case=\"built-in\" crystal_ball=\"true\"", "crystal_ball"}}) {
    write("plan.xml", stage_with(stage));
    const Outcome refused = bodkin("-q results add session.bodkin --trainee trainee-07 --plan plan.xml");
    EXPECT_EQ(refused.exit_code, 2) << stage;
    EXPECT_THAT(refused.errors, HasSubstr(said)) << stage;
    EXPECT_EQ(lines_of(refused.errors), 1) << stage;
    EXPECT_EQ(bodkin("-q plan check plan.xml").errors, refused.errors) << stage;
    EXPECT_EQ(bodkin("-q plan show plan.xml").errors, refused.errors) << stage;
    EXPECT_FALSE(fs::exists(folder_ / "data/bodkin/results.sqlite")) << stage;
  }
}

TEST_F(ResultsCommand, deletes_a_session_that_the_store_owns) {
  fs::copy(folder_ / "session.bodkin", folder_ / "owned.bodkin");
  bodkin("-q results add owned.bodkin --trainee trainee-07 --own");
  EXPECT_THAT(bodkin("-q results delete trainee-07").output, HasSubstr("attempts 1, session files 1"));
  EXPECT_FALSE(fs::exists(folder_ / "owned.bodkin"));
}

TEST_F(ResultsCommand, writes_a_table_for_statistics) {
  bodkin("-q results add session.bodkin --trainee trainee-07");
  EXPECT_EQ(bodkin("-q results csv -o table.csv").exit_code, 0);
  const std::string table = text_of("table.csv");
  EXPECT_EQ(lines_of(table), 2);
  EXPECT_THAT(table, HasSubstr("trainee,procedure,plan,stage,started_at,station"));
  EXPECT_THAT(table, HasSubstr("\r\ntrainee-07,lumbar_puncture,,,20"));
}

TEST_F(ResultsCommand, deletes_everything_of_a_trainee_but_files_that_are_not_the_stores) {
  bodkin("-q results add session.bodkin --trainee trainee-07");
  const Outcome said = bodkin("-q results delete trainee-07");
  EXPECT_EQ(said.exit_code, 0) << said.text();
  EXPECT_THAT(said.output, HasSubstr("deleted of trainee-07: attempts 1, session files 0"));
  EXPECT_TRUE(fs::exists(folder_ / "session.bodkin"));
  EXPECT_THAT(bodkin("-q results list").output, Not(HasSubstr("trainee-07")));
  EXPECT_EQ(bodkin("-q results delete trainee-07").exit_code, 2);
}

TEST_F(ResultsCommand, keeps_an_attempt_here_while_the_store_cannot_be_reached_and_delivers_it_once) {
  const std::string nowhere = " --store postgresql://station@127.0.0.1:1/none";
  const Outcome waits = bodkin("results add session.bodkin --trainee trainee-07" + nowhere);
  EXPECT_EQ(waits.exit_code, 0) << waits.text();
  EXPECT_THAT(waits.output, HasSubstr("waits for the store"));
  EXPECT_EQ(bodkin("-q results deliver" + nowhere).exit_code, 1);
  // It waits for that store, not for this one.
  const Outcome here = bodkin("results deliver");
  EXPECT_THAT(here.output, HasSubstr("attempts delivered: 0"));
  EXPECT_THAT(here.errors, HasSubstr("attempts of this station that wait for another store, "
                                     "postgresql://station@127.0.0.1:1/none: 1;"));
  EXPECT_THAT(bodkin("-q results list").output, Not(HasSubstr("trainee-07")));
  const Outcome mistaken = bodkin("-q results deliver --from postgresql://station@127.0.0.1:2/none");
  EXPECT_EQ(mistaken.exit_code, 2);
  EXPECT_THAT(mistaken.errors, HasSubstr("nothing on this station waits for the store"));
  // That store has moved here.
  const std::string moved = " --from postgres://station:secret@127.0.0.1:1/none";
  EXPECT_THAT(bodkin("-q results deliver" + moved).output, HasSubstr("attempts delivered: 1"));
  EXPECT_EQ(bodkin("-q results deliver" + moved).exit_code, 2);
  EXPECT_THAT(bodkin("-q results list").output, HasSubstr("trainee-07"));
}

TEST_F(ResultsCommand, refuses_an_address_as_a_label_and_what_is_no_store_before_anything_is_kept) {
  const Outcome address = bodkin("-q results add session.bodkin --trainee anna@example.org");
  EXPECT_EQ(address.exit_code, 2);
  EXPECT_THAT(address.errors, HasSubstr("--trainee is 'anna@example.org', expected a label"));
  const Outcome wrong = bodkin("-q results add session.bodkin patient/case.xml --trainee trainee-07");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_FALSE(fs::exists(folder_ / "data/bodkin/results.sqlite"));
  const Outcome other = bodkin("-q results list --store session.bodkin");
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.errors, HasSubstr("is a database, but not of results"));
}

}  // namespace
}  // namespace bodkin_test
