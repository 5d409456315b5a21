// tests/slow_tests.txt names tests of each program that `./test quick` leaves out.
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

// The text of all tests in tests/MODULE.
std::string tests_of(const std::string& module) {
  std::ostringstream text;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(BODKIN_REPOSITORY) / "tests" / module)) {
    if (entry.path().extension() == ".cpp") text << std::ifstream(entry.path()).rdbuf();
  }
  return text.str();
}

// A line with an outdated name, after a test was renamed, would leave that test in `./test quick`.
TEST(SlowTests, every_line_names_a_test_that_exists) {
  std::ifstream list(fs::path(BODKIN_REPOSITORY) / "tests" / "slow_tests.txt");
  int lines = 0;
  for (std::string line; std::getline(list, line);) {
    if (line.empty() || line.front() == '#') continue;
    ++lines;
    std::smatch part;  // PROGRAM [INSTANTIATION/]SUITE.TEST[/INDEX]
    ASSERT_TRUE(std::regex_match(line, part, std::regex(R"(([a-z]+)[a-z_]* (?:\w+/)?([\w*]+)\.([\w*]+)(?:/.*)?)")))
        << line;
    const auto pattern = [](const std::string& name) { return name == "*" ? std::string(R"(\w+)") : name; };
    const std::regex test(R"(\b\w*TEST\w*\(\s*)" + pattern(part[2]) + R"(,\s*)" + pattern(part[3]) + R"(\b)");
    EXPECT_TRUE(std::regex_search(tests_of(part[1]), test)) << line;
  }
  EXPECT_GT(lines, 5);
}

}  // namespace
