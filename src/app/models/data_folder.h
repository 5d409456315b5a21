#pragma once

#include <filesystem>

namespace bodkin::app {

// Where the person's patients and sessions are kept: bodkin below XDG_DATA_HOME, or else ~/.local/share/bodkin. It
// need not exist yet.
std::filesystem::path data_folder();

// A new session file of today in the data folder, "sessions/2026-11-23 Synthetic torso 1.bodkin". Its folder is made.
// Throws SystemError when that cannot be.
std::filesystem::path new_session_file(const std::string& patient);

}  // namespace bodkin::app
