#pragma once

#include <filesystem>
#include <span>
#include <string_view>

namespace bodkin {

// Writes a whole file atomically: to a temporary file in the same folder, which is then renamed. Missing parent
// folders are made. Throws SystemError naming the file when that fails, and leaves nothing behind.
void write_file(const std::filesystem::path& file, std::string_view bytes);
// The same of pieces, one after another.
void write_file(const std::filesystem::path& file, std::span<const std::string_view> pieces);

}  // namespace bodkin
