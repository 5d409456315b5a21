#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "patient/acupuncture/atlas.h"

#include "core/progress.h"

namespace bodkin::app {

// The synthetic patient of a procedure supplied with Bodkin, offered on the start page.
struct PracticePatient {
  std::string_view procedure;  // as in share/bodkin/procedures
  std::string_view folder;     // below the folder of patients
  const char* words;           // patient and task in one short line; in the translations
  bool with_ultrasound;        // with the probe from the first attempt on
};

// In display order; one for each procedure supplied with Bodkin.
std::span<const PracticePatient> practice_patients();
// The lumbar torso of the first entry, used wherever any patient is sufficient.
const PracticePatient& built_in_patient();
// Null if none has that name.
const PracticePatient* find_practice_patient(std::string_view procedure);

// Creates the case in `folder`, as `bodkin case synthesize` does. Returns notes, one sentence each. Throws
// InputError, SystemError, and the exceptions of `progress`; the folder is then absent, never incomplete.
std::vector<std::string> make_practice_patient(const PracticePatient& patient, const std::filesystem::path& folder,
                                               const Progress& progress);

// The block of a body around an acupuncture point, in the folder of patients; created if it does not exist.
std::filesystem::path needle_point_case(const patient::Atlas& atlas, const std::string& code,
                                        const std::filesystem::path& patients, const Progress& progress);

}  // namespace bodkin::app
