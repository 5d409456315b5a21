// EmbeddedNeedle with a flexible shaft, in motion: no jumps, no created energy, repeatable.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tests/fem/bent_needle.h"
#include "tests/simulation/real_time_guard.h"
#include <gtest/gtest.h>

#include "core/shortest_turn.h"
#include "fem/embedded_needle.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

using checks::bending;
using checks::bent_rig;
using checks::flesh;
using checks::NeedleRig;
using checks::steel_24g;

TEST(FlexibleNeedleWays, forces_are_continuous_wherever_nothing_is_punctured) {
  for (const NeedleHold hold : {NeedleHold::clamped, NeedleHold::pinned}) {
    NeedleRig rig = bent_rig(flesh(), checks::plain_tissues(0.02), bending(250.0, hold, 40.0));
    Random random(5);
    double largest = 0.0;
    for (int way = 0; way < (sanitized ? 4 : 20); ++way) {
      largest = std::max(
          largest,
          rig.move(Vec3(random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0), random.uniform(0.0, 14.0)), 2.0));
    }
    // 2 um a tick; along the line 14 mm of this tissue are about 2 N/mm stiff.
    EXPECT_LT(largest, 0.012);
    EXPECT_GT(largest, 1e-4);
  }
}

TEST(FlexibleNeedleWays, a_node_comes_and_goes_without_a_jump) {
  NeedleRig rig = bent_rig(flesh(), checks::plain_tissues(0.02), bending(250.0, NeedleHold::clamped, 40.0));
  rig.move(4.5, 10.0);
  rig.move(Vec3(2.0, 0.0, 4.5), 10.0);
  for (const double node : {4.0, 5.0, 4.0, 3.0, 5.0}) {
    rig.move(node - 0.01, 10.0);
    EXPECT_LT(rig.move(node + 0.01, 0.1), 1e-3) << node;
    EXPECT_LT(rig.move(node - 0.01, 0.1), 1e-3) << node;
  }
}

// Work of a hand on a random closed way, with the mean of both ends of every tick, N mm.
double closed_way(const NeedleBeam& beam, const ContactTissues& tissues, std::uint64_t seed, int ticks) {
  Random random(seed);
  EmbeddedNeedle model(flesh(), tissues, checks::narrow_settings(), 1e-3, beam);
  model.begin(Vec3::Zero(), Vec3::UnitZ());
  Pose last = needle_pose(Vec3(0.0, 0.0, -1.0), Vec3::UnitZ());
  EmbeddedNeedleForce before = model.step(last);
  const double speed = random.uniform(1.0, 4.0), phase = random.uniform(0.0, 6.0), lean = random.uniform(0.0, 0.05);
  double work = 0.0;
  for (int tick = 1; tick <= ticks; ++tick) {
    const double t = static_cast<double>(tick) / ticks;
    const double swing = std::sin(3.14159265358979323846 * t);
    const Vec3 tip(2.0 * swing * std::sin(speed * 9.0 * t + phase), 2.0 * swing * std::sin(speed * 5.0 * t),
                   -1.0 + 13.0 * swing * std::abs(std::sin(speed * 4.0 * t + phase)));
    const Vec3 axis(lean * std::sin(speed * 6.0 * t), lean * std::sin(speed * 8.0 * t + phase), 1.0);
    Pose now = Pose::Identity();
    now.linear() = shortest_turn(Vec3::UnitZ(), axis).toRotationMatrix();
    now.translation() = tip;
    const EmbeddedNeedleForce force = model.step(now);
    const Eigen::AngleAxisd turn(now.linear() * last.linear().transpose());
    const Vec3 turned = turn.angle() * turn.axis();
    work -= 0.5 * (force.on_hand.force + before.on_hand.force).dot(now.translation() - last.translation()) +
            0.5 * (force.on_hand.torque + before.on_hand.torque).dot(turned);
    before = force;
    last = now;
  }
  return work - model.stored_energy();
}

TEST(FlexibleNeedleWays, no_closed_way_gives_work) {
  for (const NeedleHold hold : {NeedleHold::clamped, NeedleHold::pinned}) {
    for (std::uint64_t seed = 1; seed <= (sanitized ? 2 : 15); ++seed) {
      const NeedleBeam beam = bending(seed % 3 == 0 ? 50.0 : 877.94, hold, 40.0);
      EXPECT_GT(closed_way(beam, checks::plain_tissues(seed % 2 == 0 ? 0.0 : 0.05), seed, 4000), -2e-3) << seed;
    }
  }
}

// Bent at a soft place and released at a stiff one, a spring would return energy that the hand never put in (here
// about 0.3 N mm, without the reaction along the needle).
TEST(FlexibleNeedleWays, bent_outside_and_let_go_deeper_it_gives_no_work) {
  for (const int ticks : {400, 1600}) {
    EmbeddedNeedle model(flesh(), checks::plain_tissues(0.0), checks::narrow_settings(), 1e-3,
                         bending(steel_24g, NeedleHold::clamped, 40.0));
    model.begin(Vec3::Zero(), Vec3::UnitZ());
    Vec3 place(0.0, 0.0, -0.5);
    EmbeddedNeedleForce before = model.step(needle_pose(place, Vec3::UnitZ()));
    double work = 0.0, pushed = 0.0, least = 0.0;
    for (const Vec3& goal : {Vec3(0.0, 0.0, 2.7), Vec3(3.0, 0.0, 2.7), Vec3(3.0, 0.0, 12.7), Vec3(0.0, 0.0, 12.7),
                             Vec3(0.0, 0.0, -0.5)}) {
      const Vec3 start = place;
      for (int tick = 1; tick <= ticks; ++tick) {
        const Vec3 next = start + (goal - start) * (static_cast<double>(tick) / ticks);
        const EmbeddedNeedleForce force = model.step(needle_pose(next, Vec3::UnitZ()));
        const Vec3 mean = 0.5 * (force.on_hand.force + before.on_hand.force);
        work -= mean.dot(next - place);
        pushed -= mean.z() * (next - place).z();
        least = std::min(least, work - model.stored_energy());
        before = force;
        place = next;
      }
    }
    EXPECT_GT(least, -1e-3);
    EXPECT_GT(work, 0.0);
    EXPECT_GT(pushed, 0.05);
  }
}

TEST(FlexibleNeedleWays, fifty_thousand_ticks_at_random_are_all_finite_and_take_no_memory_and_no_lock) {
  Random random(6);
  EmbeddedNeedle model(flesh(), default_contact_tissues(), checks::narrow_settings(), 1e-3,
                       bending(250.0, NeedleHold::pinned, 40.0, 0.2));
  model.begin(Vec3::Zero(), Vec3::UnitZ());
  bool finite = true;
  Vec3 tip(0.0, 0.0, -1.0);
  std::uint32_t most = 0;
  {
    const RealTimeGuard guard;
    for (int tick = 0; tick < (sanitized ? 3000 : 50000); ++tick) {
      if (random.uniform() < 0.001) tip = Vec3(random.normal(), random.normal(), random.uniform(-5.0, 50.0));
      if (random.uniform() < 0.0005) model.begin(Vec3(0.1, 0.0, 0.0), Vec3(0.05, 0.0, 1.0).normalized());
      if (random.uniform() < 0.0002) model.reset();
      tip += 0.1 * Vec3(random.normal(), random.normal(), random.normal() + 0.01);
      const Vec3 axis = Vec3(0.1 * random.normal(), 0.1 * random.normal(), 1.0).normalized();
      const EmbeddedNeedleForce& force = model.step(needle_pose(tip, axis));
      finite = finite && std::isfinite(force.on_hand.force.sum() + force.on_hand.torque.sum());
      finite = finite && std::isfinite(model.shaft_deflection(10.0).sum());
      most = std::max(most, force.nodes);
    }
    if (RealTimeGuard::available()) {
      EXPECT_EQ(RealTimeGuard::heap_calls(), 0u);
      EXPECT_EQ(RealTimeGuard::lock_calls(), 0u);
    }
  }
  EXPECT_TRUE(finite);
  EXPECT_GT(most, 5u);
}

TEST(FlexibleNeedleWays, the_same_motion_gives_the_same_bits) {
  NeedleRig rig = bent_rig(flesh(), default_contact_tissues(), bending(250.0, NeedleHold::clamped, 90.0, 0.2));
  std::vector<double> first;
  for (const bool again : {false, true}) {
    Random random(7);
    rig.model.reset();
    rig.begin();
    for (int way = 0; way < 10; ++way) {
      rig.move(Vec3(random.uniform(-1.0, 1.0), 0.0, random.uniform(-1.0, 14.0)), 50.0);
      const double sum = rig.force.on_hand.force.sum() + rig.force.tip_deflection.sum();
      if (again) {
        EXPECT_EQ(first[static_cast<std::size_t>(way)], sum);
      } else {
        first.push_back(sum);
      }
    }
  }
}

TEST(FlexibleNeedleWays, a_needle_longer_in_than_it_is_goes_on_from_its_hub) {
  NeedleRig rig = bent_rig(flesh(), checks::plain_tissues(0.0), bending(250.0, NeedleHold::clamped, 8.0));
  rig.move(Vec3(0.5, 0.0, 0.9), 20.0);
  EXPECT_LT(rig.move(Vec3(0.5, 0.0, 12.0), 2.0), 0.01);
  EXPECT_LT(rig.force.on_hand.force.x(), 0.0);
  EXPECT_FALSE(rig.force.fault);
}

}  // namespace
}  // namespace bodkin
