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

// Common inputs of every new case.
struct NewCase {
  std::filesystem::path folder;  // created here; must not exist unless `overwrite`
  bool overwrite = false;        // replace an existing case folder
  std::string name;              // of the patient; empty = the folder's name
  int needle_gauge = 22;
  std::string needle;  // "18,90,tuohy", see parse_needle; overrides needle_gauge; empty = only the gauge is given
  anatomy::Mechanics mechanics = anatomy::Mechanics::physical;  // of the new case
  anatomy::ForceParts parts;                                    // of the new case
  anatomy::ForceInOrgans force_in_organs = anatomy::ForceInOrgans::felt;
  std::string procedure;      // to be practised; empty: a lumbar puncture if there is a lumbar spine
  std::string target_tissue;  // its entry is the goal; only with `procedure`; empty = the target point counts
  std::optional<anatomy::NeedlePath> path;  // the planned path; without it one is planned if a lumbar spine is found
  // A target chosen by the user, by its position or by the name of a structure, to which the best path is planned by
  // `rules`; not with `path`.
  std::optional<Vec3> target;
  std::string target_structure;
  PlanningRules rules;
};

// A case from foreign images.
struct ImportOptions {
  std::filesystem::path ct;      // DICOM folder, NIfTI, NRRD or MetaImage
  std::filesystem::path labels;  // as `ct`, or empty
  std::string scheme;  // meaning of the labels, see read_label_scheme; empty: by their names in the file, else
                       // TotalSegmentator's numbers
  std::filesystem::path tissues;   // tissue library of the case, or empty for the one that comes with Bodkin
  std::optional<int> series;       // which series of a DICOM folder, from 1
  bool resample_labels = false;    // use the nearest label if the lattices differ
  bool fill_missing = false;       // interpolate missing slices
  bool assume_hounsfield = false;  // do not check whether the values can be HU
  std::string level;               // the interspace of the plan, "L3_L4", or empty; see choose_path
  std::string lowest_vertebra;     // the vertebra above the lowest interspace, "L5", or empty
  std::string conus;               // level of the end of the cord, "L1" or "L1_L2"; empty = by `age`
  std::optional<double> age;       // years, for the level of the conus; without it that of an adult
};

struct TissueAmount {
  std::string title;
  double millilitres = 0.0;
};

// The result, for people.
struct CaseSummary {
  anatomy::CaseDescription description;
  anatomy::Grid ct, tissues;
  std::vector<TissueAmount> amounts;  // by amount, largest first; without air
};

// Builds a case folder: ct.nrrd, structures.nrrd (only with labels), tissues.nrrd, case.xml, and tissues.xml, the
// tissue library, if given. It is written under a temporary name in the same folder (DIR.partial-PID) and renamed
// when it is complete, so an existing folder is always complete. Throws InputError for invalid input, SystemError for
// a disk error; nothing is left behind then.
CaseSummary build_imported_case(const NewCase& wanted, const ImportOptions& options, const Progress& progress = {});
CaseSummary build_synthetic_case(const NewCase& wanted, const LumbarParameters& parameters,
                                 const Progress& progress = {});

}  // namespace bodkin::patient
