// Every option of every command with every kind of bad value: one sentence, exit code 2, and nothing written.
#include <algorithm>
#include <regex>
#include <vector>

#include "tests/cli/bodkin_command.h"
#include "tests/cli/command_table.h"
#include <gmock/gmock.h>

namespace bodkin_test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class Arguments : public BodkinCommand {
 protected:
  // `parts` must occur in the sentence.
  static void expect_refusal(const std::string& arguments, const std::vector<std::string>& parts) {
    SCOPED_TRACE(arguments);
    const auto before = listing();
    const Outcome outcome = run_bodkin_in_copy(folder_, arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.output, "");
    EXPECT_THAT(outcome.errors, StartsWith("bodkin: "));
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
    for (const std::string& part : parts) EXPECT_THAT(outcome.errors, HasSubstr(part));
    EXPECT_EQ(listing(), before);
  }
};

TEST_F(Arguments, the_table_holds_every_command_and_every_option) {
  const std::regex option(R"(^  (?:-\w,)?(--[a-z-]+))");
  for (const CommandRow& row : command_table()) {
    const Outcome help = run_bodkin_in_copy(folder_, row.words + " --help");
    ASSERT_EQ(help.exit_code, 0) << row.words;
    std::set<std::string> told, known = {"--help"};
    std::istringstream lines(help.output);
    std::smatch match;
    for (std::string line; std::getline(lines, line);) {
      if (std::regex_search(line, match, option)) told.insert(match[1]);
    }
    for (const OptionRow& entry : row.options) known.insert(entry.name);
    EXPECT_EQ(told, known) << row.words;
  }
  const std::regex command(R"(^  ([a-z]+) +[A-Z])");
  for (const std::string group : {"", "case", "case synthesize", "devices", "plan", "results", "stations", "scene"}) {
    std::istringstream lines(run_bodkin_in_copy(folder_, group + " --help").output);
    std::smatch match;
    for (std::string line; std::getline(lines, line);) {
      if (!std::regex_search(line, match, command)) continue;
      const std::string words = (group.empty() ? "" : group + " ") + match[1].str();
      EXPECT_TRUE(std::any_of(command_table().begin(), command_table().end(), [&](const CommandRow& row) {
        return row.words == words || row.words.rfind(words + " ", 0) == 0;
      })) << words;
    }
  }
}

TEST_F(Arguments, every_bad_value_of_every_option_is_refused) {
  for (const CommandRow& row : command_table()) {
    const std::string start = row.words + " " + row.arguments + " ";
    for (const OptionRow& option : row.options) {
      if (option.kind == Kind::toggle) {
        expect_refusal(start + option.name + "=maybe", {option.name, "takes no value"});
        continue;
      }
      const bool given = (" " + row.arguments).find(" " + option.name + " ") != std::string::npos;
      const std::string before = given ? row.words + " made " : start;
      expect_refusal(before + option.name, {option.name + " has no value; expected "});
      expect_refusal(before + option.name + "=", {option.name});
      expect_refusal(before + option.name + " ''", {option.name + " is "});
      if (option.kind != Kind::texts) {
        expect_refusal(before + option.name + " 20 " + option.name + " 30",
                       {option.name + " is given more than once"});
      }
      std::vector<std::string> wrong = option.out_of_range;
      if (option.kind == Kind::number || option.kind == Kind::whole) {
        wrong.insert(wrong.end(),
                     {"abc", "nan", "-nan", "inf", "1e999", "20x", "0x14", "99999999999999999999", "20,5"});
      }
      if (option.kind == Kind::whole) wrong.insert(wrong.end(), {"20.5", "2e1"});
      for (const std::string& value : wrong) {
        expect_refusal(before + option.name + "=" + value, {option.name + " is '" + value + "'; expected a "});
      }
    }
  }
}

TEST_F(Arguments, points_are_three_finite_numbers) {
  for (const std::string words : {"case new made --ct ct.nrrd", "case synthesize lumbar made", "profile somewhere"}) {
    for (const std::string value :
         {"1,2", "1,2,3,4", "1,2,x", "nan,0,0", "1,inf,0", "1e999,0,0", "1;2;3", "1, 2,3"}) {
      expect_refusal(words + " --entry='" + value + "' --target=0,0,0",
                     {"--entry is '" + value + "'; expected three"});
      expect_refusal(words + " --entry=0,0,0 --target='" + value + "'",
                     {"--target is '" + value + "'; expected three"});
    }
  }
}

TEST_F(Arguments, unknown_words_and_missing_ones_are_named) {
  for (const CommandRow& row : command_table()) {
    const std::string start = row.words + " " + row.arguments;
    expect_refusal(start + " --no-such-option", {"bodkin " + row.words + " has no option --no-such-option"});
    expect_refusal(start + " --no-such-option=1", {"has no option --no-such-option"});
    expect_refusal(start + " -x", {"has no option -x"});
    if (!row.takes_several) expect_refusal(start + " surplus", {"bodkin " + row.words + " does not take 'surplus'"});
    if (row.missing.empty()) continue;
    expect_refusal(row.words, {row.missing + " is missing; expected "});
    expect_refusal(row.words + " ''", {row.missing + " is empty; expected "});
  }
  expect_refusal("case new made", {"--ct is missing; expected "});
  expect_refusal("", {"bodkin needs a command; expected case, "});
  expect_refusal("frob", {"bodkin has no command 'frob'; expected case, "});
  expect_refusal("case", {"bodkin case needs a command; expected new, "});
  expect_refusal("case frob", {"bodkin case has no command 'frob'"});
  expect_refusal("case synthesize", {"bodkin case synthesize needs a command; expected lumbar, body"});
  expect_refusal("case synthesize thorax made",
                 {"bodkin case synthesize has no command 'thorax'; expected lumbar, body"});
  expect_refusal("--quiet=maybe run somewhere", {"--quiet", "takes no value"});
  expect_refusal("--frob run somewhere", {"has no option --frob"});
}

TEST_F(Arguments, places_that_cannot_be_written_are_refused_before_the_work) {
  write("session.bodkin", "what must not be lost");
  std::filesystem::create_directories(folder_ / "folder.png");
  std::filesystem::create_directories(folder_ / "folder");
  expect_refusal("case show somewhere -o no/such/p.png",
                 {"--output is 'no/such/p.png'; expected a file in a folder"});
  expect_refusal("case show somewhere -o folder.png", {"which is a folder"});
  expect_refusal("profile somewhere -o no/such/base", {"--output is 'no/such/base"});
  expect_refusal("run somewhere -o no/such/s.bodkin", {"--output is 'no/such/s.bodkin'"});
  expect_refusal("perform somewhere haption -o no/such/s.bodkin", {"--output is 'no/such/s.bodkin'"});
  expect_refusal("run somewhere -o folder", {"which is a folder"});
  expect_refusal("report session.bodkin -o no/such/r.html", {"--output is 'no/such/r.html'"});
  expect_refusal("report session.bodkin -o ./session.bodkin", {"which is also an input"});
  expect_refusal("export session.bodkin --csv session.bodkin", {"--csv is 'session.bodkin', which is also an input"});
  expect_refusal("export session.bodkin --csv no/such/t.csv", {"--csv is 'no/such/t.csv'"});
  expect_refusal("export session.bodkin --csv a.csv --events a.csv", {"both 'a.csv'"});
  expect_refusal("ultrasound somewhere -o no/such/p.png",
                 {"--output is 'no/such/p.png'; expected a file in a folder"});
  expect_refusal("ultrasound somewhere -o folder.png", {"which is a folder"});
  expect_refusal("ultrasound somewhere --tilt=-9,9 -o no/such/s.mha", {"--output is 'no/such/s.mha'"});
  expect_refusal("ultrasound somewhere --tilt=-9,9 -o session.bodkin",
                 {"--output is 'session.bodkin'; a sweep becomes"});
  EXPECT_EQ(text_of("session.bodkin"), "what must not be lost");
}

}  // namespace
}  // namespace bodkin_test
