#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <utility>

#include "session/session_file.h"
#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>

namespace bodkin_test {
namespace {

using ::testing::HasSubstr;

class App : public BodkinCommand {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(BODKIN_BUILD "/bin/bodkin-app")) GTEST_SKIP() << "built without bodkin-app";
    setenv("QT_QPA_PLATFORM", "offscreen", 1);
    for (const char* variable : {"XDG_DATA_HOME", "XDG_CONFIG_HOME"}) setenv(variable, folder_.c_str(), 1);
  }
  void TearDown() override {
    for (const char* variable : {"QT_QPA_PLATFORM", "XDG_DATA_HOME", "XDG_CONFIG_HOME"}) unsetenv(variable);
  }
};

TEST_F(App, a_script_takes_a_picture_of_the_start_page_and_leaves) {
  std::ofstream(folder_ / "look.txt") << "# the first page\nshot start.png\n";
  const Outcome outcome = run_bodkin(folder_, "app --script look.txt --shots pictures --size 1280x720");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text();
  EXPECT_TRUE(std::filesystem::exists(folder_ / "pictures/start.png"));
}

TEST_F(App, a_line_that_cannot_be_done_ends_the_script_with_its_number) {
  std::ofstream(folder_ / "wrong.txt") << "shot start.png\nclick no.such.button\n";
  const Outcome outcome = run_bodkin(folder_, "app --script wrong.txt");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.errors, HasSubstr("wrong.txt:2"));
  EXPECT_THAT(outcome.errors, HasSubstr("no widget has the name no.such.button"));
}

TEST_F(App, what_is_no_line_of_a_script_and_no_size_is_refused) {
  std::ofstream(folder_ / "unknown.txt") << "jump high\n";
  const Outcome unknown = run_bodkin(folder_, "app --script unknown.txt");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.errors, HasSubstr("'jump high' is no step"));
  const Outcome size = run_bodkin(folder_, "app --size big --script unknown.txt");
  EXPECT_EQ(size.exit_code, 2);
  EXPECT_THAT(size.errors, HasSubstr("1280x720"));
  EXPECT_EQ(run_bodkin(folder_, "app --script missing.txt").exit_code, 2);
}

// The attempt begins, the terminal or the machine shuts down, and the session is complete.
TEST_F(App, the_end_of_the_terminal_or_the_machine_closes_the_window_and_saves_the_session) {
  ASSERT_EQ(run_bodkin(folder_, "-q case synthesize lumbar patient --spacing 1.5").exit_code, 0);
  for (const auto& [signal, code] : {std::pair{"HUP", 129}, {"TERM", 143}}) {
    const std::string file = std::string("ended-by-") + signal + ".bodkin";
    std::ofstream(folder_ / "end.sh") << "'" BODKIN_BUILD "/bin/bodkin-app' --attempt '{\"resistance\": \"layered\", "
                                      << "\"output\": \"" << file << "\"}' -- patient &\n"
                                      << "for wait in $(seq 600); do ls " << file << "* > /dev/null 2>&1 && break; "
                                      << "sleep 0.1; done\nsleep 2\nkill -" << signal << " $!\nwait $!\n";
    const std::string line = "cd '" + folder_.string() + "' && timeout 110 bash end.sh > end.log 2>&1";
    const int status = std::system(line.c_str());
    EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, code) << text_of("end.log");
    EXPECT_TRUE(::bodkin::session::read_session(folder_ / file).finished);
  }
}

}  // namespace
}  // namespace bodkin_test
