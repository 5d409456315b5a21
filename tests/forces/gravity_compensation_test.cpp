#include "forces/gravity_compensation.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
namespace {

TEST(GravityCompensation, is_one_constant_upward_force_without_a_slope) {
  const GravityCompensation model({.up = Vec3::UnitY(), .weight = 0.7});
  EXPECT_EQ(model.step(Vec3::Zero()), Vec3(0.0, 0.7, 0.0));
  EXPECT_EQ(model.step(Vec3(100.0, -50.0, 30.0)), Vec3(0.0, 0.7, 0.0));
}

TEST(GravityCompensation, follows_the_pose_where_a_slope_is_known) {
  const GravityCompensation model({.weight = 0.7, .slope = Vec3(0.002, 0.0, 0.0), .centre = Vec3(10.0, 0.0, 0.0)});
  EXPECT_NEAR(model.step(Vec3(10.0, 0.0, 0.0)).z(), 0.7, 1e-12);
  EXPECT_NEAR(model.step(Vec3(60.0, 0.0, 0.0)).z(), 0.8, 1e-12);
  EXPECT_EQ(model.step(Vec3(-1000.0, 0.0, 0.0)).z(), 0.0);
  EXPECT_EQ(model.step(Vec3(9000.0, 0.0, 0.0)).z(), 3.0);
}

TEST(GravityCompensation, is_recovered_from_measurements) {
  Random random(2);
  const Vec3 slope(0.001, -0.002, 0.0005);
  std::vector<GravitySample> samples;
  for (int i = 0; i < 40; ++i) {
    const Vec3 place(random.uniform(-80.0, 80.0), random.uniform(-60.0, 60.0), random.uniform(-40.0, 40.0));
    samples.push_back({place, 0.9 + slope.dot(place) + 0.005 * random.normal()});
  }
  const GravitySettings fit = fit_gravity(samples, Vec3::UnitZ());
  EXPECT_NEAR((fit.slope - slope).norm(), 0.0, 1e-4);
  EXPECT_NEAR(GravityCompensation(fit).step(Vec3::Zero()).z(), 0.9, 0.005);
}

TEST(GravityCompensation, few_or_flat_samples_give_no_slope_out_of_nothing) {
  const std::vector<GravitySample> one = {{Vec3(5.0, 0.0, 0.0), 0.6}};
  EXPECT_EQ(fit_gravity(one, Vec3::UnitZ()).slope, Vec3::Zero());
  std::vector<GravitySample> line;
  for (int i = 0; i < 10; ++i) line.push_back({Vec3(i, 0.0, 0.0), 0.6 + 0.01 * i});
  const Vec3 slope = fit_gravity(line, Vec3::UnitZ()).slope;
  EXPECT_NEAR((slope - Vec3(0.01, 0.0, 0.0)).norm(), 0.0, 1e-6);
  EXPECT_THROW(fit_gravity({}, Vec3::UnitZ()), InputError);
}

TEST(GravityCompensation, is_finite_for_any_position) {
  const GravityCompensation model({.weight = 0.7, .slope = Vec3(0.002, 0.0, 0.0)});
  for (const double x :
       {1e308, -1e308, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_TRUE(model.step(Vec3(x, x, x)).allFinite());
  }
}

TEST(GravityCompensation, refuses_settings_outside_their_ranges) {
  EXPECT_THROW(GravityCompensation({.up = Vec3::Zero()}), InputError);
  EXPECT_THROW(GravityCompensation({.weight = -1.0}), InputError);
}

}  // namespace
}  // namespace bodkin
