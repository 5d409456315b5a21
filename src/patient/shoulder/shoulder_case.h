#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "patient/shoulder/shoulder.h"

#include "anatomy/case.h"

namespace bodkin::patient {

// A case of a synthetic shoulder.
struct ShoulderCase {
  std::filesystem::path folder;
  bool overwrite = false;
  std::string name;  // empty: the folder's
  ShoulderTarget target = ShoulderTarget::joint;
  std::string procedure;                  // empty: joint_injection, or ultrasound_guided_nerve_block at the nerve
  std::optional<anatomy::Needle> needle;  // none: of `gauge`, 50 mm long if that reaches, or else 90 mm
  int gauge = 22;
  anatomy::Mechanics mechanics = anatomy::Mechanics::physical;
  ShoulderParameters shoulder;
};

// Writes it with a tissue library of its own. Atomic. Throws InputError for sizes out of range, and a folder that may
// not be replaced; SystemError for a disk error.
anatomy::CaseDescription write_shoulder_case(const ShoulderCase& wanted, const Progress& progress = {});

}  // namespace bodkin::patient
