#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "anatomy/volume.h"

namespace bodkin::io {

// The name of a label in a file.
struct LabelName {
  std::uint16_t label = 0;
  std::string name;  // printable, from the file: "Kidney left"
};

// Labels together with their names from the file.
struct NamedLabels {
  anatomy::LabelVolume labels;
  std::vector<LabelName> names;    // by label; empty when the file has none
  std::vector<std::string> notes;  // one sentence each
};

// Reads a DICOM segmentation (modality SEG; PS3.3 A.51): binary, fractional (a voxel belongs to a segment from half
// of the largest fraction on) or a label map. Labels are segment numbers, on the lattice of its frames; where
// segments overlap the smaller number wins. Throws InputError, one sentence.
NamedLabels read_segmentation(const std::filesystem::path& file);

// Reads a DICOM structure set (modality RTSTRUCT; PS3.3 A.19): closed planar contours, filled on the lattice of the
// CT on which they were drawn. A voxel belongs to a structure when its centre lies inside; contours of one structure
// in one plane cut holes into each other. A slice without contours uses those of the nearest plane, if that is no
// farther than half the distance between planes. Labels are ROI numbers; where structures overlap the smaller number
// wins. Throws InputError, one sentence, also when the contours are not parallel to slices of `ct`.
NamedLabels read_structure_set(const std::filesystem::path& file, const anatomy::Grid& ct);

}  // namespace bodkin::io
