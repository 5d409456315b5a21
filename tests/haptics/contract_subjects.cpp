// The built-in drivers, and the plug-in of the documentation, under driver_contract.cpp.
#include <memory>

#include "tests/haptics/driver_contract.h"
#include "tests/haptics/driver_rig.h"
#include "tests/haptics/spnav_server.h"

#include "haptics/drivers/simulated.h"
#include "haptics/drivers/spacemouse.h"
#include "haptics/plugin.h"

namespace bodkin {

using namespace bodkin::haptics;

namespace {

// A device with motors, behind the mock of its vendor's software.
ContractSubject on_mock(const DriverSubject& device) {
  const auto arrange = [&device] {
    device.board().clear();
    for (int i = 0; i < 3; ++i) device.board().hand[static_cast<std::size_t>(i)] = device.origin_vendor[i];
    return ContractScene{.settings = device.words(),
                         .end = [&device] { device.board().trouble = mock::Trouble::unplug; },
                         .leave = [&device] { device.board().clear(); }};
  };
  return {.name = device.name,
          .driver = device.driver,
          .arrange = arrange,
          .renders_force = true,
          .absent_settings = device.absent,
          .absent_message = device.absent_message};
}

ContractSubject spacemouse() {
  const auto arrange = [] {
    const auto daemon = std::make_shared<mock::SpnavServer>();
    return ContractScene{.settings = "socket=" + daemon->path(), .end = [daemon] { daemon->close_all(); }};
  };
  return {.name = "spacemouse",
          .driver = &spacemouse_driver(),
          .arrange = arrange,
          .absent_settings = "socket=/nowhere/spnav.sock",
          .absent_message = {"/nowhere/spnav.sock", "start spacenavd"}};
}

ContractSubject simulated() {
  const auto arrange = [] {
    return ContractScene{.settings = "speed_mm_s=100 depth_mm=0 wait_s=0", .fault_at_end = DeviceFault::none};
  };
  return {.name = "simulated", .driver = &simulated_driver(), .arrange = arrange, .renders_force = true};
}

ContractSubject plug_in() {
  static const bodkin_driver& driver = load_plugin(BODKIN_MOCKS "/plug_in/example_driver.so");
  const auto arrange = [] { return ContractScene{.ends = false}; };
  return {.name = "plug_in",
          .driver = &driver,
          .arrange = arrange,
          .renders_force = true,
          .absent_identity = "7",
          .absent_message = {"there is no device '7'"}};
}

}  // namespace

std::vector<ContractSubject> contract_subjects() {
  std::vector<ContractSubject> subjects;
  for (const DriverSubject& device : driver_subjects()) subjects.push_back(on_mock(device));
  subjects.insert(subjects.end(), {spacemouse(), simulated(), plug_in()});
  return subjects;
}

}  // namespace bodkin
