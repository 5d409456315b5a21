#include "tests/cli/bodkin_command.h"
#include "tests/session/session_samples.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class ScoreCommand : public PatientCommand {
 protected:
  static const std::string& session() {
    static const std::string file = [] {
      const std::string made = (folder_ / "session.bodkin").string();
      bodkin("-q run " + patient() + " --operator expert --output " + made + " --overwrite");
      return made;
    }();
    return file;
  }
};

TEST_F(ScoreCommand, of_the_expert_is_a_pass_and_says_why) {
  const Outcome said = bodkin("-q score " + session());
  EXPECT_EQ(said.exit_code, 0) << said.text();
  EXPECT_THAT(said.output, HasSubstr("Passed: the tip came to rest in the cerebrospinal fluid"));
  EXPECT_THAT(said.output, HasSubstr("You entered at L3/L4."));
  EXPECT_THAT(said.output, HasSubstr("You crossed the ligamentum flavum at "));
}

// Including near misses and distances to organs: the session stores the patient's voxels.
TEST_F(ScoreCommand, needs_the_session_alone) {
  const std::string recorded = session();
  const Outcome with = bodkin("-q --json score " + recorded + " --procedure epidural");
  const fs::path away = folder_ / "away";
  fs::rename(patient(), away);
  const Outcome without = bodkin("-q --json score " + recorded + " --procedure epidural");
  fs::rename(away, patient());
  EXPECT_EQ(without.errors, "");
  EXPECT_EQ(without.output, with.output);
  EXPECT_FALSE(nlohmann::json::parse(without.output).at("distances").empty());
}

TEST_F(ScoreCommand, by_another_procedure_fails_with_exit_code_3) {
  const Outcome said = bodkin("-q --json score " + session() + " --procedure epidural");
  EXPECT_EQ(said.exit_code, 3) << said.text();
  const auto score = nlohmann::json::parse(said.output);
  EXPECT_EQ(score.at("verdict"), "fail");
  EXPECT_EQ(score.at("headline"), "Failed: the tip entered the dural sac");
  EXPECT_EQ(score.at("procedure").at("name"), "epidural");
}

TEST_F(ScoreCommand, writes_a_table_with_a_row_for_each_session) {
  const Outcome said = bodkin("-q score " + session() + " " + session() + " --csv table.csv");
  EXPECT_EQ(said.exit_code, 0) << said.text();
  EXPECT_EQ(lines_of(text_of("table.csv")), 3);
  EXPECT_THAT(text_of("table.csv"), HasSubstr("\nsession.bodkin,pass,1,"));
}

TEST_F(ScoreCommand, of_an_older_session_without_its_case_says_what_could_not_be_looked_for) {
  const std::string recorded = (folder_ / "older.bodkin").string();
  fs::copy_file(session(), recorded, fs::copy_options::overwrite_existing);
  ::bodkin::make_version_4(recorded);
  fs::rename(patient(), folder_ / "away");
  const Outcome lost = bodkin("score " + recorded);
  const Outcome named = bodkin("score " + recorded + " --case nowhere");
  const Outcome found = bodkin("-q score " + recorded + " --case away");
  fs::rename(folder_ / "away", patient());
  EXPECT_EQ(lost.exit_code, 0);
  EXPECT_THAT(lost.output, HasSubstr("Borderline"));
  EXPECT_THAT(lost.output, HasSubstr("could not be checked whether the tip entered"));
  EXPECT_THAT(lost.errors, HasSubstr("holds no case.xml now"));
  EXPECT_EQ(named.exit_code, 2);
  EXPECT_THAT(found.output, HasSubstr("Passed"));
}

TEST_F(ScoreCommand, refuses_what_is_no_session_and_no_procedure) {
  write("wrong.bodkin", "not a session");
  EXPECT_EQ(bodkin("-q score wrong.bodkin").exit_code, 2);
  const Outcome said = bodkin("-q score " + session() + " --procedure appendectomy");
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_THAT(said.errors, HasSubstr("there is no procedure 'appendectomy', expected one of acupuncture"));
  EXPECT_EQ(bodkin("-q score " + session() + " --experts wrong.bodkin").exit_code, 2);
}

TEST_F(ScoreCommand, says_errors_in_the_published_form) {
  const auto schema = nlohmann::json::parse(content_of(BODKIN_REPOSITORY "/share/bodkin/error.schema.json"));
  const auto& members = schema.at("properties").at("error").at("properties");
  for (const char* arguments :
       {"score nothing.bodkin", "report nothing.bodkin", "results show nobody --store x.sqlite"}) {
    const Outcome said = bodkin(std::string("-q --json ") + arguments);
    const auto error = nlohmann::json::parse(said.output);
    ASSERT_EQ(error.size(), 1U) << arguments;
    EXPECT_EQ(error.at("error").size(), members.size()) << arguments;
    for (const auto& [name, value] : error.at("error").items()) EXPECT_TRUE(members.contains(name)) << name;
    EXPECT_EQ(error.at("error").at("exit_code"), said.exit_code);
    EXPECT_EQ("bodkin: " + error.at("error").at("sentence").get<std::string>() + "\n", said.errors);
  }
}

}  // namespace
}  // namespace bodkin_test
