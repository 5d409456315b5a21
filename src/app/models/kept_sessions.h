#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bodkin::app {

// A session file that was found, without what is in it.
struct KeptSession {
  std::filesystem::path file;
  std::string name;      // of the file, without its ending
  std::string modified;  // "2026-11-23 14:05", local time
  double size = 0.0;     // MB
};

// The session files of a folder, newest first; none where there is no such folder.
std::vector<KeptSession> kept_sessions(const std::filesystem::path& folder);

// Of these the newest that a crash has cut off and that is not among `forgotten`; empty: none. Looks at the newest
// twenty only. What is no session is passed over.
std::filesystem::path cut_off_session(const std::vector<KeptSession>& sessions,
                                      const std::vector<std::filesystem::path>& forgotten);

}  // namespace bodkin::app
