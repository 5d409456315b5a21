#include "core/motion_estimator.h"

#include <cmath>
#include <complex>
#include <numbers>

#include <gtest/gtest.h>

#include "core/random.h"
#include "core/sampled_stability.h"

namespace bodkin {
namespace {

constexpr double dt = 0.001;

TEST(MotionEstimator, a_constant_speed_is_found_and_its_direction_known) {
  MotionEstimator motion(dt, 0.0);
  AxialMotion now;
  for (int tick = 0; tick < 100; ++tick) now = motion.step(0.01 * tick);
  EXPECT_NEAR(now.velocity, 10.0, 1e-9);
  EXPECT_EQ(now.direction, 1);
  EXPECT_FALSE(now.stopped);
  EXPECT_DOUBLE_EQ(now.depth, 0.99);
}

TEST(MotionEstimator, the_velocity_settles_with_the_50_Hz_pole) {
  MotionEstimator motion(dt, 0.0);
  motion.step(0.0);
  double remaining = 10.0;
  for (int tick = 1; tick < 30; ++tick) {
    remaining *= std::exp(-2.0 * std::numbers::pi * 50.0 * dt);
    EXPECT_NEAR(10.0 - motion.step(0.01 * tick).velocity, remaining, 1e-9);
  }
}

TEST(MotionEstimator, counts_of_a_real_device_do_not_look_like_motion) {
  constexpr double count = 0.055;  // mm; one count a tick would be 55 mm/s
  MotionEstimator motion(dt, count);
  Random random(7);
  for (int tick = 0; tick < 5000; ++tick) {
    const double jitter = random.uniform() < 0.5 ? 0.0 : count;
    const AxialMotion now = motion.step(jitter);
    EXPECT_LT(std::abs(now.velocity), 3.0);
    EXPECT_EQ(now.direction, 0);
  }
}

TEST(MotionEstimator, a_quantised_slow_push_is_estimated_to_one_count_in_20_ms) {
  constexpr double count = 0.0295;
  MotionEstimator motion(dt, count);
  for (int tick = 0; tick < 2000; ++tick) {
    const double true_depth = 10.0 * tick * dt;
    const AxialMotion now = motion.step(std::floor(true_depth / count) * count);
    if (tick > 100) {
      EXPECT_NEAR(now.velocity, 10.0, count / 0.020);
      EXPECT_EQ(now.direction, 1);
    }
  }
}

TEST(MotionEstimator, a_sudden_stop_is_noticed_after_the_dwell_and_not_before) {
  MotionEstimator motion(dt, 0.0);
  double depth = 0.0;
  for (int tick = 0; tick < 200; ++tick) motion.step(depth += 0.02);
  int ticks = 0;
  while (!motion.step(depth).stopped) ++ticks;
  EXPECT_GE(ticks, 20);
  EXPECT_LE(ticks, 45);  // 20 ms v = 20 mm/s needs to fall below 0.5 mm/s through the pole, and 20 ms of dwell
}

TEST(MotionEstimator, rest_ends_only_above_one_and_a_half_times_the_threshold) {
  for (const double resolution : {0.0, 0.03}) {
    MotionEstimator slow(dt, resolution), fast(dt, resolution);
    AxialMotion a, b;
    for (int tick = 0; tick < 500; ++tick) {
      a = slow.step(1.4 * slow.threshold() * tick * dt);
      b = fast.step(1.6 * fast.threshold() * tick * dt);
    }
    EXPECT_TRUE(a.stopped);
    EXPECT_EQ(a.direction, 0);
    EXPECT_FALSE(b.stopped);
    EXPECT_EQ(b.direction, 1);
  }
}

TEST(MotionEstimator, a_turn_between_two_ticks_counts_as_a_stop) {
  MotionEstimator motion(dt, 0.0);
  double depth = 0.0;
  for (int tick = 0; tick < 200; ++tick) motion.step(depth += 0.02);
  int stops = 0;
  int direction_at_stop = 0;
  for (int tick = 0; tick < 50; ++tick) {
    const AxialMotion now = motion.step(depth -= 0.02);
    if (now.stopped) {
      ++stops;
      direction_at_stop = now.direction;
      EXPECT_LT(now.velocity, 0.0);
    }
  }
  EXPECT_EQ(stops, 1);
  EXPECT_EQ(direction_at_stop, -1);
}

TEST(MotionEstimator, the_direction_does_not_flip_below_the_threshold) {
  MotionEstimator motion(dt, 0.03);
  double depth = 0.0;
  for (int tick = 0; tick < 200; ++tick) motion.step(depth += 0.02);
  for (int tick = 0; tick < 15; ++tick) EXPECT_NE(motion.step(depth -= 0.0005).direction, -1);  // -0.5 mm/s
}

TEST(MotionEstimator, moving_the_origin_of_depth_disturbs_nothing) {
  MotionEstimator moved(dt, 0.02), still(dt, 0.02);
  for (int tick = 0; tick < 300; ++tick) {
    const double depth = std::sin(0.01 * tick);
    if (tick == 150) moved.rebase(moved.depth() + 100.0);
    const AxialMotion a = moved.step(tick < 150 ? depth : depth + 100.0);
    const AxialMotion b = still.step(depth);
    EXPECT_NEAR(a.velocity, b.velocity, 1e-9);
    EXPECT_EQ(a.direction, b.direction);
  }
}

TEST(OnePole, a_30_Hz_filter_at_1_kHz_has_the_published_steps) {
  OnePole filter(30.0, dt);
  EXPECT_NEAR(filter.gain(), 0.171796, 5e-7);
  const double expected[][2] = {{1, 0.171796}, {5, 0.610339}, {10, 0.848164}, {20, 0.976946}, {40, 0.999469}};
  int tick = 0;
  for (const auto& [at, value] : expected) {
    while (tick < static_cast<int>(at)) filter.step(1.0), ++tick;
    EXPECT_NEAR(filter.value(), value, 5e-7);
  }
}

TEST(SampledStability, the_damping_needed_is_the_bound_of_colgate_and_schenkel) {
  EXPECT_NEAR(damping_needed(0.5, 0.0, dt), 0.00025, 1e-15);
  EXPECT_NEAR(damping_needed(1.0, 0.0, dt), 0.0005, 1e-15);
  EXPECT_NEAR(damping_needed(3.16, 0.0, dt), 0.00158, 1e-15);
  EXPECT_NEAR(damping_needed(0.5, 0.002, dt), 0.00225, 1e-15);
  EXPECT_NEAR(damping_needed(0.5, -0.002, dt), 0.00225, 1e-15);
}

// The theorem's left side, swept: sup over (0, pi/T] of (T/2)/(1 - cos wT) Re{(1 - e^-jwT) H(e^jwT)}.
TEST(SampledStability, the_bound_is_the_supremum_over_all_frequencies) {
  for (const auto& [stiffness, damping] : {std::pair{0.5, 0.002}, std::pair{1.0, 0.0}, std::pair{0.3, 0.0001}}) {
    double supremum = 0.0;
    for (int step = 1; step <= 20000; ++step) {
      const double angle = std::numbers::pi * step / 20000.0;
      const std::complex<double> z = std::polar(1.0, angle);
      const std::complex<double> wall = stiffness + damping * (z - 1.0) / (dt * z);
      const double value = dt / 2.0 / (1.0 - std::cos(angle)) * ((1.0 - 1.0 / z) * wall).real();
      supremum = std::max(supremum, value);
    }
    EXPECT_NEAR(supremum, damping_needed(stiffness, damping, dt), 1e-9);
  }
}

TEST(SampledStability, what_is_allowed_plus_what_is_used_is_what_the_device_has) {
  const double allowed = damping_allowed(0.5, 1.0, dt);
  EXPECT_NEAR(damping_needed(0.5, allowed, dt), damping_needed(1.0, 0.0, dt), 1e-15);
  EXPECT_EQ(damping_allowed(2.0, 1.0, dt), 0.0);
}

}  // namespace
}  // namespace bodkin
