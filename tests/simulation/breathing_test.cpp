// A patient who breathes in the tick: the hand feels the same as in resting tissue with the opposite motion.
#include <cmath>
#include <numbers>

#include "tests/simulation/model_pairs.h"
#include <gtest/gtest.h>

#include "core/random.h"
#include "simulation/closed_loop.h"
#include "simulation/haptic_tick.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::simulation;
namespace {

Breathing breathing_about(const Vec3& centre) {
  Breathing breathing;
  breathing.rate = 20.0;  // 3 s
  breathing.motion = Vec3(1.0, -2.0, -6.0);
  breathing.centre = centre;
  breathing.radius = 70.0;
  return breathing;
}

// mm, where tissue is after `tick` ticks of 1 ms: by the library's sine, and by repeated substitution.
Vec3 material_of(const Breathing& breathing, const Vec3& place, int tick) {
  const double wave = std::sin(std::numbers::pi * tick * 0.001 * breathing.rate / 60.0);
  const double drawn_in = std::pow(wave * wave, breathing.pause);
  Vec3 material = place;
  for (int i = 0; i < 100; ++i) {
    const double inside = 1.0 - (material - breathing.centre).squaredNorm() / (breathing.radius * breathing.radius);
    material = place - drawn_in * std::pow(std::max(0.0, inside), 2) * breathing.motion;
  }
  return material;
}

// Depth of the hand's needle, mm below the skin: in, then at rest while the tissue moves.
double held(int tick) {
  return std::min(22.0, -6.0 + 0.02 * tick);
}

class BreathingModels : public ::testing::TestWithParam<NamedResistance> {};

TEST_P(BreathingModels, feel_what_the_needle_does_in_the_tissue) {
  for (const NamedConstraint& constraint : all_constraints()) {
    if (GetParam().name.starts_with("embedded_needle")) return;  // its tissue moves along the shaft, see below
    Case patient = patient_for(GetParam(), constraint);
    HapticTick still(patient);
    const Breathing breathing = breathing_about(Vec3(5.0, 0.0, 20.0));
    patient.description.breathing = breathing;
    HapticTick breathes(patient);
    double greatest = 0.0, apart = 0.0;
    int different = 0;
    for (int tick = 1; tick <= 6000; ++tick) {
      const Vec3 hand(0.0, 0.0, held(tick));
      const TickOutput found = breathes.step(needle_at(hand));
      const TickOutput expected = still.step(needle_at(material_of(breathing, hand, tick)));
      greatest = std::max(greatest, expected.requested.force.norm());
      const double here = (found.requested.force - expected.requested.force).norm();
      apart = std::max(apart, here);
      different += found.tissue != expected.tissue ? 1 : 0;
    }
    EXPECT_GT(greatest, 0.01) << constraint.name;
    EXPECT_LT(apart, 1e-4 * greatest + 1e-6) << constraint.name;
    EXPECT_EQ(different, 0) << constraint.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Breathing, BreathingModels, ::testing::ValuesIn(all_resistances()),
                         [](const auto& each) { return each.param.name; });

// Wide and even motion carries a deformable body along as a whole.
TEST(Breathing, moves_a_deformable_body_and_the_needle_in_it) {
  for (const NamedResistance& resistance : all_resistances()) {
    if (!resistance.name.starts_with("embedded_needle")) continue;
    Case patient = patient_for(resistance, {"rail", RailSettings{}, true});
    HapticTick still(patient);
    Breathing breathing = breathing_about(Vec3(0.0, 0.0, 20.0));
    breathing.radius = 500.0;
    patient.description.breathing = breathing;
    HapticTick breathes(patient);
    double greatest = 0.0, apart = 0.0;
    for (int tick = 1; tick <= 6000; ++tick) {
      const Vec3 hand(0.0, 0.0, held(tick));
      const TickOutput found = breathes.step(needle_at(hand));
      const TickOutput expected = still.step(needle_at(material_of(breathing, hand, tick)));
      greatest = std::max(greatest, std::abs(expected.resistance));
      apart = std::max(apart, std::abs(found.resistance - expected.resistance));
    }
    EXPECT_GT(greatest, 0.5);
    EXPECT_LT(apart, 0.08 * greatest) << resistance.name;
  }
}

// Narrow, the skin stands still while the tip is carried aside: the shaft in between is bent aside, and pushes back.
TEST(Breathing, tissue_along_the_shaft_moves_by_its_own_amount) {
  for (const NamedResistance& resistance : all_resistances()) {
    if (resistance.name != "embedded_needle") continue;
    Case patient = patient_for(resistance, {"none", NoConstraint{}});
    Breathing breathing = breathing_about(Vec3(0.0, 0.0, 30.0));
    breathing.motion = Vec3(3.0, 0.0, 0.0);
    breathing.radius = 30.0;
    patient.description.breathing = breathing;
    HapticTick breathes(patient);
    double held_still = 0.0, drawn_in = 0.0, out_again = 0.0;
    for (int tick = 1; tick <= 4500; ++tick) {
      TickInput input = needle_at(Vec3(0.0, 0.0, held(tick)));
      input.other.breath_held = tick <= 1500;
      const double aside = breathes.step(input).requested.force.x();
      if (tick == 1500) held_still = aside;
      if (tick == 3000) drawn_in = aside;
      out_again = aside;
    }
    EXPECT_NEAR(held_still, 0.0, 1e-9);
    EXPECT_GT(drawn_in, 0.05) << "tissue that moves to the left pushes the hand to the left";
    EXPECT_LT(std::abs(out_again), 0.5 * drawn_in);
  }
}

TEST(Breathing, held_it_changes_nothing) {
  Case patient = slab_patient();
  HapticTick still(patient);
  patient.description.breathing = breathing_about(Vec3(0.0, 0.0, 20.0));
  HapticTick holds(patient), never(patient);
  never.hold_breath();
  for (int tick = 1; tick <= 4000; ++tick) {
    TickInput input = needle_at(held(tick));
    const TickOutput expected = still.step(input);
    EXPECT_EQ(never.step(input).requested.force, expected.requested.force);
    input.other.breath_held = true;
    const TickOutput found = holds.step(input);
    ASSERT_EQ(found.requested.force, expected.requested.force) << tick;
    ASSERT_EQ(found.depth, expected.depth);
    ASSERT_EQ(found.drawn_in, 0.0);
  }
}

TEST(Breathing, comes_again_after_a_reset) {
  Case patient = slab_patient();
  patient.description.breathing = breathing_about(Vec3(0.0, 0.0, 20.0));
  HapticTick tick(patient);
  std::vector<Vec3> first;
  for (int i = 1; i <= 3000; ++i) first.push_back(tick.step(needle_at(held(i))).requested.force);
  tick.reset();
  for (int i = 1; i <= 3000; ++i) ASSERT_EQ(tick.step(needle_at(held(i))).requested.force, first[i - 1]) << i;
}

// Every tick of a wild hand in a patient who breathes deeply is bounded and finite, and does not end the haptics.
TEST(Breathing, a_wild_hand_meets_bounded_forces) {
  Case patient = slab_patient();
  patient.description.breathing = breathing_about(Vec3(0.0, 0.0, 20.0));
  patient.description.breathing->motion = Vec3(8.0, -8.0, -20.0);
  HapticTick tick(patient);
  Random random(11);
  Vec3 place(0.0, 0.0, -10.0), speed = Vec3::Zero();
  for (int i = 0; i < 60000; ++i) {
    speed += 0.02 * Vec3(random.normal(), random.normal(), random.normal()) - 0.01 * speed -
             0.0002 * (place - Vec3(0.0, 0.0, 15.0));
    place += 0.1 * speed;
    TickInput input = needle_at(place);
    input.other.breath_held = random.uniform() < 0.5;
    const TickOutput found = tick.step(input);
    ASSERT_TRUE(found.applied.force.allFinite());
    ASSERT_LE(found.applied.force.norm(), patient.description.device.peak_force * (1.0 + 1e-12));
    for (const forces::Event& event : found.events) ASSERT_NE(event.kind, forces::EventKind::fault);
  }
}

}  // namespace
}  // namespace bodkin
