#include "simulation/operator.h"

#include <cmath>

#include "tests/one_tick.h"
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::simulation;
namespace {

const NeedlePath path{{0, 100, 0}, {0, 50, 0}};  // anterior

OperatorPhase phase(const std::string& name, double speed, std::vector<OperatorCondition> until) {
  OperatorPhase made;
  made.name = name;
  made.speed = speed;
  made.until = std::move(until);
  return made;
}

OperatorCondition after(double time, int next) {
  OperatorCondition condition;
  condition.time = time;
  condition.next = next;
  return condition;
}

// Exact, without errors of aim and with a fixed reaction time.
OperatorScript machine(std::vector<OperatorPhase> phases) {
  OperatorScript script;
  script.name = "machine";
  script.aim_position = 0.0;
  script.aim_angle = 0.0;
  script.reaction = 0.2;
  script.reaction_spread = 0.0;
  script.phases = std::move(phases);
  return script;
}

// An operator whose hand moves exactly as intended, and the opposing force.
class Rehearsal {
 public:
  Rehearsal(const OperatorScript& script, std::uint64_t seed)
      : actor_(script, path, seed, one_tick), needle_(actor_.start()) {}

  // Performs one tick while `force` N push the hand out; the tip's depth after it.
  double step(double force) {
    needle_ = actor_.step({needle_, -force * needle_axis(needle_)});
    return (needle_.translation() - path.entry).dot(path.direction());
  }
  const Operator& actor() const { return actor_; }
  const Pose& needle() const { return needle_; }

 private:
  Operator actor_;
  Pose needle_;
};

TEST(Operator, moves_at_the_speed_of_the_phase_along_the_planned_path) {
  Rehearsal rehearsal(machine({phase("in", 5.0, {after(10.0, OperatorCondition::end)})}), 1);
  double depth = 0.0;
  for (int tick = 0; tick < 2000; ++tick) depth = rehearsal.step(0.0);
  // 5 mm/s for 2 s after a start at 200 mm/s^2, which costs v^2 / 2a
  EXPECT_NEAR(depth, -30.0 + 10.0 - 25.0 / 400.0, 0.01);
  EXPECT_NEAR((needle_axis(rehearsal.needle()) - path.direction()).norm(), 0.0, 1e-12);
}

TEST(Operator, answers_a_drop_of_force_after_the_reaction_time_and_not_before) {
  OperatorCondition drop;
  drop.force_drop = 1.0;
  drop.next = 1;
  Rehearsal rehearsal(machine({phase("in", 5.0, {drop}), phase("stop", 0.0, {after(9.0, OperatorCondition::end)})}),
                      1);
  for (int tick = 0; tick < 1000; ++tick) rehearsal.step(3.0);
  EXPECT_EQ(rehearsal.actor().phase(), 0) << "a steady force is not a drop";
  int answered = 0;
  for (int tick = 1; tick <= 600 && answered == 0; ++tick) {
    rehearsal.step(0.5);
    if (rehearsal.actor().phase() == 1) answered = tick;
  }
  EXPECT_GE(answered, 200);
  EXPECT_LE(answered, 230) << "smoothing of the sense of force may cost a little";
  const double there = rehearsal.step(0.5);
  for (int tick = 0; tick < 500; ++tick) rehearsal.step(0.5);
  EXPECT_NEAR(rehearsal.step(0.5), there, 1e-9) << "holding still is holding still";
}

// The sense of a slowly varying force ends at 15 Hz: a push of 3 N that is away for two milliseconds is still 2.5 N.
TEST(Operator, does_not_feel_what_is_over_in_two_milliseconds) {
  OperatorCondition drop;
  drop.force_drop = 1.0;
  drop.next = 1;
  Rehearsal rehearsal(machine({phase("in", 5.0, {drop}), phase("stop", 0.0, {after(9.0, OperatorCondition::end)})}),
                      1);
  for (int tick = 0; tick < 1500; ++tick) rehearsal.step(tick % 500 > 497 ? 0.0 : 3.0);
  EXPECT_EQ(rehearsal.actor().phase(), 0);
}

// Bone stops the needle 25 mm before the hand's aim.
TEST(Operator, a_hand_that_holds_still_lets_go_of_its_push) {
  Operator actor(
      machine({phase("in", 50.0, {after(1.0, 1)}), phase("stop", 0.0, {after(1.0, OperatorCondition::end)})}), path,
      1, one_tick);
  const auto depth = [](const Pose& pose) { return (pose.translation() - path.entry).dot(path.direction()); };
  Pose needle = actor.start(), wanted = needle;
  for (int tick = 0; tick < 1500; ++tick) {
    wanted = actor.step({needle, Vec3::Zero()});
    needle = wanted;
    if (depth(needle) > -5.0) needle.translation() = path.entry - 5.0 * path.direction();
  }
  EXPECT_NEAR(depth(wanted), -5.0, 1e-9);
}

TEST(Operator, plans_are_followed_without_a_reaction_time) {
  OperatorCondition deep;
  deep.depth_above = -20.0;
  deep.next = OperatorCondition::end;
  Rehearsal rehearsal(machine({phase("in", 10.0, {deep})}), 1);
  double depth = -30.0;
  while (!rehearsal.actor().finished()) depth = rehearsal.step(0.0);
  EXPECT_NEAR(depth, -20.0, 0.02);
}

TEST(Operator, rests_between_steps) {
  OperatorPhase stepping = phase("in", 10.0, {after(20.0, OperatorCondition::end)});
  stepping.step = 2.0;
  stepping.pause = 0.5;
  Rehearsal rehearsal(machine({stepping}), 1);
  int still = 0;
  double before = -30.0;
  for (int tick = 0; tick < 7000; ++tick) {
    const double depth = rehearsal.step(0.0);
    still += std::abs(depth - before) < 1e-12 ? 1 : 0;
    before = depth;
  }
  // A step of 2 mm takes about 0.25 s with starting and stopping, a rest 0.5 s of which 0.05 s is slowing down.
  EXPECT_GT(still, 3500);
  EXPECT_LT(still, 5000);
}

TEST(Operator, tilts_towards_the_head_and_gives_up_after_so_many_times) {
  OperatorPhase redirect = phase("redirect", 0.0, {after(1.0, 0)});
  redirect.tilt = 0.1;
  redirect.at_most = 2;
  redirect.otherwise = 1;
  Rehearsal rehearsal(machine({redirect, phase("give_up", 0.0, {after(0.1, OperatorCondition::end)})}), 1);
  int ticks = 0;
  for (; !rehearsal.actor().finished() && ticks < 10000; ++ticks) rehearsal.step(0.0);
  EXPECT_NEAR(ticks, 2100, 5);
  EXPECT_NEAR(std::asin(needle_axis(rehearsal.needle()).z()), 0.2, 1e-6) << "superior is +z";
}

TEST(Operator, twirls_to_and_fro_about_the_needle_and_comes_back) {
  OperatorPhase twirl = phase("twirl", 0.0, {after(3.0, 1)});
  twirl.twirl = 2.0;
  twirl.twirl_rate = 2.0;
  Rehearsal rehearsal(machine({twirl, phase("rest", 0.0, {after(1.0, OperatorCondition::end)})}), 1);
  const Pose start = rehearsal.needle();
  const auto turned = [&] {
    const Mat3 turn = start.linear().transpose() * rehearsal.needle().linear();
    EXPECT_NEAR(turn(2, 2), 1.0, 1e-9) << "about its own axis";
    return std::atan2(turn(1, 0), turn(0, 0));
  };
  double least = 0.0, most = 0.0;
  int crossings = 0;
  double before = 0.0;
  for (int tick = 0; tick < 2990; ++tick) {
    rehearsal.step(0.0);
    const double angle = turned();
    least = std::min(least, angle);
    most = std::max(most, angle);
    crossings += before <= 0.0 && angle > 0.0 ? 1 : 0;
    before = angle;
  }
  EXPECT_NEAR(most, 1.0, 0.01);
  EXPECT_NEAR(least, -1.0, 0.01);
  EXPECT_EQ(crossings, 6);
  for (int tick = 0; tick < 500; ++tick) rehearsal.step(0.0);
  EXPECT_NEAR(turned(), 0.0, 1e-9);
}

TEST(Operator, phases_that_only_give_way_to_each_other_end_the_script) {
  OperatorPhase one = phase("one", 0.0, {after(0.0, 0)});
  one.at_most = 1;
  one.otherwise = 0;
  Rehearsal rehearsal(machine({one}), 1);
  for (int tick = 0; tick < 10; ++tick) rehearsal.step(0.0);
  EXPECT_TRUE(rehearsal.actor().finished());
}

TEST(Operator, equal_seeds_do_the_same_and_others_do_not) {
  OperatorScript script = machine({phase("in", 10.0, {after(60.0, OperatorCondition::end)})});
  script.aim_position = 1.0;
  script.aim_angle = 0.02;
  script.unsteadiness = 0.4;
  script.wander = 0.5;
  script.wander_angle = 0.01;
  Rehearsal one(script, 4), same(script, 4), other(script, 5);
  bool differs = false;
  for (int tick = 0; tick < 3000; ++tick) {
    const double force = tick % 700 * 0.005;
    one.step(force);
    same.step(force);
    other.step(force);
    ASSERT_EQ(one.needle().matrix(), same.needle().matrix());
    differs = differs || one.needle().matrix() != other.needle().matrix();
  }
  EXPECT_TRUE(differs);
}

TEST(Operator, the_error_of_aim_has_the_wanted_spread) {
  OperatorScript script = machine({phase("in", 0.0, {after(1.0, OperatorCondition::end)})});
  script.aim_position = 2.0;
  double square = 0.0;
  constexpr int people = 2000;
  for (int seed = 0; seed < people; ++seed) {
    const Vec3 beside =
        Operator(script, path, static_cast<std::uint64_t>(seed), one_tick).start().translation() - path.entry;
    EXPECT_NEAR(beside.dot(path.direction()), -30.0, 1e-9);
    square += (beside + 30.0 * path.direction()).squaredNorm() / 2.0;
  }
  EXPECT_NEAR(std::sqrt(square / people), 2.0, 0.1);
}

TEST(Operator, a_script_that_cannot_be_performed_is_refused) {
  EXPECT_THROW(Operator(machine({}), path, 1, one_tick), InputError);
  EXPECT_THROW(Operator(machine({phase("never", 1.0, {})}), path, 1, one_tick), InputError);
  EXPECT_THROW(Operator(machine({phase("in", 1.0, {OperatorCondition{}})}), path, 1, one_tick), InputError);
  EXPECT_THROW(Operator(machine({phase("in", 1.0, {after(1.0, 3)})}), path, 1, one_tick), InputError);
  EXPECT_THROW(Operator(machine({phase("in", 900.0, {after(1.0, -1)})}), path, 1, one_tick), InputError);
  const NeedlePath nowhere{{1, 2, 3}, {1, 2, 3}};
  EXPECT_THROW(Operator(machine({phase("in", 1.0, {after(1.0, -1)})}), nowhere, 1, one_tick), InputError);
}

TEST(Operator, a_phase_can_take_the_finger_shift_it_and_handle_stylet_and_manometer) {
  OperatorPhase feel = phase("feel", 0.0, {after(1.0, 1)});
  feel.finger = true;
  feel.shift = 15.0;
  OperatorPhase out = phase("out", 0.0, {after(0.5, 2)});
  out.move_stylet = true;
  OperatorPhase in = phase("in", 0.0, {after(0.5, OperatorCondition::end)});
  in.move_stylet = in.move_manometer = true;
  Rehearsal rehearsal(machine({feel, out, in}), 1);
  for (double time = 0.0; time < 0.9; time += one_tick) rehearsal.step(0.0);
  EXPECT_TRUE(rehearsal.actor().other_hand().finger);
  EXPECT_NEAR(rehearsal.needle().translation().z(), 15.0, 1e-6) << "towards the head";
  for (double time = 0.0; time < 0.5; time += one_tick) rehearsal.step(0.0);
  EXPECT_EQ(rehearsal.actor().other_hand().byte(), 2) << "the stylet alone";
  EXPECT_NEAR(rehearsal.needle().translation().z(), 0.0, 1e-6);
  for (double time = 0.0; time < 0.3; time += one_tick) rehearsal.step(0.0);
  EXPECT_EQ(rehearsal.actor().other_hand().byte(), 4) << "the manometer alone";
}

}  // namespace
}  // namespace bodkin
