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

// Azar and Hayward (2008) measure the toughness by two insertions into one channel, of which the second only rubs:
// J = (R1 - R2)/w.
TEST(Fracture, two_insertions_into_one_channel_measure_its_toughness) {
  for (const double toughness : {0.1, 0.4}) {
    for (const double width : {0.5, 1.2}) {
      FractureBench bench({.width = width, .cutting_toughness = toughness});
      const double first = bench.to(20.0);
      bench.to(-1.0);
      const double second = bench.to(19.0);
      EXPECT_NEAR((first - second) / width, toughness, 1e-9) << width << " mm";
    }
  }
}

// For any way in, the work of the hand is that of the two cracks plus the energy stored at the cutting edge.
TEST(Fracture, the_work_of_an_insertion_is_the_energy_of_its_cracks) {
  const FractureSettings settings;
  FractureBench bench(settings);
  double work = 0.0, depth = 0.0;
  constexpr double step = 1e-3;  // mm, a tick at 1 mm/s
  while (depth < 20.0) {
    depth += step;
    work += step * bench.to(depth, 1.0);
  }
  ASSERT_EQ(bench.events.size(), 2U);
  const double torn = bench.events.begin()[1].depth, cut = settings.cutting_toughness * settings.width;
  const double membrane = settings.toughness * settings.width * settings.thickness;
  EXPECT_NEAR(work, membrane + cut * (20.0 - torn), 0.01 * work);
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
