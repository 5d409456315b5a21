#pragma once

#include <filesystem>

namespace bodkin::io {

// The folder of a person's patients, sessions and results: bodkin below XDG_DATA_HOME, or else ~/.local/share/bodkin.
// It need not exist yet.
std::filesystem::path data_folder();

}  // namespace bodkin::io
