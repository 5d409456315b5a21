#pragma once

#include <filesystem>

#include <sys/types.h>

namespace bodkin::io {

// An empty folder of this process in the system's temporary folder, removed at the end of its life. Its name contains
// the number of the process: creating one removes the folders of processes that no longer run.
class TemporaryFolder {
 public:
  TemporaryFolder();  // throws SystemError
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// Removes the temporary folders of a process that has ended.
void remove_temporary_folders(pid_t owner) noexcept;

}  // namespace bodkin::io
