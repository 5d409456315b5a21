#include "scene/raster.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/simd.h"

namespace bodkin::scene {

namespace {

// Eight pixels of a row.
constexpr int pixels_at_once = 8;
using EightFloats [[gnu::aligned(32)]] = float __attribute__((vector_size(32)));
using EightIntegers [[gnu::aligned(32)]] = std::int32_t __attribute__((vector_size(32)));

// A quantity that is linear in the picture.
struct ScreenPlane {
  float at_first, along_x, along_y;
};

struct TriangleSetup {
  PixelBox box;
  ScreenPlane edges[3];  // at least 0 inside
  ScreenPlane nearness, red, green, blue;
};

// False for a triangle that covers no pixel's centre.
BODKIN_LANES_INLINE bool set_up(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c, bool front_only,
                                const PixelBox& box, TriangleSetup& setup) {
  if (!(a.nearness > 0.0F && b.nearness > 0.0F && c.nearness > 0.0F)) return false;
  const float low_x = std::min({a.x, b.x, c.x}), high_x = std::max({a.x, b.x, c.x});
  const float low_y = std::min({a.y, b.y, c.y}), high_y = std::max({a.y, b.y, c.y});
  // False also for NaN; tested before the conversion to integers, which could overflow.
  const bool seen = high_x > static_cast<float>(box.left) && low_x < static_cast<float>(box.right) &&
                    high_y > static_cast<float>(box.top) && low_y < static_cast<float>(box.bottom);
  if (!seen) return false;
  const float limit = 1e6F;
  if (low_x < -limit || low_y < -limit || high_x > limit || high_y > limit) return false;
  // Centres lie half a pixel inwards.
  setup.box.left = std::max(box.left, static_cast<int>(std::ceil(low_x - 0.5F)));
  setup.box.right = std::min(box.right, static_cast<int>(std::floor(high_x - 0.5F)) + 1);
  setup.box.top = std::max(box.top, static_cast<int>(std::ceil(low_y - 0.5F)));
  setup.box.bottom = std::min(box.bottom, static_cast<int>(std::floor(high_y - 0.5F)) + 1);
  if (setup.box.empty()) return false;
  // Twice the area; y points down, so that counterclockwise corners on the screen give a negative one.
  float area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  const bool front = area < 0.0F;
  if (area == 0.0F || (front_only && !front)) return false;
  const float x = static_cast<float>(setup.box.left) + 0.5F, y = static_cast<float>(setup.box.top) + 0.5F;
  const float side = front ? -1.0F : 1.0F;
  const auto edge = [&](const ScreenPoint& from, const ScreenPoint& to) {
    const float along_x = -(to.y - from.y) * side, along_y = (to.x - from.x) * side;
    return ScreenPlane{along_x * (x - from.x) + along_y * (y - from.y), along_x, along_y};
  };
  setup.edges[0] = edge(b, c);
  setup.edges[1] = edge(c, a);
  setup.edges[2] = edge(a, b);
  const float one_over_area = 1.0F / (area * side);
  const auto plane = [&](float at_a, float at_b, float at_c) {
    const float p = (at_a - at_c) * one_over_area, q = (at_b - at_c) * one_over_area;
    return ScreenPlane{at_c + p * setup.edges[0].at_first + q * setup.edges[1].at_first,
                       p * setup.edges[0].along_x + q * setup.edges[1].along_x,
                       p * setup.edges[0].along_y + q * setup.edges[1].along_y};
  };
  setup.nearness = plane(a.nearness, b.nearness, c.nearness);
  setup.red = plane(a.red, b.red, c.red);
  setup.green = plane(a.green, b.green, c.green);
  setup.blue = plane(a.blue, b.blue, c.blue);
  return true;
}

BODKIN_LANES_INLINE void along(const ScreenPlane& plane, float columns, float rows, const EightFloats& lane,
                               EightFloats& values) {
  values = lane * plane.along_x + (plane.at_first + columns * plane.along_x + rows * plane.along_y);
}

BODKIN_LANES_INLINE void within_byte(EightFloats& value) {
  value = value < 0.0F ? EightFloats{} : value;
  value = value > 255.0F ? EightFloats{} + 255.0F : value;
}

BODKIN_PROCESSOR_CLONES
void draw_all(std::span<const ScreenPoint> points, std::span<const std::array<std::int32_t, 3>> triangles,
              bool front_only, Layer& layer) {
  const EightFloats lane = {0.0F, 1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F, 7.0F};
  const EightIntegers count = {0, 1, 2, 3, 4, 5, 6, 7};
  TriangleSetup setup;
  for (const std::array<std::int32_t, 3>& corners : triangles) {
    const auto corner = [&](std::size_t i) -> const ScreenPoint& {
      return points[static_cast<std::size_t>(corners[i])];
    };
    if (!set_up(corner(0), corner(1), corner(2), front_only, layer.box(), setup)) continue;
    for (int y = setup.box.top; y < setup.box.bottom; ++y) {
      const auto rows = static_cast<float>(y - setup.box.top);
      std::uint32_t* colours = layer.colours(y);
      float* nearness = layer.nearness(y);
      for (int x = setup.box.left; x < setup.box.right; x += pixels_at_once) {
        const auto columns = static_cast<float>(x - setup.box.left);
        EightFloats inside[3], near, before;
        for (int e = 0; e < 3; ++e) along(setup.edges[e], columns, rows, lane, inside[e]);
        along(setup.nearness, columns, rows, lane, near);
        std::memcpy(&before, nearness + x, sizeof before);
        const EightIntegers drawn = (inside[0] >= 0.0F) & (inside[1] >= 0.0F) & (inside[2] >= 0.0F) &
                                    (near > before) & (count < setup.box.right - x);
        std::uint64_t any[4];
        std::memcpy(any, &drawn, sizeof any);
        if ((any[0] | any[1] | any[2] | any[3]) == 0) continue;
        EightFloats red, green, blue;
        along(setup.red, columns, rows, lane, red);
        along(setup.green, columns, rows, lane, green);
        along(setup.blue, columns, rows, lane, blue);
        within_byte(red);
        within_byte(green);
        within_byte(blue);
        const EightIntegers colour = __builtin_convertvector(red, EightIntegers) * 65536 +
                                     __builtin_convertvector(green, EightIntegers) * 256 +
                                     __builtin_convertvector(blue, EightIntegers);
        EightIntegers old;
        std::memcpy(&old, colours + x, sizeof old);
        old = drawn ? colour : old;
        before = drawn ? near : before;
        std::memcpy(colours + x, &old, sizeof old);
        std::memcpy(nearness + x, &before, sizeof before);
      }
    }
  }
}

}  // namespace

PixelBox PixelBox::meet(const PixelBox& other) const {
  return {std::max(left, other.left), std::max(top, other.top), std::min(right, other.right),
          std::min(bottom, other.bottom)};
}

PixelBox PixelBox::join(const PixelBox& other) const {
  if (empty()) return other;
  if (other.empty()) return *this;
  return {std::min(left, other.left), std::min(top, other.top), std::max(right, other.right),
          std::max(bottom, other.bottom)};
}

PixelBox PixelBox::over(int factor) const {
  const auto down = [factor](int value) { return static_cast<int>(std::floor(static_cast<double>(value) / factor)); };
  return {down(left), down(top), -down(-right), -down(-bottom)};
}

void Layer::resize(const PixelBox& box) {
  box_ = box;
  stride_ = std::max(box.width(), 0) + pixels_at_once;
  const std::size_t size = static_cast<std::size_t>(stride_) * static_cast<std::size_t>(std::max(box.height(), 0));
  colours_.resize(size);
  nearness_.resize(size);
}

void Layer::clear() {
  std::fill(nearness_.begin(), nearness_.end(), 0.0F);
}

float Layer::nearness_at(int x, int y) const {
  if (x < box_.left || y < box_.top || x >= box_.right || y >= box_.bottom) return 0.0F;
  return nearness(y)[x];
}

void draw_triangles(std::span<const ScreenPoint> points, std::span<const std::array<std::int32_t, 3>> triangles,
                    bool front_only, Layer& layer) {
  if (layer.box().empty()) return;
  draw_all(points, triangles, front_only, layer);
}

}  // namespace bodkin::scene
