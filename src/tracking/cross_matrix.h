#pragma once

#include "core/geometry.h"

namespace bodkin::tracking {

// The matrix of the cross product: it maps x to v x.
inline Mat3 cross_matrix(const Vec3& v) {
  Mat3 matrix;
  matrix << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return matrix;
}

}  // namespace bodkin::tracking
