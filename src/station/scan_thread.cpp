#include "station/scan_thread.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "core/settings_check.h"
#include "imaging/warped_slice.h"

namespace bodkin::station {

namespace {

using PictureClock = std::chrono::steady_clock;

constexpr double field_spacing = 2.0;  // mm between the points at which tissue's motion is sampled
constexpr double press_fades = 20.0;   // mm beside the slice, beyond which a probe's layers press nothing

double checked_scan_rate(double rate) {
  check_range("live ultrasound", "rate", rate, {1.0, 1000.0}, "Hz");
  return rate;
}

double farthest(std::span<const float> moved) {
  double most = 0.0;
  for (std::size_t i = 0; i + 2 < moved.size(); i += 3)
    most = std::max(most, static_cast<double>(std::hypot(moved[i], moved[i + 1], moved[i + 2])));
  return most;
}

}  // namespace

ScanThread::ScanThread(std::shared_ptr<const imaging::AcousticVolume> patient, imaging::Ultrasound machine,
                       const anatomy::Needle& needle, ScanBody body, const ScanSetup& first, double rate)
    : machine_(std::move(machine)),
      needle_(needle),
      body_(std::move(body)),
      slice_(body_.mesh == nullptr ? nullptr : std::make_unique<SliceField>(body_.mesh)),
      layers_(body_.moves || (body_.by_forces == nullptr && !body_.breath && body_.left.needles() == 0)
                  ? std::nullopt
                  : std::optional<CompressedLayers>(std::in_place, std::move(patient), machine_.probe())),
      left_places_(body_.mesh == nullptr || body_.left.needles() == 0
                       ? std::vector<fem::PointInMesh>()
                       : fem::find_points(body_.mesh->mesh, body_.left.points())),
      left_moved_(3 * body_.left.points().size(), 0.0F),
      left_seen_(body_.left.needles(), imaging::NeedleInUltrasound{Pose::Identity(), needle}),
      setups_(first),
      thread_([this, pace = checked_scan_rate(rate)](const std::stop_token& stop) { run(stop, pace); }) {}

void ScanThread::set_displacements(std::span<const float> nodes, std::span<const std::uint32_t> held) {
  reported_.assign(nodes.begin(), nodes.end());
  nodes_.write(reported_);
  if (std::ranges::equal(held, reported_held_)) return;
  reported_held_.assign(held.begin(), held.end());
  held_.write(reported_held_);
}

void ScanThread::run(const std::stop_token& stop, double rate) {
  const auto interval = std::chrono::duration_cast<PictureClock::duration>(std::chrono::duration<double>(1.0 / rate));
  LiveImage now;
  auto next = PictureClock::now();
  while (!stop.stop_requested()) {
    const auto begin = PictureClock::now();
    make(now);
    now.milliseconds = std::chrono::duration<double, std::milli>(PictureClock::now() - begin).count();
    ++now.number;
    pictures_.write(now);
    next += interval;
    const auto time = PictureClock::now();
    if (next < time) next = time;  // a machine that is too slow shows fewer pictures, not a queue of old ones
    std::this_thread::sleep_until(next);
  }
}

void ScanThread::make(LiveImage& now) {
  now.setup = setups_.read();
  const Tick& tick = ticks_.read();
  if (wanted_ != now.setup.settings) {
    wanted_ = now.setup.settings;
    now.refused = false;
    try {
      machine_.set(*wanted_);
    } catch (const InputError&) {  // an impossible setting: the image keeps the previous one
      now.refused = true;
    }
  }
  now.setup.settings = machine_.settings();
  std::optional<imaging::NeedleInUltrasound> needle;
  now.needle.reset();
  if (tick.published) {
    now.needle = tick.needle;
    needle = imaging::NeedleInUltrasound{tick.needle, needle_};
  }
  // As in the needle's tick: the image is that of a probe and a needle in the tissue, which has moved away from them
  // by its motion at the probe.
  probe_ = now.setup.probe;
  carried_.setZero();
  if (body_.breath && probe_.matrix().allFinite()) {
    probe_.translation() = body_.breath->material(now.setup.probe.translation(), tick.drawn_in);
    carried_ = now.setup.probe.translation() - probe_.translation();
    if (needle) needle->pose.translation() -= carried_;
  }
  std::optional<imaging::ScanDisplacement> displacement;
  if ((slice_ != nullptr || body_.breath) && probe_.matrix().allFinite()) {
    // Only a picture shows the size that these settings give.
    if (now.setup.settings.depth != depth_) now.frame = machine_.image(probe_);
    depth_ = now.setup.settings.depth;
    move_tissue(now, tick);
    displacement = now.grid;
    displacement->moved = now.moved;
  }
  if (!left_seen_.empty() && probe_.matrix().allFinite()) {
    if (!displacement && layers_) layers_->settle(probe_, now.setup.settings.depth, now.setup.settings.gel);
    move_left_needles(now, tick.drawn_in);
  }
  now.frame = machine_.image(probe_, needle, displacement, left_seen_);
}

// mm, displacement by the probe's layers of what would otherwise be at `place` (LPS, as in probe_).
Vec3 ScanThread::by_layers(const Vec3& place) const {
  constexpr int rounds = 8;  // CompressedLayers maps from a place to its tissue, not from tissue to its place
  const Pose into_probe = probe_.inverse(Eigen::Isometry);
  Vec3 moved = Vec3::Zero();
  for (int round = 0; round < rounds; ++round) {
    const Vec3 now = into_probe * (place + moved);
    moved = std::max(0.0, 1.0 - std::abs(now.z()) / press_fades) * layers_->moved(now);
  }
  return moved;
}

// For the tissue of this image.
void ScanThread::move_left_needles(LiveImage& now, double drawn_in) {
  const std::vector<Vec3>& points = body_.left.points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    Vec3 moved = Vec3::Zero();
    for (std::size_t corner = 0; corner < 4 && !left_places_.empty(); ++corner) {
      const std::size_t node = left_places_[i].nodes[corner];
      moved += left_places_[i].weights[corner] *
               Eigen::Map<const Eigen::Vector3f>(moved_.data() + 3 * node).cast<double>();
    }
    if (layers_) moved += by_layers(points[i] + body_.left.breathed(i, drawn_in) + moved - carried_);
    Eigen::Map<Eigen::Vector3f>(left_moved_.data() + 3 * i) = moved.cast<float>();
  }
  now.left = body_.left.poses(left_moved_, drawn_in);
  for (std::size_t i = 0; i < left_seen_.size(); ++i) {
    left_seen_[i].pose = now.left[i];
    left_seen_[i].pose.translation() -= carried_;
  }
}

// The probe's effect added to the needle's: both are small.
void ScanThread::add_layers(LiveImage& now, const imaging::SlicePlane& grid) {
  layers_->settle(probe_, now.setup.settings.depth, now.setup.settings.gel);
  if (!layers_->pressed()) return;
  float* moved = now.moved.data();
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column, moved += 3) {
      const Vec3 place = now.frame.corner + grid.pixel * Vec3(column, row, 0.0);
      Eigen::Map<Eigen::Vector3f>{moved} += layers_->moved(place).cast<float>();
    }
  }
}

// Displacement of the tissue in the image by breath, minus that at the probe.
void ScanThread::add_breath(LiveImage& now, const imaging::SlicePlane& grid, double drawn_in) const {
  float* moved = now.moved.data();
  for (const Vec3& point : imaging::points_of(grid)) {
    const Vec3 place = point + carried_;
    const Vec3 by = place - body_.breath->material(place, drawn_in) - carried_;
    Eigen::Map<Eigen::Vector3f>{moved} += by.cast<float>();
    moved += 3;
  }
}

void ScanThread::move_tissue(LiveImage& now, const Tick& tick) {
  const imaging::SlicePlane grid = imaging::warp_grid(plane_of_frame(now.frame, probe_), field_spacing);
  now.left_out = 0.0;
  if (slice_ == nullptr) {
    now.moved.assign(3 * static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height), 0.0F);
  } else {
    move_body(now, grid, tick.forces);
  }
  if (body_.breath) add_breath(now, grid, tick.drawn_in);
  now.most = farthest(now.moved);
  if (layers_) add_layers(now, grid);
  now.grid = {now.frame.corner, grid.pixel, grid.width, grid.height, {}};
}

void ScanThread::move_body(LiveImage& now, const imaging::SlicePlane& grid, const fem::NodeForces& forces) {
  moved_.assign(3 * body_.mesh->mesh.nodes.size(), 0.0F);
  const auto add = [this](std::span<const float> nodes) {
    if (nodes.size() != moved_.size()) return;  // nothing was published yet
    for (std::size_t i = 0; i < moved_.size(); ++i) moved_[i] += nodes[i];
  };
  if (body_.by_forces != nullptr) {
    if (held_.is_fresh()) body_.by_forces->hold(held_.read());
    add(body_.by_forces->evaluate(forces));
    now.left_out = body_.by_forces->left_out(forces);
  }
  if (body_.moves) add(nodes_.read());
  now.moved = imaging::displacements_of_places(grid, slice_->displacements(grid, moved_));
}

}  // namespace bodkin::station
