#include "report/cut_open_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/thread_pool.h"
#include "imaging/volume_rendering/ray_caster.h"

namespace bodkin::report {

namespace {

constexpr double least_reach = 55.0;                        // mm shown about the path's middle
constexpr double relative_reach = 0.9;                      // the same over the length of the path
constexpr double opening = 2.0 / 3.0;                       // of the distance: half of the visible extent
constexpr double from_the_front = 0.45, from_above = 0.35;  // tilt of the eye out of the cut's normal
constexpr double pixels_for_px = 1.5;
constexpr std::uint32_t ground = 0x0E1116, planned = 0x2DE0BE, tip_ink = 0x4DA3FF, path_end = 0xFFFFFF,
                        probe_colour = 0xFFB547;

// The lattice's axis most perpendicular to the path and most lateral.
int side_axis(const anatomy::Grid& grid, const Vec3& along) {
  int best = 0;
  double most = -1.0;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 direction = grid.direction.col(axis);
    const double across = (1.0 - std::abs(direction.dot(along))) * (1.0 + 0.5 * std::abs(direction.x()));
    if (across > most) {
      most = across;
      best = axis;
    }
  }
  return best;
}

template <typename Voxel>
anatomy::Volume<Voxel> cropped(const anatomy::Volume<Voxel>& volume, const std::array<int, 3>& low,
                               const std::array<int, 3>& high) {
  anatomy::Grid grid = volume.grid;
  grid.origin = volume.grid.to_patient(Vec3(low[0], low[1], low[2]));
  for (std::size_t axis = 0; axis < 3; ++axis) grid.size[axis] = high[axis] - low[axis] + 1;
  anatomy::Volume<Voxel> part(grid);
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      const auto from =
          volume.voxels.begin() + static_cast<std::ptrdiff_t>(volume.grid.offset(low[0], low[1] + j, low[2] + k));
      std::copy_n(from, grid.size[0], part.voxels.begin() + static_cast<std::ptrdiff_t>(grid.offset(0, j, k)));
    }
  }
  return part;
}

// A pinhole camera and its projection of a point.
struct Eye {
  Vec3 place, forwards, right, down;  // unit directions
  double pitch = 0.0;                 // of a pixel at a distance of 1
  int width = 0, height = 0;          // pixels

  imaging::VolumeCamera camera() const {
    imaging::VolumeCamera seen;
    seen.eye = place;
    seen.right = pitch * right;
    seen.down = pitch * down;
    seen.first = forwards - 0.5 * (width - 1) * seen.right - 0.5 * (height - 1) * seen.down;
    seen.width = width;
    seen.height = height;
    return seen;
  }
  Eigen::Vector2d pixel_of(const Vec3& point) const {
    const Vec3 offset = point - place;
    const double ahead = pitch * offset.dot(forwards);
    return {offset.dot(right) / ahead + 0.5 * width, offset.dot(down) / ahead + 0.5 * height};
  }
};

// From the open side of the cut, slightly from the needle's side and from above, upright.
Eye eye_of(const Vec3& middle, const Vec3& open_side, const Vec3& along, double reach, int width, int height) {
  Eye eye;
  eye.width = width;
  eye.height = height;
  const Vec3 cranial = Vec3::UnitZ();
  const Vec3 upright = std::abs(open_side.dot(cranial)) < 0.7 ? cranial : Vec3(Vec3::UnitY());
  const Vec3 out = (open_side - from_the_front * along + from_above * upright).normalized();
  eye.place = middle + 3.0 * reach * out;
  eye.forwards = -out;
  eye.right = eye.forwards.cross(upright).normalized();
  eye.down = eye.forwards.cross(eye.right).normalized();
  eye.pitch = 2.0 * opening / (3.0 * height);
  return eye;
}

}  // namespace

imaging::Canvas cut_open_picture(const anatomy::Case& patient, const anatomy::NeedlePath& path,
                                 const std::vector<Vec3>& travelled, double width, double height,
                                 const ProbePath& probe) {
  const anatomy::Grid& grid = patient.ct.grid;
  const Vec3 middle = 0.5 * (path.entry + path.target), along = path.direction();
  const double reach = std::max(least_reach, relative_reach * path.length());
  const int side = side_axis(grid, along);

  // The box about the path, without the open side of the cut.
  const Vec3 centre = grid.to_index(middle);
  std::array<int, 3> low{}, high{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<std::size_t>(axis);
    const double half = 1.3 * reach / grid.spacing[axis];
    low[at] = std::clamp(static_cast<int>(std::floor(centre[axis] - half)), 0, grid.size[at] - 1);
    high[at] = std::clamp(static_cast<int>(std::ceil(centre[axis] + half)), low[at], grid.size[at] - 1);
  }
  const auto cut = static_cast<std::size_t>(side);
  Vec3 open_side = grid.direction.col(side);
  const bool opens_upwards = open_side.x() >= 0.0;  // the patient's left is removed
  const int at_path = std::clamp(static_cast<int>(std::lround(centre[side])), low[cut], high[cut]);
  if (opens_upwards) {
    high[cut] = at_path;
  } else {
    low[cut] = at_path;
    open_side = -open_side;
  }

  const bool has_tissues = same_lattice(grid, patient.tissues.grid);
  const anatomy::TissueVolume tissues = has_tissues ? cropped(patient.tissues, low, high) : anatomy::TissueVolume();
  const auto volume = std::make_shared<const imaging::PreparedVolume>(
      imaging::prepare_volume(cropped(patient.ct, low, high), tissues, patient.library));
  imaging::VolumeLook look;
  look.background = ground;
  const imaging::RayCaster caster(volume, look, imaging::step_of(*volume, 1.0));
  const Eye eye = eye_of(middle, open_side, along, reach, static_cast<int>(std::lround(pixels_for_px * width)),
                         static_cast<int>(std::lround(pixels_for_px * height)));
  ThreadPool pool;
  std::vector<std::uint32_t> pixels;
  caster.draw(eye.camera(), pool, pixels);
  imaging::ImageRgb image(eye.width, eye.height);
  std::transform(pixels.begin(), pixels.end(), image.pixels.begin(),
                 [](std::uint32_t pixel) { return imaging::rgb(pixel & 0xFFFFFFU); });

  imaging::Canvas canvas(width, height);
  canvas.image(std::move(image), 0.0, 0.0, width, height);
  const auto place = [&](const Vec3& point) { return Eigen::Vector2d(eye.pixel_of(point) / pixels_for_px); };
  const auto places = [&](const std::vector<Vec3>& points) {
    std::vector<Eigen::Vector2d> all;
    for (const Vec3& point : points) all.push_back(place(point));
    return all;
  };
  if (!probe.slice.empty()) {
    const imaging::Path slice = imaging::Path::polygon(places(probe.slice));
    canvas.fill(slice, {probe_colour, 0.12});
    canvas.stroke(slice, {probe_colour, 1.5});
  }
  if (!probe.face.empty()) {
    canvas.stroke(imaging::Path::polyline(places(probe.face)), {probe_colour, 3.0});
    canvas.fill(imaging::Path::circle(place(probe.face.back()), 4.0), probe_colour);
  }
  canvas.stroke(imaging::Path::segment(place(path.entry), place(path.target)), {planned, 2.0, {6.0, 4.0}});
  canvas.stroke(imaging::Path::circle(place(path.target), 7.0), {planned, 2.0});
  if (!travelled.empty()) {
    canvas.stroke(imaging::Path::polyline(places(travelled)), {tip_ink, 2.5});
    const auto deepest = std::max_element(travelled.begin(), travelled.end(), [&](const Vec3& a, const Vec3& b) {
      return (a - path.entry).dot(along) < (b - path.entry).dot(along);
    });
    canvas.fill(imaging::Path::circle(place(*deepest), 3.5), path_end);
  }
  const imaging::TextStyle words{.size = 12.0, .ink = 0xE9EDF2, .halo = true};
  if (!probe.face.empty())
    canvas.text({12.0, height - 60.0}, "probe: path of its face, with its slice",
                {.size = 12.0, .ink = probe_colour, .halo = true});
  canvas.text({12.0, height - 44.0}, "cut open along the planned path; bone as in the CT", words);
  canvas.text({12.0, height - 28.0}, "dashed: planned, with the target",
              {.size = 12.0, .ink = planned, .halo = true});
  canvas.text({12.0, height - 12.0}, "solid: path of the tip, dot at its deepest place",
              {.size = 12.0, .ink = tip_ink, .halo = true});
  return canvas;
}

}  // namespace bodkin::report
