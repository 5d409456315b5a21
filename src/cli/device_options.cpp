#include "cli/device_options.h"

#include <vector>

#include "station/driver_inquiry.h"
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/all_drivers.h"
#include "cli/arguments.h"
#include "core/error.h"
#include "haptics/driver_folder.h"

namespace bodkin::cli {

void add_driver_settings(CLI::App& command, DeviceOptions& options) {
  add_text(command, "--settings", options.settings,
           "Settings of the driver, \"KEY=VALUE ...\", such as library=/opt/sdk/libdrd.so");
}

namespace {

// The library in the driver folder whose driver has that name.
std::string file_of_driver(const std::string& name) {
  std::vector<std::string> names, files;
  for (const bodkin_driver* driver : all_drivers()) names.emplace_back(driver->name);
  for (const std::string& file : haptics::driver_files()) {
    const station::DriverAnswer answer = station::ask_driver(file, "", station::Inquiry::name);
    if (answer.name == name) files.push_back(file);
    if (!answer.name.empty()) names.push_back(answer.name);
  }
  if (files.size() == 1) return files.front();
  if (files.empty()) {
    throw InputError(fmt::format("there is no driver '{}'; expected {}, or the path of a driver with a '/' in it",
                                 name, fmt::join(names, ", ")));
  }
  throw InputError(fmt::format("{} drivers are called '{}'; name one by its path: {}", files.size(), name,
                               fmt::join(files, ", ")));
}

}  // namespace

bool is_mouse(const DeviceOptions& options) {
  return options.device == "mouse";
}

std::string driver_of(const DeviceOptions& options) {
  const std::string name = options.device.substr(0, options.device.find(':'));
  if (is_mouse(options)) {
    throw InputError(
        "the mouse can hold a needle only in the window; use 'bodkin perform CASE mouse' or 'bodkin app'");
  }
  return name.find('/') != std::string::npos || find_own_driver(name) != nullptr ? name : file_of_driver(name);
}

station::DeviceChoice choose_device(const DeviceOptions& options) {
  const std::size_t colon = options.device.find(':');
  const std::string identity = colon == std::string::npos ? "" : options.device.substr(colon + 1);
  return {&load_driver(driver_of(options)), identity, options.settings};
}

}  // namespace bodkin::cli
