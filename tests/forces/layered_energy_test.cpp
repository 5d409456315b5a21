#include <numbers>

#include "tests/forces/layered_rig.h"
#include "tests/sanitized.h"
#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {

using namespace bodkin::anatomy;
namespace {

using namespace tissue;

std::vector<Slab> random_body(Random& random) {
  const TissueId kinds[] = {skin, fat, muscle, ligamentum_flavum, epidural_fat};
  std::vector<Slab> slabs = {{skin, 2.0}};
  double depth = 2.0;
  while (depth < 60.0) {
    const double thickness = 0.5 * static_cast<double>(1 + random.next() % 20);
    slabs.push_back({kinds[random.next() % 5], thickness});
    depth += thickness;
  }
  if (random.uniform() < 0.2) slabs.insert(slabs.begin() + 3, {cortical_bone, 5.0});
  return slabs;
}

// A random motion from the surface into the body and back to it.
struct ClosedMotion {
  explicit ClosedMotion(Random& random) : reach(random.uniform(1.0, 40.0)) {
    for (double& amplitude : amplitudes) amplitude = random.uniform(-0.4, 0.4);
  }
  double depth(double part) const {  // part: 0 to 1
    double shape = 1.0;
    for (int k = 0; k < 4; ++k) shape += amplitudes[k] * std::sin(2.0 * std::numbers::pi * (k + 2) * part);
    return reach * std::sin(std::numbers::pi * part) * std::max(0.0, shape);
  }
  double reach;
  double amplitudes[4];
};

// For any way in and out, the hand does not get more work out than it put in. 10 000 ways.
TEST(LayeredEnergy, no_closed_way_gains_work) {
  Random random(4);
  double least = 1e9;
  for (int body = 0; body < (sanitized ? 10 : 100); ++body) {
    const std::vector<Slab> slabs = random_body(random);
    const double device_stiffness = body % 2 == 0 ? 1e9 : 1.0;
    LayeredRig rig(slabs, rig_library(), {}, device_stiffness);
    for (int trial = 0; trial < 100; ++trial) {
      rig.model.begin();
      rig.to(0.0, 0.0, true);
      rig.work = 0.0;
      const ClosedMotion motion(random);
      const int ticks = 800;
      for (int tick = 1; tick <= ticks; ++tick) rig.to(motion.depth(static_cast<double>(tick) / ticks));
      rig.to(0.0);
      least = std::min(least, rig.work);
      ASSERT_GE(rig.work, -2e-3) << "body " << body << ", way " << trial << ", reach " << motion.reach;
      rig.events.clear();
    }
  }
  EXPECT_LT(least, 5.0);  // some ways hardly do anything, so the bound was tested where it is tight
}

// The same in a body that was punctured before, from a depth and back to it, with the same tissues gripping.
TEST(LayeredEnergy, no_cycle_in_a_punctured_channel_gains_work) {
  Random random(8);
  for (int trial = 0; trial < (sanitized ? 100 : 2000); ++trial) {
    LayeredRig rig(random_body(random));
    rig.move(45.0, 40.0);
    const double start = random.uniform(0.0, 40.0);
    rig.move(start, 40.0);
    double total = 0.0;
    for (int cycle = 0; cycle < 3; ++cycle) {
      rig.work = 0.0;
      const ClosedMotion motion(random);
      const double size = random.uniform(0.02, 1.0);
      for (int tick = 1; tick <= 800; ++tick) rig.to(start + size * motion.depth(tick / 800.0));
      rig.to(start);
      total += rig.work;
    }
    // Energy stored in stretched tissue before the cycle may be returned; it is less than this.
    ASSERT_GE(total, -0.6) << "trial " << trial;
  }
}

}  // namespace
}  // namespace bodkin
