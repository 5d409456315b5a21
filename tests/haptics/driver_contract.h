#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "haptics/device_port.h"

namespace bodkin {

using namespace bodkin::haptics;

// A device that can be opened for one test, and a way to remove it.
struct ContractScene {
  std::string identity;
  std::string settings;
  bool ends = true;                                            // false: nothing can take it away
  std::function<void()> end;                                   // takes it away; empty: it ends by itself
  DeviceFault fault_at_end = DeviceFault::communication_lost;  // none: the hand ends the session in good order
  std::function<void()> leave;                                 // after the test, when the device is closed
};

// A driver under the contract that every driver keeps, with a force or without (docs/devices.md).
struct ContractSubject {
  std::string name;
  const bodkin_driver* driver = nullptr;
  std::function<ContractScene()> arrange;
  bool renders_force = false;
  // Obstacle to listing devices; empty if the device is found. Without a display there is no mouse.
  DeviceFault fault_of_listing = DeviceFault::none;
  // A missing device or software: its settings, and the required text of the refusal. Empty if nothing can be
  // missing.
  std::string absent_identity, absent_settings;
  std::vector<std::string> absent_message;
};

// Found by GoogleTest through the type's namespace; otherwise a failure shows bytes.
void PrintTo(const ContractSubject& subject, std::ostream* to);

// The drivers of this test program.
std::vector<ContractSubject> contract_subjects();

}  // namespace bodkin
