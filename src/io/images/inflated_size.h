#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace bodkin::io {

// How many bytes the gzip or zlib stream that starts at byte `offset` of a file unpacks to, or nothing when it is
// damaged or cut off (its checksum is looked at). The bytes are thrown away, so this takes no memory however much a
// small file claims to hold; beyond `enough` bytes counting stops.
std::optional<std::uintmax_t> inflated_size(const std::filesystem::path& file, std::uintmax_t offset,
                                            std::uintmax_t enough);

}  // namespace bodkin::io
