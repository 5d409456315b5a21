#pragma once

#include <cstdint>
#include <filesystem>

namespace bodkin::io {

// The actual extent of the elements of a DICOM file.
struct DicomExtent {
  bool header_cut = false;     // an element before the pixels goes beyond the end of the file
  bool pixels_cut = false;     // the pixels do
  std::uint32_t last_tag = 0;  // group and element of the last one; 0: unknown, as in a deflated file
};

// Follows the elements of a file from length to length, little endian, without reading their values: GDCM aborts on
// files that end within an element, and fills in missing pixels. Files that it does not understand count as complete.
DicomExtent dicom_extent(const std::filesystem::path& file);

}  // namespace bodkin::io
