#include "study/profile.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "core/error.h"
#include "core/settings_check.h"
#include "simulation/haptic_tick.h"

namespace bodkin::study {
namespace {

constexpr double longest_profile = 600.0;  // s, as of the motion of an experiment

// Empty outside the CT.
std::string hounsfield_cell(const anatomy::CtVolume& ct, const Vec3& point) {
  constexpr double outside = 1e6;
  const double value = ct.empty() ? outside : anatomy::linear(ct, point, outside);
  return value == outside ? "" : fmt::format("{:.1f}", value);
}

// The name of the structure at a point, in quotes where a table needs them; empty where nothing is labelled.
std::string structure_cell(const anatomy::Case& patient, const Vec3& point) {
  if (patient.structures.empty()) return "";
  const std::uint16_t label = anatomy::nearest(patient.structures, point, std::uint16_t{0});
  const auto& table = patient.description.structures;
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const anatomy::Structure& structure) { return structure.label == label; });
  if (label == 0 || found == table.end()) return "";
  if (found->name.find_first_of(",\"") == std::string::npos) return found->name;
  std::string quoted = "\"";
  for (const char letter : found->name) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + "\"";
}

// The motion of the options as steps.
NeedleMotion motion_of(const ProfileOptions& options) {
  if (!options.motion.empty()) return options.motion;
  NeedleMotion motion = {{.goal = MotionGoal::target}, {.goal = MotionGoal::hold, .time = options.pause}};
  if (options.withdraw) motion.push_back({.goal = MotionGoal::outside});
  return motion;
}

}  // namespace

Profile insert_at_constant_speed(const anatomy::Case& patient, const ProfileOptions& options,
                                 const Progress& progress) {
  check_range("", "--speed", options.speed, {0.5, 500.0}, "mm/s");
  check_range("", "--beyond", options.beyond, {0.0, 200.0}, "mm");
  check_range("", "--pause", options.pause, {0.0, 60.0}, "s");
  const StraightPath line = path_of_motion(patient, options.entry, options.target, options.motion, options.beyond);
  const NeedleMotion motion = motion_of(options);
  const double duration = duration_of(motion, line, options.speed, line.end);
  if (!options.motion.empty() && duration > longest_profile) {
    throw InputError(
        fmt::format("--motion takes {:.0f} s, expected at most {:.0f} s; give larger speeds or shorter holds",
                    duration, longest_profile));
  }
  Profile profile;
  profile.options = options;
  profile.path = line.path;
  profile.surface = line.surface;
  profile.notes = line.notes;

  simulation::HapticTick haptics(patient);
  haptics.hold_breath();
  profile.dt = haptics.dt();
  profile.diagnostics.assign(haptics.diagnostic_names().begin(), haptics.diagnostic_names().end());
  const double peak_force = patient.description.device.peak_force;
  profile.ticks.reserve(static_cast<std::size_t>(duration / profile.dt) + 16 + motion.size());
  const auto moment = [&haptics](const simulation::TickRecord& record) {
    const simulation::BodyPort* const body = haptics.body();
    const Vec3 ahead = body == nullptr ? Vec3(Vec3::Zero()) : body->coupling_offset();
    Pose needle = record.input.needle;
    needle.translation() -= ahead;
    return DeformedState{body == nullptr ? fem::NodeForces{} : body->node_forces(), needle, ahead.norm(),
                         record.output.depth, record.output.resistance};
  };
  const anatomy::TissueProperties* bone = nullptr;  // that the tip touches
  const auto tick = [&](double place) -> const simulation::TickOutput& {
    simulation::TickRecord record;
    record.tick = profile.ticks.size();
    record.input.needle = line.needle_at(place);
    record.output = haptics.step(record.input);
    if (record.output.resistance > profile.strongest.resistance) profile.strongest = moment(record);
    for (const forces::Event& event : record.output.events) {
      if (event.kind == forces::EventKind::bone_contact) bone = patient.library.find(event.tissue);
      if (event.kind == forces::EventKind::bone_left) bone = nullptr;
    }
    profile.ticks.push_back(record);
    if (progress && record.tick % 2048 == 0) {
      progress("Inserting the needle",
               static_cast<double>(record.tick) / static_cast<double>(profile.ticks.capacity()));
    }
    return profile.ticks.back().output;
  };

  tick(line.start);
  double here = line.start, deepest = line.start, end = line.end;
  // Whether bone resists with more than the device can render. In the deformed material a tip stopped by bone is
  // still in the tissue before it, which it pushes along.
  const auto stopped_by_bone = [&](const simulation::TickOutput& output) {
    const anatomy::TissueProperties* properties = patient.library.find(output.tissue);
    if (properties == nullptr || properties->layered.kind != anatomy::LayeredKind::rigid) properties = bone;
    if (properties == nullptr || !(output.resistance > peak_force)) return false;
    if (profile.stopped_by_bone) return true;
    profile.stopped_by_bone = output.depth;
    profile.outcome = fmt::format(
        "stopped by {} at {:.1f} mm, {:.1f} mm before the end of the {}: it asks for more than the "
        "{:.1f} N of the device",
        properties->title, output.depth, line.end - here, options.motion.empty() ? "path" : "motion", peak_force);
    return true;
  };
  for (const MotionStep& step : motion) {
    const double goal = std::min(end_of_step(step, line, here), end), before = here;
    const auto rests = static_cast<std::size_t>(std::lround(step.time / profile.dt));
    for (std::size_t n = 0; n < rests; ++n) tick(here);
    if (goal == here) continue;
    for (const double place : places_between(here, goal, step.speed.value_or(options.speed) * profile.dt)) {
      const simulation::TickOutput& output = tick(place);
      here = place;
      if (place > before && stopped_by_bone(output)) {
        end = place;
        break;
      }
    }
    if (here <= deepest) continue;
    deepest = here;
    profile.last = moment(profile.ticks.back());
  }
  if (!profile.stopped_by_bone) {
    const char* const where = line.ends_at_hub && deepest >= line.end ? "the hub met the skin"
                              : options.motion.empty()                ? "the end of the path was reached"
                                                                      : "the motion was deepest";
    profile.outcome = fmt::format("{} at {:.1f} mm", where, deepest - line.surface);
  }
  return profile;
}

std::string profile_csv(const Profile& profile, const anatomy::Case& patient) {
  std::string text =
      "time_s,depth_mm,velocity_mm_s,resistance_N,requested_L_N,requested_P_N,requested_S_N,applied_L_N,applied_P_N,"
      "applied_S_N,tissue,ct_HU,structure";
  for (const forces::DiagnosticName& diagnostic : profile.diagnostics)
    fmt::format_to(std::back_inserter(text), ",{}", diagnostic.name);
  text += '\n';
  for (const simulation::TickRecord& record : profile.ticks) {
    const simulation::TickOutput& output = record.output;
    const Vec3& asked = output.requested.force;
    const Vec3& given = output.applied.force;
    const anatomy::TissueProperties* properties = patient.library.find(output.tissue);
    fmt::format_to(std::back_inserter(text),
                   "{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{},{},{}",
                   static_cast<double>(record.tick) * profile.dt, output.depth, output.velocity, output.resistance,
                   asked.x(), asked.y(), asked.z(), given.x(), given.y(), given.z(),
                   properties != nullptr ? properties->name : std::to_string(output.tissue),
                   hounsfield_cell(patient.ct, record.input.needle.translation()),
                   structure_cell(patient, record.input.needle.translation()));
    for (std::size_t i = 0; i < profile.diagnostics.size(); ++i)
      fmt::format_to(std::back_inserter(text), ",{:.6f}", output.diagnostics[i]);
    text += '\n';
  }
  return text;
}

}  // namespace bodkin::study
