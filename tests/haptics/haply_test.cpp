// Specific to Haply's driver, beyond the contract of all drivers: a service's possible behaviour on the wire.
#include "haptics/drivers/haply.h"

#include <chrono>
#include <optional>
#include <thread>

#include "tests/haptics/driver_rig.h"
#include "tests/haptics/mocks/haply.h"
#include "tests/simulation/real_time_guard.h"
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include "haptics/device_port.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

using namespace std::chrono_literals;
using mock::HaplyService;
using mock::Oddity;
using mock::Trouble;
using testing::AllOf;
using testing::HasSubstr;

using Clock = std::chrono::steady_clock;

class Haply : public testing::Test {
 protected:
  Haply() {
    board_.hand[1] = -0.15;
    board_.hand[2] = 0.2;
    serve({});
  }
  ~Haply() override { EXPECT_EQ(board_.violations, 0) << board_.first_violation.load(); }

  void serve(const HaplyService::Behaviour& behaviour) {
    service_.reset();
    service_.emplace(board_, behaviour);
  }
  std::string words() const { return "port=" + std::to_string(service_->port()) + " "; }
  std::unique_ptr<DevicePort> opened(const std::string& settings = "") {
    // A busy machine is not a fault, unless a test says otherwise.
    const std::string patience = settings.find("silence_ms") == std::string::npos ? " silence_ms=500" : "";
    return std::make_unique<DevicePort>(haply_driver(), "", words() + settings + patience);
  }
  std::unique_ptr<DevicePort> started(const std::string& settings = "") {
    auto port = opened(settings);
    port->start();
    return port;
  }
  // At least so many rounds, of which the answers have come: a round ends after 5 ms even without one.
  DeviceState rounds(DevicePort& port, int count, const Vec3& force = Vec3::Zero()) const {
    DeviceState state;
    const auto ticks = board_.ticks.load();
    const auto end = Clock::now() + 2s;
    do {
      port.exchange({force, Vec3::Zero()}, state);
    } while (board_.ticks.load() <= ticks + count && state.fault != DeviceFault::communication_lost &&
             Clock::now() < end);
    return state;
  }
  // Runs rounds until the state has `fault`, for at most two seconds.
  static bool comes(DevicePort& port, DeviceFault fault, const Vec3& force = Vec3::Zero()) {
    DeviceState state;
    const auto end = Clock::now() + 2s;
    while (Clock::now() < end) {
      port.exchange({force, Vec3::Zero()}, state);
      if (state.fault == fault) return true;
      std::this_thread::sleep_for(100us);
    }
    return false;
  }
  std::string refusal(const std::string& settings, DeviceFault fault, const std::string& identity = "") const {
    try {
      const DevicePort port(haply_driver(), identity, settings);
    } catch (const DeviceError& error) {
      EXPECT_EQ(text_of(error.fault()), text_of(fault)) << error.what();
      return error.what();
    }
    ADD_FAILURE() << "opened";
    return {};
  }

  mock::Board board_;
  std::optional<HaplyService> service_;
};

TEST_F(Haply, introduces_itself_once_and_is_found_by_its_identity) {
  const auto found = list_devices(haply_driver(), words());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].identity, "04BA");
  DevicePort port(haply_driver(), "04BA", words());
  EXPECT_EQ(service_->profile(), "");
  for (int start = 0; start < 2; ++start) {
    port.start();
    rounds(port, 3);
    port.stop();
  }
  EXPECT_EQ(service_->profile(), "org.bodkin.trainer");
  EXPECT_EQ(port.abilities().name, "Inverse3");
  EXPECT_EQ(port.abilities().peak_torque, 0.0);
  EXPECT_THAT(refusal(words(), DeviceFault::not_connected, "0000"), HasSubstr("identity 0000"));
}

TEST_F(Haply, looks_for_the_service_quickly_where_there_is_none) {
  const auto begin = Clock::now();
  EXPECT_THAT(refusal("port=1", DeviceFault::not_installed), HasSubstr("systemctl start haply-inverse-service"));
  EXPECT_LT(Clock::now() - begin, 500ms);
}

TEST_F(Haply, spells_a_force_as_the_version_of_the_service_wants_it) {
  for (const auto& [version, key] :
       {std::pair{"3.5.0", "vector"}, {"3.4.9", "values"}, {"3.0.2", "values"}, {"4.0.0", "vector"}}) {
    serve({.version = version, .vector = key});
    const auto port = started();
    rounds(*port, 3, Vec3(1, 2, 3));
    EXPECT_EQ(board_.force[2], 3.0) << version;
  }
}

TEST_F(Haply, takes_the_key_of_a_force_from_the_user) {
  serve({.version = "3.5.0", .vector = "values"});
  const auto port = started("force_key=values");
  rounds(*port, 3, Vec3(1, 2, 3));
  EXPECT_EQ(board_.force[2], 3.0);
}

TEST_F(Haply, says_when_the_service_obeys_no_force) {
  serve({.version = "3.5.0", .vector = "values"});
  const auto port = started();
  EXPECT_EQ(rounds(*port, 20).fault, DeviceFault::none);  // idle, and nothing was asked for
  EXPECT_TRUE(comes(*port, DeviceFault::vendor_error, Vec3(1, 0, 0)));
  EXPECT_THAT(port->explain(), HasSubstr("force_key="));
  port->stop();
  port->start();
  EXPECT_EQ(rounds(*port, 5).fault, DeviceFault::none);
}

TEST_F(Haply, knows_the_older_paths) {
  serve({.version = "3.0.1", .older_paths = true, .vector = "values"});
  const auto port = started();
  rounds(*port, 3, Vec3(1, 2, 3));
  EXPECT_EQ(board_.force[0], 1.0);
}

TEST_F(Haply, refuses_what_is_not_the_service) {
  serve({.project = "printer"});
  EXPECT_THAT(refusal(words(), DeviceFault::wrong_version), AllOf(HasSubstr("'printer'"), HasSubstr("port=NUMBER")));
}

TEST_F(Haply, gives_up_one_who_listens_and_says_nothing) {
  const int listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  ASSERT_EQ(bind(listener, reinterpret_cast<sockaddr*>(&address), size), 0);
  ASSERT_EQ(listen(listener, 4), 0);
  ASSERT_EQ(getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size), 0);
  const auto begin = Clock::now();
  EXPECT_THAT(
      refusal("host=127.0.0.1 port=" + std::to_string(ntohs(address.sin_port)), DeviceFault::communication_lost),
      HasSubstr("does not answer as"));
  EXPECT_LT(Clock::now() - begin, 4s);
  close(listener);
}

TEST_F(Haply, refuses_axes_that_another_program_has_turned) {
  serve({.basis = "XZY"});
  EXPECT_THAT(refusal(words(), DeviceFault::vendor_error), HasSubstr("the basis XZY"));
  serve({.transform = true});
  EXPECT_THAT(refusal(words(), DeviceFault::vendor_error), HasSubstr("a transform of its own"));
}

TEST_F(Haply, works_without_a_grip) {
  serve({.grip = false});
  const auto port = started();
  EXPECT_FALSE(port->abilities().measures_rotation);
  const DeviceState state = rounds(*port, 3);
  EXPECT_EQ(state.fault, DeviceFault::none);
  EXPECT_TRUE(state.held);
  EXPECT_TRUE(needle_axis(state.hand).isApprox(Vec3::UnitY()));
  EXPECT_THAT(refusal(words() + "dead_man=a", DeviceFault::not_connected), HasSubstr("dead_man=none"));
  EXPECT_THAT(refusal(words() + "grip=5", DeviceFault::not_connected), HasSubstr("grip=none"));
}

TEST_F(Haply, points_the_tool_along_the_axis_that_the_user_says) {
  for (const auto& [name, axis] : {std::pair<const char*, Vec3>{"x", Vec3::UnitX()},
                                   {"-x", -Vec3::UnitX()},
                                   {"-y", -Vec3::UnitY()},
                                   {"z", Vec3::UnitZ()},
                                   {"-z", -Vec3::UnitZ()}}) {
    const auto port = started(std::string("tool_axis=") + name);
    EXPECT_TRUE(needle_axis(rounds(*port, 3).hand).isApprox(axis)) << name;
  }
}

TEST_F(Haply, a_dead_mans_button_must_be_held_and_is_no_other_button) {
  board_.buttons = 2;
  const auto port = started("dead_man=b");
  DeviceState state = rounds(*port, 30);
  EXPECT_TRUE(state.held);
  EXPECT_EQ(state.buttons, 4u);  // c, which the mock's hand holds
  board_.buttons = 1;
  state = rounds(*port, 30);
  EXPECT_FALSE(state.held);
  EXPECT_EQ(state.buttons, 5u);
}

TEST_F(Haply, a_grip_that_sleeps_or_is_gone_does_not_hold_the_dead_mans_switch) {
  for (const Oddity oddity : {Oddity::grip_asleep, Oddity::grip_gone}) {
    service_->oddity() = Oddity::none;
    const auto port = started("dead_man=c");
    EXPECT_TRUE(rounds(*port, 30).held);
    service_->oddity() = oddity;
    const DeviceState state = rounds(*port, 2);
    EXPECT_FALSE(state.held);
    EXPECT_EQ(state.fault, DeviceFault::none);
  }
}

TEST_F(Haply, takes_every_way_in_which_an_answer_may_come) {
  for (const Oddity oddity :
       {Oddity::more_fields, Oddity::fewer_fields, Oddity::fragments, Oddity::ping, Oddity::two_at_once}) {
    service_->oddity() = Oddity::none;
    const auto port = started();
    service_->oddity() = oddity;
    board_.hand[0] = 0.01;
    const DeviceState state = rounds(*port, 10, Vec3(1, 2, 3));
    EXPECT_EQ(state.fault, DeviceFault::none) << static_cast<int>(oddity);
    EXPECT_NEAR(state.hand.translation().x(), 10.0, 1e-9) << static_cast<int>(oddity);
    EXPECT_EQ(board_.force[1], 2.0) << static_cast<int>(oddity);
    EXPECT_EQ(state.velocity.array().isNaN().any(), oddity == Oddity::fewer_fields);
    service_->oddity() = Oddity::none;
    board_.hand[0] = 0.0;
  }
}

TEST_F(Haply, answers_that_cannot_be_read_are_bad_data_while_they_come) {
  for (const Oddity oddity : {Oddity::no_json, Oddity::huge_number}) {
    const auto port = started();
    rounds(*port, 3);
    service_->oddity() = oddity;
    EXPECT_EQ(rounds(*port, 1, Vec3(1, 0, 0)).fault, DeviceFault::bad_data);
    rounds(*port, 2, Vec3(1, 0, 0));
    EXPECT_EQ(board_.force[0], 0.0);  // DevicePort answers a fault with no force
    EXPECT_THAT(port->explain(), HasSubstr("cannot be read"));
    service_->oddity() = Oddity::none;
    EXPECT_EQ(rounds(*port, 2).fault, DeviceFault::none);
  }
}

TEST_F(Haply, a_connection_that_fails_ends_the_session_until_the_next_start) {
  for (const Oddity oddity : {Oddity::half_a_frame, Oddity::cut_in_a_frame, Oddity::hang_up, Oddity::too_long}) {
    const auto port = started();
    rounds(*port, 3, Vec3(1, 0, 0));
    service_->oddity() = oddity;
    EXPECT_TRUE(comes(*port, DeviceFault::communication_lost)) << static_cast<int>(oddity);
    EXPECT_THAT(port->explain(), HasSubstr("stopped answering"));
    service_->oddity() = Oddity::none;
    EXPECT_EQ(rounds(*port, 3).fault, DeviceFault::communication_lost);
    EXPECT_TRUE(comes_true([&] { return board_.open_devices == 0; })) << "the service sees that we are gone";
    EXPECT_EQ(board_.force[0], 0.0);
    port->stop();
    port->start();
    EXPECT_EQ(rounds(*port, 3).fault, DeviceFault::none) << static_cast<int>(oddity);
  }
}

TEST_F(Haply, no_round_lasts_long_and_silence_is_told_after_20_ms) {
  const auto port = started("silence_ms=20");
  service_->oddity() = Oddity::no_answer;
  const auto begin = Clock::now();
  Clock::duration longest{};
  DeviceFault fault = DeviceFault::none;
  while (fault == DeviceFault::none && Clock::now() - begin < 2s) {
    const auto before = Clock::now();
    DeviceState state;
    port->exchange({Vec3(1, 0, 0), Vec3::Zero()}, state);
    fault = state.fault;
    longest = std::max(longest, Clock::now() - before);
  }
  EXPECT_EQ(fault, DeviceFault::communication_lost);
  EXPECT_GE(Clock::now() - begin, 20ms);
  EXPECT_LT(Clock::now() - begin, 500ms);  // 25 ms on a machine that is not busy
  EXPECT_LT(longest, 200ms);               // 5 ms there
  service_->oddity() = Oddity::none;
}

TEST_F(Haply, a_device_without_a_position_is_lost) {
  const auto port = started();
  rounds(*port, 3);
  service_->oddity() = Oddity::no_position;
  EXPECT_EQ(rounds(*port, 1).fault, DeviceFault::none);
  EXPECT_TRUE(comes(*port, DeviceFault::communication_lost));
  EXPECT_THAT(port->explain(), HasSubstr("the device's position"));
  service_->oddity() = Oddity::none;
  EXPECT_TRUE(comes(*port, DeviceFault::none));
}

TEST_F(Haply, a_device_that_is_plugged_in_again_answers_again) {
  const auto port = started();
  board_.trouble = Trouble::unplug;
  EXPECT_TRUE(comes(*port, DeviceFault::communication_lost));
  EXPECT_THAT(port->explain(), HasSubstr("USB"));
  board_.trouble = Trouble::none;
  EXPECT_TRUE(comes(*port, DeviceFault::none));  // after a message that was under way
  EXPECT_EQ(rounds(*port, 2).fault, DeviceFault::none);
}

TEST_F(Haply, a_service_that_was_restarted_is_found_by_the_next_start) {
  const auto port = started();
  port->stop();
  service_->oddity() = Oddity::hang_up;
  EXPECT_THROW(port->start(), DeviceError);
  service_->oddity() = Oddity::none;
  port->start();
  EXPECT_EQ(rounds(*port, 3).fault, DeviceFault::none);
}

TEST_F(Haply, refuses_settings_that_make_no_sense) {
  for (const char* settings : {"port=0", "port=70000", "force_key=force", "dead_man=d", "dead_man=yes", "tool_axis=w",
                               "tool_axis=-", "tool_axis=xy", "peak_force=11", "peak_force=0", "silence_ms=4"}) {
    EXPECT_THROW(DevicePort(haply_driver(), "", settings), InputError) << settings;
  }
}

TEST_F(Haply, a_round_on_another_thread_than_the_start_allocates_and_locks_nothing) {
  if (!RealTimeGuard::available()) GTEST_SKIP() << "a sanitizer owns malloc and the locks in this build";
  const auto port = started();
  std::size_t calls = 1;
  std::thread([&] {
    DeviceState state;
    {
      const RealTimeGuard guard;
      for (int round = 0; round < 20; ++round) {
        port->exchange({Vec3(1.0 / 3.0, -2.0, 0.1), Vec3::Zero()}, state);
        if (round == 5) service_->oddity() = Oddity::fragments;
        if (round == 10) service_->oddity() = Oddity::ping;
        if (round == 15) service_->oddity() = Oddity::no_json;
      }
    }
    calls = RealTimeGuard::heap_calls() + RealTimeGuard::lock_calls();
  }).join();
  EXPECT_EQ(calls, 0u);
  service_->oddity() = Oddity::none;
}

}  // namespace
}  // namespace bodkin
