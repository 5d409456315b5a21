#pragma once

#include <filesystem>
#include <string>

#include "anatomy/case.h"

namespace bodkin::views {

// An opened patient, immutable while it is shared. CT, labels and tissues are those of the case; a CT or labels may
// be absent (empty volumes), the tissues may not.
struct OpenCase {
  anatomy::Case patient;
  std::filesystem::path folder;
  std::string title;      // of the patient, for people
  std::string procedure;  // its title, "CT-guided biopsy"

  const anatomy::CaseDescription& description() const noexcept { return patient.description; }
};

// The name of the structure at `point` (LPS mm) for people: labelled ("vertebra L3"), or else the tissue.
std::string place_name(const anatomy::Case& patient, const Vec3& point);

// As above, for a tip that touches `tissue` of the deformed material, which is at `point` at rest: at a boundary that
// of the tissue in front of it, along `inwards`.
std::string place_name(const anatomy::Case& patient, const Vec3& point, const Vec3& inwards,
                       anatomy::TissueId tissue);

// "vertebrae_L3" as people read it: "vertebra L3".
std::string readable_structure(const std::string& name);

}  // namespace bodkin::views
