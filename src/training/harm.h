#pragma once

#include <optional>
#include <string>
#include <vector>

#include "anatomy/volume.h"
#include "training/attempt.h"
#include "training/procedure.h"

namespace bodkin::training {

// Contact of the tip with a structure that it must not enter.
struct Harm {
  std::string title;        // "the cord or a nerve root"
  std::string consequence;  // for a patient; may be empty
  Grade grade = Grade::dangerous;
  bool entered = false;      // false: the tip only came closer than the margin
  int entries = 0;           // a new entry needs reentry_mm of travel outside
  double first_time = 0.0;   // s since the first tick; for a near miss, when the tip was closest
  double first_depth = 0.0;  // mm along the needle's line, at the same time
  double deepest = 0.0;      // mm, greatest depth of the tip while in it
  double time_inside = 0.0;  // s
  double closest = 0.0;      // mm from the tip; 0 when entered
};

struct PatientSurfaces;

// The voxels of the patient, which a session does not keep. Any may be null.
struct PatientVolumes {
  const anatomy::LabelVolume* structures = nullptr;
  const anatomy::TissueVolume* tissues = nullptr;
  const PatientSurfaces* surfaces = nullptr;  // of both, from surfaces_of(), for scoring many attempts
};

// The surfaces of everything forbidden by a procedure and the case. Both volumes of `volumes` must be set.
PatientSurfaces surfaces_of(const PatientVolumes& volumes, const anatomy::CaseDescription& description,
                            const anatomy::TissueLibrary& library, const Procedure& procedure);

// Smallest distance of the tip from a structure that it must not enter, at any distance.
struct ForbiddenDistance {
  std::string title;
  std::optional<double> closest;  // mm, 0 if it was entered; empty: it was never within 100 mm, or does not exist
  double time = 0.0;              // s since the first tick, when the tip was closest
  double depth = 0.0;             // mm, at the same time
};

struct HarmReport {
  std::vector<Harm> harms;                   // the worst first, then in chronological order
  std::vector<ForbiddenDistance> distances;  // of everything looked for, the nearest first
  std::vector<std::string> unchecked;  // structures that might have been entered: their voxels are not available
};

// Finds every entry into structures that the procedure forbids or the case marks as critical. One tick with the tip
// inside is an entry. A critical structure that contains the planned target, or adjoins it on the planned path, is
// the intended organ, and entering it is no harm.
//
// The tissue at the tip is the session's own. Structures need `volumes.structures`; without it, those whose tissue
// the procedure also forbids are still found by that tissue, and the others are reported as unchecked. Near misses
// and distances need the volumes. Throws InputError for a forbidden tissue unknown to the session and to Bodkin: it
// would never be found.
HarmReport find_harm(const Attempt& attempt, const Procedure& procedure, const PatientVolumes& volumes);

// Throws InputError unless `tissue` is in the library that comes with Bodkin: for a tissue that a session's patient
// does not have.
void require_known_tissue(const std::string& tissue, const Procedure& procedure);

// mm from a point (LPS) to the nearest voxel with this value, measured to the voxel's box; `limit` if there is none
// within it.
template <typename Voxel>
double distance_to_value(const anatomy::Volume<Voxel>& volume, const Vec3& point, Voxel value, double limit);

extern template double distance_to_value(const anatomy::LabelVolume&, const Vec3&, std::uint16_t, double);
extern template double distance_to_value(const anatomy::TissueVolume&, const Vec3&, std::uint8_t, double);

}  // namespace bodkin::training
