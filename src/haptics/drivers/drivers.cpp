#include "haptics/drivers/drivers.h"

#include "core/error.h"
#include "haptics/drivers/force_dimension.h"
#include "haptics/drivers/haption.h"
#include "haptics/drivers/openhaptics.h"
#include "haptics/drivers/spacemouse.h"
#include "haptics/plugin.h"

namespace bodkin {

std::span<const bodkin_driver* const> built_in_drivers() noexcept {
  static const bodkin_driver* const all[] = {&openhaptics_driver(), &force_dimension_driver(), &haption_driver(),
                                             &spacemouse_driver()};
  return all;
}

const bodkin_driver* find_driver(std::string_view name) noexcept {
  for (const bodkin_driver* driver : built_in_drivers()) {
    if (name == driver->name) return driver;
  }
  return nullptr;
}

const bodkin_driver& driver_named(const std::string& name) {
  if (name.find('/') != std::string::npos) return load_plugin(name);
  if (const bodkin_driver* driver = find_driver(name)) return *driver;
  std::string names;
  for (const bodkin_driver* driver : built_in_drivers()) names += std::string(driver->name) + ", ";
  throw InputError("there is no driver '" + name + "', expected " + names + "or the path of a driver's library");
}

}  // namespace bodkin
