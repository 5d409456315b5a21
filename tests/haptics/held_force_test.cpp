#include "haptics/held_force.h"

#include <vector>

#include "tests/one_tick.h"
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::haptics;
namespace {

// The force along x that a device with this delay holds in the tick after each of the commands 1, 2, 3 ... N.
std::vector<double> held(double delay, bool later) {
  HeldForce force(delay, later);
  std::vector<double> found;
  for (int i = 1; i <= 8; ++i) {
    force.command({static_cast<double>(i), 0.0, 0.0});
    found.push_back(force.step(one_tick).x());
  }
  return found;
}

TEST(HeldForce, a_vendors_loop_holds_what_the_tick_before_commanded) {
  const std::vector<double> found = held(0.0, false);
  for (int i = 0; i < 8; ++i) EXPECT_NEAR(found[static_cast<std::size_t>(i)], i + 1.0, 1e-9);
}

TEST(HeldForce, a_polled_loop_holds_the_one_before_that) {
  const std::vector<double> found = held(0.0, true);
  for (int i = 0; i < 8; ++i) EXPECT_NEAR(found[static_cast<std::size_t>(i)], i, 1e-9);
}

TEST(HeldForce, a_delay_of_a_tick_and_a_half_is_the_mean_of_two_commands) {
  const std::vector<double> found = held(0.0015, false);
  EXPECT_NEAR(found[0], 0.0, 1e-9);
  EXPECT_NEAR(found[1], 0.5, 1e-9);
  for (int i = 2; i < 8; ++i) EXPECT_NEAR(found[static_cast<std::size_t>(i)], i - 0.5, 1e-9);
}

TEST(HeldForce, a_late_tick_holds_its_command_for_longer) {
  HeldForce force(0.001, false);
  force.command({1.0, 0.0, 0.0});
  EXPECT_NEAR(force.step(0.001).x(), 0.0, 1e-12);
  force.command({2.0, 0.0, 0.0});
  // 1 N for the first millisecond of four, then 2 N.
  EXPECT_NEAR(force.step(0.004).x(), (1.0 + 3.0 * 2.0) / 4.0, 1e-12);
}

}  // namespace
}  // namespace bodkin
