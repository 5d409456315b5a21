#pragma once

#include <Eigen/Core>

#include "anatomy/needle_path.h"

namespace bodkin::views {

// A side of the patient.
enum class Side { none, cranial, caudal, left, right, anterior, posterior };

// The pose of a needle, seen along its planned path from behind: x to the viewer's right, y towards the patient's
// head (towards the front for a path along the body).
struct PathOffset {
  Eigen::Vector2d tip = Eigen::Vector2d::Zero();  // mm from the path to the tip
  Eigen::Vector2d hub = Eigen::Vector2d::Zero();  // mm from the path to the shaft, at the height of the entry
  double distance = 0.0;                          // mm from the path to the tip
  double angle = 0.0;                             // degrees between needle and path
  double to_target = 0.0;                         // mm along the path from the tip to the target; negative: beyond it
  Side side = Side::none;                         // of the tip relative to the path; none within half a millimetre
};

// `axis`: of the needle, unit, hub to tip; `tip`: LPS mm. A path without length gives zeros.
PathOffset path_offset(const anatomy::NeedlePath& path, const Vec3& tip, const Vec3& axis);

}  // namespace bodkin::views
