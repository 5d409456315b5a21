#pragma once

#include <memory>
#include <string>

#include "station/device_choice.h"
#include "station/second_hand.h"

namespace bodkin {

struct SecondChoice {
  DeviceChoice device;
  SecondRole role = SecondRole::plunger;
};

// The opened second device, until its SecondHand takes it.
class SecondDevice {
 public:
  // `rate`: Hz of the case, for a device whose loop is ours. Throws as DevicePort does, and InputError when the
  // device turns out to be `first`, whose abilities are `first_device`.
  SecondDevice(const SecondChoice& choice, const DeviceChoice& first, const DeviceAbilities& first_device,
               const NeedlePath& path, double rate, bool use_calibration);

  SecondHeader header() const;
  const std::string& calibrated_at() const noexcept { return calibration_.measured_at; }  // "": never
  bool has_force() const noexcept { return device_.peak_force > 0.0; }
  const std::shared_ptr<SecondLink>& link() const noexcept { return link_; }
  // To be called once: the hand takes the device. `body`: see SecondHand.
  std::unique_ptr<SecondHand> hand(std::shared_ptr<const Case> patient, std::shared_ptr<PatientBody> body);

 private:
  SecondChoice choice_;
  DevicePort port_;
  DeviceAbilities device_;
  DeviceCalibration calibration_;
  ServoSettings settings_;
  std::shared_ptr<SecondLink> link_;
};

}  // namespace bodkin
