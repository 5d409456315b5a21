#include "imaging/slice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace bodkin::imaging {

namespace {

constexpr double steepest = 0.7071;  // cosine of 45 degrees

struct ViewAxes {
  Vec3 right;
  Vec3 down;
};

ViewAxes axes_of(View view) {
  switch (view) {
    case View::axial:
      return {Vec3::UnitX(), Vec3::UnitY()};
    case View::coronal:
      return {Vec3::UnitX(), -Vec3::UnitZ()};
    case View::sagittal:
      break;
  }
  return {Vec3::UnitY(), -Vec3::UnitZ()};
}

SlicePlane plane_around(const ViewAxes& axes, const Vec3& middle, double width, double height, double pixel) {
  SlicePlane plane;
  plane.right = axes.right;
  plane.down = axes.down;
  plane.pixel = pixel;
  plane.width = std::max(1, static_cast<int>(std::lround(width / pixel)));
  plane.height = std::max(1, static_cast<int>(std::lround(height / pixel)));
  plane.corner = middle - pixel * (0.5 * (plane.width - 1) * plane.right + 0.5 * (plane.height - 1) * plane.down);
  return plane;
}

}  // namespace

PatientBox body_box(const anatomy::TissueVolume& tissues) {
  const auto& size = tissues.grid.size;
  std::array<int, 3> low = size, high = {-1, -1, -1};
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        if (tissues.at(i, j, k) == anatomy::tissue::air) continue;
        low = {std::min(low[0], i), std::min(low[1], j), std::min(low[2], k)};
        high = {std::max(high[0], i), std::max(high[1], j), std::max(high[2], k)};
      }
    }
  }
  if (high[0] < 0) {
    low = {0, 0, 0};
    high = {size[0] - 1, size[1] - 1, size[2] - 1};
  }
  PatientBox box{Vec3::Constant(std::numeric_limits<double>::infinity()),
                 Vec3::Constant(-std::numeric_limits<double>::infinity())};
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 index;
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      index[axis] = (corner >> axis & 1) != 0 ? high[a] + 0.5 : low[a] - 0.5;
    }
    const Vec3 point = tissues.grid.to_patient(index);
    box.low = box.low.cwiseMin(point);
    box.high = box.high.cwiseMax(point);
  }
  return box;
}

SlicePlane view_plane(View view, const Vec3& middle, double width, double height, double pixel) {
  return plane_around(axes_of(view), middle, width, height, pixel);
}

SlicePlane sagittal_plane_along(const anatomy::NeedlePath& path, const Vec3& middle, double width, double height,
                                double pixel) {
  const Vec3 along = path.direction();
  // The normal perpendicular to the path that is nearest to the sagittal plane's.
  const Vec3 across = Vec3::UnitX() - Vec3::UnitX().dot(along) * along;
  if (!(across.norm() > steepest)) {
    return view_plane(View::sagittal, Vec3(path.target.x(), middle.y(), middle.z()), width, height, pixel);
  }
  const Vec3 normal = across.normalized();
  const Vec3 down = (-Vec3::UnitZ() + normal.z() * normal).normalized();
  const Vec3 right = -down.cross(normal);  // -x away from the eye, as in the true sagittal view
  const Vec3 in_plane = middle - normal.dot(middle - path.entry) * normal;
  return plane_around({right, down}, in_plane, width, height, pixel);
}

std::string direction_letters(const Vec3& direction) {
  constexpr std::array<const char*, 3> positive = {"L", "P", "S"}, negative = {"R", "A", "I"};
  constexpr double share_of_second = 0.35;  // about 20 degrees off an axis
  std::array<int, 3> order = {0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return std::abs(direction[a]) > std::abs(direction[b]); });
  std::string letters;
  for (const int axis : {order[0], order[1]}) {
    if (!letters.empty() && std::abs(direction[axis]) < share_of_second * direction.norm()) break;
    letters +=
        direction[axis] >= 0.0 ? positive[static_cast<std::size_t>(axis)] : negative[static_cast<std::size_t>(axis)];
  }
  return letters;
}

Slice cut(const SlicePlane& plane, const anatomy::CtVolume& ct, const anatomy::TissueVolume& tissues) {
  Slice slice;
  slice.plane = plane;
  const std::size_t count = static_cast<std::size_t>(plane.width) * static_cast<std::size_t>(plane.height);
  slice.hounsfield.reserve(count);
  slice.tissues.reserve(count);
  for (int row = 0; row < plane.height; ++row) {
    for (int column = 0; column < plane.width; ++column) {
      const Vec3 point = plane.point(column, row);
      slice.hounsfield.push_back(
          static_cast<float>(anatomy::linear(ct, point, std::numeric_limits<double>::quiet_NaN())));
      slice.tissues.push_back(anatomy::nearest(tissues, point, Slice::outside));
    }
  }
  return slice;
}

ImageRgb paint(const Slice& slice, const anatomy::TissueLibrary& library, const SliceLook& look) {
  ImageRgb image(slice.plane.width, slice.plane.height);
  const double black = look.level - 0.5 * look.window;
  const auto tissue_at = [&](int column, int row) {
    return slice.tissues[static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>(column)];
  };
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      const std::size_t at =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(column);
      const double hounsfield = slice.hounsfield[at];
      const double grey =
          std::isnan(hounsfield) ? 0.0 : std::clamp((hounsfield - black) / look.window, 0.0, 1.0) * 255.0;
      const anatomy::TissueId here = slice.tissues[at];
      const anatomy::TissueProperties* properties = here == anatomy::tissue::air ? nullptr : library.find(here);
      double share = 0.0;
      Rgb colour;
      if (properties != nullptr) {
        colour = rgb(properties->colour);
        // The outline is the last pixel of a tissue towards another one on the right or below: one pixel wide.
        const bool outline = (column + 1 < image.width && tissue_at(column + 1, row) != here) ||
                             (row + 1 < image.height && tissue_at(column, row + 1) != here);
        share = outline ? look.border : look.fill;
      }
      const auto mix = [&](std::uint8_t channel) {
        return static_cast<std::uint8_t>(std::lround((1.0 - share) * grey + share * channel));
      };
      image.at(column, row) = {mix(colour.red), mix(colour.green), mix(colour.blue)};
    }
  }
  return image;
}

std::vector<anatomy::TissueId> tissues_present(const Slice& slice) {
  std::array<std::size_t, 256> pixels{};
  for (const anatomy::TissueId id : slice.tissues) ++pixels[id];
  std::vector<anatomy::TissueId> present;
  for (int id = 0; id < Slice::outside; ++id) {
    if (id != anatomy::tissue::air && pixels[static_cast<std::size_t>(id)] > 0)
      present.push_back(static_cast<anatomy::TissueId>(id));
  }
  std::stable_sort(present.begin(), present.end(),
                   [&](anatomy::TissueId a, anatomy::TissueId b) { return pixels[a] > pixels[b]; });
  return present;
}

}  // namespace bodkin::imaging
