#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "anatomy/volume.h"
#include "core/progress.h"
#include "io/images/dicom_scan.h"

namespace bodkin::io {

struct DicomOptions {
  std::optional<int> series;  // which one of several, counted from 1 as in series_listing
  bool fill_missing = false;  // interpolate missing slices instead of rejecting the series
  bool any_modality = false;  // also other modalities than CT: label images
};

// A series as a volume of HU (or of the meaning of its rescaled values).
struct DicomVolume {
  anatomy::CtVolume volume;
  bool resampled = false;          // the stack was sheared, uneven or had gaps: voxels lie on a grid of our own
  std::vector<std::string> notes;  // one sentence each
};

// Reads a DICOM series from a folder (or one file). Slices are ordered by their position; a regular stack is kept
// exactly, a sheared one (gantry tilt) or an uneven one is resampled onto a regular grid, with a note. The frames of
// an enhanced image are slices. Slices that cannot be decoded are left out, with a note, if the rest is still a stack
// without gaps. Throws InputError, one sentence, for such a slice elsewhere, for several series (with a listing), for
// a missing slice, for two slices in one place, for other modalities than CT, and for data that cannot be decoded.
DicomVolume read_dicom(const std::filesystem::path& path, const DicomOptions& options, const Progress& progress = {});

// The image series of a folder, one per line, numbered from 1: "  1: series 3 'abdomen', CT, 55 slices of 172 x 160,
// 168 x 156 mm, z = -676.47 to -499.89 mm, in thin/bone".
std::string series_listing(const DicomFolder& folder);

}  // namespace bodkin::io
