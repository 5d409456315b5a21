#include "anatomy/needle.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

namespace bodkin::anatomy {

namespace {

constexpr std::array<GaugeSize, 25> sizes = {{
    {10, 3.404, 2.692},  {11, 3.048, 2.388},  {12, 2.769, 2.159},  {13, 2.413, 1.803},  {14, 2.108, 1.6},
    {15, 1.829, 1.372},  {16, 1.651, 1.194},  {17, 1.473, 1.067},  {18, 1.27, 0.838},   {19, 1.067, 0.686},
    {20, 0.9081, 0.603}, {21, 0.8192, 0.514}, {22, 0.7176, 0.413}, {23, 0.6414, 0.337}, {24, 0.5652, 0.311},
    {25, 0.5144, 0.26},  {26, 0.4636, 0.26},  {27, 0.4128, 0.21},  {28, 0.362, 0.184},  {29, 0.3366, 0.184},
    {30, 0.3112, 0.159}, {31, 0.2604, 0.133}, {32, 0.235, 0.108},  {33, 0.2096, 0.108}, {34, 0.1842, 0.0826},
}};

}  // namespace

std::span<const GaugeSize> gauge_sizes() {
  return sizes;
}

std::optional<GaugeSize> gauge_size(int gauge) {
  const auto found =
      std::find_if(sizes.begin(), sizes.end(), [gauge](const GaugeSize& s) { return s.gauge == gauge; });
  return found == sizes.end() ? std::nullopt : std::optional(*found);
}

double bevel_angle(const Needle& needle) {
  if (needle.bevel_angle > 0.0) return needle.bevel_angle;
  switch (needle.tip) {
    case NeedleTip::tuohy:
      return 30.0;
    case NeedleTip::chiba:
      return 25.0;
    case NeedleTip::diamond:
      return 15.0;
    case NeedleTip::whitacre:
    case NeedleTip::sprotte:
    case NeedleTip::conical:
      return 12.0;
    case NeedleTip::filiform:
      return 8.0;
    case NeedleTip::quincke:
    case NeedleTip::trephine:
      break;
  }
  return 20.0;
}

double bending_stiffness(const Needle& needle) {
  const double modulus = needle.material == NeedleMaterial::nitinol ? 75000.0 : 193000.0;  // MPa
  const auto fourth = [](double diameter) { return diameter * diameter * diameter * diameter; };
  return modulus * std::numbers::pi * (fourth(needle.outer_diameter) - fourth(needle.inner_diameter)) / 64.0;
}

std::string to_string(NeedleTip tip) {
  return value_text(tip);
}

std::optional<NeedleTip> needle_tip_from(const std::string& name) {
  NeedleTip tip{};
  return parse_value(name, tip) ? std::optional(tip) : std::nullopt;
}

}  // namespace bodkin::anatomy
