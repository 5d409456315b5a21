#pragma once

#include <optional>
#include <string>
#include <vector>

#include "patient/from_ct/vertebral_levels.h"

#include "anatomy/case.h"
#include "core/progress.h"

namespace bodkin::patient {

struct PatientOptions {
  double tissue_spacing = 1.0;  // mm; the tissue lattice divides CT voxels until none is longer than about this
  std::optional<anatomy::NeedlePath> path;  // the planned path, if the user states one
  anatomy::TissueLibrary library = {};      // tissues that structures may use in addition to Bodkin's
  bool construct_lumbar = true;             // build ligaments, epidural space and dura
                                            // where a lumbar spine is found
  bool plan = true;                         // without a path, plan one through an interspace
  std::string level = {};                   // the interspace of the plan, "L3_L4"; empty = chosen by choose_path()
  std::vector<std::string> levels = {};     // interspaces that the procedure may enter; empty = any
  std::string lowest_vertebra = {};         // the user's statement on levels, see LevelTexts; empty = none
  SpinePlace conus = adult_conus;           // level of the end of the patient's cord
};

// The tissues of a CT's voxels, found from its HU, its labels and anatomy.
struct BuiltPatient {
  anatomy::TissueVolume tissues;
  std::vector<anatomy::Landmark> landmarks;  // interspaces "L3_L4", ... where found: skin entry, canal
                                             // centre; "conus"
  std::optional<anatomy::NeedlePath> path;   // given, or planned through the best interspace
  std::vector<std::string> notes;            // one sentence each
};

// `structures` lies on the CT's lattice, or is empty. `table` has the meaning of its labels. Throws InputError when
// there is no body in the CT, when no path can be planned at `options.level`, when `options.lowest_vertebra` is not a
// vertebra, and when the given path enters the spinal cord.
BuiltPatient build_patient(const anatomy::CtVolume& ct, const anatomy::LabelVolume& structures,
                           const std::vector<anatomy::Structure>& table, const PatientOptions& options,
                           const Progress& progress);

}  // namespace bodkin::patient
