#pragma once

#include <filesystem>

#include <sys/types.h>

namespace bodkin::io {

// A folder under construction. It is built next to its final place under the name `final.partial-PID` and appears
// there in one step, by renaming, so that no incomplete folder is ever visible. An unfinished one is removed.
class PartialFolder {
 public:
  // Throws InputError when `final` exists and may not be replaced, is not a case folder, or has no parent folder.
  // Removes the remains of programs that no longer run.
  PartialFolder(const std::filesystem::path& final, bool overwrite);
  ~PartialFolder();
  PartialFolder(const PartialFolder&) = delete;
  PartialFolder& operator=(const PartialFolder&) = delete;

  const std::filesystem::path& path() const { return partial_; }
  // Moves the folder to its final place, replacing an existing one. Throws SystemError.
  void finish();

 private:
  std::filesystem::path final_, partial_;
};

// The name under which process `owner` builds `final`.
std::filesystem::path partial_name(const std::filesystem::path& final, pid_t owner);

}  // namespace bodkin::io
