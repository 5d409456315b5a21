#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "patient/planning/obstacles.h"
#include "patient/synthetic/lumbar.h"

#include "anatomy/case.h"
#include "core/progress.h"

namespace bodkin::patient {

// What every new case needs to know.
struct NewCase {
  std::filesystem::path folder;  // made here; must not exist unless `overwrite`
  bool overwrite = false;        // replace a case folder that is there
  std::string name;              // of the patient; empty = the folder's name
  int needle_gauge = 22;
  std::string needle;  // "18,90,tuohy", see parse_needle; overrides needle_gauge; empty = only the gauge is said
  anatomy::Mechanics mechanics = anatomy::Mechanics::physical;  // of the new case
  anatomy::ForceParts parts;                                    // the same
  anatomy::ForceInOrgans force_in_organs = anatomy::ForceInOrgans::felt;
  std::string procedure;      // name of what is practised; empty: a lumbar puncture where there is a lumbar spine
  std::string target_tissue;  // tissue whose entry is its aim; only with `procedure`; empty = the target point counts
  std::optional<anatomy::NeedlePath>
      path;  // the planned path; without it one is planned where a lumbar spine is found
  // A target of the user's own, by its place or by the name of a structure, to which the best path is planned by
  // `rules`; not with `path`.
  std::optional<Vec3> target;
  std::string target_structure;
  PlanningRules rules;
};

// A case from foreign images.
struct ImportOptions {
  std::filesystem::path ct;      // DICOM folder, NIfTI, NRRD or MetaImage
  std::filesystem::path labels;  // the same, or empty
  std::string scheme;  // what the labels mean, see read_label_scheme; empty: by their names in the file, else
                       // TotalSegmentator's numbers
  std::filesystem::path tissues;   // tissue library of the case, or empty for the one that comes with Bodkin
  std::optional<int> series;       // which series of a DICOM folder, from 1
  bool resample_labels = false;    // take the nearest label where the lattices differ
  bool fill_missing = false;       // interpolate missing slices
  bool assume_hounsfield = false;  // do not ask whether the values can be HU
  std::string level;               // the interspace to plan at, "L3_L4", or empty; see choose_path
  std::string lowest_vertebra;     // the vertebra above the lowest interspace, "L5", or empty
  std::string conus;               // where the cord ends, "L1" or "L1_L2"; empty = by `age`
  std::optional<double> age;       // years, for the level of the conus; without it an adult's
};

struct TissueAmount {
  std::string title;
  double millilitres = 0.0;
};

// What was made, for people.
struct CaseSummary {
  anatomy::CaseDescription description;
  anatomy::Grid ct, tissues;
  std::vector<TissueAmount> amounts;  // by amount, largest first; air is left out
};

// Builds a case folder: ct.nrrd, structures.nrrd (only with labels), tissues.nrrd, case.xml, and
// tissues.xml, the tissue library, when one is given. It is written under
// a temporary name in the same folder (DIR.partial-PID) and renamed when it is complete, so a folder that is there is
// whole. Throws InputError when the input is at fault, SystemError when the disk is; nothing is left behind then.
CaseSummary build_imported_case(const NewCase& wanted, const ImportOptions& options, const Progress& progress = {});
CaseSummary build_synthetic_case(const NewCase& wanted, const LumbarParameters& parameters,
                                 const Progress& progress = {});

}  // namespace bodkin::patient
