#include "study/experiment.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>

#include "patient/prepared_body.h"
#include "study/layer_mesh.h"
#include "study/needle_motion.h"
#include <fmt/format.h>

#include "core/error.h"
#include "io/case_folder.h"
#include "simulation/haptic_tick.h"

namespace bodkin::study {

namespace {

constexpr double most_voxels = 60e6;
constexpr double same_time = 1e-9;  // s; the time of a tick is a rounded product
constexpr std::int16_t air_hounsfield = -1000;
constexpr double air_before_mesh = 5.0;  // mm

// Tissue at a depth below the surface, or at a radius of a half ball.
anatomy::TissueId tissue_at(const io::ExperimentBody& body, const std::vector<anatomy::TissueId>& ids, double depth) {
  double end = 0.0;
  for (std::size_t i = 0; i < body.layers.size(); ++i) {
    end += body.layers[i].thickness;
    if (depth < end) return ids[i];
  }
  return body.hemisphere ? ids.back() : anatomy::tissue::air;
}

anatomy::TissueVolume tissues_of(const io::Experiment& experiment) {
  const io::ExperimentBody& body = experiment.body;
  std::vector<anatomy::TissueId> ids;
  double total = 0.0;
  for (const io::ExperimentLayer& layer : body.layers) {
    ids.push_back(experiment.library.find(layer.tissue)->id);
    total += layer.thickness;
  }
  const double across = body.hemisphere ? 2.0 * body.radius : body.width;
  const double along = body.hemisphere ? body.radius : total;
  const auto voxels = [&body](double length) { return std::max(1.0, std::ceil(length / body.voxel - 1e-6)); };
  const double count = voxels(across) * voxels(across) * voxels(along);
  if (count > most_voxels) {
    throw InputError(
        fmt::format("{}: the body has {:.0f} million voxels, expected at most {:.0f}; make voxel_mm larger",
                    experiment.name, count / 1e6, most_voxels / 1e6));
  }
  // Air in front of the skin of a mesh, whose faces are held where the volume ends.
  const bool deforms = anatomy::body_of(experiment.haptics.resistance) != nullptr;
  const int front = deforms ? static_cast<int>(voxels(air_before_mesh)) : 0;
  anatomy::Grid grid;
  grid.size = {static_cast<int>(voxels(across)), static_cast<int>(voxels(across)),
               static_cast<int>(voxels(along)) + front};
  grid.spacing = Vec3::Constant(body.voxel);
  grid.origin = {-0.5 * body.voxel * (grid.size[0] - 1), -0.5 * body.voxel * (grid.size[1] - 1),
                 (0.5 - front) * body.voxel};
  anatomy::TissueVolume volume(grid, anatomy::tissue::air);
  const Vec3 centre = {0.0, 0.0, body.radius};
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const Vec3 place = grid.to_patient(Vec3(i, j, k));
        const double depth = body.hemisphere ? body.radius - (place - centre).norm() : place.z();
        if (depth >= 0.0) volume.at(i, j, k) = tissue_at(body, ids, depth);
      }
    }
  }
  return volume;
}

// The deformable body of layers, about the line of the motion, if the resistance needs one; `whole` as in
// patient::prepare_body().
void give_body(const io::Experiment& experiment, const Progress& progress, anatomy::Case& patient,
               std::shared_ptr<const fem::ContactBody>& whole) {
  const io::ExperimentBody& body = experiment.body;
  if (experiment.patient || anatomy::body_of(experiment.haptics.resistance) == nullptr) return;
  if (body.hemisphere) {
    throw InputError(
        fmt::format("{}: {} needs a mesh, and only a stack of layers or a patient has one, not a half ball",
                    experiment.name, anatomy::name_of(experiment.haptics.resistance)));
  }
  std::vector<MeshLayer> layers;
  for (const io::ExperimentLayer& layer : body.layers)
    layers.push_back({experiment.library.find(layer.tissue)->id, layer.thickness});
  double deepest = 0.0;
  for (const io::ExperimentPlace& place : experiment.motion.places) deepest = std::max(deepest, place.depth);
  const io::ExperimentMotion& motion = experiment.motion;
  patient::prepare_body(patient, mesh_of_layers(layers, body.width, body.mesh),
                        {motion.entry, motion.entry + deepest * motion.direction}, progress, &whole);
}

// The needle's position at a time.
class Mover {
 public:
  explicit Mover(const io::ExperimentMotion& motion) : motion_(motion) {}

  // Times must not decrease.
  io::ExperimentPlace at(double time) {
    const std::vector<io::ExperimentPlace>& places = motion_.places;
    while (next_ + 1 < places.size() && places[next_].time < time) ++next_;
    const io::ExperimentPlace &from = places[next_ - 1], &to = places[next_];
    const double part = std::clamp((time - from.time) / (to.time - from.time), 0.0, 1.0);
    const auto between = [part](double a, double b) { return part == 1.0 ? b : a + part * (b - a); };
    return {time, between(from.depth, to.depth), between(from.aside, to.aside), between(from.tilt, to.tilt)};
  }
  Pose pose(const io::ExperimentPlace& place) const {
    const Vec3& along = motion_.direction;
    const Vec3 axis = std::cos(place.tilt) * along + std::sin(place.tilt) * motion_.across;
    const Vec3 side = std::cos(place.tilt) * motion_.across - std::sin(place.tilt) * along;
    const Vec3& forward = motion_.tilt_about_tip ? along : axis;
    const Vec3& aside = motion_.tilt_about_tip ? motion_.across : side;
    return needle_pose(motion_.entry + place.depth * forward + place.aside * aside, axis);
  }

 private:
  const io::ExperimentMotion& motion_;
  std::size_t next_ = 1;
};

PublishedComparison compare(const io::PublishedValue& published, const io::Experiment& experiment,
                            const ExperimentRun& run) {
  double sum = 0.0, highest = -std::numeric_limits<double>::infinity(), lowest = -highest, first = 0.0, last = 0.0;
  std::size_t count = 0;
  for (const ExperimentTick& tick : run.ticks) {
    if (!is_inside(published.window, tick)) continue;
    const double value = value_of(published.quantity, tick, experiment);
    if (!std::isfinite(value)) continue;
    if (count++ == 0) first = value;
    last = value;
    sum += value;
    highest = std::max(highest, value);
    lowest = std::min(lowest, value);
  }
  if (count == 0) {
    throw InputError(
        fmt::format("{}: the published value '{}' asks for a time or depth that the motion never reaches",
                    experiment.name, published.what));
  }
  PublishedComparison comparison{published};
  switch (published.aggregation) {
    case io::Aggregation::mean:
      comparison.found = sum / static_cast<double>(count);
      break;
    case io::Aggregation::highest:
      comparison.found = highest;
      break;
    case io::Aggregation::lowest:
      comparison.found = lowest;
      break;
    case io::Aggregation::first:
      comparison.found = first;
      break;
    case io::Aggregation::last:
      comparison.found = last;
      break;
  }
  comparison.agrees = std::abs(comparison.found - published.value) <= published.tolerance;
  return comparison;
}

// mm along the line: W of a tracking wall, its only diagnostic. A wall whose spring is slack is not shown.
double wall_of(const ExperimentTick& tick, const io::Experiment& experiment) {
  constexpr double slack = std::numeric_limits<double>::quiet_NaN();
  if (!tick.in_contact) return std::get<anatomy::TrackingWallSettings>(experiment.haptics.resistance).surface;
  if (!(tick.resistance > 0.0)) return slack;
  return tick.diagnostics[0];
}

Vec3 wall_place(const ExperimentTick& tick, const io::Experiment& experiment) {
  if (!tick.in_contact) return experiment.motion.entry;
  return tick.tip + (wall_of(tick, experiment) - tick.depth) * experiment.motion.direction;
}

Vec3 proxy_place(const ExperimentTick& tick) {
  if (!tick.in_contact) return tick.tip;
  return {tick.diagnostics[0], tick.diagnostics[1], tick.diagnostics[2]};
}

}  // namespace

io::Experiment load_experiment(const std::filesystem::path& file, const Progress& progress,
                               const std::function<void(const std::string&)>& note,
                               std::shared_ptr<const fem::ContactBody>* whole) {
  io::Experiment experiment = io::read_experiment(file);
  const io::ExperimentBody& body = experiment.body;
  if (body.patient.empty()) return experiment;
  anatomy::Case patient = io::load_case(body.patient, progress);
  patient.library = experiment.library;
  patient.description.needle = experiment.needle;
  patient.description.device = experiment.device;
  patient.description.haptics = experiment.haptics;
  NeedleMotion motion;
  for (const io::ExperimentPlace& place : experiment.motion.places)
    motion.push_back({.goal = MotionGoal::depth, .depth = place.depth});
  const StraightPath line = path_of_motion(patient, body.entry, body.target, motion);
  const auto report = [&](const std::string& text) {
    if (note) note(experiment.name + ": " + text);
  };
  for (const std::string& text : line.notes) report(text);
  const Vec3 along = line.path.direction();
  experiment.motion.lay_along(line.path.entry + line.surface * along, along);
  patient::prepare_body(patient, body.patient, line.path, progress, report, whole);
  experiment.patient = std::move(patient);
  return experiment;
}

anatomy::Case experiment_case(const io::Experiment& experiment) {
  if (experiment.patient) return *experiment.patient;
  if (!experiment.body.patient.empty())
    throw InputError(
        fmt::format("{}: its patient {} has not been loaded", experiment.name, experiment.body.patient.string()));
  anatomy::Case patient;
  patient.library = experiment.library;
  patient.tissues = tissues_of(experiment);
  if (std::holds_alternative<anatomy::VolumeProxySettings>(experiment.haptics.resistance))
    patient.ct = ct_of_tissues(patient);
  patient.description.name = experiment.name;
  patient.description.needle = experiment.needle;
  patient.description.device = experiment.device;
  patient.description.haptics = experiment.haptics;
  return patient;
}

anatomy::CtVolume ct_of_tissues(const anatomy::Case& patient) {
  anatomy::CtVolume ct(patient.tissues.grid, air_hounsfield);
  const auto hounsfield = patient.library.by_id(&anatomy::TissueProperties::hounsfield);
  std::transform(patient.tissues.voxels.begin(), patient.tissues.voxels.end(), ct.voxels.begin(),
                 [&](anatomy::TissueId id) { return static_cast<std::int16_t>(std::lround(hounsfield[id])); });
  return ct;
}

ExperimentRun play(const io::Experiment& experiment, const Progress& progress,
                   std::shared_ptr<const fem::ContactBody> whole) {
  anatomy::Case patient = experiment_case(experiment);
  give_body(experiment, progress, patient, whole);
  simulation::HapticTick tick(patient);
  std::unique_ptr<fem::ContactStream> points;  // of the lines along which the motion moves the needle
  if (whole != nullptr && tick.body() != nullptr) {
    points = patient::contact_stream(patient, patient.prepared.path.length(), std::move(whole),
                                     tick.body()->stream_points(simulation::BodyPort::PointTiming::in_time));
  }
  Mover mover(experiment.motion);
  ExperimentRun run;
  run.dt = tick.dt();
  const double duration = experiment.motion.places.back().time;
  const auto count = static_cast<std::size_t>(std::floor(duration / run.dt + 1e-6)) + 1;
  run.ticks.reserve(count);
  for (std::size_t n = 0; n < count; ++n) {
    const io::ExperimentPlace place = mover.at(static_cast<double>(n) * run.dt);
    const Pose pose = mover.pose(place);
    const simulation::TickOutput output = tick.step({pose});
    run.ticks.push_back({.time = place.time,
                         .depth = output.depth,
                         .velocity = output.velocity,
                         .resistance = output.resistance,
                         .constraint = output.constraint,
                         .aside = place.aside,
                         .tilt = place.tilt,
                         .tip = pose.translation(),
                         .requested = output.requested,
                         .applied = output.applied,
                         .diagnostics = output.diagnostics,
                         .tissue = output.tissue,
                         .in_contact = output.in_contact});
    if (progress && n % (count / 16 + 1) == 0)
      progress(experiment.name, static_cast<double>(n) / static_cast<double>(count));
  }
  if (points != nullptr) points->throw_failure();
  for (const io::PublishedValue& value : experiment.values)
    run.comparisons.push_back(compare(value, experiment, run));
  return run;
}

bool is_inside(const io::ExperimentWindow& window, const ExperimentTick& tick) {
  const auto above = [](const std::optional<double>& low, double value) { return !low || value >= *low; };
  const auto below = [](const std::optional<double>& high, double value) { return !high || value <= *high; };
  const bool deep = window.depth_from || window.depth_to;
  return above(window.time_from, tick.time + same_time) && below(window.time_to, tick.time - same_time) &&
         (!deep || tick.in_contact) && above(window.depth_from, tick.depth) && below(window.depth_to, tick.depth);
}

double value_of(io::Quantity quantity, const ExperimentTick& tick, const io::Experiment& experiment) {
  switch (quantity) {
    case io::Quantity::time:
      return tick.time;
    case io::Quantity::depth:
      return tick.depth;
    case io::Quantity::position:
      return (tick.tip - experiment.motion.entry).dot(experiment.motion.direction);
    case io::Quantity::velocity:
      return tick.velocity;
    case io::Quantity::resistance:
      return tick.resistance;
    case io::Quantity::force:
      return tick.requested.force.norm();
    case io::Quantity::force_x:
      return tick.requested.force.x();
    case io::Quantity::force_y:
      return tick.requested.force.y();
    case io::Quantity::force_z:
      return tick.requested.force.z();
    case io::Quantity::applied_force:
      return tick.applied.force.norm();
    case io::Quantity::constraint:
      return tick.constraint;
    case io::Quantity::torque:
      return tick.requested.torque.norm();
    case io::Quantity::applied_torque:
      return tick.applied.torque.norm();
    case io::Quantity::tip_x:
      return tick.tip.x();
    case io::Quantity::tip_y:
      return tick.tip.y();
    case io::Quantity::tip_z:
      return tick.tip.z();
    case io::Quantity::aside:
      return tick.aside;
    case io::Quantity::tilt:
      return tick.tilt / degree;
    case io::Quantity::wall:
      return wall_of(tick, experiment);
    case io::Quantity::wall_x:
      return wall_place(tick, experiment).x();
    case io::Quantity::wall_y:
      return wall_place(tick, experiment).y();
    case io::Quantity::wall_z:
      return wall_place(tick, experiment).z();
    case io::Quantity::proxy_x:
      return proxy_place(tick).x();
    case io::Quantity::proxy_y:
      return proxy_place(tick).y();
    case io::Quantity::proxy_z:
      return proxy_place(tick).z();
  }
  return 0.0;
}

std::string experiment_csv(const io::Experiment& experiment, const ExperimentRun& run) {
  std::string text;
  for (std::size_t i = 0; i < static_cast<std::size_t>(io::Quantity::wall); ++i)
    fmt::format_to(std::back_inserter(text), "{},", io::quantity_names[i].name);
  text += "tissue\n";
  for (const ExperimentTick& tick : run.ticks) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(io::Quantity::wall); ++i)
      fmt::format_to(std::back_inserter(text), "{:.6f},",
                     value_of(static_cast<io::Quantity>(i), tick, experiment) + 0.0);
    const anatomy::TissueProperties* tissue = experiment.library.find(tick.tissue);
    fmt::format_to(std::back_inserter(text), "{}\n", tissue != nullptr ? tissue->name : std::to_string(tick.tissue));
  }
  return text;
}

}  // namespace bodkin::study
