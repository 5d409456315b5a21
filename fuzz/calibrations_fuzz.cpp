// Untrusted calibrations: any bytes are either refused with a sentence, or give calibrations that a servo can use and
// that are written as read.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/error.h"
#include "haptics/calibration.h"
#include "io/calibrations_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view document(reinterpret_cast<const char*>(data), size);
  std::vector<bodkin::haptics::DeviceCalibration> found;
  try {
    found = bodkin::io::parse_calibrations(document, "calibrations.xml");
  } catch (const bodkin::InputError&) {
    return 0;
  }
  for (const bodkin::haptics::DeviceCalibration& calibration : found) {
    bodkin::haptics::ServoSettings settings;
    bodkin::haptics::apply(calibration, settings);
    bodkin::haptics::ServoTick(settings,
                               [](const bodkin::haptics::ControlInput&) { return bodkin::haptics::Control{}; });
  }
  if (bodkin::io::parse_calibrations(bodkin::io::calibrations_xml(found), "again").size() != found.size())
    std::abort();
  return 0;
}
