#include "haptics/simulated_hand.h"

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "tests/one_tick.h"
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

HandParameters plain_hand() {
  HandParameters hand;
  hand.mass = 0.3;
  hand.stiffness = 2.0;
  hand.damping = 0.02;
  return hand;
}

Wrench push(const Vec3& force) {
  return {force, Vec3::Zero()};
}

// x(t) of a mass, spring and damper under a force applied from t = 0, from the textbook (units kg, mm, s, N).
double step_response(const HandParameters& hand, double force, double t) {
  const double natural = std::sqrt(hand.stiffness * 1000.0 / hand.mass);
  const double ratio = hand.damping * 1000.0 / (2.0 * hand.mass * natural);
  const double at_rest = force / hand.stiffness;
  if (ratio < 1.0) {
    const double damped = natural * std::sqrt(1.0 - ratio * ratio);
    return at_rest * (1.0 - std::exp(-ratio * natural * t) *
                                (std::cos(damped * t) + ratio * natural / damped * std::sin(damped * t)));
  }
  const double root = natural * std::sqrt(ratio * ratio - 1.0);
  const double slow = -ratio * natural + root, fast = -ratio * natural - root;
  return at_rest * (1.0 - (slow * std::exp(fast * t) - fast * std::exp(slow * t)) / (slow - fast));
}

TEST(SimulatedHand, yields_to_a_force_as_the_textbook_says_whatever_its_damping) {
  for (const double damping : {0.0, 0.02, 0.3}) {
    HandParameters parameters = plain_hand();
    parameters.damping = damping;
    SimulatedHand hand(parameters, one_tick, 1);
    hand.start(Pose::Identity());
    for (int tick = 1; tick <= 400; ++tick) {
      const double x = hand.step(Pose::Identity(), push({1.5, 0, 0})).translation().x();
      EXPECT_NEAR(x, step_response(parameters, 1.5, tick * one_tick), 1e-9)
          << "damping " << damping << " tick " << tick;
    }
  }
}

TEST(SimulatedHand, rests_where_spring_and_force_balance) {
  SimulatedHand hand(plain_hand(), one_tick, 1);
  hand.start(Pose::Identity());
  for (int tick = 0; tick < 5000; ++tick) hand.step(Pose::Identity(), push({0, -3.0, 1.0}));
  EXPECT_NEAR((hand.needle().translation() - Vec3(0, -1.5, 0.5)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(hand.velocity().norm(), 0.0, 1e-9);
}

TEST(SimulatedHand, follows_an_even_motion_without_lag) {
  SimulatedHand hand(plain_hand(), one_tick, 1);
  Pose intended = Pose::Identity();
  hand.start(intended);
  for (int tick = 0; tick < 5000; ++tick) {
    intended.translation() += Vec3(0, 0, 5.0 * one_tick);
    hand.step(intended, {});
  }
  EXPECT_NEAR((hand.needle().translation() - intended.translation()).norm(), 0.0, 1e-9);
  EXPECT_NEAR(hand.velocity().z(), 5.0, 1e-9);
}

TEST(SimulatedHand, is_passive_it_never_gives_more_energy_than_the_force_put_in) {
  Random random(3);
  for (int trial = 0; trial < 20; ++trial) {
    HandParameters parameters = plain_hand();
    parameters.mass = random.uniform(0.05, 2.0);
    parameters.stiffness = random.uniform(0.1, 15.0);
    parameters.damping = random.uniform(0.0, 0.3);
    SimulatedHand hand(parameters, one_tick, 1);
    hand.start(Pose::Identity());
    double work = 0.0;  // N mm, done by the force
    for (int tick = 0; tick < 2000; ++tick) {
      const Vec3 before = hand.needle().translation();
      const Vec3 force(random.uniform(-6, 6), random.uniform(-6, 6), 6.0 * std::sin(0.01 * tick * trial));
      hand.step(Pose::Identity(), push(force));
      work += force.dot(hand.needle().translation() - before);
      const double stored = 0.5 * parameters.stiffness * hand.needle().translation().squaredNorm() +
                            0.5e-3 * parameters.mass * hand.velocity().squaredNorm();
      ASSERT_GE(work, stored - 1e-9 * (1.0 + stored)) << "trial " << trial << " tick " << tick;
    }
  }
}

TEST(SimulatedHand, the_stiffest_hand_with_the_coarsest_tick_stays_finite) {
  HandParameters parameters;
  parameters.mass = 0.02;
  parameters.stiffness = 20.0;
  parameters.damping = 1.0;
  SimulatedHand hand(parameters, 0.005, 1);
  hand.start(Pose::Identity());
  for (int tick = 0; tick < 10000; ++tick) {
    hand.step(Pose::Identity(), push({tick % 2 == 0 ? 6.0 : -6.0, 0, 0}));
    ASSERT_LE(hand.needle().translation().norm(), 0.6);
  }
}

TEST(SimulatedHand, turns_by_torque_over_stiffness) {
  HandParameters parameters = plain_hand();
  SimulatedHand hand(parameters, one_tick, 1);
  hand.start(Pose::Identity());
  for (int tick = 0; tick < 3000; ++tick) hand.step(Pose::Identity(), {Vec3::Zero(), Vec3(200.0, 0, 0)});
  const Vec3 axis = needle_axis(hand.needle());
  const double angle = 200.0 / parameters.rotation_stiffness;
  EXPECT_NEAR(axis.y(), -std::sin(angle), 1e-9);
  EXPECT_NEAR(axis.z(), std::cos(angle), 1e-9);
  EXPECT_NEAR((hand.needle().linear().transpose() * hand.needle().linear() - Mat3::Identity()).norm(), 0.0, 1e-12);
}

TEST(Tremor, has_the_wanted_size_and_nothing_outside_8_to_12_hertz) {
  Tremor tremor(0.1, one_tick, 5);
  constexpr int count = 20000;
  double square = 0.0;
  std::vector<double> x(count);
  for (double& value : x) {
    value = tremor.next().x();
    square += value * value;
  }
  EXPECT_NEAR(std::sqrt(square / count), 0.1, 0.03);
  const auto power = [&](double frequency) {
    std::complex<double> sum = 0.0;
    for (int i = 0; i < count; ++i) {
      const double window = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * i / count);
      sum += window * x[static_cast<std::size_t>(i)] *
             std::polar(1.0, -2.0 * std::numbers::pi * frequency * i * one_tick);
    }
    return std::norm(sum / static_cast<double>(count));
  };
  double inside = 0.0, outside = 0.0;
  for (double f = 8.0; f <= 12.0; f += 0.05) inside += power(f);
  for (double f = 1.0; f <= 7.5; f += 0.2) outside += power(f);
  for (double f = 12.5; f <= 40.0; f += 0.2) outside += power(f);
  EXPECT_LT(outside, 1e-4 * inside);
}

TEST(SimulatedHand, equal_seeds_tremble_equally_and_others_do_not) {
  HandParameters parameters = plain_hand();
  parameters.tremor = 0.1;
  parameters.tremor_angle = 0.01;
  SimulatedHand one(parameters, one_tick, 7), same(parameters, one_tick, 7), other(parameters, one_tick, 8);
  for (SimulatedHand* hand : {&one, &same, &other}) hand->start(Pose::Identity());
  bool differs = false;
  for (int tick = 0; tick < 500; ++tick) {
    const Pose a = one.step(Pose::Identity(), {});
    ASSERT_EQ(a.matrix(), same.step(Pose::Identity(), {}).matrix());
    differs = differs || a.matrix() != other.step(Pose::Identity(), {}).matrix();
  }
  EXPECT_TRUE(differs);
}

TEST(SimulatedHand, a_parameter_out_of_range_is_named_with_its_range) {
  HandParameters parameters;
  parameters.stiffness = -1.0;
  try {
    SimulatedHand hand(parameters, one_tick, 1);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "simulated hand: stiffness is -1 N/mm, expected 0.05 to 20 N/mm");
  }
  parameters = {};
  parameters.mass = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(check(parameters), InputError);
}

}  // namespace
}  // namespace bodkin
