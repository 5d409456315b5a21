#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "core/progress.h"

namespace bodkin::io {

// The relevant header data of one DICOM image.
struct DicomSlice {
  std::filesystem::path file;
  std::string instance_uid;
  Vec3 position = Vec3::Zero();  // Image Position (Patient), LPS mm of the first pixel
  double slope = 1.0;            // HU = slope * stored + intercept
  double intercept = 0.0;
  int frame = 0;  // of an enhanced image, which holds several slices in one file
};

// Slices of one series with equal size, spacing and orientation. A series whose slices differ in these (for example
// because of a localizer) is split into several.
struct DicomSeries {
  std::string uid, description, modality;
  int number = 0;  // Series Number; not unique
  int columns = 0, rows = 0;
  int frames = 1;                                  // in one file; those of an enhanced image are slices
  int bytes_allocated = 2;                         // per stored pixel
  bool compressed = false;                         // the pixels are encapsulated, or the whole file is deflated
  bool lossy = false;                              // Lossy Image Compression: values were changed at some time
  double lossy_ratio = 0.0;                        // Lossy Image Compression Ratio, N:1; 0 = not given
  bool jpeg_2000 = false;                          // that compression was JPEG 2000
  bool placed = false;                             // position, orientation and pixel spacing are present and valid
  double column_spacing = 0.0, row_spacing = 0.0;  // mm along i and j
  double thickness = 0.0;                          // mm, Slice Thickness; 0 = not given
  Vec3 row_direction = Vec3::UnitX(), column_direction = Vec3::UnitY();  // orthonormal, LPS
  std::vector<DicomSlice> slices;                                        // in the order in which they were found

  // "series 3 'abdomen', CT, 55 slices of 172 x 160"
  std::string describe() const;
};

// A DICOM file that is not an image of a patient: a structure set, a segmentation, a report.
struct DicomObject {
  std::filesystem::path file;
  std::string modality, description;
};

struct DicomFolder {
  std::filesystem::path path;       // scanned folder or file
  std::vector<DicomSeries> series;  // by series number
  std::vector<DicomObject> other_objects;
  std::vector<std::filesystem::path> unreadable;  // files with a damaged header, or without the place of their slice
};

// Reads the headers of every DICOM file in a folder (and its subfolders), or of one file. Other files are ignored.
// Throws InputError when there is nothing, or far too much, to read.
DicomFolder scan_dicom(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace bodkin::io
