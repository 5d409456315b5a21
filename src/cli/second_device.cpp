#include "cli/second_device.h"

#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "core/error.h"
#include "haptics/calibration.h"
#include "io/calibrations_file.h"

namespace bodkin {

void add_second_options(CLI::App& command, SecondOptions& options) {
  add_text(command, "--second", options.device.device,
           "A second device, for the other hand: DRIVER or DRIVER:IDENTITY");
  add_text(command, "--second-as", options.role, "What it holds: plunger (of the syringe, the default) or probe");
  add_text(command, "--second-settings", options.device.settings, "Settings of its driver, \"KEY=VALUE ...\"");
}

std::optional<ChosenSecond> choose_second(const SecondOptions& options, const ChosenDevice& first) {
  if (options.device.device.empty()) {
    for (const auto& [option, text] :
         {std::pair("--second-as", &options.role), std::pair("--second-settings", &options.device.settings)}) {
      if (text->empty()) continue;
      throw InputError(
          fmt::format("{} is '{}', but there is no second device; name it with --second DEVICE", option, *text));
    }
    return std::nullopt;
  }
  ChosenSecond chosen;
  const std::optional<SecondRole> role = second_role(options.role.empty() ? "plunger" : options.role);
  if (!role) throw InputError(fmt::format("--second-as is '{}'; expected plunger or probe", options.role));
  chosen.role = *role;
  chosen.device = choose_device(options.device);
  chosen.settings = options.device.settings;
  if (chosen.device.is_mouse()) {
    throw InputError("--second is the mouse, whose window is the needle's; name the mouse as DEVICE");
  }
  const bool same = chosen.device.driver == first.driver && chosen.device.identity == first.identity;
  if (same && !first.is_simulated()) {
    throw InputError(
        fmt::format("--second is '{}', the device that holds the needle; expected another one, as DRIVER:IDENTITY "
                    "where both are of one driver",
                    options.device.device));
  }
  return chosen;
}

OpenSecond::OpenSecond(const ChosenSecond& chosen, const ChosenDevice& first, const DeviceAbilities& first_device,
                       const NeedlePath& path, double rate, bool use_calibration)
    : chosen_(chosen),
      port_(*chosen.device.driver, chosen.device.identity, chosen.settings),
      device_(port_.abilities()),
      link_(std::make_shared<SecondLink>()) {
  const bool one_driver = chosen.device.driver == first.driver;
  if (one_driver && !device_.serial.empty() && device_.serial == first_device.serial) {
    throw InputError(fmt::format("--second is the device that holds the needle (serial number {}); expected another",
                                 device_.serial));
  }
  complete_from_table(device_);
  if (use_calibration) calibration_ = calibration_of(chosen.device, device_);
  apply(calibration_, device_);
  // The loops do not wait for each other, so each device may keep its own rate.
  const bool keeps_its_rate = device_.owns_loop || chosen.device.is_simulated() || chosen.device.is_recorded();
  settings_.rate = keeps_its_rate ? device_.rate : rate;
  settings_.workspace = second_workspace(chosen.role, path);
  apply(calibration_, settings_);
}

SecondHeader OpenSecond::header() const {
  return {chosen_.role,
          nlohmann::ordered_json{{"device", device_.name},
                                 {"driver", chosen_.device.driver->name},
                                 {"identity", chosen_.device.identity},
                                 {"settings", chosen_.settings},
                                 {"rate_Hz", settings_.rate},
                                 {"calibration", calibration_.empty() ? "" : calibrations_xml({&calibration_, 1})}}
              .dump()};
}

std::unique_ptr<SecondHand> OpenSecond::hand(std::shared_ptr<const Case> patient,
                                             std::shared_ptr<PressedPatient> pressed) {
  return std::make_unique<SecondHand>(chosen_.role, std::move(port_), device_, settings_, std::move(patient), link_,
                                      std::move(pressed));
}

std::string text_of(SecondRole role, const SecondSample& moment) {
  if (role == SecondRole::probe) return fmt::format("probe {:5.2f} N", moment.force);
  return fmt::format("plunger {:5.1f} kPa {:5.2f} N", 1000.0 * moment.pressure, moment.force);
}

}  // namespace bodkin
