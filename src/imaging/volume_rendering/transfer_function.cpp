#include "imaging/volume_rendering/transfer_function.h"

#include <algorithm>
#include <cmath>

namespace bodkin::imaging {

namespace {

constexpr double least_gap = 1.0;  // HU between two points of a curve

std::array<double, 3> parts_of(std::uint32_t colour) {
  return {(colour >> 16U & 0xFFU) / 255.0, (colour >> 8U & 0xFFU) / 255.0, (colour & 0xFFU) / 255.0};
}

// Where `hounsfield` lies between two points; `before` and `after` are equal beyond the ends.
struct Bracket {
  std::size_t before, after;
  double share;
};
template <typename Point>
Bracket bracket(const std::vector<Point>& points, double hounsfield) {
  const auto after = std::upper_bound(points.begin(), points.end(), hounsfield,
                                      [](double value, const Point& point) { return value < point.hounsfield; });
  if (after == points.begin()) return {0, 0, 0.0};
  const auto index = static_cast<std::size_t>(after - points.begin());
  if (after == points.end()) return {index - 1, index - 1, 0.0};
  const double from = points[index - 1].hounsfield, to = points[index].hounsfield;
  return {index - 1, index, (hounsfield - from) / (to - from)};
}

}  // namespace

double TransferFunction::opacity_at(double hounsfield) const {
  if (opacity.empty()) return 0.0;
  const Bracket at = bracket(opacity, hounsfield);
  return opacity[at.before].opacity + at.share * (opacity[at.after].opacity - opacity[at.before].opacity);
}

std::array<double, 3> TransferFunction::colour_at(double hounsfield) const {
  if (colours.empty()) return {1.0, 1.0, 1.0};
  const Bracket at = bracket(colours, hounsfield);
  std::array<double, 3> mixed = parts_of(colours[at.before].colour);
  const std::array<double, 3> after = parts_of(colours[at.after].colour);
  for (std::size_t i = 0; i < 3; ++i) mixed[i] += at.share * (after[i] - mixed[i]);
  return mixed;
}

std::size_t TransferFunction::add_point(double hounsfield, double value) {
  const double at = std::clamp(hounsfield, least_shown_hounsfield, most_shown_hounsfield);
  const auto place = std::upper_bound(opacity.begin(), opacity.end(), at,
                                      [](double x, const OpacityPoint& point) { return x < point.hounsfield; });
  const auto index = static_cast<std::size_t>(place - opacity.begin());
  opacity.insert(place, {at, std::clamp(value, 0.0, 1.0)});
  move_point(index, at, value);
  return index;
}

void TransferFunction::move_point(std::size_t index, double hounsfield, double value) {
  const double low = index > 0 ? opacity[index - 1].hounsfield + least_gap : least_shown_hounsfield;
  const double high = index + 1 < opacity.size() ? opacity[index + 1].hounsfield - least_gap : most_shown_hounsfield;
  opacity[index] = {low <= high ? std::clamp(hounsfield, low, high) : 0.5 * (low + high),
                    std::clamp(value, 0.0, 1.0)};
}

void TransferFunction::remove_point(std::size_t index) {
  if (opacity.size() > 2) opacity.erase(opacity.begin() + static_cast<std::ptrdiff_t>(index));
}

TransferFunction adjusted(const TransferFunction& function, double shift, double density) {
  TransferFunction moved = function;
  for (OpacityPoint& point : moved.opacity) {
    point.hounsfield += shift;
    point.opacity = 1.0 - std::pow(1.0 - std::clamp(point.opacity, 0.0, 1.0), density);
  }
  for (ColourPoint& point : moved.colours) point.hounsfield += shift;
  return moved;
}

std::string_view name_of(TransferPreset preset) {
  switch (preset) {
    case TransferPreset::bone:
      return "bone";
    case TransferPreset::soft_tissue:
      return "soft_tissue";
    case TransferPreset::skin:
      return "skin";
    case TransferPreset::vessels:
      return "vessels";
  }
  return "";
}

TransferFunction preset_function(TransferPreset preset) {
  switch (preset) {
    case TransferPreset::bone:
      return {{{-1024.0, 0.0}, {150.0, 0.0}, {260.0, 0.22}, {500.0, 0.6}, {1200.0, 0.95}},
              {{120.0, 0xB5684A}, {220.0, 0xE2B98C}, {420.0, 0xF3E4C8}, {1200.0, 0xFFFDF5}}};
    case TransferPreset::soft_tissue:
      return {
          {{-1024.0, 0.0}, {-40.0, 0.0}, {15.0, 0.015}, {90.0, 0.035}, {170.0, 0.05}, {300.0, 0.35}, {1200.0, 0.9}},
          {{-20.0, 0x8E4038}, {40.0, 0xB04A40}, {110.0, 0xC98070}, {220.0, 0xEBD3B4}, {1200.0, 0xFFFDF5}}};
    case TransferPreset::skin:
      return {{{-1024.0, 0.0}, {-520.0, 0.0}, {-300.0, 0.28}, {-120.0, 0.75}, {1200.0, 0.95}},
              {{-600.0, 0xD9A283}, {-200.0, 0xE6BA9B}, {60.0, 0xE0AE90}, {400.0, 0xF6EBD8}}};
    case TransferPreset::vessels:  // with contrast medium; bone appears with them, but faintly
      return {
          {{-1024.0, 0.0}, {120.0, 0.0}, {170.0, 0.12}, {320.0, 0.55}, {480.0, 0.3}, {800.0, 0.12}, {1600.0, 0.12}},
          {{120.0, 0x8E1C1C}, {250.0, 0xD8402F}, {420.0, 0xF2B79A}, {700.0, 0xF4EBDD}}};
  }
  return {};
}

}  // namespace bodkin::imaging
