#pragma once

#include <filesystem>
#include <span>
#include <string_view>

namespace bodkin {

// Writes a whole file atomically: to a temporary file in the same folder, which is then renamed. Creates missing
// parent folders. On failure throws SystemError naming the file, and leaves nothing behind.
void write_file(const std::filesystem::path& file, std::string_view bytes);
// Writes the pieces one after another into one file, atomically.
void write_file(const std::filesystem::path& file, std::span<const std::string_view> pieces);

}  // namespace bodkin
