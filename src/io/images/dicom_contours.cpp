#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <gdcmDataSet.h>
#include <gdcmReader.h>
#include <gdcmTag.h>

#include "core/error.h"
#include "io/images/dicom_elements.h"
#include "io/images/dicom_extent.h"
#include "io/images/dicom_labels.h"
#include "io/text_encoding.h"

namespace bodkin::io {
namespace {

constexpr std::uintmax_t contour_memory = 512U << 20U;  // bytes: doubles take more memory than numbers as text
constexpr double flat = 0.5;                            // voxels that a contour may leave its plane
constexpr double same_height = 0.1;                     // voxels between contours of one plane
constexpr double furthest_point = 1e5;                  // mm

using Polygon = std::vector<Vec3>;  // in indices of the CT

struct Contoured {
  int number = 0;
  std::string name;
  std::vector<Polygon> polygons;
};

// The polygon of one item of Contour Sequence; empty unless it is closed and planar.
Polygon polygon_of(const gdcm::DataSet& contour, const anatomy::Grid& ct, const std::string& name) {
  if (text_of(contour, {0x3006, 0x0042}) != "CLOSED_PLANAR") return {};
  const std::vector<double> numbers = numbers_of(contour, {0x3006, 0x0050});
  if (numbers.size() % 3 != 0) {
    throw InputError(
        fmt::format("{}: a contour has {} coordinates; expected three for each point", name, numbers.size()));
  }
  Polygon polygon;
  for (std::size_t n = 0; n + 2 < numbers.size(); n += 3) {
    const Vec3 point(numbers[n], numbers[n + 1], numbers[n + 2]);
    if (point.cwiseAbs().maxCoeff() > furthest_point)
      throw InputError(fmt::format("{}: a contour goes {:.3g} mm away; it is damaged", name, point.norm()));
    polygon.push_back(ct.to_index(point));
  }
  return polygon.size() < 3 ? Polygon{} : polygon;
}

struct StructureSet {
  std::vector<Contoured> structures;
  std::size_t other = 0;  // points and open lines
};

StructureSet read_contours(const std::filesystem::path& file, const anatomy::Grid& ct) {
  const std::string name = file.string();
  gdcm::Reader reader;
  reader.SetFileName(file.c_str());
  if (dicom_extent(file).header_cut || !reader.Read())
    throw InputError(fmt::format("{}: this structure set cannot be read; it is truncated or damaged", name));
  const gdcm::DataSet& data = reader.GetFile().GetDataSet();
  std::map<int, std::string> names;
  for (const gdcm::DataSet& roi : items_of(data, {0x3006, 0x0020}))
    names[whole_number_of(roi, {0x3006, 0x0022}, 0)] = printable(text_of(roi, {0x3006, 0x0026}));
  StructureSet set;
  for (const gdcm::DataSet& roi : items_of(data, {0x3006, 0x0039})) {
    Contoured structure;
    structure.number = whole_number_of(roi, {0x3006, 0x0084}, 0);
    structure.name = names[structure.number];
    for (const gdcm::DataSet& contour : items_of(roi, {0x3006, 0x0040})) {
      Polygon polygon = polygon_of(contour, ct, name);
      if (polygon.empty()) {
        ++set.other;
      } else {
        structure.polygons.push_back(std::move(polygon));
      }
    }
    if (!structure.polygons.empty()) set.structures.push_back(std::move(structure));
  }
  return set;
}

std::pair<double, double> range_along(const Polygon& polygon, Eigen::Index axis) {
  const auto [low, high] = std::minmax_element(polygon.begin(), polygon.end(),
                                               [&](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; });
  return {(*low)[axis], (*high)[axis]};
}

// The axis of the CT across which all polygons are flat.
Eigen::Index axis_across(const std::vector<Contoured>& structures, const std::string& name) {
  Vec3 worst = Vec3::Zero();
  for (const Contoured& structure : structures) {
    for (const Polygon& polygon : structure.polygons) {
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const auto [low, high] = range_along(polygon, axis);
        worst[axis] = std::max(worst[axis], high - low);
      }
    }
  }
  Eigen::Index axis = 0;
  if (worst.minCoeff(&axis) <= flat) return axis;
  throw InputError(
      fmt::format("{}: the contours do not lie in slices of the CT; give the CT that they were drawn on", name));
}

// The polygons of one structure by their height across the slices.
std::map<double, std::vector<const Polygon*>> by_height(const Contoured& structure, Eigen::Index axis) {
  std::map<double, std::vector<const Polygon*>> planes;
  for (const Polygon& polygon : structure.polygons) {
    const auto [low, high] = range_along(polygon, axis);
    const double height = 0.5 * (low + high);
    const auto near = planes.lower_bound(height - same_height);
    const bool known = near != planes.end() && near->first <= height + same_height;
    planes[known ? near->first : height].push_back(&polygon);
  }
  return planes;
}

// Calls `inside` for every pixel centre inside the polygons of a plane, by the even-odd rule. u and v are the axes in
// the plane.
template <typename Inside>
void fill(const std::vector<const Polygon*>& polygons, const std::array<int, 3>& size, Eigen::Index u, Eigen::Index v,
          const Inside& inside) {
  const int rows = size[static_cast<std::size_t>(v)], columns = size[static_cast<std::size_t>(u)];
  double low = rows, high = -1.0;
  for (const Polygon* polygon : polygons) {
    const auto [from, to] = range_along(*polygon, v);
    low = std::min(low, from), high = std::max(high, to);
  }
  const int first = static_cast<int>(std::ceil(std::clamp<double>(low, 0.0, rows)));
  const int last = static_cast<int>(std::floor(std::clamp<double>(high, -1.0, rows - 1)));
  std::vector<double> crossings;
  for (int row = first; row <= last; ++row) {
    crossings.clear();
    for (const Polygon* polygon : polygons) {
      for (std::size_t n = 0; n < polygon->size(); ++n) {
        const Vec3 &a = (*polygon)[n], &b = (*polygon)[(n + 1) % polygon->size()];
        if ((a[v] <= row) == (b[v] <= row)) continue;
        crossings.push_back(a[u] + (row - a[v]) / (b[v] - a[v]) * (b[u] - a[u]));
      }
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t n = 0; n + 1 < crossings.size(); n += 2) {
      const int from = static_cast<int>(std::ceil(std::clamp<double>(crossings[n], 0.0, columns)));
      const int to = static_cast<int>(std::ceil(std::clamp<double>(crossings[n + 1], 0.0, columns)));
      for (int column = from; column < to; ++column) inside(column, row);
    }
  }
}

// Calls `inside` with the index of every voxel of a structure.
template <typename Inside>
void fill(const Contoured& structure, Eigen::Index axis, const anatomy::Grid& ct, const Inside& inside) {
  const auto planes = by_height(structure, axis);
  double step = std::numeric_limits<double>::infinity();
  for (auto plane = planes.begin(); std::next(plane) != planes.end(); ++plane)
    step = std::min(step, std::next(plane)->first - plane->first);
  const double reach = std::max(flat, std::isfinite(step) ? 0.5 * step : 0.0) + 1e-6;
  const Eigen::Index u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
  for (int slice = 0; slice < ct.size[static_cast<std::size_t>(axis)]; ++slice) {
    auto nearest = planes.lower_bound(slice);
    if (nearest == planes.end() ||
        (nearest != planes.begin() && slice - std::prev(nearest)->first < nearest->first - slice))
      --nearest;
    if (std::abs(nearest->first - slice) > reach) continue;
    fill(nearest->second, ct.size, u, v, [&](int column, int row) {
      std::array<int, 3> index{};
      index[static_cast<std::size_t>(axis)] = slice;
      index[static_cast<std::size_t>(u)] = column;
      index[static_cast<std::size_t>(v)] = row;
      inside(index);
    });
  }
}

// Labels are ROI numbers, unless one of them cannot be a label.
void number_structures(std::vector<Contoured>& structures) {
  std::set<int> numbers;
  for (const Contoured& structure : structures) {
    if (structure.number >= 1 && structure.number <= 65535) numbers.insert(structure.number);
  }
  if (numbers.size() == structures.size()) return;
  for (std::size_t n = 0; n < structures.size(); ++n) structures[n].number = static_cast<int>(n) + 1;
}

}  // namespace

NamedLabels read_structure_set(const std::filesystem::path& file, const anatomy::Grid& ct) {
  const std::string name = file.string();
  StructureSet set;
  const bool read = read_within_budget(file, contour_memory, [&] {
    set = read_contours(file, ct);
    return true;
  });
  if (!read)
    throw InputError(fmt::format("{}: this structure set declares more than the file holds; it is damaged", name));
  if (set.structures.empty() || set.structures.size() > 65535)
    throw InputError(
        fmt::format("{}: this structure set has no closed contours; expected structures drawn on the CT", name));
  const Eigen::Index axis = axis_across(set.structures, name);
  number_structures(set.structures);

  std::vector<std::size_t> sizes, order;
  for (const Contoured& structure : set.structures) {
    std::size_t size = 0;
    fill(structure, axis, ct, [&](const std::array<int, 3>& /*index*/) { ++size; });
    order.push_back(sizes.size());
    sizes.push_back(size);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  NamedLabels result;
  result.labels = anatomy::LabelVolume(ct);
  std::size_t overlapping = 0;
  for (const std::size_t n : order) {
    const auto label = static_cast<std::uint16_t>(set.structures[n].number);
    result.names.push_back({label, set.structures[n].name});
    fill(set.structures[n], axis, ct, [&](const std::array<int, 3>& index) {
      std::uint16_t& voxel = result.labels.at(index[0], index[1], index[2]);
      overlapping += voxel != 0 ? 1 : 0;
      voxel = label;
    });
  }
  std::sort(result.names.begin(), result.names.end(),
            [](const LabelName& a, const LabelName& b) { return a.label < b.label; });
  if (overlapping > 0)
    result.notes.push_back(
        fmt::format("Where structures overlap (voxels: {}) the smaller one was taken.", overlapping));
  if (set.other > 0)
    result.notes.push_back(
        fmt::format("Points and open lines of the structure set (contours: {}) were left out.", set.other));
  return result;
}

}  // namespace bodkin::io
