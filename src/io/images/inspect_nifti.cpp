#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <zlib.h>

#include "core/error.h"
#include "core/geometry.h"
#include "io/gzip_stream.h"
#include "io/images/image_file.h"
#include "io/images/image_format.h"
#include "io/images/inflated_size.h"

// The NIfTI-1 header (nifti1.h, Cox et al. 2004): 348 bytes, fields at fixed places, either byte order.

namespace bodkin::io {
namespace {

constexpr std::size_t header_size = 348;
constexpr double largest_shear = 1e-3;  // cosine between two axes of an affine that is still called orthogonal

using Bytes = std::array<unsigned char, header_size>;

struct Header {
  Bytes bytes{};
  bool swapped = false;

  template <typename Number>
  Number at(std::size_t place) const {
    std::array<unsigned char, sizeof(Number)> raw{};
    std::memcpy(raw.data(), bytes.data() + place, raw.size());
    if (swapped) std::reverse(raw.begin(), raw.end());
    return std::bit_cast<Number>(raw);
  }
  std::int16_t dim(std::size_t i) const { return at<std::int16_t>(40 + 2 * i); }
  float pixdim(std::size_t i) const { return at<float>(76 + 4 * i); }
};

// gzread also reads uncompressed files.
Bytes read_nifti_header(const std::filesystem::path& file) {
  const GzipStream stream(gzopen(file.c_str(), "rb"));
  if (!stream) throw InputError(fmt::format("{}: this file cannot be opened", file.string()));
  Bytes bytes{};
  const int count = gzread(stream.get(), bytes.data(), static_cast<unsigned>(bytes.size()));
  if (count < 0) throw InputError(fmt::format("{}: the gzip stream is damaged; copy the file again", file.string()));
  if (static_cast<std::size_t>(count) < bytes.size()) {
    throw InputError(fmt::format("{}: the file ends after {} of the 348 bytes of a NIfTI header; copy it again",
                                 file.string(), count));
  }
  return bytes;
}

void check_dimensions(const Header& header, const std::string& name) {
  const int dimensions = header.dim(0);
  if (dimensions < 1 || dimensions > 7) {
    throw InputError(fmt::format("{}: the NIfTI header declares {} dimensions; expected 3", name, dimensions));
  }
  for (std::size_t i = 1; i <= static_cast<std::size_t>(dimensions); ++i) {
    if (header.dim(i) < 1) {
      throw InputError(fmt::format("{}: the NIfTI header declares {} voxels along axis {}; expected at least 1", name,
                                   header.dim(i), i));
    }
  }
}

void check_spacing(const Header& header, const std::string& name) {
  for (std::size_t i = 1; i <= 3; ++i) {
    const float spacing = header.pixdim(i);
    if (!std::isfinite(spacing) || spacing == 0.0F || spacing < 0.0F) {
      throw InputError(
          fmt::format("{}: the voxel spacing along axis {} is {} mm (pixdim[{}]); expected a length above "
                      "zero",
                      name, i, spacing, i));
    }
  }
}

void check_sform(const Header& header, const std::string& name) {
  Mat3 axes;
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 4; ++column) {
      const auto value = header.at<float>(280 + static_cast<std::size_t>(16 * row + 4 * column));
      if (!std::isfinite(value)) {
        throw InputError(fmt::format("{}: the affine holds {} (srow, row {}, column {}); expected finite numbers",
                                     name, value, row + 1, column + 1));
      }
      if (column < 3) axes(row, column) = value;
    }
  }
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (axes.col(i).norm() == 0.0) {
      throw InputError(
          fmt::format("{}: the affine gives axis {} no length (srow); expected a length above zero", name, i + 1));
    }
    const double spacing = header.pixdim(static_cast<std::size_t>(i) + 1);
    if (std::abs(axes.col(i).norm() - spacing) > 0.01 * spacing) {
      throw InputError(
          fmt::format("{}: the affine says {:.4g} mm along axis {} and pixdim says {:.4g} mm; one of them "
                      "is wrong, write the file anew with the program that made it",
                      name, axes.col(i).norm(), i + 1, spacing));
    }
    axes.col(i).normalize();
  }
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double cosine = axes.col(i).dot(axes.col((i + 1) % 3));
    if (std::abs(cosine) > largest_shear) {
      throw InputError(
          fmt::format("{}: the affine is sheared, axes {} and {} meet at {:.2f} degrees instead of 90; give "
                      "the DICOM series, or resample the image onto a regular grid",
                      name, i + 1, (i + 1) % 3 + 1, std::acos(cosine) * 180.0 / std::numbers::pi));
    }
  }
}

void check_qform(const Header& header, const std::string& name) {
  for (std::size_t i = 0; i < 6; ++i) {
    const auto value = header.at<float>(256 + 4 * i);
    if (!std::isfinite(value)) {
      throw InputError(
          fmt::format("{}: the affine holds {} (quatern or qoffset); expected finite numbers", name, value));
    }
  }
}

// Bytes per voxel of a NIfTI datatype of one plain number; 0 for others.
std::size_t voxel_size(int datatype) {
  switch (datatype) {
    case 2:
    case 256:
      return 1;
    case 4:
    case 512:
      return 2;
    case 8:
    case 16:
    case 768:
      return 4;
    case 64:
    case 1024:
    case 1280:
      return 8;
    default:
      return 0;
  }
}

void check_voxel_type(const Header& header, const std::string& name) {
  const auto datatype = header.at<std::int16_t>(70);
  if (voxel_size(datatype) > 0) return;
  const bool colour = datatype == 128 || datatype == 2304;
  throw InputError(fmt::format("{}: the voxels are {} (NIfTI datatype {}); expected one number a voxel", name,
                               colour ? "colours" : "not plain numbers", datatype));
}

// Nothing for integer voxels.
std::optional<StoredFloats> stored_floats(const Header& header) {
  const auto datatype = header.at<std::int16_t>(70);
  if (datatype != 16 && datatype != 64) return std::nullopt;
  StoredFloats floats;
  floats.bytes = datatype == 16 ? 4 : 8;
  floats.offset = static_cast<std::uintmax_t>(std::min(header.at<float>(108), 1e9F));
  floats.swapped = header.swapped;
  // A slope of zero or NaN means that the values are not scaled.
  const auto slope = header.at<float>(112), intercept = header.at<float>(116);
  if (std::isfinite(slope) && slope != 0.0F) {
    floats.slope = slope;
    floats.intercept = std::isfinite(intercept) ? intercept : 0.0;
  }
  return floats;
}

bool is_gzip(const std::filesystem::path& file) {
  std::array<char, 2> magic{};
  std::ifstream(file, std::ios::binary).read(magic.data(), 2);
  return magic[0] == '\x1F' && magic[1] == '\x8B';
}

}  // namespace

Payload inspect_nifti(const std::filesystem::path& file) {
  const std::string name = file.string();
  Header header{read_nifti_header(file)};
  const auto length = header.at<std::int32_t>(0);
  header.swapped = length != 348 && length != 540;
  if (header.at<std::int32_t>(0) == 540) {
    throw InputError(
        fmt::format("{}: this is NIfTI-2, which Bodkin does not read; save it as NIfTI-1, NRRD or "
                    "MetaImage",
                    name));
  }
  if (header.at<std::int32_t>(0) != 348) {
    throw InputError(fmt::format("{}: this is a gzip file without a NIfTI image inside; expected .nii.gz", name));
  }
  if (std::memcmp(header.bytes.data() + 344, "n+1", 4) != 0) {
    throw InputError(
        fmt::format("{}: this is an Analyze image or a .hdr/.img pair; save it as one NIfTI file (.nii or "
                    ".nii.gz)",
                    name));
  }
  check_dimensions(header, name);
  check_voxel_type(header, name);
  check_spacing(header, name);
  const bool sform = header.at<std::int16_t>(254) > 0, qform = header.at<std::int16_t>(252) > 0;
  if (!sform && !qform) {
    throw InputError(
        fmt::format("{}: the file does not say where it lies in the patient (sform_code and qform_code are "
                    "0); write it anew with its orientation",
                    name));
  }
  if (sform) check_sform(header, name);
  if (qform) check_qform(header, name);
  const auto offset = header.at<float>(108);
  if (!std::isfinite(offset) || offset < 348.0F) {
    throw InputError(fmt::format("{}: the voxels start at byte {} (vox_offset); expected 352 or more", name, offset));
  }

  Payload payload;
  payload.floats = stored_floats(header);
  payload.gzip_file = is_gzip(file);
  std::uintmax_t bytes = std::filesystem::file_size(file);
  if (payload.gzip_file) {
    const std::optional<std::uintmax_t> unpacked = inflated_size(file, 0, most_voxels * 8);
    if (!unpacked) {
      throw InputError(fmt::format("{}: the gzip stream is truncated or damaged; copy the file again", name));
    }
    bytes = *unpacked;
  }
  const auto skipped = static_cast<std::uintmax_t>(std::min(offset, 1e9F));
  payload.voxel_bytes = static_cast<double>(bytes - std::min(bytes, skipped));
  std::vector<std::uintmax_t> sizes;
  for (std::size_t i = 1; i <= static_cast<std::size_t>(header.dim(0)); ++i) {
    sizes.push_back(static_cast<std::uintmax_t>(header.dim(i)));
  }
  require_plausible_size(name, sizes, voxel_size(header.at<std::int16_t>(70)), payload.voxel_bytes);
  payload.voxel_bytes *= 8.0;  // ITK reads a scaled image as float or double, whatever is stored
  return payload;
}

}  // namespace bodkin::io
