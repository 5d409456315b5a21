#pragma once

#include <memory>
#include <optional>
#include <string>

#include "station/second_hand.h"

#include "cli/device_options.h"

namespace bodkin {

// What the command line says of a second device.
struct SecondOptions {
  DeviceOptions device;
  std::string role;  // "" = plunger
};

// Adds --second, --second-as and --second-settings.
void add_second_options(CLI::App& command, SecondOptions& options);

struct ChosenSecond {
  ChosenDevice device;
  SecondRole role = SecondRole::plunger;
  std::string settings;
};

// None where there is no --second. Throws InputError for words about a second device that there is not, a role that
// is none, the device that is `first` already, and the mouse, whose window is the needle's.
std::optional<ChosenSecond> choose_second(const SecondOptions& options, const ChosenDevice& first);

// The second device, open, and what is known of it.
class OpenSecond {
 public:
  // `rate`: Hz of the case, for a device that leaves the loop to us. Throws as DevicePort does, and InputError when
  // it turns out to be `first` itself, which `first_device` is.
  OpenSecond(const ChosenSecond& chosen, const ChosenDevice& first, const DeviceAbilities& first_device,
             const NeedlePath& path, double rate, bool use_calibration);

  SecondHeader header() const;
  const std::string& calibrated_at() const noexcept { return calibration_.measured_at; }  // "": never
  bool has_force() const noexcept { return device_.peak_force > 0.0; }
  std::shared_ptr<SecondLink> link() const noexcept { return link_; }
  // Once only: the hand takes the device along. `pressed`: see SecondHand.
  std::unique_ptr<SecondHand> hand(std::shared_ptr<const Case> patient, std::shared_ptr<PressedPatient> pressed = {});

 private:
  ChosenSecond chosen_;
  DevicePort port_;
  DeviceAbilities device_;
  DeviceCalibration calibration_;
  ServoSettings settings_;
  std::shared_ptr<SecondLink> link_;
};

// What the terminal shows of it: "plunger 35.2 kPa 6.21 N", "probe 2.10 N".
std::string text_of(SecondRole role, const SecondSample& moment);

}  // namespace bodkin
