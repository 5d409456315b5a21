// A hand on a body of known stiffness that is updated only now and then.
#include "station/probe_reaction.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "haptics/simulated_hand.h"

namespace bodkin {

using namespace bodkin::fem;
using namespace bodkin::haptics;
using namespace bodkin::station;
namespace {

constexpr double tick = 0.001;  // s

// A spring of `stiffness` N/mm below the plane z = 0, which reads the probe every `pace` s and reports its result
// `pace` s later, as a busy solver does. The probe comes from above.
class SlowSpring {
 public:
  SlowSpring(double stiffness, double pace) : stiffness_(stiffness), ticks_(static_cast<int>(pace / tick)) {}

  const ProbeReading& look(const Pose& probe) {
    if (++waited_ < ticks_) return reported_;
    waited_ = 0;
    reported_ = next_;
    reported_.steps = ++steps_;
    const double deep = -probe.translation().z();
    next_.probe = probe.translation();
    next_.nodes = deep > 0.0 ? 4 : 0;
    next_.on_probe.force = Vec3(-0.2 * stiffness_ * probe.translation().x(), 0.0, stiffness_ * std::max(0.0, deep));
    next_.by_needle.force = Vec3(0.0, 0.0, deep > 0.0 ? needle : 0.0);
    next_.on_probe.force += next_.by_needle.force;
    return reported_;
  }

  double needle = 0.0;  // N, the needle's force that pushes the probe out

 private:
  double stiffness_;
  int ticks_, waited_ = 0;
  std::uint64_t steps_ = 0;
  ProbeReading reported_, next_;
};

Pose probe_at(double x, double z) {
  return needle_pose(Vec3(x, 0.0, z), -Vec3::UnitZ());
}

TEST(ProbeReaction, at_rest_the_hand_feels_the_bodys_own_force_through_a_spring_that_the_device_renders) {
  for (const double stiffness : {0.05, 0.5, 5.0, 50.0}) {
    for (const double device : {0.4, 2.0}) {
      ProbeReaction reaction(tick, device);
      SlowSpring body(stiffness, 1.0 / 60.0);
      const double spring = std::min(device, 1.0);
      double largest_jump = 0.0, before = 0.0;
      for (int i = 0; i < 4000; ++i) {
        const double z = std::max(-6.0, 5.0 - 0.02 * i);  // 20 mm/s
        const double force = reaction.step(probe_at(0.0, z), body.look(reaction.probe()), true).z();
        largest_jump = std::max(largest_jump, std::abs(force - before));
        before = force;
        EXPECT_TRUE(z <= 0.0 || force == 0.0) << "nothing is felt before the body is met";
      }
      const double felt = 6.0 * stiffness * spring / (stiffness + spring);
      EXPECT_NEAR(reaction.force(), felt, 0.02 * felt) << stiffness << " through " << device;
      EXPECT_NEAR(stiffness * -reaction.probe().translation().z(), felt, 0.02 * felt)
          << "and the body feels the same";
      EXPECT_LT(largest_jump, 0.15) << stiffness << " through " << device;
    }
  }
}

// The push of another hand's needle against the tissue under the probe is felt; a sudden push is not mistaken for a
// firm body, on which the probe would hardly move any more.
TEST(ProbeReaction, a_needles_push_is_felt_and_the_probe_goes_on_as_before) {
  for (const double stiffness : {0.5, 5.0}) {
    ProbeReaction reaction(tick, 1.0), without(tick, 1.0);
    SlowSpring body(stiffness, 1.0 / 60.0), alone(stiffness, 1.0 / 60.0);
    const auto step = [&](double z, int i) {
      const double tremor = 0.05 * std::sin(0.06 * i);  // mm
      without.step(probe_at(0.0, z + tremor), alone.look(without.probe()), true);
      reaction.step(probe_at(0.0, z + tremor), body.look(reaction.probe()), true);
    };
    for (int i = 0; i < 3000; ++i) step(-4.0, i);
    for (int push = 0; push < 6; ++push) {
      body.needle = push % 2 == 0 ? 0.8 : 0.0;
      for (int i = 0; i < 200; ++i) step(-4.0, i);
    }
    body.needle = 0.8;
    for (int i = 0; i < 400; ++i) step(-6.0, i);
    // F = f: the spring of 1 N/mm and the body share the displacement, and the needle's push is added.
    const double felt = (6.0 * stiffness + 0.8) / (stiffness + 1.0);
    EXPECT_NEAR(reaction.force(), felt, 0.05 * felt + 0.06) << stiffness;
    EXPECT_GT(reaction.force(), without.force() + 0.1);
  }
}

// However stiff and late the body is, it gives out no energy: a hand that meets it comes to rest, apart from its own
// tremor.
TEST(ProbeReaction, a_hand_comes_to_rest_on_soft_and_firm_bodies_that_are_late) {
  for (const double stiffness : {0.05, 0.5, 5.0, 50.0}) {
    for (const double pace : {1.0 / 60.0, 0.05, 0.25}) {  // s
      ProbeReaction reaction(tick, 1.0);
      SlowSpring body(stiffness, pace);
      SimulatedHand hand({.stiffness = 0.5, .damping = 0.01}, tick, 1);
      hand.start(probe_at(0.0, 5.0));
      double swing = 0.0;  // mm/s, in the last second
      for (int i = 0; i < 40000; ++i) {
        const Vec3 force = reaction.step(hand.needle(), body.look(reaction.probe()), true);
        hand.step(probe_at(0.0, std::max(-15.0, 5.0 - 0.05 * i)), {force, Vec3::Zero()});
        if (i >= 39000) swing = std::max(swing, hand.velocity().norm());
      }
      EXPECT_LT(swing, 1.5) << stiffness << " N/mm, told of after " << pace << " s";
      EXPECT_GT(reaction.force(), 0.1);
    }
  }
}

TEST(ProbeReaction, it_never_pulls_is_never_too_strong_and_drags_less_than_it_presses) {
  ProbeReaction reaction(tick, 1.0);
  SlowSpring body(3.0, 1.0 / 60.0);
  double lowest = 0.0, highest = 0.0;
  for (int i = 0; i < 6000; ++i) {
    const double z = -30.0 * std::sin(0.004 * i);
    const Vec3 force = reaction.step(probe_at(20.0 * std::sin(0.003 * i), z), body.look(reaction.probe()), true);
    lowest = std::min(lowest, force.z());
    highest = std::max(highest, force.z());
    EXPECT_LE(force.head<2>().norm(), force.z() + 1e-12);
  }
  EXPECT_EQ(lowest, 0.0);
  EXPECT_NEAR(highest, 15.0, 1e-9);
}

TEST(ProbeReaction, when_it_ends_the_force_goes_without_a_jump_within_a_third_of_a_second) {
  ProbeReaction reaction(tick, 1.0);
  SlowSpring body(1.0, 1.0 / 60.0);
  const auto step = [&](bool presses) {
    return reaction.step(probe_at(0.0, -8.0), body.look(reaction.probe()), presses).z();
  };
  for (int i = 0; i < 1000; ++i) step(true);
  double before = step(true), largest_fall = 0.0;
  EXPECT_NEAR(before, 4.0, 0.1);
  for (int i = 0; i < 310; ++i) {
    const double now = step(false);
    largest_fall = std::max(largest_fall, before - now);
    before = now;
  }
  EXPECT_EQ(before, 0.0);
  EXPECT_LT(largest_fall, 0.03);
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(step(false), 0.0);
  for (int i = 0; i < 1000; ++i) before = step(true);
  EXPECT_NEAR(before, 4.0, 0.1);
}

TEST(ProbeReaction, a_body_that_says_nonsense_is_not_felt) {
  ProbeReaction reaction(tick, 1.0);
  ProbeReading reading;
  reading.nodes = 3;
  reading.on_probe.force = Vec3::Constant(std::nan(""));
  for (int i = 0; i < 100; ++i) {
    reading.steps = static_cast<std::uint64_t>(i);
    EXPECT_EQ(reaction.step(probe_at(0.0, -8.0), reading, true), Vec3(0.0, 0.0, 0.0));
    EXPECT_TRUE(reaction.probe().matrix().allFinite());
  }
}

}  // namespace
}  // namespace bodkin
