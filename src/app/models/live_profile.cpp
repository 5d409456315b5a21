#include "app/models/live_profile.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <exception>
#include <string_view>
#include <utility>
#include <variant>

#include "patient/prepared_body.h"
#include "study/profile.h"
#include <fmt/format.h>

namespace bodkin::app {

namespace {

constexpr double curve_speed = 10.0;  // mm/s, of a hand that takes its time
constexpr double about_path = 20.0;   // mm about the path that the insertion can touch

// The patient around the planned path, without data unused by a rigid model: small enough to be copied.
anatomy::Case around_path(const anatomy::Case& whole) {
  anatomy::Case part;
  part.description = whole.description;
  part.library = whole.library;
  const std::optional<anatomy::NeedlePath>& path = whole.description.procedure.path;
  const anatomy::Grid& grid = whole.tissues.grid;
  if (!path) {
    part.tissues = whole.tissues;
    return part;
  }
  // It begins 10 mm before the skin.
  const Vec3 first = grid.to_index(Vec3(path->entry - 2.0 * about_path * path->direction()));
  const Vec3 last = grid.to_index(Vec3(path->target + about_path * path->direction()));
  std::array<int, 3> low{}, size{};
  for (int axis = 0; axis < 3; ++axis) {
    const double margin = about_path / grid.spacing[axis];
    const int most = grid.size[static_cast<std::size_t>(axis)] - 1;
    low[static_cast<std::size_t>(axis)] =
        std::clamp(static_cast<int>(std::min(first[axis], last[axis]) - margin), 0, most);
    const int high = std::clamp(static_cast<int>(std::max(first[axis], last[axis]) + margin), 0, most);
    size[static_cast<std::size_t>(axis)] = high - low[static_cast<std::size_t>(axis)] + 1;
  }
  part.tissues.grid = grid;
  part.tissues.grid.origin = grid.to_patient(Vec3(low[0], low[1], low[2]));
  for (std::size_t axis = 0; axis < 3; ++axis) part.tissues.grid.size[axis] = size[axis];
  part.tissues.voxels.reserve(part.tissues.grid.voxel_count());
  for (int z = 0; z < size[2]; ++z) {
    for (int y = 0; y < size[1]; ++y) {
      const std::uint8_t* const row = &whole.tissues.at(low[0], low[1] + y, low[2] + z);
      part.tissues.voxels.insert(part.tissues.voxels.end(), row, row + size[0]);
    }
  }
  return part;
}

// Thrown from a Progress to cancel the preparation of a body that is no longer needed.
struct PreparationObsolete : std::exception {
  const char* what() const noexcept override { return "another body is wanted"; }
};

// All inputs of a prepared body, to compare two bodies; empty: no body.
std::string recipe_of_body(const ModelSettings& settings) {
  const anatomy::DeformableBodySettings* const body = anatomy::body_of(settings.haptics.resistance);
  if (body == nullptr) return {};
  std::string recipe(anatomy::name_of(settings.haptics.resistance));
  const auto add = [&recipe](auto number) { recipe += fmt::format(" {}", number); };
  add(body->stiffness_scale);
  add(body->fix_beyond);
  add(body->fix_bone);
  add(body->fix_cut);
  if (const auto* needle = std::get_if<anatomy::EmbeddedNeedleSettings>(&settings.haptics.resistance)) {
    add(needle->point_spacing);
    add(needle->points_beyond);
    add(needle->tip_radius);
  }
  if (const auto* closest = std::get_if<anatomy::ClosestNodeSettings>(&settings.haptics.resistance)) {
    for (const double number : {closest->corridor.radius, closest->corridor.beyond, closest->corridor.nodes})
      add(number);
  }
  for (const anatomy::TissueProperties& tissue : settings.tissues) {
    const anatomy::DeformableTissue& material = tissue.deformable;
    add(static_cast<int>(tissue.id));
    add(static_cast<int>(tissue.layered.kind));
    add(static_cast<int>(material.fibres));
    for (const double number : {material.young, material.poisson, material.young_along, material.shear_along})
      add(number);
  }
  return recipe;
}

// Also reads the CT.
bool needs_ct(const anatomy::HapticSettings& haptics) {
  return anatomy::name_of(haptics.resistance) == "volume_proxy";
}

}  // namespace

ForceCurve force_curve(anatomy::Case& patient, const ModelSettings& settings) {
  constexpr double coarse = 0.05;  // mm between the points of the curve
  ForceCurve curve;
  if (!patient.description.procedure.path) {
    curve.trouble = "This patient has no planned path to try the needle on.";
    return curve;
  }
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  try {
    patient.description.haptics = settings.haptics;
    patient.library = anatomy::TissueLibrary(settings.tissues);
    study::ProfileOptions options;
    options.speed = curve_speed;
    const study::Profile profile = study::insert_at_constant_speed(patient, options);
    double shown = -1.0;
    for (const simulation::TickRecord& record : profile.ticks) {
      const simulation::TickOutput& now = record.output;
      const bool gives = std::any_of(now.events.begin(), now.events.end(), [](const forces::Event& event) {
        return event.kind == forces::EventKind::puncture;
      });
      if (gives && !curve.first_puncture_force) curve.first_puncture_force = curve.strongest;
      curve.strongest = std::max(curve.strongest, now.resistance);
      if (now.depth <= 0.0 || (now.depth - shown < coarse && !gives)) continue;
      shown = now.depth;
      curve.points.push_back({now.depth, now.resistance});
      if (curve.bands.empty() || curve.bands.back().tissue != now.tissue)
        curve.bands.push_back({now.depth, now.depth, now.tissue});
      curve.bands.back().to = now.depth;
    }
  } catch (const std::exception& failure) {
    curve.trouble = failure.what();
  }
  curve.milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
  return curve;
}

LiveProfile::LiveProfile(std::shared_ptr<const OpenCase> patient)
    : thread_([this, patient = std::move(patient)](const std::stop_token& stop) { run(stop, patient); }) {}

LiveProfile::~LiveProfile() {
  thread_.request_stop();
  changed_.notify_all();
  thread_.join();  // before what it uses goes
}

void LiveProfile::prepare(anatomy::Case& part, const ModelSettings& settings, const std::filesystem::path& folder,
                          const std::stop_token& stop) {
  const std::string recipe = recipe_of_body(settings);
  part.prepared = {};
  part.description.haptics = settings.haptics;
  part.library = anatomy::TissueLibrary(settings.tissues);
  patient::prepare_body(part, folder, std::nullopt,
                        [&](std::string_view /*stage*/, double fraction) {
                          const std::lock_guard guard(lock_);
                          if (stop.stop_requested() || (wanted_ && recipe_of_body(*wanted_) != recipe))
                            throw PreparationObsolete();
                          preparation_ = fraction;
                        },
                        {});
}

void LiveProfile::run(const std::stop_token& stop, const std::shared_ptr<const OpenCase>& patient) {
  anatomy::Case part = around_path(patient->patient);
  bool is_whole = false;
  std::string prepared;  // the recipe of the body that `part` has
  while (!stop.stop_requested()) {
    ModelSettings settings;
    {
      std::unique_lock guard(lock_);
      if (!changed_.wait(guard, stop, [this] { return wanted_.has_value(); })) return;
      settings = std::move(*wanted_);
      wanted_.reset();
      works_ = true;
    }
    const std::string recipe = recipe_of_body(settings);
    if ((needs_ct(settings.haptics) || !recipe.empty()) && !std::exchange(is_whole, true)) part = patient->patient;
    std::shared_ptr<const ForceCurve> made;
    try {
      if (!recipe.empty() && recipe != prepared && part.description.procedure.path) {
        prepared.clear();
        prepare(part, settings, patient->folder, stop);
        prepared = recipe;
      }
      made = std::make_shared<const ForceCurve>(force_curve(part, settings));
    } catch (const PreparationObsolete&) {
    } catch (const std::exception& failure) {
      ForceCurve none;
      none.trouble = failure.what();
      made = std::make_shared<const ForceCurve>(std::move(none));
    }
    const std::lock_guard guard(lock_);
    works_ = false;
    preparation_.reset();
    if (made != nullptr) curve_ = std::move(made);
  }
}

void LiveProfile::set(const ModelSettings& settings) {
  const std::lock_guard guard(lock_);
  wanted_ = settings;
  changed_.notify_one();
}

std::shared_ptr<const ForceCurve> LiveProfile::curve() const {
  const std::lock_guard guard(lock_);
  return curve_;
}

std::optional<double> LiveProfile::preparation() const {
  const std::lock_guard guard(lock_);
  return preparation_;
}

bool LiveProfile::is_busy() const {
  const std::lock_guard guard(lock_);
  return wanted_.has_value() || works_;
}

}  // namespace bodkin::app
