#include "anatomy/generic_device.h"

#include <gtest/gtest.h>

namespace bodkin::anatomy {
namespace {

Needle needle_of(int gauge) {
  const GaugeSize size = gauge_size(gauge).value();
  Needle needle;
  needle.gauge = gauge;
  needle.outer_diameter = size.outer_diameter;
  needle.inner_diameter = size.inner_diameter;
  return needle;
}

TEST(GenericDevice, is_strong_enough_for_the_needle_and_never_weaker_for_a_thicker_one) {
  double before = 1e9;
  for (const GaugeSize& size : gauge_sizes()) {  // the thickest first
    const DeviceLimits device = generic_device(needle_of(size.gauge), Mechanics::physical);
    EXPECT_EQ(device.profile, "generic");
    EXPECT_LE(device.peak_force, before) << size.gauge;
    EXPECT_LT(device.continuous_force, device.peak_force);
    EXPECT_LE(device.peak_force / device.stiffness, 10.0) << "mm, its own give at that force";
    before = device.peak_force;
  }
  // N, of the ligamentum flavum with a Tuohy needle (docs/running.md), with a reserve for the shaft's friction.
  EXPECT_GE(generic_device(needle_of(16), Mechanics::physical).peak_force, 20.0);
  EXPECT_GE(generic_device(needle_of(18), Mechanics::physical).peak_force, 12.0);
  EXPECT_EQ(generic_device(needle_of(20), Mechanics::physical).peak_force, DeviceLimits{}.peak_force);
}

TEST(GenericDevice, is_the_same_for_every_needle_where_the_tables_know_none) {
  for (const int gauge : {10, 16, 18, 22, 34}) {
    const DeviceLimits device = generic_device(needle_of(gauge), Mechanics::tables);
    EXPECT_EQ(device.peak_force, DeviceLimits{}.peak_force);
    EXPECT_EQ(device.continuous_force, DeviceLimits{}.continuous_force);
  }
}

}  // namespace
}  // namespace bodkin::anatomy
