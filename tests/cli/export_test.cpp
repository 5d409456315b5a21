#include "session/session_file.h"
#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using ExportCommand = PatientCommand;

TEST_F(ExportCommand, writes_a_row_per_tick_and_a_row_per_event) {
  ASSERT_EQ(bodkin("--quiet run patient --max-time 6 --output s.bodkin").exit_code, 0);
  const Outcome written = bodkin("--json export s.bodkin --csv ticks.csv --events events.csv");
  ASSERT_EQ(written.exit_code, 0) << written.errors;
  const ::bodkin::session::Session session = ::bodkin::session::read_session(folder_ / "s.bodkin");
  EXPECT_EQ(nlohmann::json::parse(written.output)["ticks"].get<std::size_t>(), session.ticks.size());
  const std::string ticks = text_of("ticks.csv"), events = text_of("events.csv");
  const auto lines = [](const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  };
  EXPECT_EQ(lines(ticks), session.ticks.size() + 1);
  EXPECT_EQ(lines(events), session.events.size() + 1);
  EXPECT_THAT(ticks, StartsWith("tick,time_s,tip_x_mm,"));
  EXPECT_EQ(bodkin("export s.bodkin --csv -").output, ticks);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "ticks.csv.part"));
}

TEST_F(ExportCommand, refuses_what_makes_no_sense) {
  EXPECT_EQ(bodkin("--quiet run patient --max-time 1 --output t.bodkin").exit_code, 0);
  EXPECT_EQ(bodkin("--quiet export t.bodkin").exit_code, 2);
  EXPECT_EQ(bodkin("--quiet export t.bodkin --csv a.csv --second a.csv").exit_code, 2);
  const Outcome alone = bodkin("--quiet export t.bodkin --second out.csv");
  EXPECT_EQ(alone.exit_code, 2);
  EXPECT_THAT(alone.errors, HasSubstr("has no second hand"));
  EXPECT_EQ(bodkin("--quiet export t.bodkin --csv - --events -").exit_code, 2);
  EXPECT_EQ(bodkin("--json export t.bodkin --csv -").exit_code, 2);
  EXPECT_EQ(bodkin("--quiet export t.bodkin --csv no/such/folder.csv").exit_code, 2);
  std::ofstream(folder_ / "text.bodkin") << "tick,time\n";
  const Outcome foreign = bodkin("--quiet export text.bodkin --csv out.csv");
  EXPECT_EQ(foreign.exit_code, 2);
  EXPECT_THAT(foreign.errors, HasSubstr("not a session file"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out.csv"));
}

}  // namespace
}  // namespace bodkin_test
