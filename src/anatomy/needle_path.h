#pragma once

#include "core/geometry.h"

namespace bodkin::anatomy {

// A straight needle path, LPS mm.
struct NeedlePath {
  Vec3 entry = Vec3::Zero();   // on the skin
  Vec3 target = Vec3::Zero();  // where the tip should end

  double length() const { return (target - entry).norm(); }
  Vec3 direction() const { return (target - entry).normalized(); }
};

}  // namespace bodkin::anatomy
