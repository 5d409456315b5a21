#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/device_options.h"
#include "haptics/device_port.h"
#include "haptics/drivers/drivers.h"

namespace bodkin {

namespace {

constexpr std::chrono::seconds patience{5};

constexpr const char* footer = R"(Examples:
  bodkin devices list                                          every driver, and the devices that it finds
  bodkin devices list --driver force_dimension --settings library=/opt/forcedimension/lib/libdrd.so
  bodkin devices list --driver ./my_driver.so                  a driver of your own

Nothing moves and nothing is energised. docs/devices.md says what each driver needs.)";

// What a driver answered.
struct Found {
  const bodkin_driver* driver;
  std::vector<FoundDevice> devices;
  DeviceFault fault = DeviceFault::none;
  std::string sentence;  // where there is a fault
};

Found ask(const bodkin_driver& driver, const std::string& settings) {
  Found found{&driver, {}, DeviceFault::none, ""};
  try {
    found.devices = list_devices(driver, settings, patience);
  } catch (const DeviceError& error) {
    found.fault = error.fault();
    found.sentence = error.what();
  }
  return found;
}

void say(const Console& console, const Found& found) {
  console.line(fmt::format("{:<16} {}", found.driver->name, found.driver->summary));
  for (const FoundDevice& device : found.devices) {
    console.line(fmt::format("    {}:{}   {}", found.driver->name, device.identity, device.title));
  }
  if (found.fault != DeviceFault::none) {
    console.line(fmt::format("    {}: {}", text_of(found.fault), found.sentence));
  } else if (found.devices.empty()) {
    console.line("    no device is connected");
  }
}

nlohmann::ordered_json json_of(const Found& found) {
  nlohmann::ordered_json json = {{"driver", found.driver->name},
                                 {"summary", found.driver->summary},
                                 {"devices", nlohmann::ordered_json::array()}};
  for (const FoundDevice& device : found.devices) {
    json["devices"].push_back(
        {{"device", fmt::format("{}:{}", found.driver->name, device.identity)}, {"title", device.title}});
  }
  if (found.fault != DeviceFault::none) {
    json["fault"] = text_of(found.fault);
    json["sentence"] = found.sentence;
  }
  return json;
}

void run(const DeviceOptions& options, const CommandContext& context) {
  const Console console(context);
  std::vector<const bodkin_driver*> drivers(built_in_drivers().begin(), built_in_drivers().end());
  if (!options.device.empty()) drivers = {choose_device(options).driver};
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const bodkin_driver* driver : drivers) {
    const Found found = ask(*driver, options.settings);
    say(console, found);
    json.push_back(json_of(found));
  }
  console.line("\nNext: bodkin devices check DRIVER:DEVICE");
  console.json(json.dump(2));
}

}  // namespace

void add_devices_list_command(CLI::App& devices_group, CommandContext& context) {
  auto options = std::make_shared<DeviceOptions>();
  CLI::App* command = add_command(devices_group, "list", "Every driver, and the devices that it finds", footer);
  add_text(*command, "--driver", options->device, "Ask this driver only (default: all that come with Bodkin)");
  add_driver_settings(*command, *options);
  on_run(*command, [options, &context] { run(*options, context); });
}

}  // namespace bodkin
