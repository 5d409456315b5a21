#include "forces/shaft_friction.h"

#include <vector>

#include "tests/forces/default_tissues.h"
#include "tests/forces/model_checks.h"

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
namespace {

// Friction of the whole shaft with constant parameters.
struct FrictionBench {
  ShaftContact contact{0.5, 0.5, 2.0, 0.0};
  ShaftFriction model{{}};
  TickEvents events;
  double operator()(const AxialMotion& motion) { return model.step(motion, contact, events); }
};

// 1 mm layers of muscle below z = 0, contact length growing with depth.
struct Growing {
  ShaftFriction model{{}};
  std::vector<TissueId> layers = std::vector<TissueId>(400, tissue::muscle);
  TickEvents events;
  double operator()(const AxialMotion& motion) {
    return model.step(
        motion,
        shaft_contact(layers, 1.0, motion.depth, checks::default_tissues().by_id(&TissueProperties::shaft_friction)),
        events);
  }
};

TEST(ShaftFriction, grows_gradually_to_the_coulomb_force) {
  const double depths[] = {0.1, 0.25, 0.5, 1.0}, forces[] = {0.164840, 0.316060, 0.432332, 0.490842};
  for (const double speed : {0.7, 10.0, 300.0}) {
    FrictionBench bench;
    checks::Hand hand(0.0);
    checks::rest(hand, 1, bench);
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(checks::move(hand, depths[i], speed, bench), forces[i], 5e-7);
  }
}

TEST(ShaftFriction, turns_round_with_hysteresis) {
  FrictionBench bench;
  checks::Hand hand(0.0);
  checks::rest(hand, 1, bench);
  EXPECT_NEAR(checks::move(hand, 50.0, 10.0, bench), 0.5, 1e-9);
  EXPECT_NEAR(checks::rest(hand, 1000, bench), 0.5, 1e-9);  // held at rest
  EXPECT_NEAR(checks::move(hand, 49.5, 10.0, bench), -0.364665, 5e-7);
}

TEST(ShaftFriction, slides_at_the_stribeck_curve) {
  const double speeds[] = {0.5, 5.0, 20.0}, forces[] = {0.698510, 0.578576, 0.520000};
  for (int i = 0; i < 3; ++i) {
    FrictionBench bench;
    bench.contact = {0.5, 0.7, 2.0, 0.001};
    checks::Hand hand(0.0);
    checks::rest(hand, 1, bench);
    EXPECT_NEAR(checks::move(hand, 10.0, speeds[i], bench), forces[i], 5e-7);
  }
}

TEST(ShaftFriction, is_stable_where_explicit_integration_needs_microseconds) {
  FrictionBench bench;
  bench.contact.stiffness = 2000.0;
  checks::Hand hand(0.0);
  checks::rest(hand, 1, bench);
  EXPECT_NEAR(checks::move(hand, 100.0, 200.0, bench), 0.5, 1e-12);
  EXPECT_NEAR(bench.model.stretch(), 0.5 / 2000.0, 1e-15);  // z_ss
}

TEST(ShaftFriction, adds_the_tissues_along_the_shaft) {
  std::array<ShaftFrictionTissue, 256> tissues{};
  tissues[tissue::soft] = {0.02, 0.02, 1.0, 0.0};
  tissues[tissue::ligamentum_flavum] = {0.2, 0.2, 10.0, 0.0};
  std::vector<TissueId> layers(20, tissue::soft);
  layers.insert(layers.end(), 5, tissue::ligamentum_flavum);
  EXPECT_NEAR(shaft_contact(layers, 1.0, 25.0, tissues).coulomb, 1.4, 1e-12);  // Sutherland et al. 2013, eq. 2
  EXPECT_NEAR(shaft_contact(layers, 1.0, 20.5, tissues).coulomb, 0.5, 1e-12);
  EXPECT_EQ(shaft_contact(layers, 1.0, -1.0, tissues).coulomb, 0.0);
  // Tissue without friction on the shaft does not stretch with it.
  tissues[tissue::fat] = {0.0, 0.0, 3.0, 0.0};
  std::vector<TissueId> with_fat = layers;
  with_fat.insert(with_fat.end(), 10, tissue::fat);
  EXPECT_NEAR(shaft_contact(with_fat, 1.0, 35.0, tissues).stiffness, 20.0 * 1.0 + 5.0 * 10.0, 1e-12);
  // Withdrawal reverses the sign; stopping after an advance keeps the force, without a jump.
  FrictionBench bench;
  bench.contact = shaft_contact(layers, 1.0, 25.0, tissues);
  checks::Hand hand(0.0);
  checks::rest(hand, 1, bench);
  EXPECT_NEAR(checks::move(hand, 5.0, 10.0, bench), 1.4, 1e-9);
  EXPECT_NEAR(checks::rest(hand, 10, bench), 1.4, 1e-9);
  EXPECT_NEAR(checks::move(hand, 0.0, 10.0, bench), -1.4, 1e-9);
}

TEST(ShaftFriction, has_the_properties_of_every_model) {
  const auto make = [] { return Growing(); };
  checks::finite_on_any_input(make);
  checks::passive_on_random_closed_paths(make, 60.0, 50.0, 5.0);
  checks::same_bits_on_repetition(make, 60.0);
  checks::bounded_when_saturated(make, 300.0 * (0.018 + 0.0002 * 1000.0));
  checks::no_growth_under_reversal_at_every_tick(make, 30.0);
  const auto fixed = [](double) { return FrictionBench(); };
  checks::steady_force_is_the_same_at_half_the_tick(fixed, 12.0, 10.0, 1e-9);
}

TEST(ShaftFriction, refuses_a_velocity_that_is_none) {
  EXPECT_THROW(ShaftFriction({.stribeck_velocity = 0.0}), InputError);
}

}  // namespace
}  // namespace bodkin
