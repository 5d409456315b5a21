// Calibrations from anybody: any bytes are either refused with a sentence, or calibrations that a servo can be made
// with and that are written as they were read.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/error.h"
#include "haptics/calibration.h"
#include "io/calibrations_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view document(reinterpret_cast<const char*>(data), size);
  std::vector<bodkin::DeviceCalibration> found;
  try {
    found = bodkin::parse_calibrations(document, "calibrations.xml");
  } catch (const bodkin::InputError&) {
    return 0;
  }
  for (const bodkin::DeviceCalibration& calibration : found) {
    bodkin::ServoSettings settings;
    bodkin::apply(calibration, settings);
    bodkin::ServoTick(settings, [](const bodkin::ControlInput&) { return bodkin::Control{}; });
  }
  if (bodkin::parse_calibrations(bodkin::calibrations_xml(found), "again").size() != found.size()) std::abort();
  return 0;
}
