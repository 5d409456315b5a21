#pragma once

#include <filesystem>

namespace bodkin::io {

// Where a person's patients, sessions and results are kept: bodkin below XDG_DATA_HOME, or else
// ~/.local/share/bodkin. It need not exist yet.
std::filesystem::path data_folder();

}  // namespace bodkin::io
