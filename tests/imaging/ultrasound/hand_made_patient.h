#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "core/geometry.h"
#include "imaging/ultrasound/ultrasound.h"

// Hand-made patients with known numbers, and images whose pixels are samples.
namespace bodkin::checks {

using namespace bodkin::anatomy;
using namespace bodkin::imaging;

// A box of voxels about the middle of a face at (0, 0, 0) that looks along y: pose identity lays the probe on a skin
// at y = 0.
struct Block {
  double half_width = 25.0;           // mm along x, both sides
  double above = 5.0;                 // mm of air before the skin
  double depth = 52.0;                // mm behind it
  double half_thickness = 2.0;        // mm along z, both sides
  double voxel = 0.5;                 // mm
  Mat3 direction = Mat3::Identity();  // of the lattice, turned about the box's middle
};

// Soft tissue that matches the probe, without attenuation or scatter: the only echoes are those added.
inline AcousticTissue clear_medium(double impedance = 1.6, double attenuation = 0.0) {
  AcousticTissue medium;
  medium.impedance = impedance;
  medium.attenuation = attenuation;
  medium.echo = -200.0;
  return medium;
}

inline std::int16_t impedance_steps(double impedance) {
  return static_cast<std::int16_t>(std::min(32767.0, impedance / AcousticVolume::unit + 0.5));
}

// The tissue id of media[n] is n + 1, air is 0. `where(point)` gives the id behind the skin.
template <typename Where>
std::shared_ptr<AcousticVolume> hand_made(const Block& block, const std::vector<AcousticTissue>& media,
                                          Where&& where) {
  auto volume = std::make_shared<AcousticVolume>();
  const auto count = [&block](double length) { return static_cast<int>(std::lround(length / block.voxel)) + 1; };
  Grid& grid = volume->grid;
  grid.size = {count(2.0 * block.half_width), count(block.above + block.depth), count(2.0 * block.half_thickness)};
  grid.spacing = Vec3::Constant(block.voxel);
  grid.direction = block.direction;
  const Vec3 middle(0.0, 0.5 * (block.depth - block.above), 0.0);
  grid.origin = middle - block.direction *
                             (Vec3(0.0, middle.y(), 0.0) + Vec3(block.half_width, block.above, block.half_thickness));
  volume->media[0] = clear_medium(0.0004, 12.0);
  for (std::size_t n = 0; n < media.size(); ++n) volume->media[n + 1] = media[n];
  volume->voxels.reserve(grid.voxel_count());
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const Vec3 point = grid.to_patient(Vec3(i, j, k));
        const auto id = static_cast<TissueId>(point.y() < -1e-6 ? 0 : where(point));
        volume->voxels.push_back(AcousticVolume::voxel(impedance_steps(volume->media[id].impedance), id));
      }
    }
  }
  return volume;
}

// Homogeneous behind the skin.
inline std::shared_ptr<AcousticVolume> hand_made(const Block& block, const AcousticTissue& medium) {
  return hand_made(block, {medium}, [](const Vec3&) { return 1; });
}

inline UltrasoundProbe flat_probe() {
  return {.name = "L", .frequency = 5.0, .lowest = 2.0, .highest = 12.0, .elements = 128, .pitch = 0.3125};
}

inline UltrasoundProbe curved_probe() {
  return {.name = "C",
          .kind = ProbeKind::curvilinear,
          .frequency = 3.5,
          .lowest = 2.0,
          .highest = 5.0,
          .elements = 128,
          .pitch = 0.35,
          .radius = 50.0,
          .height = 10.0,
          .lens = 60.0};
}

inline UltrasoundProbe phased_probe() {
  return {.name = "P",
          .kind = ProbeKind::phased,
          .frequency = 3.0,
          .lowest = 2.0,
          .highest = 5.0,
          .elements = 64,
          .pitch = 0.3,
          .sector = 90.0,
          .height = 12.0,
          .lens = 60.0};
}

// The picture of a linear probe's 40 mm whose pixels are its samples, `spacing` mm apart both ways, with only echoes
// of surfaces.
inline UltrasoundDetail plain_detail(double depth, double spacing = 0.25, double width = 40.0) {
  UltrasoundDetail detail = paper_detail();
  detail.lines = detail.width = static_cast<int>(std::lround(width / spacing)) + 1;
  detail.samples = detail.height = static_cast<int>(std::lround(depth / spacing)) + 1;
  return detail;
}

// dB/cm/MHz, one way, for which the machine compensates by itself.
inline constexpr double compensated = 0.7;

// dB of the machine's own compensation at a depth.
inline double compensation(double frequency, double depth) {
  return std::min(60.0, 2.0 * compensated * frequency * depth / 10.0);
}

// A pixel's level in dB below white; what is black or white is out of range.
inline double decibels(const UltrasoundFrame& frame, double dynamic_range, int column, int row) {
  const auto at =
      static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.width) + static_cast<std::size_t>(column);
  return (frame.pixels[at] / 255.0 - 1.0) * dynamic_range;
}

inline double amplitude(const UltrasoundFrame& frame, double dynamic_range, int column, int row) {
  return std::pow(10.0, decibels(frame, dynamic_range, column, row) / 20.0);
}

inline double in_decibels(double ratio) {
  return 20.0 * std::log10(std::abs(ratio));
}

inline Pose moved_to(const Vec3& point) {
  Pose pose = Pose::Identity();
  pose.translation() = point;
  return pose;
}

}  // namespace bodkin::checks
