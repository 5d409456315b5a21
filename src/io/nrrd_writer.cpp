#include "io/nrrd_writer.h"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <memory>
#include <new>
#include <string>
#include <string_view>

#include <fcntl.h>
#include <fmt/format.h>
#include <libdeflate.h>
#include <unistd.h>
#include <zlib.h>

#include "core/error.h"
#include "io/gzip_stream.h"
#include "io/nrrd_header.h"

namespace bodkin::io {
namespace {

static_assert(std::endian::native == std::endian::little, "the header says that voxels are little endian");

// Level 1 packs a CT nearly as well as level 6, four times as fast.
constexpr const char* gzip_mode = "wb1";
constexpr std::size_t chunk = 16U << 20U;  // bytes per call; gzwrite takes at most an unsigned int

NrrdHeader header_of(const anatomy::Grid& grid, std::string_view type) {
  return {std::string(type), grid.size, grid.direction * grid.spacing.asDiagonal(), grid.origin};
}

[[noreturn]] void fail_to_write(const std::filesystem::path& file) {
  throw SystemError(fmt::format("{} cannot be written: {}", file.string(), std::strerror(errno)));
}

struct FreeCompressor {
  void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
};

}  // namespace

template <typename Voxel>
void write_nrrd(const anatomy::Volume<Voxel>& volume, const std::filesystem::path& file) {
  const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) fail_to_write(file);
  const std::string header = nrrd_header_text(header_of(volume.grid, nrrd_type<Voxel>()));
  const bool header_written =
      ::write(descriptor, header.data(), header.size()) == static_cast<ssize_t>(header.size());
  GzipStream stream(header_written ? gzdopen(descriptor, gzip_mode) : nullptr);
  if (!stream) {
    close(descriptor);
    fail_to_write(file);
  }
  const char* bytes = reinterpret_cast<const char*>(volume.voxels.data());
  for (std::size_t left = volume.voxels.size() * sizeof(Voxel); left > 0;) {
    const auto count = static_cast<unsigned>(std::min(left, chunk));
    if (gzwrite(stream.get(), bytes, count) != static_cast<int>(count)) fail_to_write(file);
    bytes += count;
    left -= count;
  }
  if (gzclose(stream.release()) != Z_OK) fail_to_write(file);
}

template <typename Voxel>
std::vector<std::uint8_t> nrrd_bytes(const anatomy::Volume<Voxel>& volume) {
  const std::string header = nrrd_header_text(header_of(volume.grid, nrrd_type<Voxel>()));
  const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(libdeflate_alloc_compressor(1));
  if (!compressor) throw std::bad_alloc();
  const std::size_t length = volume.voxels.size() * sizeof(Voxel);
  std::vector<std::uint8_t> bytes(header.begin(), header.end());
  bytes.resize(header.size() + libdeflate_gzip_compress_bound(compressor.get(), length));
  const std::size_t packed = libdeflate_gzip_compress(compressor.get(), volume.voxels.data(), length,
                                                      &bytes[header.size()], bytes.size() - header.size());
  bytes.resize(header.size() + packed);
  bytes.shrink_to_fit();
  return bytes;
}

template void write_nrrd(const anatomy::CtVolume& volume, const std::filesystem::path& file);
template void write_nrrd(const anatomy::LabelVolume& volume, const std::filesystem::path& file);
template void write_nrrd(const anatomy::TissueVolume& volume, const std::filesystem::path& file);
template std::vector<std::uint8_t> nrrd_bytes(const anatomy::LabelVolume& volume);
template std::vector<std::uint8_t> nrrd_bytes(const anatomy::TissueVolume& volume);

}  // namespace bodkin::io
