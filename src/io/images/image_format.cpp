#include "io/images/image_format.h"

#include <array>
#include <cstring>
#include <fstream>
#include <string_view>

#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::io {
namespace {

constexpr std::size_t dicom_preamble = 128;  // bytes before "DICM"

std::string first_bytes(const std::filesystem::path& file, std::size_t count) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(fmt::format("{}: this file cannot be opened; check its permissions", file.string()));
  std::string bytes(count, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(count));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

// A DICOM file may lack the preamble; it then starts with an element of group 2 or 8, little endian.
bool looks_like_bare_dicom(std::string_view bytes) {
  return bytes.size() >= 8 && (bytes[0] == 0x08 || bytes[0] == 0x02) && bytes[1] == 0 && bytes[3] == 0;
}

bool looks_like_nifti(std::string_view bytes) {
  if (bytes.size() < 4) return false;
  std::array<unsigned char, 4> head{};
  std::memcpy(head.data(), bytes.data(), head.size());
  const bool nifti1 = (head[0] == 0x5C && head[1] == 0x01) || (head[2] == 0x01 && head[3] == 0x5C);  // 348
  const bool nifti2 = (head[0] == 0x1C && head[1] == 0x02) || (head[2] == 0x02 && head[3] == 0x1C);  // 540
  return nifti1 || nifti2;
}

// A MetaImage header is text, "Key = Value", and starts with one of a few keys.
bool looks_like_meta_image(std::string_view bytes) {
  for (const std::string_view key : {"ObjectType", "NDims", "Comment", "BinaryData", "DimSize"}) {
    if (bytes.starts_with(key)) return bytes.find('=') != std::string_view::npos;
  }
  return false;
}

}  // namespace

std::string to_string(ImageFormat format) {
  switch (format) {
    case ImageFormat::nifti:
      return "NIfTI";
    case ImageFormat::nrrd:
      return "NRRD";
    case ImageFormat::meta_image:
      return "MetaImage";
    case ImageFormat::dicom:
      return "DICOM";
  }
  return "unknown";
}

ImageFormat detect_image_format(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) throw InputError(fmt::format("{}: there is no such file", file.string()));
  if (std::filesystem::is_directory(status)) {
    throw InputError(fmt::format("{}: this is a folder where an image file was expected", file.string()));
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw InputError(fmt::format("{}: this is not an ordinary file", file.string()));
  }
  const std::string bytes = first_bytes(file, 512);
  if (bytes.empty()) throw InputError(fmt::format("{}: this file is empty", file.string()));
  if (bytes.size() >= dicom_preamble + 4 && bytes.compare(dicom_preamble, 4, "DICM") == 0) return ImageFormat::dicom;
  if (bytes.starts_with("NRRD000")) return ImageFormat::nrrd;
  // A gzip stream: of Bodkin's formats only NIfTI is compressed as a whole; inspect_nifti checks the contents.
  if (bytes.starts_with("\x1F\x8B") || looks_like_nifti(bytes)) return ImageFormat::nifti;
  if (looks_like_meta_image(bytes)) return ImageFormat::meta_image;
  if (looks_like_bare_dicom(bytes)) return ImageFormat::dicom;
  throw InputError(
      fmt::format("{}: this is not an image that Bodkin reads; expected DICOM, NIfTI (.nii, .nii.gz), NRRD "
                  "or MetaImage (.mha, .mhd)",
                  file.string()));
}

}  // namespace bodkin::io
