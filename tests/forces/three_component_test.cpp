#include "forces/three_component.h"

#include "tests/forces/model_checks.h"

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
namespace {

struct ThreeComponentBench {
  explicit ThreeComponentBench(const ThreeComponentSettings& settings = {}) : model(settings) {}
  double operator()(const AxialMotion& motion) { return model.step(motion, tissue::organ, events); }
  double to(double depth, double speed = 10.0) { return checks::move(hand, depth, speed, *this); }
  ThreeComponent model;
  checks::Hand hand{-1.0};
  TickEvents events;
};

TEST(ThreeComponent, the_capsule_is_a_polynomial) {
  ThreeComponentBench bench({.puncture_force = 5.0});
  EXPECT_NEAR(bench.to(1.0), 0.05, 1e-9);
  EXPECT_NEAR(bench.to(3.0), 0.33, 1e-9);
  EXPECT_NEAR(bench.to(5.0), 0.85, 1e-9);
}

TEST(ThreeComponent, breaks_at_its_force_and_drops_to_cutting) {
  ThreeComponentBench bench;
  bench.to(4.98);
  const double after = bench.to(5.05);
  ASSERT_EQ(bench.events.size(), 2u);
  EXPECT_EQ(bench.events.begin()[1].kind, EventKind::puncture);
  EXPECT_NEAR(bench.events.begin()[1].value, 0.85, 0.01);
  EXPECT_NEAR(after, 0.3, 0.05);
}

TEST(ThreeComponent, slides_with_coulomb_and_viscous_friction_on_its_length) {
  ThreeComponentSettings settings;
  settings.inwards = {0.012, 0.00021, 0.012};
  settings.cutting_force = 0.0;
  ThreeComponentBench bench(settings);
  EXPECT_NEAR(bench.to(30.0, 5.0), 0.3915, 1e-6);
}

TEST(ThreeComponent, friction_differs_by_direction_and_holds_at_rest) {
  ThreeComponentBench bench;
  EXPECT_NEAR(bench.to(40.0, 10.0), 0.3 + 40.0 * (0.01196 + 0.0021213), 1e-6);
  const double still = checks::rest(bench.hand, 500, bench);
  EXPECT_GT(still, 0.3);
  EXPECT_LE(still, 0.3 + 40.0 * 0.01845);
  EXPECT_NEAR(bench.to(30.0, 10.0), -30.0 * (0.01057 + 0.0029308), 1e-6);
}

TEST(ThreeComponent, creeps_against_static_friction_up_to_half_the_dead_band) {
  ThreeComponentBench bench;
  bench.to(40.0);
  EXPECT_NEAR(bench.to(42.0, 0.4), 0.3 + 42.0 * 0.01845, 1e-3);
  EXPECT_NEAR(bench.to(44.0, 0.6), 0.3 + 44.0 * (0.01196 + 0.6 * 0.00021213), 1e-3);
}

TEST(ThreeComponent, does_not_cut_a_channel_twice) {
  ThreeComponentBench bench;
  bench.to(20.0);
  bench.to(-1.0);
  EXPECT_NEAR(bench.to(10.0), 10.0 * (0.01196 + 0.0021213), 1e-6);  // friction alone
  EXPECT_NEAR(bench.to(21.0), 0.3 + 21.0 * (0.01196 + 0.0021213), 1e-6);
  bench.to(-1.0);
  bench.model.begin(Vec3(20.0, 0.0, 0.0), Vec3::UnitZ());
  EXPECT_NEAR(bench.to(3.0), 0.33, 1e-9);  // a new place is whole
}

TEST(ThreeComponent, has_the_properties_of_every_model) {
  const auto make = [] { return ThreeComponentBench(); };
  checks::finite_on_any_input(make);
  checks::passive_on_random_closed_paths(make, 60.0, 50.0, 5.0);
  checks::same_bits_on_repetition(make, 60.0);
  checks::bounded_when_saturated(make, 8.5);
  checks::no_growth_under_reversal_at_every_tick(make, 30.0);
}

TEST(ThreeComponent, refuses_settings_that_never_break) {
  EXPECT_THROW(ThreeComponent({.linear = 0.0, .quadratic = 0.0}), InputError);
  EXPECT_THROW(ThreeComponent({.puncture_force = 0.5, .cutting_force = 0.6}), InputError);
}

}  // namespace
}  // namespace bodkin
