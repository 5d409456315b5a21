#include "cli/all_drivers.h"

#include "link/tracking_driver.h"
#include "station/recorded_hand.h"
#ifdef BODKIN_HAS_TRACKING
#include "tracking/tool_driver.h"
#endif
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.h"
#include "haptics/drivers/drivers.h"
#include "haptics/plugin.h"

namespace bodkin::cli {

std::vector<const bodkin_driver*> all_drivers() {
  std::vector<const bodkin_driver*> drivers(haptics::built_in_drivers().begin(), haptics::built_in_drivers().end());
  drivers.push_back(&link::tracking_driver());
#ifdef BODKIN_HAS_TRACKING
  drivers.push_back(&tracking::tool_driver());
#endif
  drivers.push_back(&station::recorded_driver());
  return drivers;
}

const bodkin_driver* find_own_driver(std::string_view name) {
  for (const bodkin_driver* driver : all_drivers()) {
    if (name == driver->name) return driver;
  }
  return nullptr;
}

const bodkin_driver& load_driver(const std::string& name) {
  if (name.find('/') != std::string::npos) return haptics::load_plugin(name);
  if (const bodkin_driver* driver = find_own_driver(name)) return *driver;
  std::vector<std::string> names;
  for (const bodkin_driver* driver : all_drivers()) names.emplace_back(driver->name);
  throw InputError(fmt::format("there is no driver '{}'; expected {}, or the path of a driver with a '/' in it", name,
                               fmt::join(names, ", ")));
}

}  // namespace bodkin::cli
