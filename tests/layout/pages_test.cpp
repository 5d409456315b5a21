// The pages of the documentation: every one can be reached from docs/README.md, and no link is dead.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/layout/repository_files.h"
#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;
using bodkin_test::read_text;
using bodkin_test::repository;

// Lines outside of fenced and indented code.
std::vector<std::string> prose(const fs::path& page) {
  std::vector<std::string> lines;
  std::istringstream text(read_text(page));
  bool fenced = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("```")) fenced = !fenced;
    if (!fenced && !line.starts_with("    ")) lines.push_back(line);
  }
  return lines;
}

struct Link {
  std::string file;    // relative to the page; empty: the page itself
  std::string anchor;  // without #
};

std::vector<Link> links_of(const fs::path& page) {
  static const std::regex pattern(R"(\]\(([^)#\s]*)(#[^)\s]*)?\))");
  std::vector<Link> links;
  for (const std::string& line : prose(page)) {
    for (std::sregex_iterator match(line.begin(), line.end(), pattern), end; match != end; ++match) {
      const std::string file = (*match)[1], anchor = (*match)[2];
      if (file.find("://") != std::string::npos || file.starts_with("mailto:")) continue;
      links.push_back({file, anchor.empty() ? "" : anchor.substr(1)});
    }
  }
  return links;
}

// The anchors that GitHub gives to a page's headings.
std::set<std::string> anchors_of(const fs::path& page) {
  std::set<std::string> anchors;
  for (const std::string& line : prose(page)) {
    const auto text = line.find_first_not_of('#');
    if (text == 0 || text == std::string::npos || line[text] != ' ') continue;
    std::string anchor;
    for (const unsigned char c : line.substr(text + 1)) {
      if (c == ' ') anchor += '-';
      if (std::isalnum(c) || c == '-' || c == '_' || c >= 0x80) anchor += static_cast<char>(std::tolower(c));
    }
    anchors.insert(anchor);
  }
  return anchors;
}

std::vector<fs::path> pages() {
  std::vector<fs::path> found;
  for (const char* name : {"README.md", "CONTRIBUTING.md", "CHANGELOG.md"}) found.push_back(repository / name);
  for (const auto& entry : fs::recursive_directory_iterator(repository / "docs")) {
    if (entry.path().extension() == ".md") found.push_back(entry.path());
  }
  return found;
}

fs::path target_of(const fs::path& page, const Link& link) {
  return link.file.empty() ? page : (page.parent_path() / link.file).lexically_normal();
}

TEST(Pages, every_page_is_reached_from_the_map) {
  std::set<fs::path> reached;
  std::vector<fs::path> waiting = {repository / "docs/README.md"};
  while (!waiting.empty()) {
    const fs::path page = waiting.back();
    waiting.pop_back();
    if (!reached.insert(page).second) continue;
    for (const Link& link : links_of(page)) {
      const fs::path target = target_of(page, link);
      if (target.extension() == ".md" && fs::exists(target)) waiting.push_back(target);
    }
  }
  for (const fs::path& page : pages()) {
    if (page == repository / "README.md") continue;  // from where the reader comes
    EXPECT_TRUE(reached.contains(page)) << fs::relative(page, repository)
                                        << " is not linked from docs/README.md, nor from a page that is";
  }
  EXPECT_GT(reached.size(), 40U);
}

TEST(Pages, no_link_is_dead) {
  int checked = 0;
  for (const fs::path& page : pages()) {
    for (const Link& link : links_of(page)) {
      const fs::path target = target_of(page, link);
      ++checked;
      ASSERT_TRUE(fs::exists(target)) << fs::relative(page, repository) << " links to " << link.file;
      if (link.anchor.empty() || target.extension() != ".md") continue;
      EXPECT_TRUE(anchors_of(target).contains(link.anchor))
          << fs::relative(page, repository) << " links to " << link.file << '#' << link.anchor
          << ", which is no heading";
    }
  }
  EXPECT_GT(checked, 150);
}

// Every procedure has a page that teaches it, with the command for its synthetic patient, and experts.
// `needle_insertion` contains the common rules.
TEST(Pages, every_procedure_has_a_teaching_page_a_patient_and_experts) {
  int checked = 0;
  for (const auto& entry : fs::directory_iterator(repository / "share/bodkin/procedures")) {
    const std::string name = entry.path().stem().string();
    if (name == "needle_insertion") continue;
    ++checked;
    const fs::path page = repository / "docs/procedures" / (name + ".md");
    ASSERT_TRUE(fs::exists(page)) << name;
    const std::string text = read_text(page);
    EXPECT_TRUE(text.find("bodkin case synthesize ") != std::string::npos ||
                text.find("bodkin points") != std::string::npos)
        << page << " names no patient to begin with";
    const std::string experts = read_text(repository / "share/bodkin/experts" / (name + ".csv"));
    EXPECT_GT(std::count(experts.begin(), experts.end(), '\n'), 60) << name << " has no simulated experts";
    EXPECT_NE(experts.find("bodkin case synthesize "), std::string::npos) << name << ": of which patient are they?";
  }
  EXPECT_GE(checked, 7);
}

TEST(Pages, every_file_that_a_page_names_exists) {
  // `src/forces/rail.h`, and `forces/rail.h` for short; what contains NAME or a pattern is no file.
  static const std::regex quoted(R"(`((?:[a-z_]+/)+[\w.-]+)`)");
  int checked = 0;
  for (const fs::path& page : pages()) {
    if (page.filename() == "CHANGELOG.md") continue;  // which names what there was
    for (const std::string& line : prose(page)) {
      for (std::sregex_iterator match(line.begin(), line.end(), quoted), end; match != end; ++match) {
        const fs::path named((*match)[1].str());
        const std::string top = named.begin()->string();
        const bool in_repository = fs::exists(repository / top);
        const bool in_src = fs::exists(repository / "src" / top) && named.extension() == ".h";
        if ((!in_repository && !in_src) || named.string().find("NAME") != std::string::npos || top == "build")
          continue;
        ++checked;
        const bool is_program = fs::exists((repository / named).string() + ".cpp");  // `bench/tick_bench`
        EXPECT_TRUE(is_program || fs::exists(repository / named) || fs::exists(repository / "src" / named))
            << fs::relative(page, repository) << " names " << named;
      }
    }
  }
  EXPECT_GT(checked, 50);
}

TEST(Pages, every_test_that_the_guide_for_contributors_names_exists) {
  static const std::regex quoted(R"(`([A-Z]\w+)\.(\w+)`)");
  std::string tests;
  for (const auto& entry : fs::recursive_directory_iterator(repository / "tests")) {
    if (entry.path().extension() == ".cpp") tests += read_text(entry.path());
  }
  const std::string guide = read_text(repository / "CONTRIBUTING.md");
  int checked = 0;
  for (std::sregex_iterator match(guide.begin(), guide.end(), quoted), end; match != end; ++match) {
    const std::string head = "(" + (*match)[1].str() + ", " + (*match)[2].str() + ")";
    ++checked;
    EXPECT_NE(tests.find(head), std::string::npos) << "CONTRIBUTING.md names " << match->str();
  }
  EXPECT_GE(checked, 5);
}

TEST(Pages, the_readme_links_the_map_and_the_guide_for_contributors) {
  const std::string readme = read_text(repository / "README.md");
  EXPECT_NE(readme.find("](docs/README.md)"), std::string::npos);
  EXPECT_NE(readme.find("](CONTRIBUTING.md)"), std::string::npos);
}

}  // namespace
