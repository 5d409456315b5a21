#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "anatomy/volume.h"
#include "core/progress.h"
#include "io/images/dicom_labels.h"
#include "io/images/dicom_series.h"

namespace bodkin::io {

// A CT read from a file or a DICOM folder.
struct CtImage {
  anatomy::CtVolume ct;
  bool resampled = false;  // voxels lie on a grid of our own (see DicomVolume)
  std::vector<std::string> notes;
};

// Reads a CT from a DICOM folder, or a NIfTI, NRRD, MetaImage or single DICOM file. HU as int16. Throws InputError.
CtImage read_ct(const std::filesystem::path& path, const DicomOptions& options = {}, const Progress& progress = {});

// Reads the labels of the CT on lattice `ct` from any of these, or from a DICOM segmentation or structure set, also
// if it is the only one in a DICOM folder. Throws InputError.
NamedLabels read_named_labels(const std::filesystem::path& path, const anatomy::Grid& ct,
                              const Progress& progress = {});

// Reads labels without their names; a structure set has no lattice of its own and is rejected. Throws InputError.
anatomy::LabelVolume read_labels(const std::filesystem::path& path, const Progress& progress = {});

// Reads tissue ids from a NIfTI, NRRD or MetaImage file. Throws InputError.
anatomy::TissueVolume read_tissues(const std::filesystem::path& path);

}  // namespace bodkin::io
