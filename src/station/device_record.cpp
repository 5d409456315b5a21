#include "station/device_record.h"

#include <nlohmann/json.hpp>

#include "io/calibrations_file.h"

namespace bodkin::station {

std::string device_record(const StationOptions& options, const haptics::DeviceAbilities& device,
                          const haptics::StableStiffness& stiffness, const haptics::DeviceCalibration& calibration) {
  return nlohmann::ordered_json{
      {"device", device.name},
      {"driver", options.device.driver->name},
      {"identity", options.device.identity},
      {"settings", options.device.settings},
      {"scale", options.scale},
      {"force_scale", options.force_scale},
      {"delay_s", device.measured_delay.value_or(device.delay)},
      {"delay_source", device.measured_delay ? "measured" : device.delay_source},
      {"force_delay_s", stiffness.delay},
      {"stiffness_N_per_mm", stiffness.weakest()},
      {"stiffness_by_axis_N_per_mm", {stiffness.axis.x(), stiffness.axis.y(), stiffness.axis.z()}},
      {"published_stiffness_N_per_mm", stiffness.published},
      {"mannequin", mannequin_json(options.mannequin)},
      {"calibration", calibration.empty() ? "" : io::calibrations_xml({&calibration, 1})}}
      .dump();
}

bool moves_along_its_axis(const DeviceChoice& choice, const haptics::DeviceAbilities& device) {
  return device.peak_force == 0.0 && !choice.is_recorded() && !choice.is_mouse() && !choice.is_seen();
}

}  // namespace bodkin::station
