#pragma once

#include <filesystem>

#include <sys/types.h>

namespace bodkin::io {

// A folder in the making. It is built next to its final place under the name `final.partial-PID` and appears there in
// one step, by renaming, so that no half-written folder is ever visible. What is not finished is removed.
class PartialFolder {
 public:
  // Refuses (InputError) when `final` exists and may not be replaced, is no case folder, or has no parent folder.
  // Removes what programs that no longer run have left behind.
  PartialFolder(const std::filesystem::path& final, bool overwrite);
  ~PartialFolder();
  PartialFolder(const PartialFolder&) = delete;
  PartialFolder& operator=(const PartialFolder&) = delete;

  const std::filesystem::path& path() const { return partial_; }
  // Moves the folder to its final place, replacing what was there. Throws SystemError.
  void finish();

 private:
  std::filesystem::path final_, partial_;
};

// The name under which process `owner` builds `final`.
std::filesystem::path partial_name(const std::filesystem::path& final, pid_t owner);

}  // namespace bodkin::io
