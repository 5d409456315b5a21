// Haply's service from 3.0 to 3.5, as the pages of its versions describe it.
#include <chrono>
#include <optional>
#include <thread>

#include "tests/haptics/driver_rig.h"
#include "tests/haptics/mocks/haply.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptics/device_port.h"
#include "haptics/drivers/driver_adapter.h"
#include "haptics/drivers/haply.h"
#include "haptics/drivers/haply_events.h"
#include "haptics/drivers/haply_service.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

using testing::HasSubstr;

class HaplyVersions : public testing::Test {
 protected:
  HaplyVersions() {
    board_.hand[1] = -0.15;
    board_.hand[2] = 0.2;
  }
  ~HaplyVersions() override { EXPECT_EQ(board_.violations, 0) << board_.first_violation.load(); }

  void serve(const mock::HaplyService::Behaviour& behaviour) {
    service_.reset();
    service_.emplace(board_, behaviour);
  }
  std::string words(const std::string& settings = "") const {
    return "port=" + std::to_string(service_->port()) +
           " websocket_port=" + std::to_string(service_->websocket_port()) +
           " events_port=" + std::to_string(service_->events_port()) + " silence_ms=500 " + settings;
  }
  // Rounds until `done`, for half a minute at most.
  template <typename Done>
  DeviceState rounds_until(DevicePort& port, Done done, const Vec3& force = Vec3::Zero()) const {
    DeviceState state;
    EXPECT_TRUE(comes_true([&] {
      port.exchange({force, Vec3::Zero()}, state);
      return done(state);
    }));
    return state;
  }
  std::string refusal(const std::string& settings) const {
    try {
      DevicePort port(haply_driver(), "", settings);
      port.start();
    } catch (const DeviceError& error) {
      EXPECT_EQ(text_of(error.fault()), text_of(DeviceFault::vendor_error)) << error.what();
      return error.what();
    }
    ADD_FAILURE() << "started";
    return {};
  }

  mock::Board board_;
  std::optional<mock::HaplyService> service_;
};

TEST_F(HaplyVersions, every_version_is_found_takes_forces_and_tells_of_its_buttons) {
  for (const char* version : {"3.0", "3.1", "3.2", "3.3", "3.4", "3.5"}) {
    serve(mock::HaplyService::of(version));
    board_.buttons = 1;
    DevicePort port(haply_driver(), "", words());
    port.start();
    const DeviceState state = rounds_until(
        port, [&](const DeviceState& now) { return board_.force[2] == 3.0 && now.buttons != 0; }, Vec3(1, 2, 3));
    EXPECT_EQ(state.buttons & 1U, 1U) << version;
    EXPECT_EQ(state.fault, DeviceFault::none) << version;
    port.stop();
    EXPECT_EQ(board_.force[2], 0.0) << version;
  }
}

TEST_F(HaplyVersions, every_version_tells_that_no_force_is_obeyed) {
  for (const char* version : {"3.0", "3.3", "3.5"}) {
    mock::HaplyService::Behaviour behaviour = mock::HaplyService::of(version);
    behaviour.vector = behaviour.vector == "vector" ? "values" : "vector";
    serve(behaviour);
    DevicePort port(haply_driver(), "", words());
    port.start();
    const auto refused = [](const DeviceState& now) { return now.fault == DeviceFault::vendor_error; };
    EXPECT_EQ(rounds_until(port, refused, Vec3(1, 0, 0)).fault, DeviceFault::vendor_error) << version;
  }
}

TEST_F(HaplyVersions, http_and_websocket_are_found_on_one_port_or_two) {
  for (const bool apart : {false, true}) {
    mock::HaplyService::Behaviour behaviour = mock::HaplyService::of("3.4");
    behaviour.apart = apart;
    serve(behaviour);
    // The service's usual ports, whichever of the two its HTTP has.
    const int http = service_->port(), socket = service_->websocket_port();
    for (const HaplyPorts& usual : {HaplyPorts{.newer = socket, .older = http, .events = 0},
                                    HaplyPorts{.newer = http, .older = socket, .events = 0}}) {
      const haptics::HaplyService found = find_haply_service(DriverSettings("", {"host", "port"}), usual);
      EXPECT_EQ(found.address.port, http);
      const HaplySession session = open_haply_session(found);
      EXPECT_EQ(session.address.port, socket);
      EXPECT_EQ(session.inventory.devices.size(), 1u);
    }
  }
}

TEST_F(HaplyVersions, the_older_port_takes_the_older_spelling_of_a_force) {
  serve(mock::HaplyService::of("3.5"));
  const int port = service_->port();
  const DriverSettings none("", {"host", "port"});
  EXPECT_FALSE(open_haply_session(find_haply_service(none, {.newer = port, .older = 1, .events = 0})).older_format);
  EXPECT_TRUE(open_haply_session(find_haply_service(none, {.newer = 1, .older = port, .events = 0})).older_format);
}

TEST_F(HaplyVersions, a_basis_a_preset_or_a_mount_of_another_program_is_refused_by_name) {
  mock::HaplyService::Behaviour behaviour = mock::HaplyService::of("3.5");
  behaviour.preset = "arm_front_centered";
  serve(behaviour);
  EXPECT_THAT(refusal(words()), HasSubstr("the preset arm_front_centered"));
  behaviour = mock::HaplyService::of("3.5");
  behaviour.mount_height = 0.05;
  serve(behaviour);
  EXPECT_THAT(refusal(words()), HasSubstr("a mount that is moved or turned"));
  behaviour = mock::HaplyService::of("3.2");
  behaviour.basis = "XZY";
  serve(behaviour);
  EXPECT_THAT(refusal(words()), HasSubstr("the basis XZY"));
}

TEST_F(HaplyVersions, a_basis_that_comes_with_the_introduction_is_refused_before_any_force) {
  mock::HaplyService::Behaviour behaviour = mock::HaplyService::of("3.5");
  behaviour.remembered_basis = "YXZ";
  serve(behaviour);
  EXPECT_THAT(refusal(words()), HasSubstr("the basis YXZ"));
  EXPECT_EQ(board_.force[0], 0.0);
}

TEST_F(HaplyVersions, the_event_channel_tells_of_the_brake_and_of_a_device_that_is_lost) {
  serve(mock::HaplyService::of("3.5"));
  DevicePort port(haply_driver(), "", words());
  port.start();
  const auto with = [](DeviceFault fault) { return [fault](const DeviceState& now) { return now.fault == fault; }; };
  rounds_until(port, with(DeviceFault::none));
  const std::string of_safety = R"({"name":"device-safety-triggered","category":"device","level":"error",)";
  service_->send_event("no JSON");
  service_->send_event(R"({"name":"device-disconnected","data":{},"message":"whichever"})");  // nobody's
  service_->send_event(of_safety +
                       R"("data":{"device_id":"FFFF","safety_type":"ebrake_triggered"},"message":"another"})");
  service_->send_event(of_safety +
                       R"("data":{"device_id":"04BA","safety_type":"ebrake_triggered"},"message":"E-brake on"})");
  rounds_until(port, with(DeviceFault::emergency_stop), Vec3(1, 0, 0));
  EXPECT_THAT(port.explain(), HasSubstr("E-brake on"));
  service_->send_event(of_safety + R"("data":{"device_id":"04BA","safety_type":"ebrake_released"},"message":"off"})");
  rounds_until(port, with(DeviceFault::none));
  service_->send_event(R"({"name":"device-disconnected","data":{"device_id":"04BA"},"message":"gone"})");
  rounds_until(port, with(DeviceFault::communication_lost));
  service_->send_event(R"({"name":"device-connected","data":{"device_id":"04BA"},"message":"back"})");
  rounds_until(port, with(DeviceFault::none));
}

TEST_F(HaplyVersions, a_transform_that_is_set_meanwhile_takes_the_force) {
  mock::HaplyService::Behaviour behaviour = mock::HaplyService::of("3.5");
  serve(behaviour);
  DevicePort port(haply_driver(), "", words());
  port.start();
  rounds_until(port, [](const DeviceState& now) { return now.fault == DeviceFault::none; });
  service_->oddity() = mock::Oddity::new_transform;
  rounds_until(
      port, [](const DeviceState& now) { return now.fault == DeviceFault::vendor_error; }, Vec3(1, 0, 0));
  EXPECT_THAT(port.explain(), HasSubstr("a transform"));
  service_->oddity() = mock::Oddity::none;
  rounds_until(port, [](const DeviceState& now) { return now.fault == DeviceFault::none; });
}

// As the vendor's own example of a remote configuration does, over HTTP, to whatever session runs.
TEST_F(HaplyVersions, a_basis_a_preset_or_a_mount_that_is_set_meanwhile_takes_the_force) {
  for (const mock::Oddity oddity : {mock::Oddity::new_basis, mock::Oddity::new_preset, mock::Oddity::new_mount}) {
    serve(mock::HaplyService::of("3.5"));
    DevicePort port(haply_driver(), "", words());
    port.start();
    const Vec3 force(1, 0, 0);
    rounds_until(
        port, [&](const DeviceState&) { return board_.force[0] == 1.0; }, force);
    service_->oddity() = oddity;
    rounds_until(
        port,
        [&](const DeviceState& now) { return now.fault == DeviceFault::vendor_error && board_.force[0] == 0.0; },
        force);  // the force of the round before may still be on its way to the service
    EXPECT_THAT(port.explain(), HasSubstr("a basis, a preset or a mount"));
    DeviceState state;
    for (int i = 0; i < 50; ++i) {  // and stays so, whatever the states without a configuration say
      port.exchange({force, Vec3::Zero()}, state);
      EXPECT_EQ(state.fault, DeviceFault::vendor_error);
      EXPECT_EQ(board_.force[0], 0.0);
    }
    service_->oddity() = mock::Oddity::none;
    rounds_until(port, [](const DeviceState& now) { return now.fault == DeviceFault::none; });
    port.stop();
  }
}

TEST(HaplyEvents, are_read_and_what_is_none_is_nothing) {
  const HaplyEvent brake = parse_haply_event(
      R"({"name":"device-safety-triggered","data":{"device_id":"049D","safety_type":"stall_detected"},"message":"m"})");
  EXPECT_EQ(brake.incident, HaplyIncident::reported);
  EXPECT_EQ(brake.device, "049D");
  EXPECT_EQ(brake.message, "m");
  for (const char* text : {"", "[]", "7", "{", R"({"name":7,"data":[]})", R"({"name":"device-battery-low"})"}) {
    EXPECT_EQ(parse_haply_event(text).incident, HaplyIncident::other) << text;
  }
}

}  // namespace
}  // namespace bodkin
