#include "study/compare.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.h"
#include "core/settings_check.h"
#include "io/force_choice.h"
#include "simulation/haptic_tick.h"

namespace bodkin::study {

namespace {

constexpr double most_ticks = 3e6;
constexpr double longest_motion = 600.0;  // s
constexpr std::size_t block = 2048;       // ticks between checks of the clock
constexpr double bone_search = 0.1;       // mm
constexpr double least_bone = 1e-3;       // N/mm

constexpr const char* option = "--models";

// Comparison settings of a model.
struct Variant {
  std::string_view of, name;
};
constexpr Variant variants[] = {
    {"layered", "layered_sum"}, {"tracking_wall", "tracking_wall_leash"}, {"volume_proxy", "volume_proxy_viscous"}};

// The needle cannot pass the surface of `surface_proxy`, and registered models are named by their program.
constexpr std::string_view not_compared[] = {"surface_proxy", "registered"};

const std::vector<std::string_view>& model_names() {
  static const std::vector<std::string_view> all = [] {
    std::vector<std::string_view> names;
    for (const std::string_view model : anatomy::resistance_names) {
      if (std::find(std::begin(not_compared), std::end(not_compared), model) != std::end(not_compared)) continue;
      names.push_back(model);
      for (const Variant& variant : variants)
        if (variant.of == model) names.push_back(variant.name);
    }
    return names;
  }();
  return all;
}

// The settings of one of `names`. Those of the case's own model are kept, except for the variant's changes.
anatomy::ResistanceSettings settings_of(std::string_view name, const anatomy::ResistanceSettings& own) {
  const bool sum = name.ends_with("_sum"), leash = name.ends_with("_leash"), viscous = name.ends_with("_viscous");
  const std::string_view base = sum || leash || viscous ? name.substr(0, name.rfind('_')) : name;
  anatomy::ResistanceSettings settings = base == anatomy::name_of(own) ? own : io::parse_resistance(base, option);
  if (auto* layered = std::get_if<anatomy::LayeredSettings>(&settings)) {
    layered->law = sum ? anatomy::LayeredLaw::sum : anatomy::LayeredLaw::cubic;
  } else if (auto* wall = std::get_if<anatomy::TrackingWallSettings>(&settings)) {
    wall->leash = leash;
  } else if (auto* proxy = std::get_if<anatomy::VolumeProxySettings>(&settings)) {
    proxy->variant = viscous ? anatomy::ProxyVariant::viscous : anatomy::ProxyVariant::drag;
  }
  return settings;
}

// A name as a table column.
std::string column_of(const std::string& name, std::string_view quantity) {
  std::string column;
  for (const char c : name) {
    const bool kept = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.';
    if (kept || column.empty() || column.back() != '_') column += kept ? c : '_';
  }
  return column + '_' + std::string(quantity);
}

// End of the motion, mm from the entry: at the end of the line, or at the depth in bone where the device's force
// ends.
double deepest_place(const StraightPath& line, const anatomy::Case& patient, Comparison& result) {
  const anatomy::DeviceLimits& device = patient.description.device;
  for (double place = line.surface; place < line.end; place += bone_search) {
    const anatomy::TissueId here = anatomy::nearest<anatomy::TissueId>(
        patient.tissues, line.needle_at(place).translation(), anatomy::tissue::air);
    const anatomy::TissueProperties* properties = patient.library.find(here);
    if (properties == nullptr || properties->layered.kind != anatomy::LayeredKind::rigid) continue;
    const double stiffness = std::max(least_bone, std::min(properties->layered.contact_stiffness, device.stiffness));
    const double end = place + device.peak_force / stiffness;
    if (end >= line.end) return line.end;
    result.ends_in_bone = end - line.surface;
    result.notes.push_back(fmt::format(
        "{} lies in the line at a depth of {:.1f} mm; the needle stops {:.1f} mm deep, {:.1f} mm before the {}",
        properties->title, place - line.surface, *result.ends_in_bone, line.end - end,
        result.options.motion.empty() ? "target" : "end of the motion"));
    return end;
  }
  return line.end;
}

// The motion of the options as steps.
NeedleMotion steps_of(const CompareOptions& options) {
  if (!options.motion.empty()) return options.motion;
  const MotionStep in{.goal = MotionGoal::target}, rest{.goal = MotionGoal::hold, .time = options.pause},
      out{.goal = MotionGoal::outside, .speed = options.withdraw_speed};
  if (options.reinsert) return {in, rest, out, in};
  return {in, rest, out};
}

// The poses of the motion, tick by tick; fills depth, tissue, parts, first and closed of `result`.
std::vector<simulation::TickInput> motion_of(const StraightPath& line, const anatomy::Case& patient,
                                             Comparison& result) {
  const CompareOptions& options = result.options;
  const NeedleMotion steps = steps_of(options);
  const double end = deepest_place(line, patient, result);
  const double duration = duration_of(steps, line, options.speed, end);
  if (!options.motion.empty() && duration > longest_motion) {
    throw InputError(
        fmt::format("--motion takes {:.0f} s, expected at most {:.0f} s; give larger speeds or shorter holds",
                    duration, longest_motion));
  }
  if (const double ticks = duration / result.dt; ticks > most_ticks) {
    throw InputError(
        fmt::format("the motion would take {:.1f} million ticks, expected at most {:.0f} million; give a "
                    "larger --speed or a shorter path",
                    1e-6 * ticks, 1e-6 * most_ticks));
  }
  MotionTicks ticks = ticks_of(steps, line, options.speed, result.dt, end);
  result.parts = std::move(ticks.parts);
  result.first = std::move(ticks.first);
  if (options.motion.empty() && !options.reinsert) {  // its part exists, without ticks
    result.parts.push_back(MotionPhase::reinsertion);
    result.first.push_back(ticks.places.size());
  }

  std::vector<simulation::TickInput> motion;
  motion.reserve(ticks.places.size());
  for (const double place : ticks.places) {
    motion.push_back({line.needle_at(place)});
    result.depth.push_back(place - line.surface);
    result.tissue.push_back(anatomy::nearest<anatomy::TissueId>(patient.tissues, motion.back().needle.translation(),
                                                                anatomy::tissue::air));
    if (place == line.outside) result.closed = motion.size();
  }
  return motion;
}

// ns of CPU time of this thread: other work on the machine does not count.
double processor_time() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
}

ModelRun play(const std::string& name, const anatomy::Case& patient, const std::vector<simulation::TickInput>& motion,
              const Comparison& result, const Progress& progress) {
  ModelRun run;
  run.name = name;
  run.force.reserve(motion.size());
  simulation::HapticTick haptics(patient);
  haptics.hold_breath();
  run.diagnostics.assign(haptics.diagnostic_names().begin(), haptics.diagnostic_names().end());
  run.published.reserve(motion.size() * run.diagnostics.size());
  double spent = 0.0;
  for (std::size_t begin = 0; begin < motion.size(); begin += block) {
    const std::size_t end = std::min(begin + block, motion.size());
    const double started = processor_time();
    for (std::size_t tick = begin; tick < end; ++tick) {
      const simulation::TickOutput output = haptics.step(motion[tick]);
      run.force.push_back(output.resistance);
      run.published.insert(run.published.end(), output.diagnostics.begin(),
                           output.diagnostics.begin() + static_cast<std::ptrdiff_t>(run.diagnostics.size()));
      for (const forces::Event& event : output.events) {
        const bool is_loss = event.kind == forces::EventKind::loss_of_resistance;
        if (event.kind != forces::EventKind::puncture && !is_loss) continue;
        if (result.phase_of(tick) == MotionPhase::insertion) run.events.push_back({tick, event});
        if (is_loss) continue;
        ++run.punctures[static_cast<std::size_t>(result.phase_of(tick))];
      }
    }
    spent += processor_time() - started;
    if (progress) {
      progress(fmt::format("Inserting with {}", name), static_cast<double>(end) / static_cast<double>(motion.size()));
    }
  }
  run.nanoseconds = spent / static_cast<double>(motion.size());
  return run;
}

// All results that depend on the forces of only one model.
void measure(ModelRun& run, const Comparison& result) {
  for (std::size_t tick = 0; tick < run.force.size(); ++tick) {
    const MotionPhase phase = result.phase_of(tick);
    if (phase == MotionPhase::insertion && run.force[tick] > run.peak) {
      run.peak = run.force[tick];
      run.peak_tick = tick;
    }
    if (phase == MotionPhase::reinsertion) run.peak_again = std::max(run.peak_again, run.force[tick]);
    run.lowest = std::min(run.lowest, run.force[tick]);
    if (tick == 0) continue;
    const double advance = result.depth[tick] - result.depth[tick - 1];
    const double work = 0.5 * (run.force[tick] + run.force[tick - 1]) * advance;
    run.work[static_cast<std::size_t>(phase)] += work;
    if (tick < result.closed) run.closed_work += work;
  }
  run.peak_tissue = result.tissue[run.peak_tick];
  for (const ReportedEvent& each : run.events) {
    const bool follows = each.tick >= run.peak_tick && each.tick <= run.peak_tick + 2;
    if (follows && each.event.kind == forces::EventKind::puncture) run.peak_tissue = each.event.tissue;
  }
  const auto turns = std::find(result.parts.begin(), result.parts.end(), MotionPhase::withdrawal);
  run.end_of_stop = run.force[result.first[static_cast<std::size_t>(turns - result.parts.begin())] - 1];
}

void measure_difference(ModelRun& run, const ModelRun& reference, const std::vector<double>& depth) {
  double sum = 0.0;
  std::size_t inside = 0;
  for (std::size_t tick = 0; tick < depth.size(); ++tick) {
    if (depth[tick] <= 0.0) continue;
    const double difference = std::abs(run.force[tick] - reference.force[tick]);
    run.largest_difference = std::max(run.largest_difference, difference);
    sum += difference * difference;
    ++inside;
  }
  run.rms_difference = inside > 0 ? std::sqrt(sum / static_cast<double>(inside)) : 0.0;
}

// One sentence for many refusals; a common reason is stated once.
std::string nothing_ran(const std::vector<ModelRefused>& refused) {
  const bool same = std::all_of(refused.begin(), refused.end(),
                                [&](const ModelRefused& model) { return model.reason == refused[0].reason; });
  if (same) return refused[0].reason;
  std::string text = "none of the models can be run on this case";
  for (const ModelRefused& model : refused) text += fmt::format("; {}: {}", model.name, model.reason);
  return text;
}

}  // namespace

std::span<const std::string_view> compared_names() {
  return model_names();
}

std::vector<ComparedModel> models_of(const std::vector<std::string>& texts, const anatomy::ResistanceSettings& own) {
  std::vector<ComparedModel> models;
  if (texts.empty()) {
    for (const std::string_view name : model_names()) models.push_back({std::string(name), settings_of(name, own)});
  }
  for (const std::string& text : texts) {
    const auto is_text = [&](const ComparedModel& model) { return model.name == text; };
    if (std::any_of(models.begin(), models.end(), is_text)) continue;
    if (std::find(model_names().begin(), model_names().end(), text) != model_names().end()) {
      models.push_back({text, settings_of(text, own)});
      continue;
    }
    const std::string_view first = std::string_view(text).substr(0, text.find_first_of(" ;"));
    if (std::find(anatomy::resistance_names.begin(), anatomy::resistance_names.end(), first) ==
        anatomy::resistance_names.end()) {
      throw InputError(fmt::format("{}: there is no model '{}', expected 'all' or some of {}", option, text,
                                   fmt::join(model_names(), ", ")));
    }
    models.push_back({text, io::parse_resistance(text, option)});
  }
  return models;
}

MotionPhase Comparison::phase_of(std::size_t tick) const {
  std::size_t part = 0;
  while (part + 1 < parts.size() && tick >= first[part + 1]) ++part;
  return parts[part];
}

Comparison compare_models(anatomy::Case patient, const CompareOptions& options, const Progress& progress,
                          const std::function<void(anatomy::Case&)>& prepare) {
  check_range("", "--speed", options.speed, {0.5, 500.0}, "mm/s");
  check_range("", "--withdraw-speed", options.withdraw_speed.value_or(options.speed), {0.5, 500.0}, "mm/s");
  check_range("", "--pause", options.pause, {0.0, 60.0}, "s");
  if (options.models.empty()) throw InputError("there is no model to compare");
  anatomy::HapticSettings& haptics = patient.description.haptics;
  haptics.constraint = options.constraint.value_or(haptics.constraint);
  haptics.parts = options.parts.value_or(haptics.parts);

  Comparison result;
  result.options = options;
  result.constraint = anatomy::name_of(haptics.constraint);
  const StraightPath line = path_of_motion(patient, options.entry, options.target, options.motion);
  result.path = line.path;
  result.notes = line.notes;
  result.dt = 1.0 / haptics.rate;
  const std::vector<simulation::TickInput> motion = motion_of(line, patient, result);

  for (const ComparedModel& model : options.models) {
    haptics.resistance = model.settings;
    try {
      if (prepare) prepare(patient);
      result.models.push_back(play(model.name, patient, motion, result, progress));
    } catch (const InputError& error) {
      result.refused.push_back({model.name, error.what()});
    }
  }
  if (result.models.empty()) throw InputError(nothing_ran(result.refused));
  const auto layered = std::find_if(result.models.begin(), result.models.end(),
                                    [](const ModelRun& run) { return run.name == "layered"; });
  if (layered != result.models.end()) result.reference = static_cast<std::size_t>(layered - result.models.begin());
  for (ModelRun& run : result.models) {
    measure(run, result);
    measure_difference(run, result.models[result.reference], result.depth);
  }
  return result;
}

std::string comparison_csv(const Comparison& comparison) {
  std::string text = "time_s,depth_mm";
  for (const ModelRun& run : comparison.models) {
    text += ',' + column_of(run.name, "N");
    for (const forces::DiagnosticName& diagnostic : run.diagnostics)
      text += ',' + column_of(run.name, diagnostic.name);
  }
  text += '\n';
  for (std::size_t tick = 0; tick < comparison.depth.size(); ++tick) {
    fmt::format_to(std::back_inserter(text), "{:.6f},{:.6f}", static_cast<double>(tick) * comparison.dt,
                   comparison.depth[tick]);
    for (const ModelRun& run : comparison.models) {
      fmt::format_to(std::back_inserter(text), ",{:.6f}", run.force[tick]);
      const std::size_t count = run.diagnostics.size();
      for (std::size_t i = 0; i < count; ++i)
        fmt::format_to(std::back_inserter(text), ",{:.6f}", run.published[tick * count + i]);
    }
    text += '\n';
  }
  return text;
}

}  // namespace bodkin::study
