#include "forces/fracture.h"

#include "tests/forces/model_checks.h"

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
namespace {

struct FractureBench {
  explicit FractureBench(const FractureSettings& settings = {}) : model(settings) {}
  double operator()(const AxialMotion& motion) { return model.step(motion, tissue::skin, events); }
  double to(double depth, double speed = 10.0) { return checks::move(hand, depth, speed, *this); }
  Fracture model;
  checks::Hand hand{-1.0};
  TickEvents events;
};

TEST(Fracture, cutting_pays_for_the_crack) {
  EXPECT_DOUBLE_EQ(cutting_force(0.1, 0.8), 0.08);
  EXPECT_NEAR(toughness_from_insertions(0.68, 0.6, 0.8), 0.1, 1e-12);
}

TEST(Fracture, rupture_force_falls_with_speed_and_saturates) {
  const double speeds[] = {0.0, 1.0, 10.0}, forces[] = {3.0, 2.0, 1.18182};
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(rupture_force(1.0, 2.0, 1.0, speeds[i]), forces[i], 5e-6);
}

TEST(Fracture, stored_energy_is_the_integral_of_the_cubic_law) {
  EXPECT_NEAR(stored_energy(0.05, 1.0, 3.0), 0.46875, 1e-12);
  const VoigtLaw law(VoigtSum::cubic, 0.03, 0.0, 0.7);
  double sum = 0.0;
  for (int i = 0; i < 10000; ++i) sum += law.elastic((i + 0.5) * 4e-4) * 4e-4;
  EXPECT_NEAR(stored_energy(0.03, 0.7, 4.0), sum, 1e-6);
}

TEST(Fracture, tears_where_the_energy_suffices_at_any_speed) {
  for (const double speed : {1.0, 10.0, 50.0}) {
    FractureSettings settings;
    settings.thickness = 2.0;
    settings.toughness = 0.46875 / 0.8 / 2.0;  // so that U(3 mm) = J w t_m
    FractureBench bench(settings);
    EXPECT_NEAR(bench.to(2.9, speed), 0.05 * 2.9 * 3.9 * 4.9 / 6.0, 1e-9);
    bench.to(3.5, speed);
    ASSERT_EQ(bench.events.size(), 2u);
    EXPECT_NEAR(bench.events.begin()[1].depth, 3.0, speed * 1e-3 + 1e-9);
    EXPECT_NEAR(bench.to(6.0, speed), 0.08, 1e-9);
  }
}

TEST(Fracture, tissue_behind_that_is_tougher_than_the_membrane_makes_no_jump) {
  FractureSettings settings;
  settings.toughness = 0.2;
  settings.cutting_toughness = 2.0;  // 1.6 N, more than the membrane bears
  FractureBench bench(settings);
  while (bench.events.size() < 2) bench.to(bench.hand.depth() + 0.01);
  const Event tear = bench.events.begin()[1];
  ASSERT_LT(tear.value, 1.0);
  EXPECT_NEAR(bench.to(bench.hand.depth() + 0.01), tear.value, 0.011);
  EXPECT_NEAR(bench.to(10.0), 1.6, 1e-9);
}

TEST(Fracture, a_second_insertion_into_the_channel_cuts_nothing) {
  FractureBench bench;
  bench.to(20.0);
  bench.to(-1.0);
  EXPECT_EQ(bench.to(10.0), 0.0);
  bench.to(-1.0);
  bench.model.begin(Vec3(10.0, 0.0, 0.0), Vec3::UnitZ());
  EXPECT_GT(bench.to(3.0), 0.4);
}

TEST(Fracture, has_the_properties_of_every_model) {
  const auto make = [] { return FractureBench(); };
  checks::finite_on_any_input(make);
  checks::passive_on_random_closed_paths(make, 40.0, 50.0, 2.0);
  checks::same_bits_on_repetition(make, 40.0);
  checks::bounded_when_saturated(make, 8.5);
  checks::no_growth_under_reversal_at_every_tick(make, 12.0);
}

TEST(Fracture, refuses_settings_outside_their_ranges) {
  EXPECT_THROW(Fracture({.toughness = 0.0}), InputError);
  EXPECT_THROW(Fracture({.width = 50.0}), InputError);
}

}  // namespace
}  // namespace bodkin
