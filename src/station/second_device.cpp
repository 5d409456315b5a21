#include "station/second_device.h"

#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "haptics/calibration.h"
#include "io/calibrations_file.h"

namespace bodkin::station {

SecondDevice::SecondDevice(const SecondChoice& choice, const DeviceChoice& first,
                           const haptics::DeviceAbilities& first_device, const anatomy::NeedlePath& path, double rate,
                           bool use_calibration)
    : choice_(choice),
      port_(*choice.device.driver, choice.device.identity,
            settings_about(second_workspace(choice.role, path).centre, path, choice.device)),
      device_(port_.abilities()),
      link_(std::make_shared<session::SecondLink>()) {
  const bool one_driver = choice.device.driver == first.driver;
  if (one_driver && !device_.serial.empty() && device_.serial == first_device.serial) {
    throw InputError(fmt::format("--second is the device that holds the needle (serial number {}); expected another",
                                 device_.serial));
  }
  complete_from_table(device_);
  if (use_calibration) calibration_ = calibration_of(choice.device, device_);
  haptics::apply(calibration_, device_);
  // The loops do not wait for each other, so each device keeps its own rate.
  const bool keeps_its_rate =
      device_.owns_loop || choice.device.is_simulated() || choice.device.is_recorded() || choice.device.is_tracked();
  settings_.rate = keeps_its_rate ? device_.rate : rate;
  stiffness_ = haptics::stable_stiffness(device_, settings_.rate, calibration_.friction);
  device_.stiffness = stiffness_.weakest();
  settings_.workspace = second_workspace(choice.role, path);
  haptics::apply(calibration_, settings_);
}

session::SecondHeader SecondDevice::header() const {
  return {choice_.role, nlohmann::ordered_json{{"device", device_.name},
                                               {"driver", choice_.device.driver->name},
                                               {"identity", choice_.device.identity},
                                               {"settings", choice_.device.settings},
                                               {"rate_Hz", settings_.rate},
                                               {"calibration",
                                                calibration_.empty() ? "" : io::calibrations_xml({&calibration_, 1})}}
                            .dump()};
}

std::unique_ptr<SecondHand> SecondDevice::hand(std::shared_ptr<const anatomy::Case> patient,
                                               std::shared_ptr<fem::BodyThread> body) {
  return std::make_unique<SecondHand>(choice_.role, std::move(port_), device_, settings_, std::move(patient), link_,
                                      std::move(body));
}

}  // namespace bodkin::station
