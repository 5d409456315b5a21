#pragma once

#include <optional>
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

// For every interspace the path with the most clearance to bone, of those 0 to 24 degrees cephalad and up to 4
// degrees sideways that meet no bone; interspaces without such a path are left out. The order is that of
// `spine.interspaces`.
std::vector<PlannedPath> plan_paths(const anatomy::TissueVolume& tissues, const SpineView& view,
                                    const LumbarSpine& spine);

// The path to propose: L3/L4, else L4/L5, else L2/L3, each when it leaves 2.5 mm to bone; else the roomiest.
std::optional<PlannedPath> best_path(const std::vector<PlannedPath>& paths);

// The narrower paths that best_path() would rather have taken than `taken`, in its order.
std::vector<PlannedPath> passed_over(const std::vector<PlannedPath>& paths, const PlannedPath& taken);

// The last point of the body on the ray from `inside` along `direction` (unit), and whether it is skin that ends
// there.
struct SkinPoint {
  Vec3 point;
  bool skin;
};
SkinPoint skin_along(const anatomy::TissueVolume& tissues, const Vec3& inside, const Vec3& direction);

}  // namespace bodkin::patient
