#pragma once

// Properties that every force model along the needle must have, as functions that its tests call.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "tests/sanitized.h"
#include <gtest/gtest.h>

#include "core/axial_motion.h"
#include "core/random.h"
#include "forces/events.h"

namespace bodkin::checks {

using namespace bodkin::anatomy;

// Depths of a moving tip to the motion that a model gets: exact speed, "stopped" below 0.5 mm/s.
class Hand {
 public:
  explicit Hand(double start, double dt = 1e-3) : depth_(start), dt_(dt) {}
  AxialMotion to(double depth) {
    AxialMotion motion;
    motion.depth = depth;
    motion.velocity = (depth - depth_) / dt_;
    motion.direction = motion.velocity > 0.5 ? 1 : (motion.velocity < -0.5 ? -1 : 0);
    motion.stopped = motion.direction == 0;
    depth_ = depth;
    return motion;
  }
  double depth() const { return depth_; }

 private:
  double depth_;
  double dt_;
};

// Moves at `speed` mm/s to `depth`, exactly, calling step(motion) -> R in every tick; returns the last R.
template <typename Step>
double move(Hand& hand, double depth, double speed, Step&& step, double dt = 1e-3) {
  double force = 0.0;
  const double start = hand.depth();
  const double way = depth - start;
  const int ticks = std::max(1, static_cast<int>(std::ceil(std::abs(way) / (speed * dt) - 1e-9)));
  for (int i = 1; i <= ticks; ++i) force = step(hand.to(start + way * i / ticks));
  return force;
}

template <typename Step>
double rest(Hand& hand, int ticks, Step&& step) {
  double force = 0.0;
  for (int i = 0; i < ticks; ++i) force = step(hand.to(hand.depth()));
  return force;
}

// A path from outside, through random depths at random speeds with rests and reversals, back outside.
inline std::vector<double> random_closed_path(Random& random, double deepest, double fastest, double dt = 1e-3) {
  std::vector<double> depths = {-2.0};
  const auto go = [&](double to) {
    const double speed = random.uniform(1.0, fastest);
    const double from = depths.back();
    const int ticks = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / (speed * dt))));
    for (int i = 1; i <= ticks; ++i) depths.push_back(from + (to - from) * i / ticks);
  };
  const int legs = 3 + static_cast<int>(random.uniform(0.0, 8.0));
  for (int leg = 0; leg < legs; ++leg) {
    const double near = depths.back() + random.uniform(-4.0, 4.0);
    go(random.uniform() < 0.5 ? random.uniform(-1.0, deepest) : std::clamp(near, -1.0, deepest));
    const int pause = random.uniform() < 0.3 ? static_cast<int>(random.uniform(1.0, 200.0)) : 0;
    for (int i = 0; i < pause; ++i) depths.push_back(depths.back());
  }
  go(-2.0);
  return depths;
}

// Net work that the hand does on random closed paths is never negative. `slope` is the model's largest stiffness
// (N/mm): where a force law has a corner inside a tick the trapezium rule errs by at most slope dx^2.
template <typename Make>
void passive_on_random_closed_paths(Make&& make, double deepest, double fastest, double slope,
                                    int paths = sanitized ? 40 : 400) {
  Random random(17);
  auto step = make();
  for (int path = 0; path < paths; ++path) {
    double work = 0.0, allowed = 1e-9;
    Hand hand(-2.0);
    double force = rest(hand, 300, step);  // what the path before has left stored fades
    int direction = 0;
    for (const double depth : random_closed_path(random, deepest, fastest)) {
      const double dx = depth - hand.depth();
      const AxialMotion motion = hand.to(depth);
      const double next = step(motion);
      work += 0.5 * (force + next) * dx;
      if (motion.direction != direction) allowed += slope * fastest * fastest * 1e-6;
      direction = motion.direction;
      force = next;
    }
    ASSERT_GE(work, -allowed) << "path " << path;
  }
}

// NaN, infinities and huge numbers in any input give a finite force; a fault is reported for what is not finite.
template <typename Make>
void finite_on_any_input(Make&& make) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const double values[] = {0.0,
                           -0.0,
                           1e-300,
                           1.0,
                           -1.0,
                           300.0,
                           1e4,
                           1e12,
                           1e308,
                           -1e308,
                           inf,
                           -inf,
                           std::numeric_limits<double>::quiet_NaN()};
  auto step = make();
  for (const double depth : values) {
    for (const double velocity : values) {
      for (const int direction : {-1, 0, 1}) {
        const double force = step(AxialMotion{depth, velocity, direction, direction == 0});
        ASSERT_TRUE(std::isfinite(force)) << depth << ' ' << velocity;
        const double after = step(AxialMotion{5.0, 10.0, 1, false});
        ASSERT_TRUE(std::isfinite(after)) << "after " << depth << ' ' << velocity;
      }
    }
  }
}

template <typename Make>
void same_bits_on_repetition(Make&& make, double deepest) {
  Random random(5);
  const std::vector<double> path = random_closed_path(random, deepest, 200.0);
  std::vector<double> runs[2];
  for (auto& run : runs) {
    auto step = make();
    Hand hand(-2.0);
    for (const double depth : path) run.push_back(step(hand.to(depth)));
  }
  EXPECT_EQ(0, std::memcmp(runs[0].data(), runs[1].data(), runs[0].size() * sizeof(double)));
}

// 1 m/s to 300 mm and back.
template <typename Make>
void bounded_when_saturated(Make&& make, double limit) {
  auto step = make();
  Hand hand(-2.0);
  const auto check = [&](const AxialMotion& motion) {
    const double force = step(motion);
    EXPECT_LE(std::abs(force), limit);
    return force;
  };
  move(hand, 300.0, 1000.0, check);
  rest(hand, 50, check);
  move(hand, -2.0, 1000.0, check);
}

// A reversal in every tick for 10 s: the force swings in the last second no more than in the first.
template <typename Make>
void no_growth_under_reversal_at_every_tick(Make&& make, double depth, double amplitude = 0.02) {
  auto step = make();
  Hand hand(-2.0);
  move(hand, depth, 10.0, step);
  double first = 0.0, last = 0.0;
  for (int tick = 0; tick < 10000; ++tick) {
    const double force = step(hand.to(depth + (tick % 2 == 0 ? amplitude : -amplitude)));
    if (tick < 1000) first = std::max(first, std::abs(force));
    if (tick >= 9000) last = std::max(last, std::abs(force));
  }
  EXPECT_LE(last, first + 1e-9);
}

// The steady force of an advance does not depend on dt. make(dt) gives a step.
template <typename Make>
void steady_force_is_the_same_at_half_the_tick(Make&& make, double depth, double speed, double tolerance) {
  double steady[2];
  const double dts[] = {1e-3, 5e-4};
  for (int i = 0; i < 2; ++i) {
    auto step = make(dts[i]);
    Hand hand(-2.0, dts[i]);
    steady[i] = move(hand, depth, speed, step, dts[i]);
  }
  EXPECT_NEAR(steady[0], steady[1], tolerance);
}

}  // namespace bodkin::checks
