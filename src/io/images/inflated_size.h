#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace bodkin::io {

// The unpacked size in bytes of the gzip or zlib stream that starts at byte `offset` of a file, or nothing when it is
// damaged or truncated (its checksum is verified). The bytes are discarded, so this takes no memory however much a
// small file claims to contain; counting stops beyond `enough` bytes.
std::optional<std::uintmax_t> inflated_size(const std::filesystem::path& file, std::uintmax_t offset,
                                            std::uintmax_t enough);

}  // namespace bodkin::io
