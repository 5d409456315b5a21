#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "anatomy/volume.h"

namespace bodkin::io {

// What a file calls one of its labels.
struct LabelName {
  std::uint16_t label = 0;
  std::string name;  // printable, as the file has it: "Kidney left"
};

// Labels together with the names that their file gives them.
struct NamedLabels {
  anatomy::LabelVolume labels;
  std::vector<LabelName> names;    // by label; empty when the file has none
  std::vector<std::string> notes;  // one sentence each
};

// Reads a DICOM segmentation (modality SEG; PS3.3 A.51): binary, fractional (a voxel belongs to a segment from half
// of the largest fraction on) or a label map. Labels are segment numbers, on the lattice of its frames; where
// segments overlap the smaller one counts. Throws InputError, one sentence.
NamedLabels read_segmentation(const std::filesystem::path& file);

// Reads a DICOM structure set (modality RTSTRUCT; PS3.3 A.19): closed planar contours, filled on the lattice of the
// CT that they were drawn on. A voxel belongs to a structure when its centre lies inside; contours of one structure
// in one plane cut holes into each other. A slice without contours takes those of the nearest plane, if that is no
// further than half the distance between planes. Labels are ROI numbers; where structures overlap the smaller one
// counts. Throws InputError, one sentence, also when the contours are not parallel to slices of `ct`.
NamedLabels read_structure_set(const std::filesystem::path& file, const anatomy::Grid& ct);

}  // namespace bodkin::io
