// A state message from any program at the port: refused, or finite numbers. The same bytes as an inventory.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "haptics/drivers/driver_adapter.h"
#include "haptics/drivers/haply_inventory.h"
#include "haptics/drivers/haply_messages.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static bodkin::haptics::HaplyStateReader reader("04BA", "61576");
  bodkin::haptics::HaplyReading reading;
  const std::size_t fits = std::min(size, reader.buffer().size());
  std::copy_n(data, fits, reader.buffer().begin());
  if (reader.read(fits, reading)) {
    const bool finite = reading.position.allFinite() && reading.velocity.allFinite() &&
                        std::all_of(reading.rotation.begin(), reading.rotation.end(),
                                    [](double component) { return std::isfinite(component); });
    if (!finite || reading.buttons > 15 || (reading.has_position && !reading.device_listed)) std::abort();
  }
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    for (const bodkin::haptics::HaplyInverse& device : bodkin::haptics::parse_haply_inventory(text).devices) {
      if (device.identity.empty() || device.identity.find('"') != std::string::npos) std::abort();
    }
  } catch (const bodkin::haptics::DriverFailure&) {
  }
  try {
    bodkin::haptics::parse_haply_version(text);
  } catch (const bodkin::haptics::DriverFailure&) {
  }
  return 0;
}
