#include "cli/device_options.h"

#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/arguments.h"
#include "core/error.h"
#include "haptics/device_profiles.h"
#include "haptics/drivers/drivers.h"
#include "haptics/plugin.h"
#include "io/device_profiles_file.h"

namespace bodkin {

void add_driver_settings(CLI::App& command, DeviceOptions& options) {
  add_text(command, "--settings", options.settings,
           "Settings of the driver, \"KEY=VALUE ...\", such as library=/opt/sdk/libdrd.so");
}

ChosenDevice choose_device(const DeviceOptions& options) {
  const std::size_t colon = options.device.find(':');
  const std::string name = options.device.substr(0, colon);
  const std::string identity = colon == std::string::npos ? "" : options.device.substr(colon + 1);
  if (name.find('/') != std::string::npos) return {&load_plugin(name), identity};
  if (const bodkin_driver* driver = find_driver(name)) return {driver, identity};
  std::vector<std::string> names;
  for (const bodkin_driver* driver : built_in_drivers()) names.emplace_back(driver->name);
  throw InputError(fmt::format("there is no driver '{}'; expected {}, or the path of a driver with a '/' in it", name,
                               fmt::join(names, ", ")));
}

void complete_from_table(DeviceAbilities& abilities) {
  const auto profiles = default_device_profiles();
  if (const DeviceProfile* profile = find_profile(profiles, abilities.name)) complete(abilities, *profile);
}

}  // namespace bodkin
