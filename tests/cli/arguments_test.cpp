// Every option of every command with every kind of bad value: one sentence, exit code 2, and nothing written.
#include <algorithm>
#include <regex>
#include <vector>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>

namespace bodkin_test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

enum class Kind { text, texts, point, number, whole, toggle };

struct OptionRow {
  std::string name;
  Kind kind;
  std::vector<std::string> out_of_range = {};  // numbers of the right kind that are refused
};

struct CommandRow {
  std::string words;      // the command
  std::string arguments;  // that it cannot do without, all good as far as the command line goes
  std::string missing;    // the first of them; empty where there is none
  std::vector<OptionRow> options;
  bool takes_several = false;  // of the last argument, so that no word is one too many
};

const std::vector<CommandRow>& table() {
  static const std::vector<CommandRow> rows = {
      {"case new",
       "made --ct ct.nrrd",
       "DIR",
       {{"--name", Kind::text},
        {"--entry", Kind::point},
        {"--target", Kind::point},
        {"--needle-gauge", Kind::whole, {"9", "35", "-22"}},
        {"--needle", Kind::text},
        {"--procedure", Kind::text},
        {"--level", Kind::text},
        {"--lowest-vertebra", Kind::text},
        {"--conus", Kind::text},
        {"--age", Kind::number, {"-1", "121"}},
        {"--overwrite", Kind::toggle},
        {"--ct", Kind::text},
        {"--labels", Kind::text},
        {"--scheme", Kind::text},
        {"--tissues", Kind::text},
        {"--series", Kind::whole, {"0", "-1", "100001"}},
        {"--resample-labels", Kind::toggle},
        {"--fill-missing", Kind::toggle},
        {"--assume-hu", Kind::toggle}}},
      {"case synthesize lumbar",
       "made",
       "DIR",
       {{"--name", Kind::text},
        {"--entry", Kind::point},
        {"--target", Kind::point},
        {"--needle-gauge", Kind::whole, {"9", "35", "-22"}},
        {"--needle", Kind::text},
        {"--procedure", Kind::text},
        {"--overwrite", Kind::toggle},
        {"--seed", Kind::whole, {"-1"}},
        {"--age", Kind::number, {"17.9", "95.1", "-40"}},
        {"--height", Kind::number, {"1.39", "2.06", "-1.7"}},
        {"--weight", Kind::number, {"39", "161", "-70"}},
        {"--flexion", Kind::number, {"-0.1", "1.1"}},
        {"--spacing", Kind::number, {"0", "0.4", "3.1", "-1"}}}},
      {"case check", "somewhere", "CASE", {}},
      {"case show", "somewhere", "CASE", {{"--output", Kind::text}}},
      {"case mesh",
       "somewhere",
       "CASE",
       {{"--nodes", Kind::whole, {"499", "400001", "-5"}},
        {"--fine", Kind::number, {"0.1", "21", "-1"}},
        {"--coarse", Kind::number, {"0.1", "101", "-1"}},
        {"--corridor", Kind::number, {"0.9", "201", "-1"}},
        {"--import", Kind::text},
        {"--regions", Kind::text},
        {"--output", Kind::text},
        {"--force", Kind::toggle}}},
      {"devices list", "", "", {{"--driver", Kind::text}, {"--settings", Kind::text}}},
      {"devices check",
       "force_dimension",
       "DEVICE",
       {{"--settings", Kind::text}, {"--seconds", Kind::number, {"0.09", "3601", "-1"}}}},
      {"devices calibrate",
       "force_dimension",
       "DEVICE",
       {{"--settings", Kind::text},
        {"--steps", Kind::texts},
        {"--seconds", Kind::number, {"0.9", "601", "-1"}},
        {"--countdown", Kind::number, {"-1", "601"}},
        {"--file", Kind::text},
        {"--show", Kind::toggle},
        {"--forget", Kind::toggle}}},
      {"profile",
       "somewhere",
       "CASE",
       {{"--entry", Kind::point},
        {"--target", Kind::point},
        {"--speed", Kind::number, {"0", "0.4", "501", "-10"}},
        {"--beyond", Kind::number, {"-1", "201"}},
        {"--pause", Kind::number, {"-1", "61"}},
        {"--withdraw", Kind::toggle},
        {"--deformation", Kind::toggle},
        {"--resistance", Kind::text},
        {"--constraint", Kind::text},
        {"--part", Kind::texts},
        {"--output", Kind::text}}},
      {"compare",
       "somewhere",
       "CASE",
       {{"--entry", Kind::point},
        {"--target", Kind::point},
        {"--models", Kind::texts},
        {"--constraint", Kind::text},
        {"--part", Kind::texts},
        {"--speed", Kind::number, {"0", "0.4", "501", "-10"}},
        {"--withdraw-speed", Kind::number, {"0", "0.4", "501", "-10"}},
        {"--pause", Kind::number, {"-1", "61"}},
        {"--no-reinsert", Kind::toggle},
        {"--output", Kind::text}}},
      {"fit",
       "layered curve.csv",
       "MODEL",
       {{"--from", Kind::number, {"-1001", "1001"}},
        {"--to", Kind::number, {"-1001", "1001"}},
        {"--speed", Kind::number, {"0", "1001", "-5"}},
        {"--resolution", Kind::number, {"-0.1", "1.1"}},
        {"--fix", Kind::texts},
        {"--start", Kind::texts},
        {"--bounds", Kind::texts},
        {"--free", Kind::texts},
        {"--output", Kind::text}}},
      {"figures", "made", "DIR", {{"--experiment", Kind::texts}}},
      {"ultrasound",
       "somewhere",
       "CASE",
       {{"--probe", Kind::text},
        {"--probes", Kind::text},
        {"--view", Kind::text},
        {"--at", Kind::text},
        {"--from", Kind::text},
        {"--face", Kind::point},
        {"--look", Kind::point},
        {"--marked", Kind::point},
        {"--pose", Kind::text},
        {"--press", Kind::number, {"-61", "41"}},
        {"--depth", Kind::number, {"9", "401", "-80"}},
        {"--gain", Kind::number, {"-41", "41"}},
        {"--dynamic-range", Kind::number, {"19", "121", "-60"}},
        {"--focus", Kind::number, {"4", "401", "-40"}},
        {"--frequency", Kind::number, {"0", "31", "-5"}},
        {"--tgc", Kind::text},
        {"--no-gel", Kind::toggle},
        {"--lines", Kind::whole, {"15", "2049", "-1"}},
        {"--samples", Kind::whole, {"31", "4097", "-1"}},
        {"--size", Kind::text},
        {"--slices", Kind::whole, {"0", "8", "-1"}},
        {"--threads", Kind::whole, {"0", "65", "-1"}},
        {"--mark", Kind::text},
        {"--needle", Kind::toggle},
        {"--needle-depth", Kind::number, {"-1", "301"}},
        {"--deformed", Kind::toggle},
        {"--output", Kind::text},
        {"--plain", Kind::toggle},
        {"--ct", Kind::toggle},
        {"--beside", Kind::text},
        {"--beside-pixel", Kind::number, {"0", "11", "-1"}},
        {"--beside-crop", Kind::text},
        {"--window", Kind::text},
        {"--beside-window", Kind::text},
        {"--sweep", Kind::text},
        {"--sweep-to", Kind::point},
        {"--on-skin", Kind::toggle},
        {"--tilt", Kind::text},
        {"--rock", Kind::text},
        {"--rotate", Kind::text},
        {"--frames", Kind::whole, {"0", "100001", "-1"}},
        {"--rate", Kind::number, {"0", "0.9", "201", "-1"}},
        {"--live", Kind::toggle}}},
      {"perform",
       "somewhere force_dimension",
       "CASE",
       {{"--settings", Kind::text},
        {"--output", Kind::text},
        {"--overwrite", Kind::toggle},
        {"--scale", Kind::number, {"0.09", "10.1", "-1"}},
        {"--force-scale", Kind::number, {"0.009", "1.1", "-1"}},
        {"--no-calibration", Kind::toggle},
        {"--max-time", Kind::number, {"0.9", "3601"}},
        {"--second", Kind::text},
        {"--second-as", Kind::text},
        {"--second-settings", Kind::text},
        {"--body", Kind::text},
        {"--ultrasound", Kind::text},
        {"--resistance", Kind::text},
        {"--constraint", Kind::text},
        {"--part", Kind::texts}}},
      {"run",
       "somewhere",
       "CASE",
       {{"--operator", Kind::text},
        {"--seed", Kind::whole, {"-1"}},
        {"--realtime", Kind::toggle},
        {"--output", Kind::text},
        {"--overwrite", Kind::toggle},
        {"--entry", Kind::point},
        {"--target", Kind::point},
        {"--resistance", Kind::text},
        {"--constraint", Kind::text},
        {"--part", Kind::texts},
        {"--max-time", Kind::number, {"0", "0.9", "3601", "-1"}}}},
      {"replay", "session.bodkin", "SESSION", {{"--case", Kind::text}}},
      {"export",
       "session.bodkin",
       "SESSION",
       {{"--csv", Kind::text}, {"--events", Kind::text}, {"--second", Kind::text}}},
      {"report",
       "session.bodkin",
       "SESSION",
       {{"--case", Kind::text},
        {"--procedure", Kind::text},
        {"--experts", Kind::text},
        {"--output", Kind::text},
        {"--open", Kind::toggle}}},
      {"score",
       "session.bodkin",
       "SESSION",
       {{"--procedure", Kind::text}, {"--case", Kind::text}, {"--experts", Kind::text}, {"--csv", Kind::text}},
       true},
      {"cohort",
       "plan.xml",
       "PLAN",
       {{"--trainees", Kind::whole, {"0", "1000001", "-1"}},
        {"--seed", Kind::whole, {"-1"}},
        {"--operator", Kind::text},
        {"--output", Kind::text},
        {"--threads", Kind::whole, {"-1", "1025"}}}},
      {"app", "somewhere", "", {{"--script", Kind::text}, {"--shots", Kind::text}, {"--size", Kind::text}}}};
  return rows;
}

class Arguments : public BodkinCommand {
 protected:
  // `parts` are what the sentence must say.
  static void expect_refusal(const std::string& arguments, const std::vector<std::string>& parts) {
    SCOPED_TRACE(arguments);
    const auto before = listing();
    const Outcome outcome = bodkin(arguments);
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
  for (const CommandRow& row : table()) {
    const Outcome help = bodkin(row.words + " --help");
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
  for (const std::string group : {"", "case", "case synthesize", "devices"}) {
    std::istringstream lines(bodkin(group + " --help").output);
    std::smatch match;
    for (std::string line; std::getline(lines, line);) {
      if (!std::regex_search(line, match, command)) continue;
      const std::string words = (group.empty() ? "" : group + " ") + match[1].str();
      EXPECT_TRUE(std::any_of(table().begin(), table().end(), [&](const CommandRow& row) {
        return row.words == words || row.words.rfind(words + " ", 0) == 0;
      })) << words;
    }
  }
}

TEST_F(Arguments, every_bad_value_of_every_option_is_refused) {
  for (const CommandRow& row : table()) {
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
  for (const CommandRow& row : table()) {
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
  expect_refusal("case synthesize", {"bodkin case synthesize needs a command; expected lumbar"});
  expect_refusal("case synthesize thorax made", {"bodkin case synthesize has no command 'thorax'; expected lumbar"});
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
  expect_refusal("report session.bodkin -o ./session.bodkin", {"which is read from"});
  expect_refusal("export session.bodkin --csv session.bodkin", {"--csv is 'session.bodkin', which is read from"});
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
