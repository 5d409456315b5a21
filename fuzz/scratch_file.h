#pragma once

#include <filesystem>
#include <string>
#include <system_error>

#include <unistd.h>

// A file for code that needs one rather than bytes; in shared memory, which costs no disk. Removed when the fuzzer
// ends, with SQLite's files beside it.
class ScratchFile {
 public:
  explicit ScratchFile(const std::string& name)
      : path_(std::string(std::filesystem::exists("/dev/shm") ? "/dev/shm" : "/tmp") + "/bodkin_fuzz_" +
              std::to_string(getpid()) + "_" + name) {}
  ~ScratchFile() {
    std::error_code ignored;
    for (const char* ending : {"", "-wal", "-shm", "-journal"}) std::filesystem::remove(path_ + ending, ignored);
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};
