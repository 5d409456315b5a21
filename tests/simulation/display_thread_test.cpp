#include "simulation/display_thread.h"

#include <chrono>
#include <memory>
#include <thread>

#include "tests/sanitized.h"
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::fem;
using namespace bodkin::simulation;
namespace {

NodeForces push_of(float force, std::uint32_t node = 0) {
  NodeForces forces;
  forces.count = 1;
  forces.nodes[0] = {node, {force, 0.0F, 0.0F}};
  return forces;
}

template <typename Holds>
bool comes_true(DisplayThread& display, Holds&& holds) {
  for (int tries = 0; tries < 2000; ++tries) {
    if (holds(display.snapshot())) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

TEST(DisplayThread, shows_the_newest_forces_without_being_asked) {
  DisplayThread display(DisplayField(Eigen::MatrixXf::Ones(30, 6)), 500.0);
  EXPECT_EQ(display.snapshot().displacements.size(), 30U);
  display.set_forces(push_of(2.0F));
  EXPECT_TRUE(comes_true(display, [](const DisplaySnapshot& now) { return now.displacements[29] == 2.0F; }));
  display.set_forces(push_of(3.0F, 7));  // a node without columns
  EXPECT_TRUE(comes_true(display, [](const DisplaySnapshot& now) { return now.left_out == 3.0; }));
  EXPECT_EQ(display.snapshot().displacements[0], 0.0F);
}

TEST(DisplayThread, every_picture_is_of_one_tick) {
  DisplayThread display(DisplayField(Eigen::MatrixXf::Ones(300, 6)), 1000.0);
  std::jthread tick([&](const std::stop_token& stop) {
    for (float force = 1.0F; !stop.stop_requested(); force += 1.0F) display.set_forces(push_of(force));
  });
  std::uint64_t last = 0;
  for (int pictures = 0; pictures < (sanitized ? 20 : 200);) {
    const DisplaySnapshot& now = display.snapshot();
    for (const float value : now.displacements) ASSERT_EQ(value, now.displacements.front());
    ASSERT_GE(now.frame, last);
    if (now.frame > last) ++pictures;
    last = now.frame;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
}

TEST(DisplayThread, shows_another_field_from_its_first_snapshot_on_and_the_forces_go_on) {
  DisplayThread display(DisplayField(Eigen::MatrixXf::Ones(30, 6)), 500.0);
  display.set_forces(push_of(2.0F));
  ASSERT_TRUE(comes_true(display, [](const DisplaySnapshot& now) { return now.displacements[29] == 2.0F; }));
  for (const std::size_t points : {4U, 50U, 10U}) {
    const auto rows = static_cast<Eigen::Index>(3 * points);
    display.show(std::make_unique<GrowingField>(DisplayField(Eigen::MatrixXf::Constant(rows, 6, 0.5F))));
    EXPECT_EQ(display.snapshot().displacements.size(), 3 * points) << "at once";
    EXPECT_TRUE(comes_true(display, [&](const DisplaySnapshot& now) {
      EXPECT_EQ(now.displacements.size(), 3 * points);
      return now.displacements.back() == 1.0F;
    }));
  }
}

TEST(DisplayThread, refuses_rates_that_are_none) {
  for (const double rate : {0.0, -1.0, 2000.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(DisplayThread(DisplayField(Eigen::MatrixXf::Ones(3, 3)), rate), InputError);
}

}  // namespace
}  // namespace bodkin
