#include "io/images/image_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>

#include <fmt/format.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

#include "core/error.h"
#include "io/gzip_stream.h"
#include "io/images/image_format.h"
#include "io/temporary_folder.h"

namespace bodkin::io {
namespace {

// niftilib derives file names from file names: asked for a.nii.gz it may read the voxels of an a.nii in the same
// folder. So it is given a link with a unique name in a separate folder.
class PrivateLink {
 public:
  PrivateLink(const std::filesystem::path& file, const std::string& name) : path_(folder_.path() / name) {
    std::filesystem::create_symlink(std::filesystem::absolute(file), path_);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  TemporaryFolder folder_;
  std::filesystem::path path_;
};

itk::ImageIOBase::Pointer image_io(ImageFormat format) {
  switch (format) {
    case ImageFormat::nifti:
      return itk::NiftiImageIO::New().GetPointer();
    case ImageFormat::nrrd:
      return itk::NrrdImageIO::New().GetPointer();
    case ImageFormat::meta_image:
      return itk::MetaImageIO::New().GetPointer();
    case ImageFormat::dicom:
      break;
  }
  throw SystemError("a DICOM file was handed to the reader of single-file images");
}

Payload inspect(ImageFormat format, const std::filesystem::path& file) {
  switch (format) {
    case ImageFormat::nifti:
      return inspect_nifti(file);
    case ImageFormat::nrrd:
      return inspect_nrrd(file);
    default:
      return inspect_meta_image(file);
  }
}

// ITK's own words, without its file names and line breaks.
std::string reason(const itk::ExceptionObject& error) {
  std::string text = error.GetDescription();
  if (const auto place = text.find("): "); place != std::string::npos) text = text.substr(place + 3);
  for (char& letter : text) {
    if (letter < ' ') letter = ' ';
  }
  return text.substr(0, 200);
}

anatomy::Grid grid_of(const itk::ImageIOBase& io) {
  anatomy::Grid grid;
  for (unsigned axis = 0; axis < 3; ++axis) {
    grid.size[axis] = static_cast<int>(io.GetDimensions(axis));
    grid.spacing[axis] = io.GetSpacing(axis);
    grid.origin[axis] = io.GetOrigin(axis);
    const std::vector<double> direction = io.GetDirection(axis);
    for (unsigned row = 0; row < 3; ++row) grid.direction(row, axis) = direction.at(row);
  }
  return grid;
}

std::vector<std::uintmax_t> declared_sizes(const itk::ImageIOBase& io, const std::string& name) {
  std::vector<std::uintmax_t> sizes;
  for (unsigned axis = 0; axis < io.GetNumberOfDimensions(); ++axis) sizes.push_back(io.GetDimensions(axis));
  if (sizes.size() < 3) {
    throw InputError(fmt::format("{}: the image has {} dimensions; expected a volume of 3", name, sizes.size()));
  }
  for (std::size_t axis = 3; axis < sizes.size(); ++axis) {
    if (sizes[axis] != 1) {
      throw InputError(
          fmt::format("{}: the image has {} frames or channels along axis {}; expected a volume of 3 "
                      "dimensions",
                      name, sizes[axis], axis + 1));
    }
  }
  return sizes;
}

template <typename Voxel>
VoxelBuffer read_voxels(itk::ImageIOBase& io, std::size_t count) {
  std::vector<Voxel> voxels(count);
  io.Read(voxels.data());
  return voxels;
}

// niftilib turns NaN into 0, which in a CT is water, so these voxels are read here. gzread also reads uncompressed
// files.
template <typename Voxel>
VoxelBuffer read_floats(const std::filesystem::path& file, const StoredFloats& stored, std::size_t count,
                        const std::string& name) {
  constexpr std::size_t at_once = 1U << 24U;  // bytes; gzread counts in int
  std::vector<Voxel> voxels(count);
  const GzipStream stream(gzopen(file.c_str(), "rb"));
  bool whole = stream && gzseek(stream.get(), static_cast<z_off_t>(stored.offset), SEEK_SET) >= 0;
  auto* bytes = reinterpret_cast<char*>(voxels.data());
  for (std::size_t left = count * sizeof(Voxel); whole && left > 0;) {
    const int got = gzread(stream.get(), bytes, static_cast<unsigned>(std::min(left, at_once)));
    whole = got > 0;
    if (!whole) break;
    bytes += got;
    left -= static_cast<std::size_t>(got);
  }
  if (!whole) throw InputError(fmt::format("{}: the voxels cannot be read; the file is truncated or damaged", name));
  const bool scaled = stored.slope != 1.0 || stored.intercept != 0.0;
  for (Voxel& voxel : voxels) {
    if (stored.swapped) {
      auto raw = std::bit_cast<std::array<unsigned char, sizeof(Voxel)>>(voxel);
      std::reverse(raw.begin(), raw.end());
      voxel = std::bit_cast<Voxel>(raw);
    }
    if (scaled) voxel = static_cast<Voxel>(stored.slope * static_cast<double>(voxel) + stored.intercept);
  }
  return voxels;
}

VoxelBuffer read_voxels_as_stored(itk::ImageIOBase& io, std::size_t count, const std::string& name) {
  switch (io.GetComponentType()) {
    case itk::IOComponentEnum::CHAR:
      return read_voxels<std::int8_t>(io, count);
    case itk::IOComponentEnum::UCHAR:
      return read_voxels<std::uint8_t>(io, count);
    case itk::IOComponentEnum::SHORT:
      return read_voxels<std::int16_t>(io, count);
    case itk::IOComponentEnum::USHORT:
      return read_voxels<std::uint16_t>(io, count);
    case itk::IOComponentEnum::INT:
      return read_voxels<std::int32_t>(io, count);
    case itk::IOComponentEnum::UINT:
      return read_voxels<std::uint32_t>(io, count);
    case itk::IOComponentEnum::LONG:
    case itk::IOComponentEnum::LONGLONG:
      return read_voxels<std::int64_t>(io, count);
    case itk::IOComponentEnum::ULONG:
    case itk::IOComponentEnum::ULONGLONG:
      return read_voxels<std::uint64_t>(io, count);
    case itk::IOComponentEnum::FLOAT:
      return read_voxels<float>(io, count);
    case itk::IOComponentEnum::DOUBLE:
      return read_voxels<double>(io, count);
    default:
      break;
  }
  throw InputError(fmt::format("{}: the voxels are of type '{}'; expected one number a voxel", name,
                               itk::ImageIOBase::GetComponentTypeAsString(io.GetComponentType())));
}

ImageFile read_with_itk(const std::filesystem::path& shown, ImageFormat format, const Payload& payload,
                        const std::string& name) {
  itk::Object::SetGlobalWarningDisplay(false);
  const itk::ImageIOBase::Pointer io = image_io(format);
  io->SetFileName(shown.string());
  io->ReadImageInformation();
  if (io->GetNumberOfComponents() != 1) {
    throw InputError(fmt::format("{}: a voxel holds {} numbers (colours or vectors); expected one", name,
                                 io->GetNumberOfComponents()));
  }
  const std::vector<std::uintmax_t> sizes = declared_sizes(*io, name);
  require_plausible_size(name, sizes, io->GetComponentSize(), payload.voxel_bytes);

  itk::ImageIORegion region(static_cast<unsigned>(sizes.size()));
  for (unsigned axis = 0; axis < sizes.size(); ++axis) {
    region.SetIndex(axis, 0);
    region.SetSize(axis, sizes[axis]);
  }
  io->SetIORegion(region);
  ImageFile image;
  image.grid = clean_grid(grid_of(*io), name);
  const std::size_t count = image.grid.voxel_count();
  if (!payload.floats) {
    image.voxels = read_voxels_as_stored(*io, count, name);
  } else if (payload.floats->bytes == 4) {
    image.voxels = read_floats<float>(shown, *payload.floats, count, name);
  } else {
    image.voxels = read_floats<double>(shown, *payload.floats, count, name);
  }
  return image;
}

}  // namespace

ImageFile read_image_file(const std::filesystem::path& file) {
  const std::string name = file.string();
  const ImageFormat format = detect_image_format(file);
  if (format == ImageFormat::dicom) {
    throw InputError(fmt::format("{}: this is a DICOM file; give the folder that holds its series", name));
  }
  const Payload payload = inspect(format, file);
  try {
    if (format != ImageFormat::nifti) return read_with_itk(file, format, payload, name);
    const PrivateLink link(file, payload.gzip_file ? "image.nii.gz" : "image.nii");
    return read_with_itk(link.path(), format, payload, name);
  } catch (const itk::ExceptionObject& error) {
    throw InputError(fmt::format("{}: this {} file cannot be read; it is truncated or damaged ({})", name,
                                 to_string(format), reason(error)));
  }
}

}  // namespace bodkin::io
