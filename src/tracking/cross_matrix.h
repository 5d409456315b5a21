#pragma once

#include "core/geometry.h"

namespace bodkin::tracking {

// The matrix that makes of x the cross product v x.
inline Mat3 cross_matrix(const Vec3& v) {
  Mat3 matrix;
  matrix << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return matrix;
}

}  // namespace bodkin::tracking
