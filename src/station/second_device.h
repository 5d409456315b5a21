#pragma once

#include <memory>
#include <string>

#include "station/device_choice.h"
#include "station/second_hand.h"

#include "fem/moving/body_thread.h"
#include "haptics/stable_stiffness.h"

namespace bodkin::station {

struct SecondChoice {
  DeviceChoice device;
  session::SecondRole role = session::SecondRole::plunger;
};

// The opened second device, until its SecondHand takes it.
class SecondDevice {
 public:
  // `rate`: Hz of the case, for a device whose loop is ours. Throws as DevicePort does, and InputError when the
  // device turns out to be `first`, whose abilities are `first_device`.
  SecondDevice(const SecondChoice& choice, const DeviceChoice& first, const haptics::DeviceAbilities& first_device,
               const anatomy::NeedlePath& path, double rate, bool use_calibration);

  session::SecondHeader header() const;
  const std::string& calibrated_at() const noexcept { return calibration_.measured_at; }  // "": never
  bool has_force() const noexcept { return device_.peak_force > 0.0; }
  const std::shared_ptr<session::SecondLink>& link() const noexcept { return link_; }
  // The stiffness that the device may be asked to render; the hand from hand() requests no more.
  const haptics::StableStiffness& stiffness() const noexcept { return stiffness_; }
  const haptics::DeviceAbilities& abilities() const noexcept { return device_; }
  // N, largest force of the device from now on. Before hand().
  void limit_force(double most) noexcept { settings_.guard.user_force = most; }
  // To be called once: the hand takes the device. `body`: see SecondHand.
  std::unique_ptr<SecondHand> hand(std::shared_ptr<const anatomy::Case> patient,
                                   std::shared_ptr<fem::BodyThread> body);

 private:
  SecondChoice choice_;
  haptics::DevicePort port_;
  haptics::DeviceAbilities device_;
  haptics::DeviceCalibration calibration_;
  haptics::StableStiffness stiffness_;
  haptics::ServoSettings settings_;
  std::shared_ptr<session::SecondLink> link_;
};

}  // namespace bodkin::station
