// Inner loops that are compiled for several processors (BODKIN_PROCESSOR_CLONES) have their versions in the program:
// a compiler may silently omit them, and everything still works, at half the speed.
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "tests/sanitized.h"
#include <gtest/gtest.h>

namespace bodkin_test {
namespace {

namespace fs = std::filesystem;

// The names of the functions that are marked in the sources of these modules.
std::set<std::string> marked_functions() {
  std::set<std::string> names;
  const std::regex marked(R"(\nBODKIN_PROCESSOR_CLONES\n[^(]*?(\w+)\()");
  for (const char* module : {"fem", "imaging"}) {
    for (const auto& file : fs::recursive_directory_iterator(fs::path(BODKIN_REPOSITORY) / "src" / module)) {
      if (file.path().extension() != ".cpp") continue;
      std::stringstream text;
      text << std::ifstream(file.path()).rdbuf();
      const std::string source = text.str();
      for (std::sregex_iterator i(source.begin(), source.end(), marked), end; i != end; ++i) names.insert((*i)[1]);
    }
  }
  return names;
}

std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string output;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe.get()))
    output.append(buffer.data(), count);
  return output;
}

TEST(ProcessorVersions, are_in_the_program) {
  if (bodkin::sanitized) GTEST_SKIP() << "the sanitizers' builds have the plain version alone";
#if !defined(__x86_64__)
  GTEST_SKIP() << "only x86-64 has versions";
#endif
  std::set<std::string> found;
  std::istringstream symbols(output_of("nm '" BODKIN_BUILD "/bin/bodkin'"));
  for (std::string line; std::getline(symbols, line);)
    if (line.find(".avx2") != std::string::npos) found.insert(line);
  ASSERT_FALSE(found.empty()) << "nm (Debian: binutils) finds no function for AVX2 in the program";
  const std::set<std::string> marked = marked_functions();
  EXPECT_GE(marked.size(), 20U);
  for (const std::string& name : marked) {
    const std::string mangled = std::to_string(name.size()) + name;
    EXPECT_TRUE(std::ranges::any_of(
        found, [&mangled](const std::string& symbol) { return symbol.find(mangled) != std::string::npos; }))
        << name << " has no version for AVX2";
  }
}

}  // namespace
}  // namespace bodkin_test
