#include <array>
#include <csignal>
#include <cstdio>
#include <string>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bodkin_test {
namespace {

using ::testing::HasSubstr;

class TeacherCommand : public BodkinCommand {};

TEST_F(TeacherCommand, answers_a_browser_until_it_is_interrupted) {
  if (std::system("curl --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "curl is not installed here";
  const std::string command = "cd '" + folder_.string() +
                              "' && echo $$ && exec '" BODKIN_BUILD
                              "/bin/bodkin' -q teacher --port 0 --store results.sqlite";
  FILE* pipe = popen(command.c_str(), "r");
  std::array<char, 512> line{};
  ASSERT_NE(fgets(line.data(), line.size(), pipe), nullptr);
  const int process = std::stoi(line.data());
  ASSERT_NE(fgets(line.data(), line.size(), pipe), nullptr);
  const std::string said = line.data();
  EXPECT_THAT(said, HasSubstr("http://127.0.0.1:"));
  const std::string url = said.substr(0, said.find(' '));
  const std::string page_file = (folder_ / "page.html").string();
  EXPECT_EQ(std::system(("curl -s -m 10 -o '" + page_file + "' '" + url + "'").c_str()), 0);
  EXPECT_THAT(text_of("page.html"), HasSubstr("No attempt has been kept yet."));
  kill(process, SIGTERM);
  EXPECT_EQ(WEXITSTATUS(pclose(pipe)), 0);
}

TEST_F(TeacherCommand, refuses_what_is_no_address_and_no_store) {
  const Outcome address = bodkin("-q teacher --address nowhere --store results.sqlite");
  EXPECT_EQ(address.exit_code, 2);
  EXPECT_THAT(address.errors, HasSubstr("the address is 'nowhere', expected an IP address"));
  EXPECT_EQ(bodkin("-q teacher --store /nowhere/results.sqlite").exit_code, 1);
}

}  // namespace
}  // namespace bodkin_test
