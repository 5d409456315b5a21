#include "imaging/ct_scan.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace bodkin::imaging {

namespace {

constexpr double least_thickness = 0.5, most_thickness = 10.0, least_spacing = 0.5, most_spacing = 20.0;  // mm
constexpr int most_scan_pixels = 512;       // along each side
constexpr double metal = 20000.0;           // HU of steel before clipping by the scanner's scale
constexpr double faintest_needle = 1600.0;  // HU at least of a pixel crossed by the needle's middle

// The box around a lattice with the outer halves of its voxels, LPS mm.
PatientBox scan_box_of(const anatomy::Grid& grid) {
  PatientBox box{Vec3::Constant(1e9), Vec3::Constant(-1e9)};
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 index;
    for (int axis = 0; axis < 3; ++axis) {
      index[axis] = (corner >> axis & 1) != 0 ? grid.size[static_cast<std::size_t>(axis)] - 0.5 : -0.5;
    }
    box.low = box.low.cwiseMin(grid.to_patient(index));
    box.high = box.high.cwiseMax(grid.to_patient(index));
  }
  return box;
}

// mm between voxels along a patient's axis, by the lattice's axis closest to it.
double spacing_along(const anatomy::Grid& grid, int patient_axis) {
  int nearest = 0;
  grid.direction.row(patient_axis).cwiseAbs().maxCoeff(&nearest);
  return grid.spacing[nearest];
}

// For a rod of radius r and a square pixel of side s whose middle is `distance` mm from the rod's axis: the covered
// fraction, as if the pixel were as wide towards the rod.
double covered(double distance, double radius, double side) {
  const double overlap = std::min(distance + 0.5 * side, radius) - std::max(distance - 0.5 * side, -radius);
  return std::clamp(overlap / side, 0.0, 1.0);
}

double distance_to_rod(const Vec3& point, const Vec3& from, const Vec3& to) {
  const Vec3 along = to - from;
  const double share = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (point - from - share * along).norm();
}

// The needle's fraction of each pixel, averaged over the levels of a slice.
void add_needle(const ScannedNeedle& needle, const SlicePlane& plane, const std::vector<double>& levels,
                std::vector<float>& mean) {
  const Vec3 tip = needle.pose.translation(), hub = needle.hub();
  std::vector<float> share(mean.size(), 0.0F);
  const double reach = needle.radius + plane.pixel;
  for (const double level : levels) {
    // The piece of the needle near this level.
    const Vec3 along = tip - hub;
    double begin = 0.0, end = 1.0;
    if (std::abs(along.z()) > 1e-9) {
      const double a = (level - reach - hub.z()) / along.z(), b = (level + reach - hub.z()) / along.z();
      begin = std::max(begin, std::min(a, b));
      end = std::min(end, std::max(a, b));
    } else if (std::abs(hub.z() - level) > reach) {
      continue;
    }
    if (begin > end) continue;
    const Eigen::Vector2d p = plane.place(hub + begin * along), q = plane.place(hub + end * along);
    const double margin = reach / plane.pixel + 1.0;
    const int left = std::max(0, static_cast<int>(std::floor(std::min(p.x(), q.x()) - margin)));
    const int right = std::min(plane.width - 1, static_cast<int>(std::ceil(std::max(p.x(), q.x()) + margin)));
    const int top = std::max(0, static_cast<int>(std::floor(std::min(p.y(), q.y()) - margin)));
    const int bottom = std::min(plane.height - 1, static_cast<int>(std::ceil(std::max(p.y(), q.y()) + margin)));
    for (int row = top; row <= bottom; ++row) {
      for (int column = left; column <= right; ++column) {
        Vec3 point = plane.point(column, row);
        point.z() = level;
        const double part = covered(distance_to_rod(point, hub, tip), needle.radius, plane.pixel);
        share[static_cast<std::size_t>(row) * static_cast<std::size_t>(plane.width) +
              static_cast<std::size_t>(column)] += static_cast<float>(part / static_cast<double>(levels.size()));
      }
    }
  }
  for (std::size_t i = 0; i < mean.size(); ++i) {
    if (share[i] <= 0.0F) continue;
    const double mixed =
        static_cast<double>(mean[i]) + static_cast<double>(share[i]) * (metal - static_cast<double>(mean[i]));
    mean[i] = static_cast<float>(share[i] > 0.02F ? std::max(mixed, faintest_needle) : mixed);
  }
}

// Smoothing by (1 2 1) / 4 along rows and columns; `sharpen` adds the difference instead of removing it.
void filter(std::vector<float>& values, int width, int height, ScanKernel kernel) {
  if (kernel == ScanKernel::standard) return;
  std::vector<float> smooth = values, rows = values;
  const auto at = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      rows[at(x, y)] = 0.25F * (values[at(std::max(x - 1, 0), y)] + 2.0F * values[at(x, y)] +
                                values[at(std::min(x + 1, width - 1), y)]);
    }
  }
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      smooth[at(x, y)] = 0.25F * (rows[at(x, std::max(y - 1, 0))] + 2.0F * rows[at(x, y)] +
                                  rows[at(x, std::min(y + 1, height - 1))]);
    }
  }
  if (kernel == ScanKernel::soft) {
    values = smooth;
    return;
  }
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += 1.2F * (values[i] - smooth[i]);
}

}  // namespace

std::string trouble_with(const ScanProtocol& protocol) {
  if (!(protocol.thickness >= least_thickness && protocol.thickness <= most_thickness)) {
    return fmt::format("slice thickness is {:g} mm, expected {:g} to {:g} mm", protocol.thickness, least_thickness,
                       most_thickness);
  }
  if (!(protocol.spacing >= least_spacing && protocol.spacing <= most_spacing)) {
    return fmt::format("slice spacing is {:g} mm, expected {:g} to {:g} mm", protocol.spacing, least_spacing,
                       most_spacing);
  }
  if (!std::isfinite(protocol.from) || !std::isfinite(protocol.to)) return "the range is not a number; draw it again";
  return {};
}

std::vector<double> slice_positions(const ScanProtocol& protocol) {
  std::vector<double> positions;
  if (!trouble_with(protocol).empty()) return positions;
  const double length = protocol.to - protocol.from;
  const int count = static_cast<int>(std::floor(std::abs(length) / protocol.spacing + 1e-9)) + 1;
  for (int i = 0; i < count; ++i) positions.push_back(protocol.from + std::copysign(i * protocol.spacing, length));
  return positions;
}

SlicePlane scan_plane(const anatomy::Grid& grid) {
  const PatientBox box = scan_box_of(grid);
  const Vec3 size = box.high - box.low;
  SlicePlane plane;
  plane.pixel = std::max({std::min(spacing_along(grid, 0), spacing_along(grid, 1)), size.x() / most_scan_pixels,
                          size.y() / most_scan_pixels});
  plane.width = std::max(1, static_cast<int>(std::lround(size.x() / plane.pixel)));
  plane.height = std::max(1, static_cast<int>(std::lround(size.y() / plane.pixel)));
  plane.corner = box.low + Vec3(0.5 * plane.pixel, 0.5 * plane.pixel, 0.0);
  return plane;
}

ScanSlice take_slice(const anatomy::CtVolume& ct, const SlicePlane& plane, const ScanProtocol& protocol, double z,
                     const std::optional<ScannedNeedle>& needle) {
  // The mean over the thickness from samples closer together than voxels.
  const int count =
      std::clamp(static_cast<int>(std::ceil(2.0 * protocol.thickness / spacing_along(ct.grid, 2))), 2, 40);
  std::vector<double> levels;
  for (int i = 0; i < count; ++i) levels.push_back(z + protocol.thickness * ((i + 0.5) / count - 0.5));
  std::vector<float> mean(static_cast<std::size_t>(plane.width) * static_cast<std::size_t>(plane.height), 0.0F);
  for (const double level : levels) {
    std::size_t at = 0;
    for (int row = 0; row < plane.height; ++row) {
      Vec3 first = plane.point(0.0, row);
      first.z() = level;
      Vec3 index = ct.grid.to_index(first);
      const Vec3 step = ct.grid.to_index(first + plane.pixel * plane.right) - index;
      for (int column = 0; column < plane.width; ++column, index += step) {
        mean[at++] += static_cast<float>(anatomy::linear_at_index(ct, index, -1000.0) / count);
      }
    }
  }
  if (needle) add_needle(*needle, plane, levels, mean);
  filter(mean, plane.width, plane.height, protocol.kernel);
  ScanSlice slice;
  slice.z = z;
  slice.hounsfield.resize(mean.size());
  std::transform(mean.begin(), mean.end(), slice.hounsfield.begin(), [](float value) {
    const long rounded = std::lround(std::clamp(static_cast<double>(value), -1024.0, double{metal_hounsfield}));
    return static_cast<std::int16_t>(rounded);
  });
  return slice;
}

const ScanSlice* CtScan::slice_at(double z) const {
  const ScanSlice* nearest = nullptr;
  double distance = 0.5 * protocol.thickness + 1e-9;
  for (const ScanSlice& slice : slices) {
    if (std::abs(slice.z - z) > distance) continue;
    distance = std::abs(slice.z - z);
    nearest = &slice;
  }
  return nearest;
}

Vec3 CtScan::point(const ScanSlice& slice, double column, double row) const {
  Vec3 at = plane.point(column, row);
  at.z() = slice.z;
  return at;
}

ReformattedSlice reformatted(const CtScan& scan, Reformat direction, int at) {
  ReformattedSlice made;
  if (scan.slices.empty()) return made;
  const auto [low, high] = std::minmax(scan.slices.front().z, scan.slices.back().z);
  made.pixel = scan.plane.pixel;
  made.top = high + 0.5 * scan.protocol.thickness;
  made.width = direction == Reformat::sagittal ? scan.plane.height : scan.plane.width;
  made.height =
      std::max(1, static_cast<int>(std::lround((made.top - low + 0.5 * scan.protocol.thickness) / made.pixel)));
  made.hounsfield.assign(static_cast<std::size_t>(made.width) * static_cast<std::size_t>(made.height),
                         nothing_scanned);
  const int most = direction == Reformat::sagittal ? scan.plane.width - 1 : scan.plane.height - 1;
  const int line = std::clamp(at, 0, most);
  for (int row = 0; row < made.height; ++row) {
    const ScanSlice* const slice = scan.slice_at(made.top - (row + 0.5) * made.pixel);
    if (slice == nullptr) continue;
    for (int i = 0; i < made.width; ++i) {
      const int from = direction == Reformat::sagittal ? i * scan.plane.width + line : line * scan.plane.width + i;
      made.hounsfield[static_cast<std::size_t>(row) * static_cast<std::size_t>(made.width) +
                      static_cast<std::size_t>(i)] = slice->hounsfield[static_cast<std::size_t>(from)];
    }
  }
  return made;
}

Scout make_scout(const anatomy::CtVolume& ct, ScoutView view, double pixel) {
  const PatientBox box = scan_box_of(ct.grid);
  const int across = view == ScoutView::frontal ? 0 : 1, through = 1 - across;
  const Vec3 size = box.high - box.low;
  Scout scout;
  scout.pixel = pixel;
  scout.top = box.high.z();
  scout.width = std::max(1, static_cast<int>(std::lround(size[across] / pixel)));
  scout.height = std::max(1, static_cast<int>(std::lround(size.z() / pixel)));
  const double step = std::max(2.0, spacing_along(ct.grid, through));  // mm
  std::vector<float> sums;
  sums.reserve(static_cast<std::size_t>(scout.width) * static_cast<std::size_t>(scout.height));
  for (int row = 0; row < scout.height; ++row) {
    for (int column = 0; column < scout.width; ++column) {
      Vec3 at = box.low;
      at[across] += (column + 0.5) * pixel;
      at.z() = scout.top - (row + 0.5) * pixel;
      double sum = 0.0;
      for (double way = 0.5 * step; way < size[through]; way += step) {
        at[through] = box.low[through] + way;
        const double value = anatomy::nearest<std::int16_t>(ct, at, -1000);
        // Bone attenuates X-rays more than its density suggests.
        if (value > -900.0)
          sum += step * (0.001 * (value + 1000.0) + (value > 120.0 ? 0.0015 * (value - 120.0) : 0.0));
      }
      sums.push_back(static_cast<float>(sum));
    }
  }
  std::vector<float> sorted = sums;
  std::sort(sorted.begin(), sorted.end());
  const double white = std::max(
      1.0, static_cast<double>(sorted[static_cast<std::size_t>(0.995 * static_cast<double>(sorted.size() - 1))]));
  scout.grey.resize(sums.size());
  std::transform(sums.begin(), sums.end(), scout.grey.begin(), [&](float sum) {
    const double share = std::clamp(static_cast<double>(sum) / white, 0.0, 1.0);
    return static_cast<std::uint8_t>(std::lround(255.0 * std::pow(share, 1.4)));
  });
  return scout;
}

}  // namespace bodkin::imaging
