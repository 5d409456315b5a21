#include <cstddef>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "station/driver_inquiry.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/all_drivers.h"
#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/device_options.h"
#include "core/error.h"
#include "haptics/driver_folder.h"

namespace bodkin::cli {

namespace {

using station::DriverAnswer;

constexpr const char* devices_list_footer = R"(Examples:
  bodkin devices list                                          every driver, and the devices that it finds
  bodkin devices list --driver force_dimension --settings library=/opt/forcedimension/lib/libdrd.so
  bodkin devices list --driver ./my_driver.so                  a driver of your own

Drivers of your own are also found in the folder that BODKIN_DRIVERS names. Each driver is asked in its own
process, so that a driver that crashes or hangs only adds a line to the list. Nothing moves and no motor is energised.
docs/devices.md says what each driver needs.)";

// For each answer the sentence about its name, empty if the name is unambiguous.
std::vector<std::string> clashes(const std::vector<DriverAnswer>& answers) {
  std::vector<std::string> sentences(answers.size());
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (answers[i].driver.find('/') == std::string::npos || answers[i].name.empty()) continue;
    for (std::size_t other = 0; other < answers.size(); ++other) {
      if (other == i || answers[other].name != answers[i].name) continue;
      sentences[i] = fmt::format("{} has the same name: say {} instead of {}, or remove one of the two",
                                 answers[other].driver, answers[i].driver, answers[i].name);
    }
  }
  return sentences;
}

// Devices found with an identity that another one has too.
std::string twins(const DriverAnswer& answer) {
  std::set<std::string> seen;
  for (const haptics::FoundDevice& device : answer.devices) {
    if (seen.insert(device.identity).second) continue;
    return fmt::format("two devices have the identity '{}': unplug one of them, because only the first can be chosen",
                       device.identity);
  }
  return "";
}

void print_answer(const Console& console, const DriverAnswer& answer, const std::string& call,
                  const std::string& clash) {
  console.line(fmt::format("{:<16} {}", answer.name.empty() ? answer.driver : answer.name, answer.summary));
  for (const haptics::FoundDevice& device : answer.devices) {
    console.line(fmt::format("    {}:{}   {}", call, device.identity, device.title));
  }
  if (answer.fault != haptics::DeviceFault::none) {
    console.line(fmt::format("    {}: {}", haptics::text_of(answer.fault), answer.sentence));
  } else if (answer.devices.empty()) {
    console.line("    no device is connected");
  }
  for (const std::string& sentence : {clash, twins(answer)}) {
    if (!sentence.empty()) console.line("    " + sentence);
  }
}

nlohmann::ordered_json json_of(const DriverAnswer& answer, const std::string& call, const std::string& clash) {
  nlohmann::ordered_json json = {{"driver", answer.name.empty() ? answer.driver : answer.name},
                                 {"summary", answer.summary},
                                 {"devices", nlohmann::ordered_json::array()}};
  if (answer.driver.find('/') != std::string::npos) json["file"] = answer.driver;
  for (const haptics::FoundDevice& device : answer.devices) {
    json["devices"].push_back({{"device", fmt::format("{}:{}", call, device.identity)}, {"title", device.title}});
  }
  if (answer.fault != haptics::DeviceFault::none) {
    json["fault"] = haptics::text_of(answer.fault);
    json["sentence"] = answer.sentence;
  }
  for (const std::string& sentence : {clash, twins(answer)}) {
    if (!sentence.empty()) json["ambiguous"].push_back(sentence);
  }
  return json;
}

// Every driver supplied with Bodkin and every one in the folder, or the requested one.
std::vector<std::string> drivers_of(const DeviceOptions& options) {
  if (!options.device.empty()) return {driver_of(options)};
  std::vector<std::string> drivers;
  for (const bodkin_driver* driver : all_drivers()) drivers.emplace_back(driver->name);
  for (const std::string& file : haptics::driver_files()) drivers.push_back(file);
  return drivers;
}

void run_devices_list(const DeviceOptions& options, const CommandContext& context) {
  const Console console(context);
  std::vector<DriverAnswer> answers;
  for (const std::string& driver : drivers_of(options)) {
    answers.push_back(station::ask_driver(driver, options.settings, station::Inquiry::devices));
  }
  if (!options.device.empty() && answers.front().name.empty()) throw SystemError(answers.front().sentence);
  const std::vector<std::string> clash = clashes(answers);
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const bool by_path = !clash[i].empty() || !options.device.empty();
    const std::string& call = by_path ? answers[i].driver : answers[i].name;
    print_answer(console, answers[i], call, clash[i]);
    json.push_back(json_of(answers[i], call, clash[i]));
  }
  console.line("\nNext: bodkin devices check DRIVER:DEVICE");
  console.json(json.dump(2));
}

}  // namespace

void add_devices_list_command(CLI::App& devices_group, CommandContext& context) {
  add_command(devices_group, "list", "Every driver, and the devices that it finds", devices_list_footer,
              [&context](CLI::App& command) {
                auto options = std::make_shared<DeviceOptions>();
                add_text(
                    command, "--driver", options->device,
                    "Ask only this driver (default: all that come with Bodkin, and those in the folder of drivers)");
                add_driver_settings(command, *options);
                on_run(command, [options, &context] { run_devices_list(*options, context); });
              });
}

}  // namespace bodkin::cli
