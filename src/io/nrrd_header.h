#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "anatomy/grid.h"

namespace bodkin::io {

// What NRRD calls the type of a voxel.
template <typename Voxel>
constexpr std::string_view nrrd_type() {
  if constexpr (std::is_same_v<Voxel, std::int16_t>) return "short";
  if constexpr (std::is_same_v<Voxel, std::uint16_t>) return "unsigned short";
  if constexpr (std::is_same_v<Voxel, std::uint8_t>) return "unsigned char";
}

// The header of a volume as Bodkin writes it: NRRD (teem.sourceforge.net/nrrd/format.html), attached voxels, gzip,
// little endian, LPS. Bodkin's own files have these fields, in this order and no others, so they can be read in this
// process by a strict reader; every other NRRD file is a foreign one, for the image worker.
struct NrrdHeader {
  std::string type;               // of a voxel, as NRRD names it: "short"
  std::array<int, 3> size{};      // voxels along i, j, k
  Mat3 steps = Mat3::Identity();  // columns: from a voxel to the next along i, j, k, LPS mm
  Vec3 origin = Vec3::Zero();     // centre of the first voxel, LPS mm
};

// The bytes of the header, with 17 digits for each number, up to the first voxel byte.
std::string nrrd_header_text(const NrrdHeader& header);

// A header and how long it is, bytes.
struct ParsedNrrdHeader {
  NrrdHeader header;
  std::size_t bytes = 0;
};

// The header with which `bytes` start, or nothing when they do not start as nrrd_header_text() writes it or when a
// number is not finite. Any bytes may be given; sizes are positive, otherwise unchecked.
std::optional<ParsedNrrdHeader> parse_nrrd_header(std::string_view bytes);

// No header that nrrd_header_text() writes is longer, bytes.
inline constexpr std::size_t longest_nrrd_header = 1024;

}  // namespace bodkin::io
