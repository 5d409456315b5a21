#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "patient/planning/clearance.h"

namespace bodkin::patient {

// Criteria for proposed paths.
struct PathCriteria {
  double longest = 85.0;         // mm from skin to target: the reach of the needle
  Vec3 outwards = Vec3::Zero();  // unit, axis of the cone of directions searched; zero: all directions
  double cone = 180.0;           // degrees from it
  double flattest = 60.0;        // degrees between the path and the skin's normal
  double apart = 8.0;            // degrees between two proposals
  std::size_t count = 6;
};

// For the needle and the rules of a procedure: a spine is entered from behind, within 40 degrees.
PathCriteria criteria_for(const anatomy::Needle& needle, const PlanningRules& rules);

struct PathSearch {
  std::vector<PathReport> proposals;  // the best first; all of them leave every margin
  std::string why_not;                // a sentence; empty if there are proposals
  std::size_t looked_at = 0;          // directions examined
};

// Straight paths from the skin to `target` that keep every margin of `obstacles`, best first. Directions are tried 5
// degrees apart, then 1 degree apart about the good ones; if there are none, 2.5 degrees apart everywhere before
// failure is reported. Better means: more room, up to 8 mm above the margins; shorter (0.05 mm of room per mm); less
// oblique to the skin and to the sagittal plane. Runs on all processors; a stop returns the paths found so far.
PathSearch search_paths(const PatientView& patient, const Obstacles& obstacles, const Vec3& target,
                        const PathCriteria& criteria, const std::stop_token& stop = {});

// The point where the ray from `inside` along `direction` (unit) leaves the body, 0.1 mm before the air; empty if the
// image ends first or there is no air within `reach` mm.
std::optional<Vec3> find_skin_exit(const anatomy::TissueVolume& tissues, const Vec3& inside, const Vec3& direction,
                                   double reach);

// The direction out of the body at a point on its skin, averaged over 4 mm; empty if no air is near.
std::optional<Vec3> skin_normal(const anatomy::TissueVolume& tissues, const Vec3& point);

// The target of a structure of the segmentation: its centre of mass or, if that lies outside it (a crescent), its
// deepest point. Throws InputError when there is no such structure, listing the names that exist, or when it has no
// voxel.
Vec3 target_in_structure(const PatientView& patient, const std::string& name);

}  // namespace bodkin::patient
