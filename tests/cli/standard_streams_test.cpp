#include <fstream>
#include <string>
#include <tuple>

#include "session/session_file.h"
#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>

// How commands end when nobody reads their output, when the disk of standard output is full, and when the terminal or
// the machine shuts down during a session.

namespace bodkin_test {
namespace {

using ::testing::HasSubstr;

class StandardStreams : public PatientCommand {
 protected:
  static Outcome shell(const std::string& command) {
    const std::string line = "cd '" + folder_.string() + "' && " + command;
    FILE* pipe = popen(("exec bash -c \"" + line + "\" 2>&1").c_str(), "r");
    Outcome outcome;
    char block[4096];
    for (std::size_t n = 0; (n = fread(block, 1, sizeof block, pipe)) > 0;) outcome.output.append(block, n);
    const int status = pclose(pipe);
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return outcome;
  }

  static inline const std::string program = "'" BODKIN_BUILD "/bin/bodkin' ";

  // A one-second session, with the shell text before and after the command.
  static Outcome perform(const std::string& before, const std::string& behind, const std::string& time = "1") {
    std::filesystem::remove(folder_ / "hand.bodkin");
    return shell(before + " " + program + "perform patient force_dimension --settings library='" +
                 BODKIN_MOCKS "/force_dimension/libdrd.so' --max-time " + time + " -o hand.bodkin " + behind);
  }
  // What goes behind a command: it starts, and the signal comes half a second after its session file is there,
  // however long a busy machine took for that. Job control, for without it a shell's background programs ignore
  // SIGINT.
  static std::string signalled(const std::string& signal) {
    return "& for i in {1..1200}; do [ -s hand.bodkin ] && break; sleep 0.05; done; sleep 0.5; kill -s " + signal +
           " \\$!; wait \\$!";
  }
  static void expect_complete_session() {
    EXPECT_TRUE(::bodkin::session::read_session(folder_ / "hand.bodkin").finished);
  }
};

TEST_F(StandardStreams, nobody_who_reads_the_result_is_no_error_of_the_data) {
  const Outcome said = shell("set -o pipefail; " + program + "-q --json case show patient | true");
  EXPECT_EQ(said.exit_code, 141);
  EXPECT_EQ(said.output, "");
}

TEST_F(StandardStreams, a_full_disk_behind_the_result_is_one_sentence) {
  const Outcome said = shell(program + "-q case show patient > /dev/full");
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.output, HasSubstr("the result cannot be written to standard output: No space left on device"));
}

TEST_F(StandardStreams, a_session_does_not_need_a_standard_error) {
  for (const char* behind : {"2> /dev/full", "2>&-", "2> >(exec 0<&-)"}) {
    const Outcome said = perform("", behind);
    EXPECT_EQ(said.exit_code, 0) << behind << said.output;
    expect_complete_session();
  }
}

TEST_F(StandardStreams, a_session_whose_result_nobody_reads_is_complete) {
  const Outcome said = perform("set -o pipefail; ", "| true");
  EXPECT_EQ(said.exit_code, 141) << said.output;
  expect_complete_session();
}

TEST_F(StandardStreams, the_end_of_the_terminal_or_the_machine_ends_a_session_and_the_exit_code_tells) {
  for (const auto& [signal, code] : {std::pair{"HUP", 129}, {"TERM", 143}, {"INT", 0}}) {
    const Outcome said = perform("set -m;", signalled(signal), "60");
    EXPECT_EQ(said.exit_code, code) << signal << said.output;
    expect_complete_session();
  }
}

// Nobody holds a needle here, but the session is as complete.
TEST_F(StandardStreams, the_end_of_the_terminal_ends_a_run_with_a_complete_session) {
  std::ofstream(folder_ / "waits.xml") << R"(<operator name="waits" version="1"><description>d</description>
  <hand mass_kg="0.4" stiffness_N_per_mm="4" damping_N_s_per_mm="0.06" tremor_mm="0.02" tremor_deg="0.02"/>
  <accuracy entry_mm="0.5" direction_deg="0.5" wander_mm="0.1" wander_deg="0.05" unsteadiness="0.08"/>
  <reaction time_s="0.18" spread_s="0.03"/><start distance_mm="30"/>
  <phase name="wait" speed_mm_per_s="0"><until time_s="3000" then="end"/></phase></operator>)";
  for (const auto& [signal, code, how] : {std::tuple{"HUP", 129, "--realtime "},
                                          {"TERM", 143, "--realtime "},
                                          {"INT", 130, "--realtime "},
                                          {"HUP", 129, ""}}) {
    std::filesystem::remove(folder_ / "hand.bodkin");
    const Outcome said = shell("set -m; " + program + "run patient --operator waits.xml --max-time 3600 " + how +
                               "-o hand.bodkin " + signalled(signal));
    EXPECT_EQ(said.exit_code, code) << signal << said.output;
    EXPECT_THAT(said.output, HasSubstr(std::string("ended by SIG") + signal));
    EXPECT_THAT(said.output, testing::Not(HasSubstr("the longest time")));
    expect_complete_session();
  }
}

// The limit, in kB, simulates a full disk: a write beyond it fails. The patient's voxels fit, and some seconds.
TEST_F(StandardStreams, a_disk_that_fills_under_a_recording_ends_it_and_keeps_what_was_written) {
  const Outcome said = perform("trap '' XFSZ; ulimit -f 2000;", "-q", "30");
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.output, HasSubstr("cannot write the session hand.bodkin"));
  const auto kept = ::bodkin::session::read_session(folder_ / "hand.bodkin");
  EXPECT_FALSE(kept.finished);
  EXPECT_GT(kept.ticks.size(), 100U);
}

TEST_F(StandardStreams, a_disk_that_is_full_from_the_beginning_leaves_no_file_and_keeps_the_one_before) {
  ASSERT_EQ(perform("", "-q").exit_code, 0);
  const std::size_t ticks = ::bodkin::session::read_session(folder_ / "hand.bodkin").ticks.size();
  ASSERT_GT(ticks, 0U);
  const std::string begin = "trap '' XFSZ; ulimit -f 1; " + program +
                            "-q perform patient force_dimension --settings library='" + BODKIN_MOCKS +
                            "/force_dimension/libdrd.so' --max-time 1 -o ";
  const Outcome anew = shell(begin + "full.bodkin");
  EXPECT_EQ(anew.exit_code, 1) << anew.output;
  EXPECT_THAT(anew.output, HasSubstr("cannot create the session file full.bodkin"));
  const Outcome again = shell(begin + "hand.bodkin --overwrite");
  EXPECT_EQ(again.exit_code, 1) << again.output;
  EXPECT_EQ(::bodkin::session::read_session(folder_ / "hand.bodkin").ticks.size(), ticks);
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    const std::string name = entry.path().filename().string();
    EXPECT_TRUE(name.find(".bodkin") == std::string::npos || name == "hand.bodkin") << name;
  }
}

TEST_F(StandardStreams, a_session_that_cannot_begin_leaves_no_file) {
  const Outcome no_device =
      shell(program + "-q perform patient force_dimension --settings library=/no/such/libdrd.so -o none.bodkin");
  EXPECT_EQ(no_device.exit_code, 1) << no_device.output;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "none.bodkin"));
  const Outcome no_folder = shell(program + "-q perform patient simulated -o nowhere/none.bodkin");
  EXPECT_NE(no_folder.exit_code, 0);
  EXPECT_THAT(no_folder.output, HasSubstr("none.bodkin"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "nowhere"));
}

}  // namespace
}  // namespace bodkin_test
