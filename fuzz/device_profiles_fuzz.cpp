// An untrusted table of devices: refused with a sentence, or possible limits of a device.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/error.h"
#include "io/device_profiles_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const std::string text(reinterpret_cast<const char*>(data), size);
    for (const bodkin::haptics::DeviceProfile& profile : bodkin::io::parse_device_profiles(text, "devices.csv")) {
      if (profile.name.empty()) std::abort();
      for (const bodkin::haptics::ProfileValue& value : profile.values) {
        if (!std::isfinite(value.value) || value.value < 0.0) std::abort();
      }
    }
  } catch (const bodkin::InputError&) {
  }
  return 0;
}
