#include "station/calibration_steps.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.h"
#include "haptics/calibration.h"

namespace bodkin::station {

namespace {

constexpr std::chrono::milliseconds step_interval{10};
constexpr double lift = 25.0;            // mm by which the handle is lifted while it is weighed
constexpr double glide_of_handle = 2.5;  // s for that and until the swinging ends
constexpr double draw = 15.0;            // mm by which it is moved to the right and away
constexpr double glide_of_draw = 2.0;    // s
constexpr double rest_time = 1.0;        // s over which the force is averaged
constexpr double arming_time = 4.0;      // s within which the force must have arrived
constexpr double least_follow = 5.0;     // mm that the handle must have been lifted
constexpr double slew_delay = 0.0005;    // s by which the guard's slew rate delays a pulse
constexpr double longest_probe = 10.0;   // s for the pulses that measure the delay
constexpr double longest_delay = 0.02;   // s

struct StepWords {
  CalibrationStep step;
  std::string_view name;
  std::string_view what_to_do;
};

constexpr std::array<StepWords, 6> step_table = {
    {{CalibrationStep::workspace, "workspace",
      "Workspace: move the handle to every corner that you want to use, near and far, left and right, up and down."},
     {CalibrationStep::mounting, "mounting",
      "Mounting: hold the handle near you. Then push it straight away from you, 5 cm or more, and leave it there."},
     {CalibrationStep::tip, "tip",
      "Tip: put the tool's tip into a dimple that holds it, and swivel the tool about it, 20 degrees or more to "
      "every "
      "side."},
     {CalibrationStep::axis, "axis", "Axis: hold the tool so that it points straight down, and keep it still."},
     {CalibrationStep::weight, "weight",
      "Weight: the motors will carry the handle. Hold it in the middle of the workspace; as the force comes, let go "
      "and "
      "keep clear until this step is over."},
     {CalibrationStep::delay, "delay",
      "Delay: hold the handle loosely in the middle of the workspace, and let it tick up and down for five "
      "seconds."}}};

const StepWords& step_words(CalibrationStep step) {
  return step_table[static_cast<std::size_t>(step)];
}

double time_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

std::string_view name_of(CalibrationStep step) {
  return step_words(step).name;
}

std::string_view task_of(CalibrationStep step) {
  return step_words(step).what_to_do;
}

CalibrationStep calibration_step(const std::string& name) {
  std::vector<std::string_view> names;
  for (const StepWords& step : step_table) {
    if (step.name == name) return step.step;
    names.push_back(step.name);
  }
  throw InputError(fmt::format("--steps: '{}' is not a step, expected {}", name, fmt::join(names, ", ")));
}

std::vector<CalibrationStep> steps_for(const haptics::DeviceAbilities& device) {
  std::vector<CalibrationStep> steps = {CalibrationStep::workspace, CalibrationStep::mounting};
  if (device.measures_rotation) steps.insert(steps.end(), {CalibrationStep::tip, CalibrationStep::axis});
  if (device.peak_force > 0.0) steps.insert(steps.end(), {CalibrationStep::weight, CalibrationStep::delay});
  return steps;
}

CalibrationSteps::CalibrationSteps(haptics::DeviceServo& servo, haptics::CalibrationController& controller,
                                   const CalibrationSettings& settings, CalibrationPerson person)
    : servo_(servo), controller_(controller), settings_(settings), person_(std::move(person)) {}

void CalibrationSteps::require_valid() {
  if (person_.cancelled && person_.cancelled()) throw CalibrationCancelled();
  const haptics::ServoSnapshot& now = servo_.tick().snapshot();
  if (now.device.fault != haptics::DeviceFault::none) {
    const std::string sentence = servo_.explain();
    throw SystemError(sentence.empty()
                          ? fmt::format("the device reported a fault: {}", haptics::text_of(now.device.fault))
                          : sentence);
  }
  if (now.state == haptics::GuardState::faulted) {
    throw SystemError(fmt::format("the force was taken away: {}; try again", haptics::text_of(now.fault)));
  }
}

void CalibrationSteps::wait_for_confirmation() {
  const auto begin = std::chrono::steady_clock::now();
  for (;;) {
    std::this_thread::sleep_for(step_interval);
    require_valid();
    if (person_.confirmed ? person_.confirmed() : time_since(begin) >= settings_.countdown) return;
  }
}

std::vector<Pose> CalibrationSteps::watch(double seconds, std::string_view stage, bool may_end_early) {
  std::vector<Pose> readings;
  const auto begin = std::chrono::steady_clock::now();
  while (time_since(begin) < seconds) {
    std::this_thread::sleep_for(step_interval);
    require_valid();
    readings.push_back(servo_.tick().snapshot().device.hand);
    if (person_.progress) person_.progress(stage, time_since(begin) / seconds);
    const bool enough = person_.confirmed && person_.confirmed();
    if (may_end_early && enough) break;
  }
  if (person_.after_measurement) person_.after_measurement();
  return readings;
}

Vec3 CalibrationSteps::place() const {
  return servo_.tick().snapshot().device.hand.translation();
}

// N that hold the handle at rest, `away` from its first place, after `glide` s.
Vec3 CalibrationSteps::carried_force(const Vec3& away, double glide, std::string_view stage) {
  controller_.carry(away);
  watch(glide, stage, false);
  Vec3 sum = Vec3::Zero();
  int count = 0;
  const auto begin = std::chrono::steady_clock::now();
  while (time_since(begin) < rest_time) {
    std::this_thread::sleep_for(step_interval);
    require_valid();
    sum += servo_.tick().snapshot().applied.force;
    ++count;
  }
  return sum / count;
}

void CalibrationSteps::bring_force_in() {
  haptics::ServoCommand command;
  command.kind = haptics::ServoCommand::Kind::arm;
  servo_.tick().command(command);
  const auto begin = std::chrono::steady_clock::now();
  while (servo_.tick().snapshot().state != haptics::GuardState::active) {
    std::this_thread::sleep_for(step_interval);
    require_valid();
    if (time_since(begin) > arming_time) {
      throw InputError("no force was rendered, because the handle was not at rest; hold it still at the beginning");
    }
  }
}

// The measured delay is that of a command through our loop and the device; ours is known, and the rest is the
// device's.
void CalibrationSteps::measure_delay(haptics::DeviceCalibration& measured) {
  haptics::DelayProbe& probe = controller_.delay_probe();
  if (probe.is_over()) throw InputError("the delay was measured already; start again to measure it anew");
  bring_force_in();
  probe.begin();
  const auto begin = std::chrono::steady_clock::now();
  while (!probe.is_over() && time_since(begin) < longest_probe) {
    std::this_thread::sleep_for(step_interval);
    require_valid();
    if (person_.progress) person_.progress("delay", time_since(begin) / longest_probe);
  }
  if (person_.after_measurement) person_.after_measurement();
  servo_.tick().disarm();
  const std::optional<double> found = probe.delay();
  if (!found) {
    throw InputError(
        "the handle did not follow the force clearly; hold it loosely, and try again with --steps delay");
  }
  measured.delay = std::clamp(*found - servo_.own_delay() - slew_delay, 0.0, longest_delay);
  person_.report(fmt::format("  a force comes {:.1f} ms after its tick, {:.1f} ms of which are the device's",
                             1e3 * *found, 1e3 * *measured.delay));
}

void CalibrationSteps::weigh(haptics::DeviceCalibration& measured) {
  bring_force_in();
  const Vec3 up = Vec3::UnitZ();
  carried_force(Vec3::Zero(), glide_of_handle, "weighing: let go of the handle");
  const double low = place().z();
  const double from_below = carried_force(lift * up, glide_of_handle, "weighing: the handle goes up").z();
  const double followed = place().z() - low;
  const double from_above = carried_force(Vec3::Zero(), glide_of_handle, "weighing: the handle goes down").z();
  Vec3 friction = Vec3::Zero();
  for (const auto& [axis, stage] : {std::pair(0, "friction: the handle goes right and back"),
                                    std::pair(1, "friction: the handle goes away and back")}) {
    const double here = place()[axis];
    const double from_one_side = carried_force(draw * Vec3::Unit(axis), glide_of_draw, stage)[axis];
    const double way = place()[axis] - here;
    const double from_the_other = carried_force(Vec3::Zero(), glide_of_draw, stage)[axis];
    friction[axis] = haptics::level_friction(from_one_side, from_the_other, way, draw);
  }
  servo_.tick().disarm();
  if (followed < least_follow) {
    throw InputError(
        fmt::format("the handle went up by {:.1f} mm when it was lifted, expected {:g} or more; let it hang freely",
                    followed, least_follow));
  }
  const haptics::WeightFit fit = haptics::weight_of(from_below, from_above);
  measured.weight = fit.weight;
  friction.z() = fit.friction;
  measured.friction = friction;
  person_.report(
      fmt::format("  the handle weighs {:.2f} N, its friction is {:.2f} N to the right, {:.2f} N away from you "
                  "and {:.2f} N upwards",
                  fit.weight, friction.x(), friction.y(), friction.z()));
}

void CalibrationSteps::perform(CalibrationStep step, haptics::DeviceCalibration& measured) {
  person_.report(std::string(step_words(step).what_to_do));
  wait_for_confirmation();
  const std::string stage(name_of(step));
  switch (step) {
    case CalibrationStep::workspace: {
      measured.reach = haptics::reach_of(watch(settings_.seconds, stage, true));
      const Vec3 size = measured.reach->high - measured.reach->low;
      person_.report(fmt::format("  {:.0f} x {:.0f} x {:.0f} mm", size.x(), size.y(), size.z()));
      return;
    }
    case CalibrationStep::mounting:
      measured.mounting = haptics::mounting_of(watch(settings_.seconds, stage, true));
      person_.report(fmt::format("  the device stands turned by {:.1f} degrees", *measured.mounting / degree));
      return;
    case CalibrationStep::tip: {
      const haptics::TipFit fit = haptics::tip_of(watch(settings_.seconds, stage, true));
      measured.tip_offset = fit.offset;
      measured.tip_residual = fit.residual;
      person_.report(fmt::format("  the tip lies {:.1f} mm from the device's point, found within {:.2f} mm",
                                 fit.offset.norm(), fit.residual));
      return;
    }
    case CalibrationStep::axis:
      measured.tool_axis = haptics::tool_axis_of(watch(std::min(settings_.seconds, 3.0), stage, true));
      person_.report(fmt::format("  the needle's axis is {:.3f} {:.3f} {:.3f} of the tool's", measured.tool_axis->x(),
                                 measured.tool_axis->y(), measured.tool_axis->z()));
      return;
    case CalibrationStep::weight:
      return weigh(measured);
    case CalibrationStep::delay:
      return measure_delay(measured);
  }
}

haptics::TouchFit CalibrationSteps::touch(const std::string& name, const Vec3& tip_offset) {
  constexpr double touch_time = 1.0;  // s
  constexpr int attempts = 3;
  for (int attempt = 1;; ++attempt) {
    person_.report(fmt::format("{}: put the tip there and keep it there.", name));
    wait_for_confirmation();
    try {
      haptics::TouchFit fit = haptics::touch_of(watch(touch_time, name, false), tip_offset);
      person_.report(fmt::format("  at {:.2f} {:.2f} {:.2f} mm, within {:.2f} mm", fit.place.x(), fit.place.y(),
                                 fit.place.z(), fit.spread));
      return fit;
    } catch (const InputError& error) {
      if (attempt == attempts) throw;
      person_.report(fmt::format("  {}", error.what()));
    }
  }
}

}  // namespace bodkin::station
