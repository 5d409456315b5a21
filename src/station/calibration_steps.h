#pragma once

#include <exception>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/progress.h"
#include "haptics/calibration.h"
#include "haptics/calibration_controller.h"
#include "haptics/device_calibration.h"
#include "haptics/device_servo.h"

namespace bodkin::station {

// The measurements of `bodkin devices calibrate`, in this order.
enum class CalibrationStep { workspace, mounting, tip, axis, weight, delay };

// "workspace"
std::string_view name_of(CalibrationStep step);
// Throws InputError for an unknown name.
CalibrationStep calibration_step(const std::string& name);
// Instruction for the person, one or two sentences.
std::string_view task_of(CalibrationStep step);
// The steps that a device allows: tip and axis need rotation, weight and delay need force.
std::vector<CalibrationStep> steps_for(const haptics::DeviceAbilities& device);

struct CalibrationSettings {
  double seconds = 15.0;   // for the motions of a step
  double countdown = 3.0;  // s before a step if no one can say "go on"
};

// Thrown when the person gives up. It is not an error, so no error handler catches it.
struct CalibrationCancelled : std::exception {
  const char* what() const noexcept override { return "the calibration was given up"; }
};

// Communication between the steps and the person. Called on the thread that performs them.
struct CalibrationPerson {
  std::function<void(const std::string& sentence)> report;
  // Whether the person has said "go on" since the last call: begin the step, or end it. Empty: not possible; each
  // step begins after the countdown.
  std::function<bool()> confirmed;
  std::function<bool()> cancelled;          // asked every 10 ms; empty: never
  Progress progress;                        // may be empty
  std::function<void()> after_measurement;  // called after a long measurement; may be empty
};

// Guides a person through the steps with an open device, and stores the results.
class CalibrationSteps {
 public:
  // The servo must run with `controller`.
  CalibrationSteps(haptics::DeviceServo& servo, haptics::CalibrationController& controller,
                   const CalibrationSettings& settings, CalibrationPerson person);

  // Gives instructions, waits for the person or the countdown, measures. Throws InputError if the readings are
  // unsuitable, SystemError when the device fails, and CalibrationCancelled.
  void perform(CalibrationStep step, haptics::DeviceCalibration& measured);
  // Asks for the tip to be put on the point of that name, waits for the person or the countdown, and returns its
  // position. Asks again, up to twice, if the tip does not stay there. `tip_offset`: as in
  // haptics::DeviceCalibration. Throws as perform() does.
  haptics::TouchFit touch(const std::string& name, const Vec3& tip_offset);

 private:
  void wait_for_confirmation();
  std::vector<Pose> watch(double seconds, std::string_view stage, bool may_end_early);
  Vec3 carried_force(const Vec3& away, double glide, std::string_view stage);
  Vec3 place() const;
  void weigh(haptics::DeviceCalibration& measured);
  void measure_delay(haptics::DeviceCalibration& measured);
  void bring_force_in();
  // Throws when the device has failed or the person gives up.
  void require_valid();

  haptics::DeviceServo& servo_;
  haptics::CalibrationController& controller_;
  CalibrationSettings settings_;
  CalibrationPerson person_;
};

}  // namespace bodkin::station
