#pragma once

#include <cstdint>
#include <vector>

#include "core/progress.h"
#include "io/images/dicom_scan.h"
#include "io/images/image_values.h"

namespace bodkin::io {

// Decodes the pixels of every slice of a series, in the order given, into HU: slice by slice, row by row. All
// transfer syntaxes of GDCM are read (raw, RLE, JPEG, JPEG-LS, JPEG 2000); two slices are decoded at a time. Throws
// InputError naming the file whose pixels are missing, damaged, or not one number each.
std::vector<std::int16_t> decode_slices(const DicomSeries& series, HounsfieldLosses& losses,
                                        const Progress& progress = {});

}  // namespace bodkin::io
