#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "patient/acupuncture/atlas.h"

#include "core/progress.h"

namespace bodkin::app {

// The synthetic patient on whom a procedure that comes with Bodkin is practised from the start page.
struct PracticePatient {
  std::string_view procedure;  // as in share/bodkin/procedures
  std::string_view folder;     // below the folder of patients
  const char* words;           // who it is and what is done, one short line; in the dictionary of the languages
  bool with_ultrasound;        // the probe is there from the first attempt on
};

// In the order in which they are offered; one for each procedure that comes with Bodkin.
std::span<const PracticePatient> practice_patients();
// The lumbar torso of the first of them, which everything uses that wants just a patient.
const PracticePatient& built_in_patient();
// Null where none has that name.
const PracticePatient* find_practice_patient(std::string_view procedure);

// Makes the case in `folder`, as `bodkin case synthesize` would. Returns notes, one sentence each. Throws InputError,
// SystemError, and what `progress` throws; the folder is whole or not there.
std::vector<std::string> make_practice_patient(const PracticePatient& patient, const std::filesystem::path& folder,
                                               const Progress& progress);

// The block of a body about an acupuncture point, in the folder of patients; made where it is not there yet.
std::filesystem::path needle_point_case(const patient::Atlas& atlas, const std::string& code,
                                        const std::filesystem::path& patients, const Progress& progress);

}  // namespace bodkin::app
