#include "haptics/drivers/drivers.h"

#include "haptics/drivers/force_dimension.h"
#include "haptics/drivers/haply.h"
#include "haptics/drivers/haption.h"
#include "haptics/drivers/openhaptics.h"
#include "haptics/drivers/simulated.h"
#include "haptics/drivers/spacemouse.h"

namespace bodkin::haptics {

std::span<const bodkin_driver* const> built_in_drivers() noexcept {
  static const bodkin_driver* const all[] = {&openhaptics_driver(), &force_dimension_driver(), &haption_driver(),
                                             &haply_driver(),       &spacemouse_driver(),      &simulated_driver()};
  return all;
}

const bodkin_driver* find_driver(std::string_view name) noexcept {
  for (const bodkin_driver* driver : built_in_drivers()) {
    if (name == driver->name) return driver;
  }
  return nullptr;
}

}  // namespace bodkin::haptics
