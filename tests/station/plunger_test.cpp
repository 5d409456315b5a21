#include "station/plunger.h"

#include <algorithm>
#include <limits>

#include "tests/one_tick.h"
#include "tests/simulation/real_time_guard.h"
#include <gtest/gtest.h>

#include "io/tissue_library_file.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
using namespace bodkin::station;
namespace {

constexpr double area = 176.71459;  // mm^2, of 15 mm bore
const Vec3 start(12.0, -7.0, 30.0);

// A hand that is armed at `start` and moves down by `down` mm in `time` s.
class PlungerTest : public ::testing::Test {
 protected:
  PlungerTest() { plunger_.step(start, tissue::air, false); }
  Vec3 go(double down, double time, TissueId tissue) {
    const int ticks = static_cast<int>(time / one_tick);
    Vec3 force = Vec3::Zero();
    for (int i = 1; i <= ticks; ++i)
      force = plunger_.step(start - (at_ + down * i / ticks) * Vec3::UnitZ(), tissue, true);
    at_ += down;
    return force;
  }
  Plunger plunger_{default_tissue_library(), one_tick, 1.0, 0.0};
  double at_ = 0.0;  // mm in
};

// The device renders 1 N/mm, so the syringe is a spring of 1 N/mm as long as nothing flows out.
TEST_F(PlungerTest, ligament_is_a_spring_of_the_devices_stiffness) {
  const Vec3 force = go(5.0, 0.5, tissue::ligamentum_flavum);
  EXPECT_NEAR(force.z(), 5.0, 0.01);
  EXPECT_NEAR(plunger_.pressure(), 5.0 / area, 1e-4);
  EXPECT_NEAR(plunger_.volume(), 5.0 * area, 1e-3);
  EXPECT_EQ(force.head<2>(), Eigen::Vector2d(0.0, 0.0));
}

// R = 1e-5 + 1.604e-6 MPa s/mm^3 and C = A^2 mm/N: R C = 0.362 s. The pressure falls to that of the space, 0.6 kPa.
TEST_F(PlungerTest, the_force_collapses_in_the_epidural_space) {
  go(5.0, 0.5, tissue::ligamentum_flavum);
  const double within = 6e-4 * area;  // N
  EXPECT_NEAR(go(0.0, 0.362, tissue::epidural_fat).z(), within + (5.0 - within) / 2.71828, 0.03);
  EXPECT_NEAR(go(0.0, 4.0, tissue::epidural_fat).z(), within, 0.01);
}

TEST_F(PlungerTest, ends_in_a_stop_when_the_barrel_is_empty) {
  go(60.0, 20.0, tissue::air);
  EXPECT_NEAR(plunger_.volume(), 60.0 * area, 1e-2);
  go(0.0, 2.0, tissue::air);
  EXPECT_NEAR(go(3.0, 0.1, tissue::air).z(), 3.0, 1e-2) << "1 N/mm beyond the end";
  EXPECT_EQ(plunger_.travel(), 60.0);
}

TEST_F(PlungerTest, pulled_out_there_is_no_force) {
  go(5.0, 0.5, tissue::ligamentum_flavum);
  EXPECT_LT(go(-4.0, 0.1, tissue::ligamentum_flavum).z(), 1.1);
  EXPECT_EQ(go(-2.0, 0.1, tissue::ligamentum_flavum), Vec3::Zero());
  EXPECT_EQ(plunger_.volume(), 0.0);
}

TEST_F(PlungerTest, sideways_a_spring_leads_back_with_one_newton_at_most) {
  EXPECT_TRUE(plunger_.step(start + Vec3(3.0, -4.0, 0.0), tissue::air, true).isApprox(Vec3(-0.6, 0.8, 0.0), 1e-12));
  EXPECT_TRUE(plunger_.step(start + Vec3(30.0, -40.0, 0.0), tissue::air, true).isApprox(Vec3(-0.6, 0.8, 0.0), 1e-12));
  EXPECT_TRUE(plunger_.step(start + Vec3(1.0, 0.0, 0.0), tissue::air, true).isApprox(Vec3(-0.2, 0.0, 0.0), 1e-12));
}

TEST_F(PlungerTest, a_hand_that_is_not_armed_takes_a_full_syringe_along) {
  go(5.0, 0.5, tissue::ligamentum_flavum);
  EXPECT_EQ(plunger_.step(start - 9.0 * Vec3::UnitZ(), tissue::ligamentum_flavum, false), Vec3::Zero());
  EXPECT_EQ(plunger_.pressure(), 0.0);
  EXPECT_EQ(plunger_.step(start - 9.0 * Vec3::UnitZ(), tissue::ligamentum_flavum, true), Vec3::Zero());
  EXPECT_NEAR(plunger_.step(start - 9.1 * Vec3::UnitZ(), tissue::ligamentum_flavum, true).z(), 0.1, 1e-3);
}

TEST_F(PlungerTest, a_tick_neither_allocates_nor_locks) {
  if (!RealTimeGuard::available()) GTEST_SKIP() << "a sanitizer needs the heap's functions for itself";
  const RealTimeGuard guard;
  go(8.0, 0.5, tissue::ligamentum_flavum);
  go(-9.0, 0.5, tissue::epidural_fat);
  EXPECT_EQ(RealTimeGuard::heap_calls(), 0u);
  EXPECT_EQ(RealTimeGuard::lock_calls(), 0u);
}

TEST(Plunger, never_is_stiffer_than_the_device) {
  for (const double stiffness : {0.5, 1.0, 3.0}) {
    Plunger plunger(default_tissue_library(), one_tick, stiffness, 0.0);
    plunger.step(Vec3::Zero(), tissue::ligamentum_flavum, false);
    const double force = plunger.step(Vec3(0.0, 0.0, -1.0), tissue::ligamentum_flavum, true).z();
    EXPECT_NEAR(force, std::min(1.0, stiffness), 1e-3) << stiffness;
  }
}

}  // namespace
}  // namespace bodkin
