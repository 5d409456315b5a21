#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "patient/planning/clearance.h"

namespace bodkin::patient {

// Which paths are worth proposing.
struct PathWishes {
  double longest = 85.0;         // mm from skin to target: what the needle reaches
  Vec3 outwards = Vec3::Zero();  // unit, the middle of the cone in which ways out are looked for; zero: all around
  double cone = 180.0;           // degrees from it
  double flattest = 60.0;        // degrees between the path and the skin's normal
  double apart = 8.0;            // degrees between two proposals
  std::size_t count = 6;
};

// For the needle and the rules of a procedure: a spine is entered from behind, within 40 degrees.
PathWishes wishes_for(const anatomy::Needle& needle, const PlanningRules& rules);

struct PathSearch {
  std::vector<PathReport> proposals;  // the best first; all of them leave every margin
  std::string why_not;                // a sentence; empty with proposals
  std::size_t looked_at = 0;          // directions
};

// Straight paths from the skin to `target` that keep every margin of `obstacles`, best first. Ways out are tried 5
// degrees apart, then 1 degree apart about the good ones; without any, 2.5 degrees apart all over before it is said
// that there is none. Better is: more room, up to 8 mm more than the margins ask for; shorter (0.05 mm of room a mm);
// less oblique to the skin and to the sagittal plane. Runs on all processors; a stop gives what was found so far.
PathSearch search_paths(const PatientView& patient, const Obstacles& obstacles, const Vec3& target,
                        const PathWishes& wishes, const std::stop_token& stop = {});

// Where the ray from `inside` along `direction` (unit) leaves the body, 0.1 mm before the air; nothing where the
// image ends first or within `reach` mm no air is met.
std::optional<Vec3> way_out(const anatomy::TissueVolume& tissues, const Vec3& inside, const Vec3& direction,
                            double reach);

// The direction out of the body at a point on its skin, averaged over 4 mm; nothing where no air is near.
std::optional<Vec3> skin_normal(const anatomy::TissueVolume& tissues, const Vec3& point);

// The target that a structure of the segmentation means: its centre of mass, or where that lies outside of it (a
// crescent), the point deepest inside. Throws InputError when there is no such structure, with the names that there
// are, or when it has no voxel.
Vec3 target_in_structure(const PatientView& patient, const std::string& name);

}  // namespace bodkin::patient
