#pragma once

#include <gtest/gtest.h>

#include "core/geometry.h"

namespace bodkin {

inline void expect_near(const Vec3& found, const Vec3& expected, double tolerance = 1e-12) {
  EXPECT_NEAR((found - expected).norm(), 0.0, tolerance) << found.transpose() << " for " << expected.transpose();
}

}  // namespace bodkin
