#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace bodkin::io {

enum class ImageFormat { nifti, nrrd, meta_image, dicom };

std::string to_string(ImageFormat format);

// The format of a file, from its first bytes, ignoring its name. Throws InputError when it does not exist, is empty
// or a folder, or has none of the formats that Bodkin reads.
ImageFormat detect_image_format(const std::filesystem::path& file);

// How a NIfTI file stores floating-point voxels, and their meaning: slope * stored + intercept.
struct StoredFloats {
  int bytes = 4;              // of a voxel: 4 or 8
  std::uintmax_t offset = 0;  // bytes before the first voxel, in the unpacked file
  bool swapped = false;       // big endian
  double slope = 1.0, intercept = 0.0;
};

// The number of voxel bytes in a file, determined before any memory is allocated for them.
struct Payload {
  double voxel_bytes = 0.0;            // at most, once unpacked; packed streams are counted without storing them
  bool gzip_file = false;              // the whole file is a gzip stream (NIfTI)
  std::optional<StoredFloats> floats;  // NIfTI with voxels of floating point
};

// Checks a header strictly, before a library reads it: every number of the geometry must be present, finite and, for
// a length, not zero; the voxels must be in the file itself or in a plain file in the same folder (never elsewhere);
// the kind of voxel must be a number. Throws InputError, one sentence. For DICOM use read_dicom_*.
Payload inspect_nifti(const std::filesystem::path& file);
Payload inspect_nrrd(const std::filesystem::path& file);
Payload inspect_meta_image(const std::filesystem::path& file);

}  // namespace bodkin::io
