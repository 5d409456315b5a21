#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "io/images/coding_error.h"
#include "io/images/dicom_scan.h"
#include "io/images/image_values.h"

namespace bodkin::io {

// A slice whose pixels are missing, damaged, or not single numbers.
struct DamagedSlice {
  std::size_t slice = 0;  // position in the series
  std::string sentence;   // names the file and says what is wrong
};

struct DecodedSlices {
  std::vector<std::int16_t> voxels;   // HU, slice by slice, row by row; air in damaged slices
  std::vector<DamagedSlice> damaged;  // in the order of the slices
  std::optional<CodingError> coding;  // the largest of all slices, HU; empty when no code states a loss
};

// Decodes the pixels of every slice of a series, in the order given. All transfer syntaxes of GDCM are read (raw,
// deflated, RLE, JPEG, JPEG-LS, JPEG 2000); two files are decoded at a time. Throws InputError naming the first
// file when no slice can be decoded.
DecodedSlices decode_slices(const DicomSeries& series, HounsfieldLosses& losses, const Progress& progress = {});

}  // namespace bodkin::io
