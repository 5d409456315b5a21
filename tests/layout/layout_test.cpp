// The layout is the architecture; these tests keep it so (docs/architecture.md).
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
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

const std::map<std::string, int> levels = {
    {"core", 0},  {"anatomy", 1},    {"forces", 2},   {"fem", 2},      {"haptics", 2}, {"imaging", 3},
    {"io", 3},    {"simulation", 4}, {"patient", 4},  {"tracking", 4}, {"session", 5}, {"station", 6},
    {"study", 6}, {"training", 7},   {"scene", 7},    {"report", 8},   {"link", 8},    {"views", 8},
    {"app", 9},   {"cli", 9},        {"programs", 9}, {"python", 9}};

struct Include {
  fs::path file;
  int line;
  std::string target;  // what stands between the quotes or brackets
};

std::vector<fs::path> sources(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<Include> includes_of(const fs::path& file) {
  static const std::regex pattern(R"(^\s*#\s*include\s*["<]([^">]+)[">])");
  std::vector<Include> found;
  std::istringstream text(read_text(file));
  std::string line;
  for (int number = 1; std::getline(text, line); ++number) {
    std::smatch match;
    if (std::regex_search(line, match, pattern)) found.push_back({file, number, match[1]});
  }
  return found;
}

std::string module_of(const fs::path& file) {
  return fs::relative(file, repository / "src").begin()->string();
}

std::string where(const Include& include) {
  return fs::relative(include.file, repository).string() + ":" + std::to_string(include.line);
}

TEST(Layout, every_folder_of_src_is_a_module_with_a_level) {
  for (const auto& entry : fs::directory_iterator(repository / "src")) {
    EXPECT_TRUE(levels.contains(entry.path().filename().string())) << entry.path();
  }
}

// clang-tidy sees a module at once, in one file that includes its sources: it takes them for headers, and is silent
// about those that its filter does not name.
TEST(Layout, clang_tidy_speaks_of_every_module) {
  std::smatch filter;
  const std::string settings = read_text(repository / ".clang-tidy");
  ASSERT_TRUE(std::regex_search(settings, filter, std::regex("HeaderFilterRegex: '(.*)'")));
  const std::regex named(filter[1].str());
  for (const auto& [module, level] : levels)
    EXPECT_TRUE(std::regex_match("/somewhere/src/" + module + "/file.cpp", named)) << module;
}

TEST(Layout, includes_go_downwards) {
  int checked = 0;
  for (const fs::path& file : sources(repository / "src")) {
    const std::string module = module_of(file);
    for (const Include& include : includes_of(file)) {
      const std::string target = include.target.substr(0, include.target.find('/'));
      if (!levels.contains(target) || target == module) continue;
      ++checked;
      // Modules of one level do not use each other.
      EXPECT_LT(levels.at(target), levels.at(module))
          << where(include) << ": " << module << " includes " << include.target;
    }
  }
  EXPECT_GT(checked, 20);
}

// What a module declares is bodkin::MODULE; the names of core are bodkin's own. A name of another module is declared
// only ahead of its definition, in a block of its own.
TEST(Layout, a_module_has_one_namespace) {
  static const std::regex opening(R"((^|\n)namespace bodkin(::(\w+))?[\w:]* \{)");
  static const std::regex ahead(R"(namespace bodkin::\w+ \{\n((struct|class|enum class) \w+;\n)+\})");
  int checked = 0;
  for (const fs::path& file : sources(repository / "src")) {
    const std::string module = module_of(file);
    const std::string text = std::regex_replace(read_text(file), ahead, "");
    for (std::sregex_iterator found(text.begin(), text.end(), opening), end; found != end; ++found) {
      ++checked;
      const std::string name = (*found)[3];
      if (module == "core") {
        EXPECT_FALSE(levels.contains(name)) << file << ": namespace bodkin::" << name;
      } else {
        EXPECT_EQ(name, module) << file << ": namespace bodkin::" << name << ", expected bodkin::" << module;
      }
    }
  }
  EXPECT_GT(checked, 300);
}

TEST(Layout, heavy_headers_stay_in_source_files_of_the_modules_that_own_them) {
  struct Rule {
    std::regex header;
    std::regex owner;  // path below src/
  };
  const std::vector<Rule> rules = {
      {std::regex("^(itk|gdcm|vnl).*"), std::regex(R"(^(io/images|patient/from_ct)/.*\.cpp$)")},
      {std::regex("^libxml/.*"), std::regex(R"(^io/(mesh/)?[^/]*\.cpp$)")},
      {std::regex("^nlohmann/json\\.hpp$"),
       std::regex(
           R"(^((io|patient|tracking|session|station|study|training|report|link|app|programs|cli)/.*|haptics/drivers/haply_(inventory|events))\.cpp$)")},
      {std::regex("^simdjson\\.h$"), std::regex(R"(^haptics/drivers/haply_messages\.cpp$)")},
      {std::regex("^SQLiteCpp/.*|^sqlite3.*"), std::regex(R"(^(session|training/store)/.*\.cpp$)")},
      {std::regex("^pybind11/.*"), std::regex(R"(^python/.*\.cpp$)")},
      {std::regex("^pqxx/.*"), std::regex(R"(^training/store/postgresql/.*\.cpp$)")},
      {std::regex("^CLI/.*"), std::regex(R"(^cli/.*\.cpp$)")},
      {std::regex("^boost/(asio|beast)/.*"),
       std::regex(
           R"(^(haptics/drivers/haply_connection|link/(closing_messages|server|client)|report/teacher/http_server)\.cpp$)")},
      {std::regex("^(ceres|boost/math)/.*"), std::regex(R"(^study/fitting/.*\.cpp$)")},
      {std::regex("^boost/(?!asio/|beast/|math/).*"), std::regex("^$")},  // nor these
      {std::regex("^(metis|cblas.*|lapacke)\\.h$"),
       std::regex(R"(^fem/solid/(nested_dissection|dense_kernels)\.cpp$)")},
      {std::regex("^(cairo|png)\\.h$"), std::regex(R"(^imaging/.*\.cpp$)")},
      {std::regex("^libdeflate\\.h$"), std::regex(R"(^io/nrrd_(reader|writer)\.cpp$)")},
      {std::regex("^(fmt|spdlog)/.*"), std::regex(R"(.*\.cpp$)")},
      {std::regex("^CGAL/.*"), std::regex(R"(^programs/mesher/label_mesher\.cpp$)")},
      {std::regex("^Q[A-Z].*"), std::regex(R"(^(app/(?!models/)|views/(?!open_case)).*)")},
      {std::regex("^vtk.*"), std::regex(R"(^(scene|patient/warp)/.*)")},
      {std::regex("^(GL|X11)/.*"), std::regex(R"(^scene/graphics_card/.*\.cpp$)")},
      {std::regex("^opencv2/.*"), std::regex(R"(^tracking/.*\.cpp$)")},
      {std::regex("^jpeglib\\.h$"), std::regex(R"(^tracking/jpeg_file\.cpp$)")},
      {std::regex("^igtl.*"), std::regex("^$")},  // no module owns it
      {std::regex("^Eigen/(SVD|Sparse|Eigenvalues|Dense|QR|LU)$"), std::regex(R"(.*\.cpp$)")},
  };
  for (const fs::path& file : sources(repository / "src")) {
    const std::string below = fs::relative(file, repository / "src").string();
    for (const Include& include : includes_of(file)) {
      for (const Rule& rule : rules) {
        if (!std::regex_match(include.target, rule.header)) continue;
        EXPECT_TRUE(std::regex_match(below, rule.owner)) << where(include) << " includes " << include.target;
      }
    }
  }
}

// Functions of the C library, and rotations of Eigen's that call them, have other bits on another processor. What is
// computed from them here is shown only, or was read from a device and is in the session.
TEST(Layout, what_a_session_repeats_calls_no_function_that_depends_on_the_processor) {
  const std::set<std::string> exempt = {"haptics/calibration.cpp",   "haptics/drivers/spacemouse.cpp",
                                        "station/device_choice.cpp", "station/live_scan.cpp",
                                        "station/scan_thread.cpp",   "fem/display_field.cpp"};
  const std::regex pattern(
      R"(std::(a?(sin|cos|tan)h?|atan2|exp[2m1]*|log(2|10|1p)?|pow|cbrt|hypot)\(|AngleAxis|\.slerp\(|angularDistance)");
  for (const char* module : {"core", "anatomy", "forces", "fem", "haptics", "simulation", "session", "station"}) {
    for (const fs::path& file : sources(repository / "src" / module)) {
      if (exempt.contains(fs::relative(file, repository / "src").string())) continue;
      std::istringstream text(read_text(file));
      std::string line;
      for (int number = 1; std::getline(text, line); ++number) {
        EXPECT_FALSE(std::regex_search(line, pattern)) << fs::relative(file, repository).string() << ":" << number
                                                       << ": take core/repeatable.h or core/rotation.h";
      }
    }
  }
}

TEST(Layout, a_file_holds_one_idea) {
  for (const char* folder : {"src", "tests", "bench", "fuzz"}) {
    for (const fs::path& file : sources(repository / folder)) {
      const std::string text = read_text(file);
      EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 450) << fs::relative(file, repository);
    }
  }
}

TEST(Layout, no_module_holds_more_than_13_percent_of_the_lines) {
  std::map<std::string, std::ptrdiff_t> lines;
  std::ptrdiff_t all = 0;
  for (const fs::path& file : sources(repository / "src")) {
    const std::string text = read_text(file);
    const auto count = std::count(text.begin(), text.end(), '\n');
    lines[module_of(file)] += count;
    all += count;
  }
  for (const auto& [module, count] : lines)
    EXPECT_LE(100 * count, 13 * all) << module << ": " << count << " of " << all;
}

TEST(Layout, every_public_header_compiles_first_in_its_own_source_file) {
  for (const fs::path& file : sources(repository / "src")) {
    fs::path header = file;
    header.replace_extension(".h");
    if (file.extension() != ".cpp" || !fs::exists(header)) continue;
    const auto found = includes_of(file);
    ASSERT_FALSE(found.empty()) << file;
    EXPECT_EQ(found.front().target, fs::relative(header, repository / "src").string()) << where(found.front());
  }
}

TEST(Layout, a_model_has_a_header_a_source_a_test_and_a_page_of_one_name) {
  int models = 0;
  for (const auto& page : fs::directory_iterator(repository / "docs" / "models")) {
    if (page.path().extension() != ".md") continue;
    const std::string name = page.path().stem();
    ++models;
    const std::string module = fs::exists(repository / "src/fem" / (name + ".h")) ? "fem" : "forces";
    EXPECT_TRUE(fs::exists(repository / "src" / module / (name + ".h"))) << name;
    EXPECT_TRUE(fs::exists(repository / "src" / module / (name + ".cpp"))) << name;
    EXPECT_TRUE(fs::exists(repository / "tests" / module / (name + "_test.cpp"))) << name;
  }
  EXPECT_GE(models, 2);
}

// docs/adding-a-force-model.md numbers the files that a new model touches, with NAME for its name.
TEST(Layout, a_force_model_touches_at_most_five_files) {
  const std::string page = read_text(repository / "docs/adding-a-force-model.md");
  const std::string list = page.substr(0, page.find("```"));
  static const std::regex pattern(R"(\d\. `([^`]+)`)");
  std::vector<std::string> files;
  for (std::sregex_iterator match(list.begin(), list.end(), pattern), last; match != last; ++match)
    files.push_back((*match)[1]);
  EXPECT_EQ(files.size(), 5U) << "the page lists them all";
  EXPECT_EQ(std::count(files.begin(), files.end(), "src/anatomy/resistance_settings.h"), 1);
  for (const char* name : {"fracture", "surface_proxy", "tracking_wall", "volume_proxy"}) {
    for (const std::string& file : files) {
      const std::string path = std::regex_replace(file, std::regex("NAME"), name);
      ASSERT_TRUE(fs::exists(repository / path)) << path;
      EXPECT_NE(read_text(repository / path).find(name), std::string::npos) << path << " does not mention " << name;
    }
  }
  // Tick, recordings, tables and plots contain no model's name.
  for (const char* folder : {"src/session", "src/station", "src/app", "src/cli"}) {
    for (const fs::path& file : sources(repository / folder)) {
      for (const char* name : {"spring_damper_wall", "depth_profile", "three_component", "volume_proxy"})
        EXPECT_EQ(read_text(file).find("forces/" + std::string(name)), std::string::npos)
            << file << " knows " << name;
    }
  }
}

TEST(Layout, a_subcommand_has_a_test_of_its_name) {
  for (const fs::path& file : sources(repository / "src" / "cli")) {
    const std::string name = file.stem();
    const bool command = read_text(file).find("void add_" + name + "_command(") != std::string::npos;
    if (!command || file.extension() != ".cpp") continue;
    EXPECT_TRUE(fs::exists(repository / "tests/cli" / (name + "_test.cpp"))) << name;
  }
}

}  // namespace
