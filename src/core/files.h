#pragma once

#include <filesystem>
#include <string_view>

namespace bodkin {

// Writes a whole file so that nobody ever sees half of it: beside it first, then renamed. Missing parent folders are
// made. Throws SystemError naming the file when that fails, and leaves nothing behind.
void write_file(const std::filesystem::path& file, std::string_view bytes);

}  // namespace bodkin
