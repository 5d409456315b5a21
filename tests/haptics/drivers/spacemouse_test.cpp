#include "haptics/drivers/spacemouse.h"

#include <cmath>
#include <cstdlib>
#include <ctime>

#include "tests/haptics/spnav_server.h"
#include "tests/simulation/real_time_guard.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptics/device_port.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

using testing::HasSubstr;

constexpr int full = 350;  // counts

class SpaceMouse : public testing::Test {
 protected:
  std::unique_ptr<DevicePort> started(const std::string& settings = "reach_mm=2 speed_mm_s=1000") {
    auto port = std::make_unique<DevicePort>(spacemouse_driver(), "", "socket=" + server_.path() + " " + settings);
    server_.accept_one();
    port->start();
    return port;
  }
  // Moves the puck and releases it at the end of its reach.
  static Vec3 pushed(DevicePort& port) {
    DeviceState state;
    Vec3 before;
    do {
      before = state.hand.translation();
      const timespec pause{0, 2'000'000};
      nanosleep(&pause, nullptr);
      port.exchange({}, state);
    } while (state.hand.translation() != before || state.hand.translation().isZero());
    EXPECT_EQ(state.fault, DeviceFault::none);
    return state.hand.translation();
  }
  std::string refusal(const std::string& settings, DeviceFault fault) const {
    try {
      const DevicePort port(spacemouse_driver(), "", settings);
    } catch (const DeviceError& error) {
      EXPECT_EQ(error.fault(), fault);
      return error.what();
    }
    ADD_FAILURE() << "opened";
    return {};
  }

  mock::SpnavServer server_;
};

TEST_F(SpaceMouse, each_axis_of_the_puck_moves_its_own_way_and_stops_at_the_reach) {
  const Vec3 ways[3] = {{2, 0, 0}, {0, 0, 2}, {0, -2, 0}};  // right; up; towards the operator
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto port = started();
    mock::SpnavServer::Event event{};
    event[1 + axis] = full;
    server_.send(event);
    EXPECT_EQ(pushed(*port), ways[axis]) << axis;
    event[1 + axis] = -full;
    server_.send(event);
    EXPECT_EQ(pushed(*port), -ways[axis]) << axis;
  }
}

TEST_F(SpaceMouse, takes_the_axes_that_the_user_says) {
  const auto port = started("reach_mm=2 speed_mm_s=1000 axes=-y,x,z");
  server_.send({0, 0, full, 0, 0, 0, 0, 1});
  EXPECT_EQ(pushed(*port), Vec3(-2, 0, 0));
}

TEST_F(SpaceMouse, stays_where_it_is_when_the_puck_is_let_go_and_within_the_dead_zone) {
  const auto port = started();
  server_.send({0, full, 0, 0, 0, 0, 0, 1});
  EXPECT_EQ(pushed(*port), Vec3(2, 0, 0));
  server_.send({0, -full / 50, 0, 0, 0, 0, 0, 1});
  DeviceState state;
  for (int round = 0; round < 20; ++round) port->exchange({}, state);
  EXPECT_EQ(state.hand.translation(), Vec3(2, 0, 0));
  EXPECT_EQ(state.velocity, Vec3::Zero());
}

TEST_F(SpaceMouse, a_twist_turns_the_tool_about_the_same_axis) {
  const auto port = started("turn_deg_s=720");
  server_.send({0, 0, 0, 0, 0, full, 0, 1});  // about the puck's Y, which is up
  DeviceState state;
  port->exchange({}, state);
  EXPECT_TRUE(state.hand.translation().isZero());
  double turned = 0.0;
  while (turned < 0.3) {
    port->exchange({}, state);
    const Vec3 axis = needle_axis(state.hand);
    turned = std::atan2(-axis.x(), axis.y());  // to the left, seen from above
    EXPECT_NEAR(axis.z(), 0.0, 1e-9);
    ASSERT_GT(turned, -1e-9);
  }
}

TEST_F(SpaceMouse, an_event_that_comes_in_pieces_is_put_together) {
  const auto port = started();
  const mock::SpnavServer::Event event{1, 1, 0, 0, 0, 0, 0, 0};
  DeviceState state;
  server_.send_bytes(event, 0, 7);
  port->exchange({}, state);
  EXPECT_EQ(state.buttons, 0u);
  server_.send_bytes(event, 7, sizeof event);
  port->exchange({}, state);
  EXPECT_EQ(state.buttons, 2u);
  server_.send({2, 1, 0, 0, 0, 0, 0, 0});
  server_.send({1, 77, 0, 0, 0, 0, 0, 0});  // a button that cannot be
  port->exchange({}, state);
  EXPECT_EQ(state.buttons, 0u);
}

TEST_F(SpaceMouse, that_loses_its_daemon_stands_still_and_says_so) {
  const auto port = started();
  server_.send({0, full, 0, 0, 0, 0, 0, 1});
  const Vec3 at = pushed(*port);
  server_.hang_up();
  DeviceState state;
  port->exchange({}, state);
  port->exchange({}, state);
  EXPECT_EQ(state.fault, DeviceFault::communication_lost);
  EXPECT_EQ(state.hand.translation(), at);
  EXPECT_THAT(port->explain(), HasSubstr(server_.path()));
}

TEST_F(SpaceMouse, renders_no_force_and_says_so) {
  const auto port = started();
  EXPECT_EQ(port->abilities().peak_force, 0.0);
  EXPECT_FALSE(port->abilities().owns_loop);
}

TEST_F(SpaceMouse, is_found_by_the_daemons_environment_variable) {
  setenv("SPNAV_SOCKET", server_.path().c_str(), 1);
  EXPECT_EQ(list_devices(spacemouse_driver(), "").size(), 1u);
  unsetenv("SPNAV_SOCKET");
}

TEST_F(SpaceMouse, without_a_daemon_says_what_to_start) {
  EXPECT_THAT(refusal("socket=/nowhere/spnav.sock", DeviceFault::not_installed),
              testing::AllOf(HasSubstr("/nowhere/spnav.sock"), HasSubstr("start spacenavd")));
}

TEST_F(SpaceMouse, refuses_settings_that_make_no_sense) {
  for (const char* settings :
       {"axes=x,x,y", "axes=xyz", "axes=x,y", "axes=", "axes=--x,y,z", "dead_zone=1", "reach_mm=0", "reach_mm=nan",
        "speed_mm_s=fast", "reach", "colour=red", "socket=\"open"}) {
    EXPECT_THROW(started(settings), InputError) << settings;
  }
}

TEST_F(SpaceMouse, an_exchange_allocates_and_locks_nothing) {
  if (!RealTimeGuard::available()) GTEST_SKIP() << "a sanitizer owns malloc and the locks in this build";
  const auto port = started();
  for (int event = 0; event < 10; ++event) server_.send({0, full, full, full, full, full, full, 1});
  DeviceState state;
  {
    const RealTimeGuard guard;
    for (int round = 0; round < 10; ++round) port->exchange({}, state);
  }
  EXPECT_EQ(RealTimeGuard::heap_calls() + RealTimeGuard::lock_calls(), 0u);
}

}  // namespace
}  // namespace bodkin
