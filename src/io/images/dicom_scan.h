#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "core/progress.h"

namespace bodkin::io {

// What the header of one DICOM image says, as far as it matters here.
struct DicomSlice {
  std::filesystem::path file;
  std::string instance_uid;
  Vec3 position = Vec3::Zero();  // Image Position (Patient), LPS mm of the first pixel
  double slope = 1.0;            // HU = slope * stored + intercept
  double intercept = 0.0;
};

// Slices of one series that share size, spacing and orientation. A series whose slices differ in these (a localizer
// among them) falls into several.
struct DicomSeries {
  std::string uid, description, modality;
  int number = 0;  // Series Number; not unique
  int columns = 0, rows = 0, frames = 1;
  int bytes_allocated = 2;                         // per stored pixel
  bool compressed = false;                         // the pixels are encapsulated
  bool placed = false;                             // position, orientation and pixel spacing are there and make sense
  double column_spacing = 0.0, row_spacing = 0.0;  // mm along i and j
  double thickness = 0.0;                          // mm, Slice Thickness; 0 = not given
  Vec3 row_direction = Vec3::UnitX(), column_direction = Vec3::UnitY();  // orthonormal, LPS
  std::vector<DicomSlice> slices;                                        // in the order in which they were found

  // "series 3 'abdomen', CT, 55 slices of 172 x 160"
  std::string describe() const;
};

struct DicomFolder {
  std::vector<DicomSeries> series;  // by series number
  std::size_t other_objects = 0;    // DICOM files that are not images: structure sets, segmentations, reports
  std::size_t unreadable = 0;       // DICOM files whose header is damaged
};

// Reads the headers of every DICOM file in a folder (and the folders in it), or of one file. Anything that is not
// DICOM is passed over. Throws InputError when there is nothing, or far too much, to read.
DicomFolder scan_dicom(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace bodkin::io
