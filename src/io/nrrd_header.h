#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "anatomy/grid.h"

namespace bodkin::io {

// NRRD's name of a voxel type.
template <typename Voxel>
constexpr std::string_view nrrd_type() {
  if constexpr (std::is_same_v<Voxel, std::int16_t>) return "short";
  if constexpr (std::is_same_v<Voxel, std::uint16_t>) return "unsigned short";
  if constexpr (std::is_same_v<Voxel, std::uint8_t>) return "unsigned char";
}

// The header of a volume written by Bodkin: NRRD (teem.sourceforge.net/nrrd/format.html), attached voxels, gzip,
// little endian, LPS. Bodkin's own files have these fields, in this order and no others, so they can be read in this
// process by a strict reader; every other NRRD file is foreign, and left to the image worker.
struct NrrdHeader {
  std::string type;               // of a voxel, in NRRD's notation: "short"
  std::array<int, 3> size{};      // voxels along i, j, k
  Mat3 steps = Mat3::Identity();  // columns: from a voxel to the next along i, j, k, LPS mm
  Vec3 origin = Vec3::Zero();     // centre of the first voxel, LPS mm
};

// The bytes of the header, with 17 digits for each number, up to the first voxel byte.
std::string nrrd_header_text(const NrrdHeader& header);

// A header and its length in bytes.
struct ParsedNrrdHeader {
  NrrdHeader header;
  std::size_t bytes = 0;
};

// The header at the start of `bytes`, or nothing when it is not in the form of nrrd_header_text() or when a number is
// not finite. Accepts any bytes; sizes are positive, otherwise unchecked.
std::optional<ParsedNrrdHeader> parse_nrrd_header(std::string_view bytes);

// Upper bound of the length of nrrd_header_text(), bytes.
inline constexpr std::size_t longest_nrrd_header = 1024;

}  // namespace bodkin::io
