#pragma once

#include <optional>
#include <string>
#include <vector>

#include "anatomy/volume.h"
#include "training/attempt.h"
#include "training/procedure.h"

namespace bodkin::training {

// What the tip did to something that it must not enter.
struct Harm {
  std::string title;        // "the cord or a nerve root"
  std::string consequence;  // what it does to a patient; may be empty
  Grade grade = Grade::dangerous;
  bool entered = false;      // false: the tip only came closer than the margin
  int entries = 0;           // counted again after reentry_mm of travel outside
  double first_time = 0.0;   // s since the first tick; of a near miss, when the tip was closest
  double first_depth = 0.0;  // mm along the needle's line, at the same time
  double deepest = 0.0;      // mm, greatest depth of the tip while in it
  double time_inside = 0.0;  // s
  double closest = 0.0;      // mm from the tip; 0 when entered
};

struct PatientSurfaces;

// The voxels of the patient, for what a session does not keep. Any may be null.
struct PatientVolumes {
  const anatomy::LabelVolume* structures = nullptr;
  const anatomy::TissueVolume* tissues = nullptr;
  const PatientSurfaces* surfaces = nullptr;  // of both, by surfaces_of(), where many attempts are measured
};

// The surfaces of what a procedure and the case forbid. Both volumes of `volumes` must be there.
PatientSurfaces surfaces_of(const PatientVolumes& volumes, const anatomy::CaseDescription& description,
                            const anatomy::TissueLibrary& library, const Procedure& procedure);

// How near the tip came to something that it must not enter, however far that was.
struct ForbiddenDistance {
  std::string title;
  std::optional<double> closest;  // mm, 0 where it was entered; nothing: it was never within 100 mm, or is not there
  double time = 0.0;              // s since the first tick, when the tip was closest
  double depth = 0.0;             // mm, at the same time
};

struct HarmReport {
  std::vector<Harm> harms;                   // the worst first, then in the order of time
  std::vector<ForbiddenDistance> distances;  // of all that was looked for, the nearest first
  std::vector<std::string> unchecked;        // structures that might have been entered: their voxels are not at hand
};

// Finds every entry into what the procedure forbids, and into structures that the case marks as critical. One tick
// with the tip inside is an entry. A critical structure that the planned target lies in, or adjoins on the planned
// path, is the organ that the needle is meant for, and no harm.
//
// The tissue at the tip is the session's own. Structures need `volumes.structures`; without, those whose tissue the
// procedure forbids too are still found by it, and the others are told as unchecked. Near misses and distances need
// the volumes. Throws InputError for a forbidden tissue that neither the session nor Bodkin knows: it would never be
// found.
HarmReport find_harm(const Attempt& attempt, const Procedure& procedure, const PatientVolumes& volumes);

// Throws InputError unless `tissue` is one of the library that comes with Bodkin: for a tissue that a session's
// patient does not have.
void require_known_tissue(const std::string& tissue, const Procedure& procedure);

// mm from a point (LPS) to the nearest voxel that has this value, measured to the voxel's box; `limit` where there is
// none within it.
template <typename Voxel>
double distance_to_value(const anatomy::Volume<Voxel>& volume, const Vec3& point, Voxel value, double limit);

extern template double distance_to_value(const anatomy::LabelVolume&, const Vec3&, std::uint16_t, double);
extern template double distance_to_value(const anatomy::TissueVolume&, const Vec3&, std::uint8_t, double);

}  // namespace bodkin::training
