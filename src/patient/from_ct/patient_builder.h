#pragma once

#include <optional>
#include <string>
#include <vector>

#include "patient/from_ct/vertebral_levels.h"

#include "anatomy/case.h"
#include "core/progress.h"

namespace bodkin::patient {

struct PatientOptions {
  double tissue_spacing = 1.0;              // mm; the tissue lattice divides CT voxels until
                                            // none is longer than about this
  std::optional<anatomy::NeedlePath> path;  // the planned path, when the user gives it
  anatomy::TissueLibrary library = {};      // tissues that structures may name besides Bodkin's own
  bool construct_lumbar = true;             // build ligaments, epidural space and dura
                                            // where a lumbar spine is found
  bool plan = true;                         // without a path, plan one through an interspace
  std::string level = {};                   // the interspace to plan at, "L3_L4"; empty = chosen by choose_path()
  std::vector<std::string> levels = {};     // interspaces that the procedure may enter; empty = any
  std::string lowest_vertebra = {};         // the user's word on levels, see LevelWords; empty = not said
  SpinePlace conus = adult_conus;           // where the patient's cord ends
};

// What the voxels of a CT are made of, found from its HU, its labels and anatomy.
struct BuiltPatient {
  anatomy::TissueVolume tissues;
  std::vector<anatomy::Landmark> landmarks;  // interspaces "L3_L4", ... where found: skin entry, canal
                                             // centre; "conus"
  std::optional<anatomy::NeedlePath> path;   // given, or planned through the best interspace
  std::vector<std::string> notes;            // one sentence each
};

// `structures` lies on the CT's lattice, or is empty. `table` says what its labels mean. Throws InputError when there
// is no body in the CT, when no path can be planned at `options.level`, when `options.lowest_vertebra` is no
// vertebra, and when the given path goes into the spinal cord.
BuiltPatient build_patient(const anatomy::CtVolume& ct, const anatomy::LabelVolume& structures,
                           const std::vector<anatomy::Structure>& table, const PatientOptions& options,
                           const Progress& progress);

}  // namespace bodkin::patient
