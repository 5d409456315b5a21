#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "anatomy/case.h"

namespace bodkin::patient {

// The parts of a patient used by a plan. They must outlive it.
struct PatientView {
  const anatomy::TissueVolume& tissues;
  const anatomy::LabelVolume& structures;           // may be empty
  const std::vector<anatomy::Structure>& table;     // meaning of its labels
  const std::vector<anatomy::Landmark>& landmarks;  // interspaces and conus, if a spine was found
  const anatomy::TissueLibrary& library;
};
PatientView view_of(const anatomy::Case& patient);

// An obstacle of a procedure: a tissue of the library or a structure of the segmentation, by name.
struct AvoidRule {
  std::string tissue, structure;  // exactly one of them
  std::string title;              // as people read it, "a large vessel"; empty: the tissue's or structure's name
  double margin = 0.0;            // mm; 0: PlanningRules::margin
};

// How paths are planned for a procedure. Margins are from the needle's axis, mm. [D]
struct PlanningRules {
  std::vector<AvoidRule> avoid;
  std::vector<std::string> levels;  // interspaces that may be entered, "L3_L4"; empty: any place of the body
  double bone_margin = 2.0;
  double margin = 3.0;  // of those that state none: forbidden tissues, and structures that the case marks as critical
  double cord_margin = 5.0;  // of the spinal cord, at least
};

// One kind of obstacle.
struct Obstacle {
  std::string name;     // "bone", or of the tissue or structure
  std::string title;    // as people read it
  double margin = 0.0;  // mm that a path must keep; less than the rule's if the target itself is closer
};

// All kinds, marked voxel by voxel.
struct Obstacles {
  std::vector<Obstacle> kinds;       // the first one is bone
  anatomy::Volume<std::uint8_t> at;  // on the lattice of the tissues: 0 free, else 1 + position in `kinds`
};

// The obstacles of a path to `target` (LPS mm): bone and metal, those named in `rules`, and structures that the case
// marks as critical. The organ that contains the target, or contains the lesion with the target, is intended to be
// entered and left out; so is a forbidden tissue at the target itself, except the cord. Throws InputError for a
// tissue that the library does not have, and for more than 254 kinds.
Obstacles find_obstacles(const PatientView& patient, const PlanningRules& rules, const Vec3& target);

// Why a puncture of the spine may not be planned at `target`, as the end of a sentence; empty if it may, and for
// rules without levels. It may at an interspace that the rules allow, at L2/L3 or below, a whole vertebra below the
// conus.
std::optional<std::string> level_problem(const PatientView& patient, const PlanningRules& rules, const Vec3& target);

// The interspace at `target` ("L3_L4"), by the nearest landmark within 25 mm along the spine; empty: none is known
// there.
std::string level_at(const PatientView& patient, const Vec3& target);

// The middles of the interspaces at which the rules allow a plan, from head to foot.
std::vector<anatomy::Landmark> allowed_levels(const PatientView& patient, const PlanningRules& rules);

// "inferior_vena_cava" becomes "inferior vena cava".
std::string spoken(std::string name);

}  // namespace bodkin::patient
