#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "haptics/bodkin_driver.h"
#include "haptics/device.h"
#include "haptics/device_port.h"

namespace bodkin::station {

// Asks a driver for its identity and its devices, in a child process: a vendor's library may crash when it is loaded,
// or never return, and must not take this program with it. The child is the program `bodkin`.

// A driver's answer, or the reason why there is none.
struct DriverAnswer {
  std::string driver;  // as requested: a built-in driver's name, or the path of a library
  std::string name;    // its own name; empty if it could not be loaded
  std::string summary;
  std::vector<haptics::FoundDevice> devices;
  haptics::DeviceFault fault = haptics::DeviceFault::none;
  std::string sentence;  // if there is a fault, or no answer
};

enum class Inquiry {
  name,    // only its identity
  devices  // also its devices
};

// `driver`: the name of a built-in driver or the path of a library. For a driver that crashes or does not respond for
// eight seconds the answer is a vendor error and a sentence that says what to do. Throws InputError for settings that
// it does not accept. `program`: the child, which answers by answer_driver_inquiry(); empty: this program again.
DriverAnswer ask_driver(const std::string& driver, const std::string& settings, Inquiry inquiry,
                        const std::filesystem::path& program = {});

// The child's side: the argument that main() recognises, and the function that it then calls instead of anything
// else.
constexpr const char* driver_inquiry_argument = "answer-driver-inquiry";
// `load`: the driver of a name or of a path; throws InputError and SystemError.
int answer_driver_inquiry(const std::function<const bodkin_driver&(const std::string&)>& load);

}  // namespace bodkin::station
