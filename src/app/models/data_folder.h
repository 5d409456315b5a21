#pragma once

#include <filesystem>

namespace bodkin::app {

// The folder of the user's patients and sessions: bodkin below XDG_DATA_HOME, or else ~/.local/share/bodkin. It need
// not exist yet.
std::filesystem::path data_folder();

// A new session file of today in the data folder, "sessions/2026-11-23 Synthetic torso 1.bodkin". Creates its folder;
// throws SystemError if it cannot.
std::filesystem::path new_session_file(const std::string& patient);

}  // namespace bodkin::app
