#include "station/probe_contact.h"

#include <cmath>
#include <limits>

#include "tests/one_tick.h"
#include "tests/simulation/real_time_guard.h"
#include "tests/simulation/slab_patient.h"
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::station;
namespace {

// The skin is the plane z = 0: the last air voxel is centred at -0.5 mm, the first skin voxel at +0.5.
class ProbeContactTest : public ::testing::Test {
 protected:
  Case patient_ = slab_patient();
};

TEST_F(ProbeContactTest, depth_is_measured_from_the_skin_along_the_axis) {
  for (const double depth : {0.05, 0.3, 0.77, 5.0, 17.31, 39.9}) {
    EXPECT_NEAR(depth_below_skin(patient_.tissues, {3.0, -4.0, depth}, Vec3::UnitZ()), depth, 1e-3) << depth;
  }
  for (const double above : {-0.05, -1.0, -39.0, -500.0}) {
    EXPECT_EQ(depth_below_skin(patient_.tissues, {3.0, -4.0, above}, Vec3::UnitZ()), 0.0) << above;
  }
  const Vec3 oblique = Vec3(3.0, 0.0, 4.0).normalized();
  EXPECT_NEAR(depth_below_skin(patient_.tissues, {0.0, 0.0, 8.0}, oblique), 10.0, 1e-2);
}

TEST_F(ProbeContactTest, a_way_that_begins_in_the_body_is_forty_millimetres) {
  EXPECT_EQ(depth_below_skin(patient_.tissues, {0.0, 0.0, 60.0}, Vec3::UnitZ()), 40.0);
}

TEST_F(ProbeContactTest, air_in_the_body_is_not_its_outside) {
  std::vector<TissueId> slabs = spine_slabs();
  std::fill(slabs.begin() + 10, slabs.begin() + 15, tissue::air);
  const Case hollow = slab_patient(slabs);
  EXPECT_NEAR(depth_below_skin(hollow.tissues, {0.0, 0.0, 18.0}, Vec3::UnitZ()), 18.0, 1e-3);
}

TEST_F(ProbeContactTest, a_place_that_is_none_is_air) {
  EXPECT_EQ(depth_below_skin(patient_.tissues, Vec3::Constant(std::nan("")), Vec3::UnitZ()), 0.0);
  EXPECT_EQ(depth_below_skin(patient_.tissues, Vec3::Constant(1e300), Vec3::UnitZ()), 0.0);
}

TEST_F(ProbeContactTest, pushes_back_along_its_axis_with_fifteen_newtons_at_most) {
  ProbeContact probe(patient_.tissues, one_tick, 0.0, 1.0, 0.002);
  Vec3 force = probe.step(needle_at(-5.0).needle);
  EXPECT_EQ(force, Vec3::Zero());
  for (int i = 0; i < 200; ++i) force = probe.step(needle_at(5.0).needle);
  EXPECT_NEAR((force - Vec3(0.0, 0.0, -2.0)).norm(), 0.0, 1e-3);  // 0.4 N/mm, at rest
  for (int i = 0; i < 200; ++i) force = probe.step(needle_at(39.0).needle);
  EXPECT_NEAR((force - Vec3(0.0, 0.0, -15.0)).norm(), 0.0, 1e-9);
  for (int i = 0; i < 3; ++i) force = probe.step(needle_at(-1.0).needle);
  EXPECT_EQ(force, Vec3::Zero());
}

TEST_F(ProbeContactTest, a_tick_neither_allocates_nor_locks) {
  if (!RealTimeGuard::available()) GTEST_SKIP() << "a sanitizer needs the heap's functions for itself";
  ProbeContact probe(patient_.tissues, one_tick, 0.05, 1.0, 0.002);
  const RealTimeGuard guard;
  for (int i = 0; i < 300; ++i) probe.step(needle_at(-5.0 + 0.1 * i).needle);
  EXPECT_EQ(RealTimeGuard::heap_calls(), 0u);
  EXPECT_EQ(RealTimeGuard::lock_calls(), 0u);
}

TEST_F(ProbeContactTest, resists_motion_into_the_skin) {
  ProbeContact probe(patient_.tissues, one_tick, 0.0, 1.0, 0.002);
  Vec3 force = Vec3::Zero();
  double depth = 1.0;
  for (int i = 0; i < 300; ++i) force = probe.step(needle_at(depth += 20.0 * one_tick).needle);  // 20 mm/s
  EXPECT_NEAR(-force.z(), 0.4 * depth + 0.002 * 20.0, 2e-3);
  ProbeContact weak(patient_.tissues, one_tick, 0.0, 0.1, 0.0);
  for (int i = 0; i < 200; ++i) force = weak.step(needle_at(5.0).needle);
  EXPECT_NEAR(-force.z(), 0.5, 1e-3) << "no stiffer than the device";
}

}  // namespace
}  // namespace bodkin
