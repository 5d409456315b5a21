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

// What `bodkin devices calibrate` measures, in this order.
enum class CalibrationStep { workspace, mounting, tip, axis, weight, delay };

// "workspace"
std::string_view name_of(CalibrationStep step);
// Throws InputError for a name that no step has.
CalibrationStep calibration_step(const std::string& name);
// What the person has to do, one or two sentences.
std::string_view task_of(CalibrationStep step);
// The steps that a device allows: tip and axis need rotation, weight and delay need force.
std::vector<CalibrationStep> steps_for(const haptics::DeviceAbilities& device);

struct CalibrationSettings {
  double seconds = 15.0;   // for the motions of a step
  double countdown = 3.0;  // s before a step where nobody can say "go on"
};

// Thrown where the person gives up. It is no error, so nothing that tells of one catches it.
struct CalibrationGivenUp : std::exception {
  const char* what() const noexcept override { return "the calibration was given up"; }
};

// How the steps and the person talk. Called on the thread that performs them.
struct CalibrationPerson {
  std::function<void(const std::string& sentence)> say;
  // The person has said "go on" since the last call: begin the step, or enough of it. Empty: he cannot, and each step
  // begins after the countdown.
  std::function<bool()> goes_on;
  std::function<bool()> gives_up;  // asked every 10 ms; empty: never
  Progress progress;               // may be empty
  std::function<void()> waited;    // a long measurement is over; may be empty
};

// Leads a person through the steps with an open device, and keeps what they came to.
class CalibrationSteps {
 public:
  // The servo runs; its controller is `controller`.
  CalibrationSteps(haptics::DeviceServo& servo, haptics::CalibrationController& controller,
                   const CalibrationSettings& settings, CalibrationPerson person);

  // Says what to do, waits for the person or the countdown, measures. Throws InputError where the readings do not
  // do, SystemError when the device fails, and
  // CalibrationGivenUp.
  void perform(CalibrationStep step, haptics::DeviceCalibration& measured);
  // Asks for the tip on a point of that name, waits for the person or the countdown, and says where it is. A tip that
  // does not stay there is asked for again, twice. `tip_offset`: as in haptics::DeviceCalibration. Throws the same.
  haptics::TouchFit touch(const std::string& name, const Vec3& tip_offset);

 private:
  void wait_for_a_person();
  std::vector<Pose> watch(double seconds, std::string_view stage, bool may_end_early);
  Vec3 carried_force(const Vec3& away, double glide, std::string_view stage);
  Vec3 place() const;
  void weigh(haptics::DeviceCalibration& measured);
  void measure_delay(haptics::DeviceCalibration& measured);
  void bring_force_in();
  // Throws when the device has failed or the person gives up.
  void require_sound();

  haptics::DeviceServo& servo_;
  haptics::CalibrationController& controller_;
  CalibrationSettings settings_;
  CalibrationPerson person_;
};

}  // namespace bodkin::station
