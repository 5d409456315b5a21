#include <cstdlib>
#include <filesystem>
#include <fstream>

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

}  // namespace
}  // namespace bodkin_test
