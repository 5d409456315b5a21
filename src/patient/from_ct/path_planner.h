#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "patient/from_ct/lumbar_landmarks.h"

#include "anatomy/case.h"

namespace bodkin::patient {

// A straight path from the skin through one interspace into the dural sac.
struct PlannedPath {
  std::string interspace;
  anatomy::NeedlePath path;
  double clearance = 0.0;  // mm from the needle's axis to the nearest bone
  double cephalad = 0.0;   // degrees towards the head
  bool from_skin = true;   // false: the image ends before the skin
};

// For every interspace the path with the most clearance to bone, among those 0 to 24 degrees cephalad and up to 4
// degrees sideways that meet neither bone nor spinal cord, including the 5 mm after their target; interspaces without
// such a path are left out. The order is that of `spine.interspaces`.
std::vector<PlannedPath> plan_paths(const anatomy::TissueVolume& tissues, const SpineView& view,
                                    const LumbarSpine& spine);

struct PathChoice {
  std::optional<PlannedPath> path;
  std::vector<PlannedPath> passed_over;  // narrower paths with a higher priority
  std::string why_not;                   // the end of a sentence; empty with a path
};

// The path to propose. Without `level` only if levels are known, at interspaces allowed by may_plan_at() and whose
// vertebrae the image border does not cut: L3/L4, else L4/L5, else L2/L3, each if it leaves 2.5 mm to bone; else the
// one with the most room. `allowed` are the interspaces that the procedure may enter, empty for all. With `level`,
// the name of an interspace, the path there, allowed or not; throws InputError with the reason if there is none, and
// if levels are unknown.
PathChoice choose_path(const std::vector<PlannedPath>& paths, const LumbarSpine& spine, const std::string& level,
                       std::span<const std::string> allowed = {});

// Depth (mm from the entry) at which a path first meets spinal cord, up to `beyond` mm after its target; empty if it
// does not.
std::optional<double> depth_of_cord(const anatomy::TissueVolume& tissues, const anatomy::NeedlePath& path,
                                    double beyond);

// The last point of the body on the ray from `inside` along `direction` (unit), and whether the body ends there with
// skin.
struct SkinPoint {
  Vec3 point;
  bool skin;
};
SkinPoint skin_along(const anatomy::TissueVolume& tissues, const Vec3& inside, const Vec3& direction);

}  // namespace bodkin::patient
