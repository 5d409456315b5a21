#pragma once

#include <cstdint>
#include <filesystem>

namespace bodkin::io {

// How far the elements of a DICOM file really reach.
struct DicomExtent {
  bool header_cut = false;     // an element before the pixels goes beyond the end of the file
  bool pixels_cut = false;     // the pixels do
  std::uint32_t last_tag = 0;  // group and element of the last one; 0: not looked at, as in a deflated file
};

// Follows the elements of a file from length to length, little endian, without reading their values: GDCM aborts on
// files that end within an element, and fills pixels that are missing. What it does not understand it passes as
// whole.
DicomExtent dicom_extent(const std::filesystem::path& file);

}  // namespace bodkin::io
