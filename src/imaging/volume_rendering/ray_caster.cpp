#include "imaging/volume_rendering/ray_caster.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <tuple>

#include "imaging/volume_rendering/ray_kernel.h"

namespace bodkin::imaging {

namespace {

constexpr int scale_size = 4096;        // HU
constexpr int scale_from = -1024;       // HU of the first row
constexpr double most_opacity = 0.999;  // of 1 mm: its optical depth is finite
constexpr double air_up_to = -900.0;    // HU without weight in a sum: else the noise of air would count
constexpr int tile = 16;                // pixels along each side: neighbouring rays share voxels
constexpr double light_from_right = -0.35, light_from_above = -0.45;  // beside the line of sight
const double length_of_light =
    std::sqrt(1.0 + light_from_right * light_from_right + light_from_above * light_from_above);

void append_row(std::vector<float>& table, const std::array<double, 3>& colour) {
  for (const double part : colour) table.push_back(static_cast<float>(part));
  table.push_back(0.0F);
}

std::uint32_t byte_of(float share) {
  return static_cast<std::uint32_t>(std::clamp(share, 0.0F, 1.0F) * 255.0F + 0.5F);
}

// Turns a set of blocks (0) into each block's distance from the nearest one, the largest of the three directions, in
// two sweeps.
void find_distances(std::vector<std::uint8_t>& away, const std::array<int, 3>& size) {
  const auto sweep = [&](int sign) {
    const auto order = [&](int index, int count) { return sign > 0 ? index : count - 1 - index; };
    for (int c = 0; c < size[2]; ++c) {
      for (int b = 0; b < size[1]; ++b) {
        for (int a = 0; a < size[0]; ++a) {
          const int i = order(a, size[0]), j = order(b, size[1]), k = order(c, size[2]);
          const int in_order = (k * size[1] + j) * size[0] + i;
          std::uint8_t& here = away[static_cast<std::size_t>(in_order)];
          // The thirteen neighbours already visited by this sweep.
          for (int n = 0; n < 13 && here > 0; ++n) {
            const int di = n % 3 - 1, dj = n / 3 % 3 - 1, dk = n / 9 - 1;
            const int ni = i + sign * di, nj = j + sign * dj, nk = k + sign * dk;
            if (ni < 0 || nj < 0 || nk < 0 || ni >= size[0] || nj >= size[1] || nk >= size[2]) continue;
            const int neighbour = (nk * size[1] + nj) * size[0] + ni;
            const std::uint8_t there = away[static_cast<std::size_t>(neighbour)];
            here = std::min(here, static_cast<std::uint8_t>(std::min(there + 1, 255)));
          }
        }
      }
    }
  };
  sweep(1);
  sweep(-1);
}

}  // namespace

double step_of(const PreparedVolume& volume, double voxels) {
  return voxels * volume.grid.spacing.minCoeff();
}

RayCaster::RayCaster(std::shared_ptr<const PreparedVolume> volume, const VolumeLook& look, double step)
    : volume_(std::move(volume)),
      look_(look),
      step_(step),
      index_from_mm_(volume_->grid.spacing.cwiseInverse().asDiagonal() * volume_->grid.direction.transpose()),
      index_of_origin_(volume_->to_index(Vec3::Zero())) {
  depth_.resize(scale_size);
  for (std::vector<float>& table : shown_) table.reserve(scale_size);
  colours_.reserve(4 * scale_size);
  for (int row = 0; row < scale_size; ++row) {
    const double hounsfield = row + scale_from;
    const double opacity = std::clamp(look.transfer.opacity_at(hounsfield), 0.0, most_opacity);
    const bool sums = look.mode == VolumeMode::sum;
    const double depth =
        sums ? (hounsfield < air_up_to ? 0.0 : 0.001 * (hounsfield + 1000.0)) : -std::log1p(-opacity);
    depth_[static_cast<std::size_t>(row)] = static_cast<float>(depth);
    std::array<double, 3> colour = look.transfer.colour_at(hounsfield);
    if (look.mode == VolumeMode::grey) {
      // Never quite black: opaque parts can be told from the background.
      colour.fill(std::clamp((hounsfield - look.level) / look.window + 0.5, 0.06, 1.0));
    }
    append_row(colours_, colour);
    double passed = std::exp(-depth * step);
    for (std::vector<float>& table : shown_) {
      table.push_back(static_cast<float>(1.0 - passed));
      passed *= passed;
    }
  }
  if (look.mode == VolumeMode::colour && look.tissue_colours && !volume_->tissues.empty()) {
    for (const std::uint32_t colour : look.tissues) {
      append_row(tissue_colours_,
                 {(colour >> 16U & 0xFFU) / 255.0, (colour >> 8U & 0xFFU) / 255.0, (colour & 0xFFU) / 255.0});
    }
  }
  find_skips();
}

void RayCaster::find_skips() {
  away_.assign(volume_->ranges.size(), 0);
  if (look_.mode == VolumeMode::maximum) return;
  // Number of visible HU up to each row: a range contains some if its ends differ.
  std::vector<int> shown(scale_size + 1, 0);
  for (std::size_t row = 0; row < scale_size; ++row) shown[row + 1] = shown[row] + (depth_[row] > 0.0F ? 1 : 0);
  for (std::size_t i = 0; i < away_.size(); ++i) {
    const PreparedVolume::Range& range = volume_->ranges[i];
    const auto low = static_cast<std::size_t>(range.least - scale_from);
    const auto high = static_cast<std::size_t>(range.most - scale_from);
    away_[i] = shown[high + 1] > shown[low] ? 0 : 255;
  }
  find_distances(away_, volume_->blocks);
}

void RayCaster::skip_nothing() {
  std::fill(away_.begin(), away_.end(), std::uint8_t{0});
}

void RayCaster::set_moved(const RestOffsets* moved) {
  moved_.clear();
  moved_blocks_ = 0;
  if (moved == nullptr) return;
  moved_lattice_ = moved->lattice;
  moved_.reserve(moved->offsets.size() / 3 * 4);
  double most = 0.0;
  for (std::size_t i = 0; i + 2 < moved->offsets.size(); i += 3) {
    const Vec3 offset = index_from_mm_ * Eigen::Map<const Eigen::Vector3f>(moved->offsets.data() + i).cast<double>();
    most = std::max(most, offset.cwiseAbs().maxCoeff());
    for (int axis = 0; axis < 3; ++axis) moved_.push_back(static_cast<float>(offset[axis]));
    moved_.push_back(0.0F);
  }
  moved_blocks_ = static_cast<int>(std::ceil(std::min(most / PreparedVolume::block, 255.0)));
}

CastRay RayCaster::cast(const Vec3& eye, const Vec3& direction, double until, bool far_apart) const {
  const PreparedVolume& volume = *volume_;
  const Vec3 from = index_from_mm_ * eye + index_of_origin_;
  const Vec3 speed = index_from_mm_ * direction;
  Vec3 until_next;
  double enters = 0.0, leaves = until;
  for (int axis = 0; axis < 3; ++axis) {
    // The outermost voxels extend half a voxel beyond their centres.
    const double low = 0.5, high = volume.grid.size[static_cast<std::size_t>(axis)] + 0.5;
    if (std::abs(speed[axis]) < 1e-12) {
      if (from[axis] < low || from[axis] > high) return {};
      until_next[axis] = std::copysign(1e12, speed[axis] > 0.0 ? 1.0 : -1.0);
      continue;
    }
    until_next[axis] = 1.0 / speed[axis];
    const double a = (low - from[axis]) * until_next[axis], b = (high - from[axis]) * until_next[axis];
    enters = std::max(enters, std::min(a, b));
    leaves = std::min(leaves, std::max(a, b));
  }
  const double length = leaves - enters;
  if (!(length > 1e-6 * step_)) return {};
  kernel::RaySection section;
  section.samples = std::max(1, static_cast<int>(std::ceil(length / step_ - 1e-6)));
  const double before = (section.samples - 1) * step_;
  section.last = static_cast<float>(length - before);
  section.last_at = static_cast<float>(before + 0.5 * (length - before));
  section.far_apart = far_apart;
  const Vec3 entry = from + enters * speed;
  // The light is beside the viewer, above the shoulder.
  Vec3 side(direction.y(), -direction.x(), 0.0);  // direction x UnitZ
  const double across = std::hypot(side.x(), side.y());
  side = across < 1e-3 ? Vec3(Vec3::UnitX()) : Vec3(side / across);
  const Vec3 light = -direction - light_from_above * side.cross(direction) + light_from_right * side;
  const Vec3 light_along = volume.grid.direction.transpose() * (light / length_of_light);
  for (int axis = 0; axis < 3; ++axis) {
    section.entry[axis] = static_cast<float>(entry[axis]);
    section.direction[axis] = static_cast<float>(speed[axis]);
    section.until_next[axis] = static_cast<float>(until_next[axis]);
    section.light[axis] = static_cast<float>(light_along[axis]);
  }
  kernel::Field field;
  field.hounsfield = volume.hounsfield.data();
  field.tissues = tissue_colours_.empty() ? nullptr : volume.tissues.data();
  field.gradients = look_.shaded ? volume.gradients.data()->data() : nullptr;
  field.away = away_.data();
  field.ranges = &volume.ranges.data()->least;
  for (std::size_t a = 0; a < 3; ++a) {
    field.size[a] = volume.size[a];
    field.blocks[a] = volume.blocks[a];
  }
  field.depth = depth_.data();
  field.colours = colours_.data();
  static_assert(kernel::step_lengths == std::tuple_size_v<decltype(shown_)>);
  for (std::size_t table = 0; table < shown_.size(); ++table) field.shown[table] = shown_[table].data();
  field.tissue_colours = tissue_colours_.data();
  field.step = static_cast<float>(step_);
  if (!moved_.empty()) {
    field.moved = moved_.data();
    field.moved_spacing = static_cast<float>(moved_lattice_.spacing);
    field.moved_blocks = moved_blocks_;
    const Vec3 entry_place = (eye + enters * direction - moved_lattice_.corner) / moved_lattice_.spacing;
    for (int axis = 0; axis < 3; ++axis) {
      field.moved_size[axis] = moved_lattice_.size[static_cast<std::size_t>(axis)];
      section.lattice_entry[axis] = static_cast<float>(entry_place[axis]);
      section.lattice_direction[axis] = static_cast<float>(direction[axis] / moved_lattice_.spacing);
    }
  }
  kernel::RayResult result;
  switch (look_.mode) {
    case VolumeMode::colour:
    case VolumeMode::grey:
      field.moved != nullptr ? kernel::cast_moved_light(field, section, result)
                             : kernel::cast_light(field, section, result);
      break;
    case VolumeMode::maximum:
      kernel::cast_maximum(field, section, result);
      break;
    case VolumeMode::sum:
      kernel::cast_sum(field, section, result);
      break;
  }
  return {result.red, result.green, result.blue, result.opacity, result.most, result.sum};
}

std::uint32_t RayCaster::colour(const CastRay& ray) const {
  if (look_.mode == VolumeMode::maximum || look_.mode == VolumeMode::sum) {
    double share = 0.0;
    if (ray.opacity > 0.0F) {
      share = look_.mode == VolumeMode::maximum ? (static_cast<double>(ray.most) - look_.level) / look_.window + 0.5
                                                : look_.brightness * static_cast<double>(ray.sum) / volume_->thickest;
    }
    const std::uint32_t grey = byte_of(static_cast<float>(share));
    return 0xFF000000U | grey << 16U | grey << 8U | grey;
  }
  const float left = 1.0F - ray.opacity;
  const auto over = [&](float light, unsigned shift) {
    return byte_of(light + left * static_cast<float>(look_.background >> shift & 0xFFU) / 255.0F) << shift;
  };
  return 0xFF000000U | over(ray.red, 16U) | over(ray.green, 8U) | over(ray.blue, 0U);
}

bool RayCaster::draw(const VolumeCamera& camera, ThreadPool& pool, std::vector<std::uint32_t>& pixels,
                     const std::function<bool()>& cancelled) const {
  const int columns = (camera.width + tile - 1) / tile, rows = (camera.height + tile - 1) / tile;
  pixels.resize(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height));
  std::atomic<bool> stopped = false;
  pool.run(columns * rows, [&](int index) {
    if (stopped.load(std::memory_order_relaxed)) return;
    if (cancelled && cancelled()) return stopped.store(true, std::memory_order_relaxed);
    const int left = index % columns * tile, top = index / columns * tile;
    for (int y = top; y < std::min(top + tile, camera.height); ++y) {
      for (int x = left; x < std::min(left + tile, camera.width); ++x) {
        const Vec3 direction = (camera.first + x * camera.right + y * camera.down).normalized();
        pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(camera.width) + static_cast<std::size_t>(x)] =
            colour(cast(camera.eye, direction, 1e9));
      }
    }
  });
  return !stopped.load();
}

}  // namespace bodkin::imaging
