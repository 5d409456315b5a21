#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "desktop/keys.h"

#include "cli/console.h"
#include "haptics/device_calibration.h"
#include "haptics/device_servo.h"
#include "haptics/weighing.h"

namespace bodkin::cli {

// What `bodkin devices calibrate` measures, in this order.
enum class CalibrationStep { workspace, mounting, tip, axis, weight };

// "workspace"
std::string_view name_of(CalibrationStep step);
// Throws InputError for a name that no step has.
CalibrationStep calibration_step(const std::string& name);
// The steps that a device allows: tip and axis need rotation, the weight needs force.
std::vector<CalibrationStep> steps_for(const haptics::DeviceAbilities& device);

struct CalibrationSettings {
  double seconds = 15.0;   // for the motions of a step
  double countdown = 3.0;  // s before a step where no key can be pressed
};

// Leads a person through the steps with an open device, and keeps what they came to.
class CalibrationSteps {
 public:
  // The servo runs; its controller is `weighing`.
  CalibrationSteps(haptics::DeviceServo& servo, haptics::Weighing& weighing, const CalibrationSettings& settings,
                   Console& console);

  // Says what to do, waits for the Enter key or the countdown, measures. Throws InputError where the readings do not
  // do, and SystemError when the device fails.
  void perform(CalibrationStep step, haptics::DeviceCalibration& measured);

 private:
  void wait_for_a_person();
  std::vector<Pose> watch(double seconds, std::string_view stage, bool may_end_early);
  double carried_force(double above, std::string_view stage);
  void weigh(haptics::DeviceCalibration& measured);
  void require_sound();

  haptics::DeviceServo& servo_;
  haptics::Weighing& weighing_;
  CalibrationSettings settings_;
  Console& console_;
  desktop::Keys keys_;
};

}  // namespace bodkin::cli
