#include "io/nrrd_reader.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <libdeflate.h>

#include "core/error.h"
#include "io/image_grid.h"
#include "io/nrrd_header.h"

namespace bodkin::io {
namespace {

// Of a gzip stream (RFC 1952), bytes: head and tail; the tail ends with the unpacked length modulo 2^32.
constexpr std::size_t gzip_frame = 18;
constexpr std::size_t gzip_length = 4;
// A deflate stream (RFC 1951) decompresses to at most this many times its length: 258 bytes from two bits.
constexpr double most_inflation = 1032.0;
// Voxels that cannot be packed are stored, with 5 bytes for each block; a block of zlib holds at least 4 kB.
constexpr double most_growth = 1.002;
constexpr double growth_of_any = 1024.0;  // bytes

struct FreeDecompressor {
  void operator()(libdeflate_decompressor* decompressor) const { libdeflate_free_decompressor(decompressor); }
};

[[noreturn]] void refuse_packed(const std::string& name, std::string_view fault) {
  throw InputError(fmt::format("{}: the packed voxels {}; restore the file or make the case again", name, fault));
}

// The next `size` bytes of an open file.
std::vector<std::uint8_t> read_bytes(std::ifstream& stream, std::size_t size, const std::string& name) {
  std::vector<std::uint8_t> bytes(size);
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (static_cast<std::size_t>(stream.gcount()) != size) {
    throw InputError(fmt::format("{}: the file cannot be read to its end", name));
  }
  return bytes;
}

// The compressed length must be possible for `unpacked` bytes, and the stream must state that number.
void require_packed_length(const std::uint8_t* tail, std::size_t packed, std::size_t unpacked,
                           const std::string& name) {
  const auto length = static_cast<double>(unpacked);
  if (static_cast<double>(packed) > length * most_growth + growth_of_any)
    refuse_packed(name, "are followed by other bytes");
  std::uint32_t claimed = 0;
  std::memcpy(&claimed, tail, gzip_length);  // little endian, as nrrd_writer.cpp asserts of this machine
  if (claimed != static_cast<std::uint32_t>(unpacked)) {
    refuse_packed(name, "are truncated or damaged, or are not as many as the header declares");
  }
}

anatomy::Grid grid_of_header(const NrrdHeader& header, const std::string& name) {
  anatomy::Grid grid;
  grid.size = header.size;
  grid.origin = header.origin;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    // In the order in which teem computes it, for the same bits: a sum of squares, then a factor.
    const Vec3 step = header.steps.col(axis);
    const double spacing = std::sqrt(step.x() * step.x() + step.y() * step.y() + step.z() * step.z());
    grid.spacing[axis] = spacing;
    grid.direction.col(axis) = step * (1.0 / spacing);
  }
  return clean_grid(grid, name);
}

// Unpacks `packed` into the whole of `voxels`.
template <typename Voxel>
void unpack(std::span<const std::uint8_t> packed, std::vector<Voxel>& voxels, const std::string& name) {
  const std::unique_ptr<libdeflate_decompressor, FreeDecompressor> decompressor(libdeflate_alloc_decompressor());
  if (!decompressor) throw std::bad_alloc();
  const std::size_t expected = voxels.size() * sizeof(Voxel);
  std::size_t read = 0, written = 0;
  const libdeflate_result result = libdeflate_gzip_decompress_ex(decompressor.get(), packed.data(), packed.size(),
                                                                 voxels.data(), expected, &read, &written);
  if (result == LIBDEFLATE_INSUFFICIENT_SPACE || (result == LIBDEFLATE_SUCCESS && written != expected)) {
    refuse_packed(name, "are not as many as the header declares");
  }
  if (result != LIBDEFLATE_SUCCESS) refuse_packed(name, "are truncated or damaged");
  if (read != packed.size()) refuse_packed(name, "are followed by other bytes");
}

// The grid declared by a header, after checking all its claims against the `packed_length` bytes behind it, the last
// of which are `tail`.
anatomy::Grid checked_grid(const NrrdHeader& header, std::size_t voxel_bytes, std::size_t packed_length,
                           const std::uint8_t* tail, const std::string& name) {
  require_plausible_size(name, {header.size.begin(), header.size.end()}, voxel_bytes,
                         static_cast<double>(packed_length) * most_inflation);
  anatomy::Grid grid = grid_of_header(header, name);
  require_packed_length(tail, packed_length, grid.voxel_count() * voxel_bytes, name);
  return grid;
}

template <typename Voxel>
std::optional<ParsedNrrdHeader> header_in(std::string_view head) {
  std::optional<ParsedNrrdHeader> parsed = parse_nrrd_header(head.substr(0, longest_nrrd_header));
  if (parsed && parsed->header.type != nrrd_type<Voxel>()) parsed.reset();
  return parsed;
}

}  // namespace

template <typename Voxel>
std::optional<anatomy::Volume<Voxel>> read_nrrd(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::ifstream stream(file, std::ios::binary);
  std::string head(longest_nrrd_header, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  const std::optional<ParsedNrrdHeader> parsed = header_in<Voxel>(head);
  if (!parsed) return std::nullopt;

  // All of the header's claims are checked before memory is allocated.
  stream.clear();
  stream.seekg(0, std::ios::end);
  const std::size_t length = static_cast<std::size_t>(stream.tellg());
  if (length < parsed->bytes + gzip_frame) refuse_packed(name, "are truncated or damaged");
  const std::size_t packed_length = length - parsed->bytes;
  std::uint8_t tail[gzip_length];
  stream.seekg(-static_cast<std::streamoff>(gzip_length), std::ios::end);
  stream.read(reinterpret_cast<char*>(tail), gzip_length);
  anatomy::Volume<Voxel> volume;
  volume.grid = checked_grid(parsed->header, sizeof(Voxel), packed_length, tail, name);

  stream.seekg(static_cast<std::streamoff>(parsed->bytes));
  const std::vector<std::uint8_t> packed = read_bytes(stream, packed_length, name);
  volume.voxels.resize(volume.grid.voxel_count());
  unpack<Voxel>(packed, volume.voxels, name);
  return volume;
}

template <typename Voxel>
std::optional<anatomy::Volume<Voxel>> parse_nrrd(std::span<const std::uint8_t> bytes, const std::string& name) {
  const std::optional<ParsedNrrdHeader> parsed =
      header_in<Voxel>({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  if (!parsed) return std::nullopt;
  if (bytes.size() < parsed->bytes + gzip_frame) refuse_packed(name, "are truncated or damaged");
  const std::span<const std::uint8_t> packed = bytes.subspan(parsed->bytes);
  anatomy::Volume<Voxel> volume;
  volume.grid = checked_grid(parsed->header, sizeof(Voxel), packed.size(), packed.last(gzip_length).data(), name);
  volume.voxels.resize(volume.grid.voxel_count());
  unpack<Voxel>(packed, volume.voxels, name);
  return volume;
}

template std::optional<anatomy::CtVolume> read_nrrd(const std::filesystem::path& file);
template std::optional<anatomy::LabelVolume> read_nrrd(const std::filesystem::path& file);
template std::optional<anatomy::TissueVolume> read_nrrd(const std::filesystem::path& file);
template std::optional<anatomy::LabelVolume> parse_nrrd(std::span<const std::uint8_t> bytes, const std::string& name);
template std::optional<anatomy::TissueVolume> parse_nrrd(std::span<const std::uint8_t> bytes,
                                                         const std::string& name);

}  // namespace bodkin::io
