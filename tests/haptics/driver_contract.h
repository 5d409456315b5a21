#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "haptics/device_port.h"

namespace bodkin {

using namespace bodkin::haptics;

// A device that can be opened for one test, and what takes it away.
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
  // Of asking for what is there; none where it is found. A mouse is not there without a display.
  DeviceFault fault_of_listing = DeviceFault::none;
  // A device or software that is not there: how it is asked for, and what the refusal must say. Empty where nothing
  // can be missing.
  std::string absent_identity, absent_settings;
  std::vector<std::string> told_of_absent;
};

// GoogleTest finds it by the type's namespace; without it a failure shows bytes.
void PrintTo(const ContractSubject& subject, std::ostream* to);

// Those that this test program knows.
std::vector<ContractSubject> contract_subjects();

}  // namespace bodkin
