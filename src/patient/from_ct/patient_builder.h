#pragma once

#include <optional>
#include <string>
#include <vector>

#include "anatomy/case.h"
#include "core/progress.h"

namespace bodkin {

struct PatientOptions {
  double tissue_spacing = 1.0;     // mm; the tissue lattice divides CT voxels until none is longer than about this
  std::optional<NeedlePath> path;  // the planned path, when the user gives it
  TissueLibrary library = {};      // tissues that structures may name besides Bodkin's own
  bool construct_lumbar = true;    // build ligaments, epidural space and dura where a lumbar spine is found
};

// What the voxels of a CT are made of, found from its HU, its labels and anatomy.
struct BuiltPatient {
  TissueVolume tissues;
  std::vector<Landmark> landmarks;  // interspaces "L3_L4", ... where found: skin entry, canal centre
  std::optional<NeedlePath> path;   // given, or planned through the best interspace
  std::vector<std::string> notes;   // one sentence each
};

// `structures` lies on the CT's lattice, or is empty. `table` says what its labels mean. Throws InputError when there
// is no body in the CT.
BuiltPatient build_patient(const CtVolume& ct, const LabelVolume& structures, const std::vector<Structure>& table,
                           const PatientOptions& options, const Progress& progress);

}  // namespace bodkin
