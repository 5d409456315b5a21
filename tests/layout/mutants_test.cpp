// scripts/mutants.txt names lines of the source that scripts/mutate.py changes.
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

int occurrences(std::string_view text, std::string_view part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + part.size()))
    ++count;
  return count;
}

// A line that no longer exists after a change would end the script before its first mutant.
TEST(Mutants, every_original_stands_in_its_file_exactly_once) {
  std::ifstream list(fs::path(BODKIN_REPOSITORY) / "scripts" / "mutants.txt");
  std::string file;
  std::string source;
  int mutants = 0;
  for (std::string line; std::getline(list, line);) {
    if (line.empty() || line.front() == '#' || line.starts_with("    ")) continue;
    if (line.front() != ' ') {
      file = line;
      std::ostringstream text;
      text << std::ifstream(fs::path(BODKIN_REPOSITORY) / file).rdbuf();
      source = text.str();
      continue;
    }
    ++mutants;
    const std::size_t arrow = line.find(" => ");
    ASSERT_NE(arrow, std::string::npos) << line;
    EXPECT_EQ(occurrences(source, line.substr(2, arrow - 2)), 1) << file << ":" << line;
  }
  EXPECT_GT(mutants, 150);
}

}  // namespace
