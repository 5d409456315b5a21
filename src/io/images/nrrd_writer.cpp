#include "io/images/nrrd_writer.h"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <memory>
#include <type_traits>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <zlib.h>

#include "core/error.h"
#include "io/images/gzip_stream.h"

namespace bodkin {
namespace {

static_assert(std::endian::native == std::endian::little, "the header says that voxels are little endian");

// Level 1 packs a CT nearly as well as level 6, four times as fast.
constexpr const char* gzip_mode = "wb1";
constexpr std::size_t chunk = 16U << 20U;  // bytes per call; gzwrite takes at most an unsigned int

template <typename Voxel>
constexpr const char* type_name() {
  if constexpr (std::is_same_v<Voxel, std::int16_t>) return "short";
  if constexpr (std::is_same_v<Voxel, std::uint16_t>) return "unsigned short";
  if constexpr (std::is_same_v<Voxel, std::uint8_t>) return "unsigned char";
}

std::string vector_text(const Vec3& v) {
  return fmt::format("({:.17g},{:.17g},{:.17g})", v.x(), v.y(), v.z());
}

std::string header_text(const Grid& grid, const char* type) {
  std::string directions;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    directions +=
        fmt::format("{}{}", axis == 0 ? "" : " ", vector_text(grid.direction.col(axis) * grid.spacing[axis]));
  }
  return fmt::format(
      "NRRD0004\ntype: {}\ndimension: 3\nspace: left-posterior-superior\nsizes: {} {} {}\nspace directions: {}\n"
      "kinds: domain domain domain\nendian: little\nencoding: gzip\nspace origin: {}\n\n",
      type, grid.size[0], grid.size[1], grid.size[2], directions, vector_text(grid.origin));
}

[[noreturn]] void fail(const std::filesystem::path& file) {
  throw SystemError(fmt::format("{} cannot be written: {}", file.string(), std::strerror(errno)));
}

}  // namespace

template <typename Voxel>
void write_nrrd(const Volume<Voxel>& volume, const std::filesystem::path& file) {
  const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) fail(file);
  const std::string header = header_text(volume.grid, type_name<Voxel>());
  const bool header_written =
      ::write(descriptor, header.data(), header.size()) == static_cast<ssize_t>(header.size());
  GzipStream stream(header_written ? gzdopen(descriptor, gzip_mode) : nullptr);
  if (!stream) {
    close(descriptor);
    fail(file);
  }
  const char* bytes = reinterpret_cast<const char*>(volume.voxels.data());
  for (std::size_t left = volume.voxels.size() * sizeof(Voxel); left > 0;) {
    const auto count = static_cast<unsigned>(std::min(left, chunk));
    if (gzwrite(stream.get(), bytes, count) != static_cast<int>(count)) fail(file);
    bytes += count;
    left -= count;
  }
  if (gzclose(stream.release()) != Z_OK) fail(file);
}

template void write_nrrd(const CtVolume& volume, const std::filesystem::path& file);
template void write_nrrd(const LabelVolume& volume, const std::filesystem::path& file);
template void write_nrrd(const TissueVolume& volume, const std::filesystem::path& file);

}  // namespace bodkin
