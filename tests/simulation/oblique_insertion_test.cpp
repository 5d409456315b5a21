// A law of one scalar along a slanted needle: one threshold along the line, and a force along that line alone.
#include "tests/simulation/model_pairs.h"
#include <gtest/gtest.h>

#include "simulation/haptic_tick.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::simulation;
namespace {

TEST(ObliqueInsertion, the_tracking_wall_saturates_along_the_line_and_not_along_each_axis) {
  HapticTick tick(patient_for({"", TrackingWallSettings{}, {}}, {"none", NoConstraint{}}));
  const Vec3 axis(0.6, 0.0, 0.8);
  TickOutput output;
  for (double depth = -3.0; depth <= 30.0; depth += 0.02) output = tick.step(needle_at(depth * axis, axis));
  // K_t 0.5 N/mm and f_R 1 N are the defaults of a tissue; a threshold for each axis would give 1.41 N.
  EXPECT_NEAR(output.resistance, 1.0, 1e-9);
  EXPECT_NEAR((output.requested.force + axis).norm(), 0.0, 1e-9);
}

}  // namespace
}  // namespace bodkin
