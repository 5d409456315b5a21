#include "forces/tracking_wall_leash.h"

#include <numbers>

#include "tests/forces/default_tissues.h"
#include "tests/forces/model_checks.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
namespace {

// Moves the tip along z of the line, with a sideways path of its own.
struct Leash {
  explicit Leash(const TrackingWallSettings& settings = {}) : wall(checks::default_tissues(), settings, 1e-3) {}

  TrackingWallLeash wall;
  TickEvents events;
  Vec3 force = Vec3::Zero();

  double operator()(const AxialMotion& motion) {
    force = wall.step({0.0, 0.0, motion.depth}, motion, tissue::muscle, events);
    return -force.z();
  }
};

TEST(TrackingWallLeash, is_the_scalar_wall_on_a_straight_path) {
  Leash leash;
  TrackingWall scalar(checks::default_tissues(), {}, 1e-3);
  checks::Hand hand(-1.0);
  const auto compare = [&](const AxialMotion& motion) {
    TickEvents events;
    const double expected = scalar.step(motion, tissue::muscle, events);
    EXPECT_NEAR(leash(motion), expected, 1e-9) << motion.depth;
    return expected;
  };
  checks::move(hand, 12.0, 10.0, compare);
  checks::move(hand, 10.5, 10.0, compare);
  checks::move(hand, 14.0, 10.0, compare);
  checks::rest(hand, 600, compare);
  checks::move(hand, 3.0, 10.0, compare);
  checks::move(hand, 16.0, 10.0, compare);
  checks::move(hand, -1.0, 10.0, compare);
}

TEST(TrackingWallLeash, is_the_scalar_wall_through_layers_and_at_its_limit) {
  TrackingWallSettings layers, limited;
  layers.layers = {{0.0, {0.5, 1.0}}, {6.0, {1.0, 3.0}}, {14.0, {0.25, 2.0}}};
  limited.limit = 0.75;
  for (const TrackingWallSettings& settings : {layers, limited}) {
    Leash leash(settings);
    TrackingWall scalar(checks::default_tissues(), settings, 1e-3);
    checks::Hand hand(-1.0);
    checks::move(hand, 25.0, 10.0, [&](const AxialMotion& motion) {
      TickEvents events;
      const double expected = scalar.step(motion, tissue::muscle, events);
      EXPECT_NEAR(leash(motion), expected, 1e-9) << motion.depth;
      return expected;
    });
  }
}

TEST(TrackingWallLeash, a_cut_channel_is_free_to_its_old_depth_on_the_way_in_again) {
  Leash leash;
  checks::Hand hand(-1.0);
  checks::move(hand, 12.0, 10.0, leash);
  checks::move(hand, -1.0, 10.0, leash);
  for (double depth = 1.0; depth < 12.0; ++depth) EXPECT_EQ(checks::move(hand, depth, 10.0, leash), 0.0) << depth;
  EXPECT_NEAR(checks::move(hand, 12.5, 10.0, leash), 0.25, 0.005 + 1e-9);  // K v dt: the wall waits at the last tip
}

TEST(TrackingWallLeash, holds_the_tip_back_along_the_tangent_of_a_curved_path) {
  TrackingWallLeash wall(checks::default_tissues(), {}, 1e-3);
  TickEvents events;
  wall.begin(Vec3::Zero(), Vec3::UnitZ());
  const double radius = 100.0;
  Vec3 force;
  double angle = 0.0;
  for (; angle < 0.5; angle += 1e-4) {
    const Vec3 tip(radius * (1.0 - std::cos(angle)), 0.0, radius * std::sin(angle));
    force = wall.step(tip, {tip.z(), 10.0, 1, false}, tissue::muscle, events);
  }
  EXPECT_NEAR(force.norm(), 1.0, 1e-9);
  angle -= 1e-4;  // where the last tip was
  const Vec3 tangent(std::sin(angle), 0.0, std::cos(angle));
  // A leash of length D on a circle of radius r settles at asin(D/r) to the tangent (a tractrix).
  EXPECT_NEAR(std::acos(-force.dot(tangent)), std::asin(2.0 / radius), 1e-4);
}

TEST(TrackingWallLeash, feels_a_diagonal_as_one_force) {
  TrackingWallLeash wall(checks::default_tissues(), {}, 1e-3);
  TickEvents events;
  const Vec3 direction = Vec3::Ones() / std::numbers::sqrt3;
  wall.begin(Vec3::Zero(), direction);
  Vec3 force;
  for (int i = 1; i < 1000; ++i)
    force = wall.step(direction * (0.01 * i), {0.01 * i, 10.0, 1, false}, tissue::muscle, events);
  EXPECT_NEAR((force + direction).norm(), 0.0, 1e-9);
}

TEST(TrackingWallLeash, has_the_properties_of_every_model) {
  const auto make = [] { return Leash{}; };
  checks::finite_on_any_input(make);
  checks::passive_on_random_closed_paths(make, 30.0, 50.0, 1.0);
  checks::same_bits_on_repetition(make, 30.0);
  checks::bounded_when_saturated(make, 8.5);
  checks::no_growth_under_reversal_at_every_tick(make, 12.0);
}

}  // namespace
}  // namespace bodkin
