// Sessions that cannot be scored, and stores that cannot be written: each command reports it in one sentence, and
// nothing is lost.
#include <cstdlib>

#include "session/session_file.h"
#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bodkin_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class BadSession : public PatientCommand {
 protected:
  static void SetUpTestSuite() {
    PatientCommand::SetUpTestSuite();
    setenv("XDG_DATA_HOME", (folder_ / "data").c_str(), 1);
    unsetenv("BODKIN_STORE");
    if (made_.exit_code == 0) bodkin("-q run patient --operator expert --output session.bodkin");
  }
  static void TearDownTestSuite() {
    unsetenv("XDG_DATA_HOME");
    PatientCommand::TearDownTestSuite();
  }
  void SetUp() override {
    PatientCommand::SetUp();
    fs::remove_all(folder_ / "data");
  }

  // The session without the ticks from `first` to before `last`.
  static void write_without(const std::string& name, std::uint64_t first, std::uint64_t last, bool finish) {
    const ::bodkin::session::Session whole = ::bodkin::session::read_session(folder_ / "session.bodkin");
    ::bodkin::session::SessionWriter writer(folder_ / name, whole.header, true);
    auto event = whole.events.begin();
    for (::bodkin::simulation::TickRecord record : whole.ticks) {
      for (; event != whole.events.end() && event->tick == record.tick; ++event)
        record.output.events.push(event->event);
      if (record.tick < first || record.tick >= last) writer.append(record);
    }
    if (finish) writer.finish();
  }

  // Every scoring command refuses this session in one line, and leaves nothing behind.
  static void expect_refused(const std::string& file, const std::string& part) {
    const std::set<std::string> before = listing();
    for (const std::string command : {"score", "report", "results add --trainee t1", "experts import"}) {
      const Outcome said = bodkin("-q " + command + " " + file);
      EXPECT_EQ(said.exit_code, 2) << command;
      EXPECT_THAT(said.errors, StartsWith("bodkin: " + file + ": ")) << command;
      EXPECT_THAT(said.errors, HasSubstr(part)) << command;
      EXPECT_EQ(lines_of(said.errors), 1) << command;
      EXPECT_EQ(said.output, "") << command;
    }
    EXPECT_EQ(listing(), before) << "nothing was made";
  }
};

TEST_F(BadSession, of_another_version) {
  std::string bytes = text_of("session.bodkin");
  bytes[63] = 9;  // the lowest byte of the database's user version
  write("newer.bodkin", bytes);
  expect_refused("newer.bodkin", "format version 9, this Bodkin reads versions 2 to 5");
}

TEST_F(BadSession, that_is_truncated_or_empty) {
  const std::string bytes = text_of("session.bodkin");
  write("half.bodkin", bytes.substr(0, bytes.size() / 2));
  expect_refused("half.bodkin", "the end of the file is missing");
  write("zero.bodkin", "");
  expect_refused("zero.bodkin", "this is not a session file");
  write_without("no_tick.bodkin", 0, 1'000'000, true);
  expect_refused("no_tick.bodkin", "holds no tick");
}

TEST_F(BadSession, of_another_patient) {
  if (!fs::exists(folder_ / "other")) fs::copy(folder_ / "patient", folder_ / "other", fs::copy_options::recursive);
  write("other/case.xml", text_of("patient/case.xml") + "\n");
  for (const std::string command : {"score", "results add --trainee t1", "experts import"}) {
    const Outcome said = bodkin("-q " + command + " session.bodkin --case other");
    EXPECT_EQ(said.exit_code, 2) << command << said.text();
    EXPECT_EQ(said.errors, "bodkin: --case: other/case.xml is not the case.xml that the session was recorded on\n");
  }
  EXPECT_FALSE(fs::exists(folder_ / "data/bodkin/results.sqlite"));
  const Outcome report = bodkin("report session.bodkin --case other -o other.html");
  EXPECT_THAT(report.errors, HasSubstr("the case has changed since the recording"));
  EXPECT_THAT(report.output, StartsWith("Passed")) << "it is judged on the voxels that the session keeps";
  EXPECT_EQ(bodkin("-q replay session.bodkin --case other").exit_code, 2);
}

TEST_F(BadSession, with_a_gap_is_judged_and_never_passes) {
  write_without("gap.bodkin", 8000, 9000, true);
  const Outcome said = bodkin("-q score gap.bodkin");
  EXPECT_EQ(said.exit_code, 0) << said.text();
  EXPECT_THAT(said.output, StartsWith("Borderline"));
  EXPECT_THAT(said.output, HasSubstr("1.000 s of the recording are missing while the needle was in the body."));
  const Outcome replayed = bodkin("-q replay gap.bodkin");
  EXPECT_EQ(replayed.exit_code, 2);
  EXPECT_THAT(replayed.errors, HasSubstr("tick 8000 is missing"));
  EXPECT_EQ(lines_of(replayed.errors), 1);
  const Outcome added = bodkin("-q results add gap.bodkin --trainee t1");
  EXPECT_EQ(added.exit_code, 0);
  EXPECT_THAT(added.output, HasSubstr("borderline"));
}

TEST_F(BadSession, without_an_insertion_has_failed) {
  write_without("air.bodkin", 500, 1'000'000, true);
  const Outcome said = bodkin("-q score air.bodkin");
  EXPECT_EQ(said.exit_code, 3);
  EXPECT_THAT(said.output, StartsWith("Failed: the needle never touched the body\n"));
  EXPECT_EQ(bodkin("-q report air.bodkin").exit_code, 0);
  EXPECT_THAT(text_of("air.html"), HasSubstr("The needle never touched the body."));
}

TEST_F(BadSession, of_which_nothing_is_wrong_waits_while_the_store_is_no_place_for_one) {
  const Outcome list = bodkin("-q results list --store patient");
  EXPECT_EQ(list.exit_code, 1);
  EXPECT_EQ(list.errors, "bodkin: the store patient cannot be opened; its folder must exist and be yours to write\n");
  const Outcome waits = bodkin("results add session.bodkin --trainee t1 --store patient");
  EXPECT_EQ(waits.exit_code, 0) << waits.text();
  EXPECT_THAT(waits.output, HasSubstr("waits for the store"));
  EXPECT_THAT(waits.errors, HasSubstr("the store patient cannot be opened"));
  EXPECT_THAT(bodkin("results deliver --store store.sqlite").errors, HasSubstr("wait for another store"));
  EXPECT_THAT(bodkin("-q results deliver --store store.sqlite --from patient").output,
              HasSubstr("attempts delivered: 1"));
}

}  // namespace
}  // namespace bodkin_test
