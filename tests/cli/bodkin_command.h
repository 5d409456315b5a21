#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iostream>
#include <iterator>
#include <set>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>
#include <wordexp.h>

#include "cli/program.h"

namespace bodkin_test {

struct Outcome {
  int exit_code = -1;
  std::string output;  // standard output
  std::string errors;  // standard error

  std::string text() const { return output + errors; }
};

inline std::ptrdiff_t lines_of(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n');
}

inline std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

// Shell commands of run_bodkin() before the program.
inline std::string& before_program() {
  static std::string words;
  return words;
}

// Runs the bodkin command that was built, in `folder`.
inline Outcome run_bodkin(const std::filesystem::path& folder, const std::string& arguments) {
  const std::filesystem::path errors =
      std::filesystem::temp_directory_path() / ("bodkin_errors_" + std::to_string(getpid()));
  const std::string command = "cd '" + folder.string() + "' && " + before_program() +
                              "'" BODKIN_BUILD "/bin/bodkin' " + arguments + " 2> '" + errors.string() + "'";
  FILE* pipe = popen(command.c_str(), "r");
  Outcome outcome;
  char block[4096];
  for (std::size_t n = 0; (n = fread(block, 1, sizeof block, pipe)) > 0;) outcome.output.append(block, n);
  const int status = pclose(pipe);
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  outcome.errors = content_of(errors);
  std::filesystem::remove(errors);
  return outcome;
}

// The same as run_bodkin() in a copy of this process instead of a new one, which takes a hundredth of the time: for
// the thousands of command lines that end in a sentence.
inline Outcome run_bodkin_in_copy(const std::filesystem::path& folder, const std::string& arguments) {
  const std::filesystem::path temporary = std::filesystem::temp_directory_path();
  const std::filesystem::path output = temporary / ("bodkin_output_" + std::to_string(getpid()));
  const std::filesystem::path errors = temporary / ("bodkin_errors_" + std::to_string(getpid()));
  wordexp_t words{};
  EXPECT_EQ(wordexp(("bodkin " + arguments).c_str(), &words, WRDE_NOCMD | WRDE_UNDEF), 0);
  fflush(nullptr);
  const pid_t copy = fork();
  if (copy == 0) {
    const bool ready = dup2(open(output.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600), STDOUT_FILENO) >= 0 &&
                       dup2(open(errors.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600), STDERR_FILENO) >= 0 &&
                       chdir(folder.c_str()) == 0;
    const int exit_code = ready ? bodkin::cli::run_program(static_cast<int>(words.we_wordc), words.we_wordv) : -1;
    std::cout.flush();
    fflush(nullptr);
    _exit(exit_code);
  }
  wordfree(&words);
  Outcome outcome;
  int status = -1;
  waitpid(copy, &status, 0);
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  outcome.output = content_of(output);
  outcome.errors = content_of(errors);
  std::filesystem::remove(output);
  std::filesystem::remove(errors);
  return outcome;
}

// A separate folder for the tests of a file, removed with its contents.
class BodkinCommand : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::filesystem::temp_directory_path() / ("bodkin_commands_" + std::to_string(getpid()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    // This user's calibrations must not affect a test.
    setenv("XDG_CONFIG_HOME", (folder_.string() + "_config").c_str(), 1);
  }
  static void TearDownTestSuite() {
    std::filesystem::remove_all(folder_);
    std::filesystem::remove_all(folder_.string() + "_config");
  }

  static Outcome bodkin(const std::string& arguments) { return run_bodkin(folder_, arguments); }
  static std::string text_of(const std::string& file) { return content_of(folder_ / file); }
  static void write(const std::string& name, const std::string& bytes) {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
  }
  // All contents of the folder, including subfolders.
  static std::set<std::string> listing() {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_))
      names.insert(entry.path().string());
    return names;
  }

  static inline std::filesystem::path folder_;
};

// A system without memory locking, even for the superuser, while this lives.
class LittleLockedMemory {
 public:
  LittleLockedMemory() {
    before_program() = "ulimit -l 64 && ";
    if (geteuid() == 0) before_program() += "setpriv --bounding-set=-ipc_lock,-sys_resource ";
  }
  ~LittleLockedMemory() { before_program().clear(); }
  LittleLockedMemory(const LittleLockedMemory&) = delete;
  LittleLockedMemory& operator=(const LittleLockedMemory&) = delete;
};

// A synthetic patient, "patient" in a separate folder, created once for all tests of this process, because it takes
// seconds.
struct SyntheticPatient {
  SyntheticPatient(const std::string& name, std::initializer_list<const char*> commands)
      : folder(std::filesystem::temp_directory_path() / ("bodkin_" + name + "_" + std::to_string(getpid()))) {
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    for (const char* command : commands) {
      made = run_bodkin(folder, command);
      if (made.exit_code != 0) break;
    }
  }
  ~SyntheticPatient() {
    std::error_code ignored;  // what cannot be removed is in the folder of temporary files
    std::filesystem::remove_all(folder, ignored);
  }
  SyntheticPatient(const SyntheticPatient&) = delete;
  SyntheticPatient& operator=(const SyntheticPatient&) = delete;

  void copy_to(const std::filesystem::path& other) const {
    std::filesystem::copy(folder / "patient", other / "patient", std::filesystem::copy_options::recursive);
  }

  std::filesystem::path folder;
  Outcome made;
};

// The same as BodkinCommand with a copy of a small synthetic patient in its folder, "patient".
class PatientCommand : public BodkinCommand {
 protected:
  static void SetUpTestSuite() {
    BodkinCommand::SetUpTestSuite();
    static const SyntheticPatient original("patient", {"--quiet case synthesize lumbar patient --spacing 1.5"});
    made_ = original.made;
    if (made_.exit_code == 0) original.copy_to(folder_);
  }
  void SetUp() override { ASSERT_EQ(made_.exit_code, 0) << made_.errors; }

  static std::string patient() { return (folder_ / "patient").string(); }

  static inline Outcome made_;
};

}  // namespace bodkin_test
