#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "haptics/bodkin_driver.h"
#include "haptics/device.h"
#include "haptics/device_port.h"

namespace bodkin::station {

// Asking a driver what it is and what it finds, in a child process: a vendor's library may crash when it is loaded,
// or never return, and must not take this program with it. The child is the program `bodkin`.

// What a driver answered, or what became of it instead.
struct DriverAnswer {
  std::string driver;  // as it was asked for: a built-in driver's name, or the path of a library
  std::string name;    // its own; empty where it could not be loaded
  std::string summary;
  std::vector<haptics::FoundDevice> devices;
  haptics::DeviceFault fault = haptics::DeviceFault::none;
  std::string sentence;  // where there is a fault, or no answer
};

enum class Inquiry {
  name,    // only who it is
  devices  // what it finds, too
};

// `driver`: the name of a built-in driver or the path of a library. A driver that crashes or is silent for eight
// seconds answers with a vendor error and a sentence that says what to do. Throws InputError for settings that it
// does not take. `program`: the child, which answers by answer_driver_inquiry(); empty: this program again.
DriverAnswer ask_driver(const std::string& driver, const std::string& settings, Inquiry inquiry,
                        const std::filesystem::path& program = {});

// The child's side: the argument that main() recognises, and what it then does instead of anything else.
constexpr const char* driver_inquiry_argument = "answer-driver-inquiry";
// `load`: the driver of a name or of a path; throws InputError and SystemError.
int answer_driver_inquiry(const std::function<const bodkin_driver&(const std::string&)>& load);

}  // namespace bodkin::station
