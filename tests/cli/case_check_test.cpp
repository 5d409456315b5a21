// bodkin case check: exit codes, words and JSON, on a small synthetic patient that is then damaged in several ways.
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class CaseCheck : public BodkinCommand {
 protected:
  static void SetUpTestSuite() {
    BodkinCommand::SetUpTestSuite();
    made_ = bodkin("case synthesize lumbar sound --spacing 3");
  }

  void SetUp() override {
    ASSERT_EQ(made_.exit_code, 0) << made_.errors;
    case_ = folder_ / ::testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::copy(folder_ / "sound", case_, fs::copy_options::recursive);
  }

  std::string case_xml() const {
    std::stringstream text;
    text << std::ifstream(case_ / "case.xml").rdbuf();
    return text.str();
  }
  void replace(const std::string& from, const std::string& to) const {
    std::string text = case_xml();
    const auto position = text.find(from);
    ASSERT_NE(position, std::string::npos) << from;
    std::ofstream(case_ / "case.xml") << text.replace(position, from.size(), to);
  }
  // The value of `attribute` of the first `element` in case.xml.
  std::string value(const std::string& element, const std::string& attribute) const {
    const std::string text = case_xml();
    const auto start = text.find(attribute + "=\"", text.find("<" + element + " ")) + attribute.size() + 2;
    return text.substr(start, text.find('"', start) - start);
  }
  Outcome check(const std::string& options = "") const {
    return bodkin("--quiet " + options + " case check " + case_.string());
  }

  static inline Outcome made_;
  fs::path case_;
};

TEST_F(CaseCheck, a_synthetic_patient_is_sound) {
  const Outcome outcome = check();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("is valid: "));
  EXPECT_THAT(outcome.output, HasSubstr("22G"));
}

TEST_F(CaseCheck, json_says_the_same) {
  const auto sound = nlohmann::json::parse(check("--json").output);
  EXPECT_EQ(sound.at("sound"), true);
  EXPECT_EQ(sound.at("case"), case_.string());
  EXPECT_TRUE(sound.at("problems").empty());
  replace("<needle ", "<needle colour=\"red\" ");
  const Outcome outcome = check("--json");
  EXPECT_EQ(outcome.exit_code, 2);
  const auto unsound = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(unsound.at("sound"), false);
  ASSERT_EQ(unsound.at("problems").size(), 1U);
  EXPECT_THAT(unsound.at("problems")[0].get<std::string>(), HasSubstr("<needle> has the unknown attribute 'colour'"));
}

TEST_F(CaseCheck, every_problem_is_said_at_once) {
  fs::remove(case_ / value("tissues", "file"));
  replace(value("ct", "digest"), std::string(32, '0'));
  replace("<structure label=\"" + value("structure", "label") + "\"", "<structure label=\"60000\"");
  const Outcome outcome = check();
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.output, HasSubstr("has changed since the case was made"));
  EXPECT_THAT(outcome.output, HasSubstr("does not exist"));
  EXPECT_THAT(outcome.output, HasSubstr("which case.xml does not list as a structure"));
  EXPECT_THAT(outcome.output, HasSubstr("is not valid: 3 problems"));
}

TEST_F(CaseCheck, damaged_volumes_are_problems_and_not_crashes) {
  const fs::path ct = case_ / value("ct", "file");
  fs::resize_file(ct, fs::file_size(ct) / 2);
  std::ofstream(case_ / value("structures", "file"), std::ios::trunc).close();
  const Outcome outcome = check();
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.output, HasSubstr(ct.filename().string()));
  EXPECT_THAT(outcome.output, HasSubstr("is not valid: 2 problems"));
}

TEST_F(CaseCheck, a_path_that_misses_the_body_is_a_problem) {
  replace("<entry x_mm=\"" + value("entry", "x_mm") + "\"", "<entry x_mm=\"9000\"");
  const Outcome outcome = check();
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.output, HasSubstr("of the planned path lies outside the image"));
}

TEST_F(CaseCheck, a_case_that_is_no_case_is_refused) {
  EXPECT_EQ(bodkin("case check nowhere").exit_code, 2);
  fs::remove(case_ / "case.xml");
  const Outcome outcome = check();
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.output, HasSubstr("case.xml: there is no such file"));
}

}  // namespace
}  // namespace bodkin_test
