#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bodkin::app {

// A session file in a folder, without its content.
struct KeptSession {
  std::filesystem::path file;
  std::string name;      // of the file, without its extension
  std::string modified;  // "2026-11-23 14:05", local time
  double size = 0.0;     // MB
};

// The session files of a folder, newest first; none if the folder does not exist.
std::vector<KeptSession> kept_sessions(const std::filesystem::path& folder);

// The newest of these that was truncated by a crash and is not among `forgotten`; empty: none. Examines only the
// newest twenty. Skips files that are no sessions.
std::filesystem::path cut_off_session(const std::vector<KeptSession>& sessions,
                                      const std::vector<std::filesystem::path>& forgotten);

}  // namespace bodkin::app
