#include "app/models/device_work.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "app/models/late_force.h"
#include "station/device_check.h"
#include "station/real_time_check.h"
#include <fmt/format.h>

#include "core/error.h"
#include "core/utc_time.h"
#include "haptics/calibration.h"
#include "haptics/calibration_controller.h"
#include "io/calibrations_file.h"

namespace bodkin::app {

namespace {

constexpr double slowest_rate = 200.0, fastest_rate = 4000.0;  // Hz

// Thrown to end the work.
struct DeviceWorkCancelled : std::exception {
  const char* what() const noexcept override { return "Cancelled."; }
};

std::string box_of(const Vec3& low, const Vec3& high) {
  return fmt::format("{:.0f} x {:.0f} x {:.0f} mm", high.x() - low.x(), high.y() - low.y(), high.z() - low.z());
}

}  // namespace

DeviceWork::~DeviceWork() {
  cancel();
}

template <typename Change>
void DeviceWork::change(Change&& how) {
  const std::lock_guard guard(lock_);
  how(status_);
}

DeviceWork::Status DeviceWork::status() const {
  const std::lock_guard guard(lock_);
  return status_;
}

void DeviceWork::check(const station::DeviceChoice& choice, double seconds) {
  start(Task::check, choice, seconds, {});
}

void DeviceWork::calibrate(const station::DeviceChoice& choice, const station::CalibrationSettings& settings) {
  start(Task::calibrate, choice, 0.0, settings);
}

void DeviceWork::start(Task task, const station::DeviceChoice& choice, double seconds,
                       const station::CalibrationSettings& settings) {
  {
    const std::lock_guard guard(lock_);
    if (status_.is_busy) return;
    status_ = Status{};
    status_.is_busy = true;
    status_.task = task;
    status_.stage = "opening the device";
  }
  cancelled_.store(false);
  confirmed_.store(false);
  thread_ = std::jthread([this, task, choice, seconds, settings] {
    std::string trouble;
    try {
      task == Task::check ? do_check(choice, seconds) : do_calibration(choice, settings);
    } catch (const std::exception& error) {
      trouble = error.what();
    }
    change([&](Status& status) {
      status.trouble = trouble;
      status.force = 0.0;
      status.stage.clear();
      status.is_busy = false;
    });
  });
}

void DeviceWork::show(const haptics::DeviceAbilities& abilities) {
  change([&](Status& status) {
    status.abilities = abilities;
    status.is_open = true;
  });
}

void DeviceWork::do_check(const station::DeviceChoice& choice, double seconds) {
  haptics::DevicePort port(*choice.driver, choice.identity, choice.settings);
  haptics::DeviceAbilities abilities = port.abilities();
  station::complete_from_table(abilities);
  show(abilities);
  haptics::ServoSettings settings;
  settings.rate = std::clamp(abilities.rate, slowest_rate, fastest_rate);
  haptics::DeviceServo servo(std::move(port), abilities, settings,
                             [](const haptics::ControlInput&) { return haptics::Control{}; });
  const auto watch = [&](double elapsed) {
    const haptics::ServoSnapshot now = servo.rounds() > 0 ? servo.tick().snapshot() : haptics::ServoSnapshot{};
    change([&](Status& status) {
      status.hand = now.device.hand;
      status.force = now.applied.force.norm();
      status.buttons |= now.device.buttons;
      status.stage = "checking: move the device to every corner, press its buttons";
      status.fraction = elapsed / seconds;
    });
    return !cancelled_.load();
  };
  const station::DeviceObservation seen = station::observe_device(servo, seconds, watch);
  if (cancelled_.load()) throw DeviceWorkCancelled();
  const std::string why_not = station::why_not_ready(seen, abilities);
  change([&](Status& status) {
    status.went_well = why_not.empty();
    status.verdict =
        why_not.empty() ? fmt::format("Ready: {:.0f} ticks a second, {} of {} too late, moved within {}.",
                                      seen.rate(), seen.timings.overruns, seen.rounds,
                                      seen.low.x() <= seen.high.x() ? box_of(seen.low, seen.high) : "no space at all")
                        : fmt::format("Not ready: {}.", why_not);
  });
}

void DeviceWork::do_calibration(const station::DeviceChoice& choice, const station::CalibrationSettings& settings) {
  const auto file = io::calibrations_file();
  if (!file)
    throw InputError("there is no folder for calibrations, because neither XDG_CONFIG_HOME nor HOME is set; set one");
  std::vector<haptics::DeviceCalibration> all = io::read_calibrations(*file);
  haptics::DevicePort port(*choice.driver, choice.identity, choice.settings);
  haptics::DeviceAbilities abilities = port.abilities();
  station::complete_from_table(abilities);
  show(abilities);
  const std::vector<station::CalibrationStep> steps = station::steps_for(abilities);
  change([&](Status& status) { status.steps = steps; });
  const auto controller = std::make_shared<haptics::CalibrationController>();
  haptics::ServoSettings servo_settings;
  servo_settings.rate = std::clamp(abilities.rate, slowest_rate, fastest_rate);
  const auto note = [this](const std::string& sentence) {
    change([&](Status& status) { status.messages.push_back(sentence); });
  };
  servo_settings.guard.user_force = station::measuring_force(choice, abilities, late_force_is_allowed(), note);
  servo_settings.guard.frozen_time = 0.0;  // a free handle can stand still under force
  haptics::DeviceServo servo(std::move(port), abilities, servo_settings,
                             [controller](const haptics::ControlInput& input) { return controller->step(input); });
  servo.start();
  station::CalibrationPerson person;
  person.report = [this](const std::string& sentence) {
    change([&](Status& status) { status.messages.push_back(sentence); });
  };
  person.progress = [this](std::string_view stage, double fraction) {
    change([&](Status& status) {
      status.stage = stage;
      status.fraction = fraction;
    });
  };
  // Called every 10 ms in every step: also used to check the device.
  person.confirmed = [this, &servo] {
    if (cancelled_.load()) throw DeviceWorkCancelled();
    const haptics::ServoSnapshot now = servo.rounds() > 0 ? servo.tick().snapshot() : haptics::ServoSnapshot{};
    change([&](Status& status) {
      status.hand = now.device.hand;
      status.force = now.applied.force.norm();
    });
    return confirmed_.exchange(false);
  };
  station::CalibrationSteps guide(servo, *controller, settings, person);
  haptics::DeviceCalibration measured;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    change([&](Status& status) {
      status.step = i;
      status.stage.clear();
      status.fraction = 0.0;
    });
    guide.perform(steps[i], measured);
  }
  const bool stopped = servo.stop();
  measured.driver = choice.driver->name;
  measured.model = abilities.name;
  measured.serial = abilities.serial;
  measured.measured_at = utc_now();
  io::merge_calibration(all, measured);
  io::write_calibrations(all, *file);
  change([&](Status& status) {
    status.step = steps.size();
    status.went_well = stopped;
    status.verdict = fmt::format("Calibrated, and saved in {}.{}", file->string(),
                                 stopped ? "" : " The device could not be stopped; switch it off and on again.");
  });
}

std::vector<std::string> kept_calibration(const std::string& driver) {
  std::vector<std::string> lines;
  const auto file = io::calibrations_file();
  if (!file) return lines;
  for (const haptics::DeviceCalibration& each : io::read_calibrations(*file)) {
    if (each.driver != driver) continue;
    lines.push_back(fmt::format("{}{}, calibrated {}", each.model,
                                each.serial.empty() ? "" : ", serial number " + each.serial, each.measured_at));
    if (each.reach) lines.push_back(fmt::format("workspace {}", box_of(each.reach->low, each.reach->high)));
    if (each.mounting) lines.push_back(fmt::format("stands turned by {:.1f} degrees", *each.mounting / degree));
    if (each.tip_offset) {
      lines.push_back(fmt::format("tip {:.1f} mm from the device's point, within {:.2f} mm", each.tip_offset->norm(),
                                  each.tip_residual));
    }
    if (each.tool_axis) {
      lines.push_back(fmt::format("needle's axis {:.3f} {:.3f} {:.3f} of the tool's", each.tool_axis->x(),
                                  each.tool_axis->y(), each.tool_axis->z()));
    }
    if (each.weight)
      lines.push_back(fmt::format("weight {:.2f} N, friction {:.2f} N", *each.weight, each.friction.z()));
  }
  return lines;
}

}  // namespace bodkin::app
