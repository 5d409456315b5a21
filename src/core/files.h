#pragma once

#include <filesystem>
#include <string_view>

namespace bodkin {

// Writes a whole file atomically: to a temporary file in the same folder, which is then renamed. Missing parent
// folders are made. Throws SystemError naming the file when that fails, and leaves nothing behind.
void write_file(const std::filesystem::path& file, std::string_view bytes);

}  // namespace bodkin
