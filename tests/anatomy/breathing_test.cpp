// Breathing against its formula, computed with the library's sine, and against a patient's behaviour.
#include "anatomy/breathing.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"

namespace bodkin {

using namespace bodkin::anatomy;
namespace {

Breathing deep() {
  Breathing breathing;
  breathing.motion = Vec3(2.0, -4.0, -15.0);
  breathing.centre = Vec3(10.0, -20.0, 300.0);
  breathing.radius = 60.0;
  return breathing;
}

TEST(Breathing, follows_the_published_course) {
  for (const int pause : {1, 2, 3, 6}) {
    Breathing breathing = deep();
    breathing.rate = 15.0;  // 4 s
    breathing.pause = pause;
    BreathClock clock(breathing, 0.001);
    double above_half = 0.0;
    for (int tick = 1; tick <= 12000; ++tick) {
      const double found = clock.step(false);
      const double wave = std::sin(std::numbers::pi * tick / 4000.0);
      ASSERT_NEAR(found, std::pow(wave * wave, pause), 1e-11) << pause << " " << tick;
      above_half += found > 0.5 ? 1.0 / 12000.0 : 0.0;
    }
    // sin^2n x > 1/2 for this share of the period
    const double expected = 1.0 - 2.0 * std::asin(std::pow(0.5, 0.5 / pause)) / std::numbers::pi;
    EXPECT_NEAR(above_half, expected, 2e-3);
  }
}

TEST(Breathing, who_is_asked_breathes_out_and_then_holds) {
  Breathing breathing = deep();
  breathing.rate = 15.0;
  breathing.longest_hold = 10.0;
  BreathClock clock(breathing, 0.001);
  for (int tick = 0; tick < 1500; ++tick) clock.step(false);
  EXPECT_GT(clock.drawn_in(), 0.5);
  int until = 0;
  while (!clock.holds()) {
    clock.step(true);
    ASSERT_LT(++until, 3000);
  }
  EXPECT_NEAR(until, 2501, 1) << "the breath that was begun is finished";
  int held = 1;
  for (; clock.holds(); ++held) {
    EXPECT_EQ(clock.drawn_in(), 0.0);
    clock.step(true);
  }
  EXPECT_NEAR(held, 10001, 1);
  double most = 0.0;
  int breath = 0;
  for (; !clock.holds(); ++breath) most = std::max(most, clock.step(true));
  EXPECT_NEAR(breath, 4000, 2) << "one breath, then the patient holds again";
  EXPECT_NEAR(most, 1.0, 1e-6);
  clock.step(false);
  EXPECT_FALSE(clock.holds());
  EXPECT_GT(clock.drawn_in(), 0.0);
}

TEST(Breathing, the_material_point_is_the_one_that_moved_there) {
  const Breathing breathing = deep();
  const BreathField field(breathing);
  Random random(3);
  double most = 0.0;
  for (int i = 0; i < 100000; ++i) {
    const Vec3 material = breathing.centre + 70.0 * Vec3(random.normal(), random.normal(), random.normal());
    const double drawn_in = random.uniform();
    const Vec3 place = material + field.moved(material, drawn_in);
    most = std::max(most, (field.material(place, drawn_in) - material).norm());
  }
  EXPECT_LT(most, 1e-9);
  EXPECT_EQ(field.moved(breathing.centre, 1.0), breathing.motion);
  const Vec3 outside = breathing.centre + Vec3(0.0, 60.1, 0.0);
  EXPECT_EQ(field.moved(outside, 1.0), Vec3(Vec3::Zero()));
  EXPECT_EQ(field.material(outside + Vec3(0.0, 20.0, 0.0), 1.0), outside + Vec3(0.0, 20.0, 0.0));
}

// Volumes keep their sign: the determinant of the deformation stays well above 0 at the strongest motion allowed.
TEST(Breathing, tissue_does_not_fold) {
  Breathing breathing = deep();
  breathing.motion = Vec3(0.0, 0.0, -20.0);
  const BreathField field(breathing);
  Random random(4);
  double least = 1.0;
  constexpr double step = 1e-4;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 at = breathing.centre + 30.0 * Vec3(random.normal(), random.normal(), random.normal());
    Mat3 gradient;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 off = step * Vec3::Unit(axis);
      gradient.col(axis) =
          Vec3::Unit(axis) + (field.moved(at + off, 1.0) - field.moved(at - off, 1.0)) / (2.0 * step);
    }
    least = std::min(least, gradient.determinant());
  }
  EXPECT_NEAR(least, 1.0 - 20.0 / 60.0 * 8.0 / (3.0 * std::sqrt(3.0)), 0.01) << "as derived from w";
  EXPECT_GT(least, 0.4);
  breathing.motion.z() = -20.1;
  EXPECT_THROW(check(breathing, "breathing"), InputError);
}

}  // namespace
}  // namespace bodkin
