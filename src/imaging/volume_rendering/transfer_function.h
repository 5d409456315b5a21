#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace bodkin::imaging {

// Opacity of a HU: the fraction of light, 0 to 1, absorbed by 1 mm of it.
struct OpacityPoint {
  double hounsfield = 0.0;
  double opacity = 0.0;

  bool operator==(const OpacityPoint&) const = default;
};

struct ColourPoint {
  double hounsfield = 0.0;
  std::uint32_t colour = 0xFFFFFF;  // 0xRRGGBB

  bool operator==(const ColourPoint&) const = default;
};

// The appearance of each HU in a volume view. Points ascend in HU; both are linear between them and constant beyond
// the outermost ones. Without points: opacity 0, white.
struct TransferFunction {
  std::vector<OpacityPoint> opacity;
  std::vector<ColourPoint> colours;

  double opacity_at(double hounsfield) const;
  std::array<double, 3> colour_at(double hounsfield) const;  // red, green, blue, 0 to 1

  // Adds a point on the curve at a HU within the range of the scale. Returns its position in `opacity`.
  std::size_t add_point(double hounsfield, double value);
  // Moves a point, which stays 1 HU from its neighbours, on the scale, and between 0 and 1.
  void move_point(std::size_t index, double hounsfield, double value);
  // No effect on a curve of two points.
  void remove_point(std::size_t index);

  bool operator==(const TransferFunction&) const = default;
};

// The scale of the opacity curve, HU.
inline constexpr double least_shown_hounsfield = -1024.0, most_shown_hounsfield = 3071.0;

// All points moved by `shift` HU, with opacity scaled by `density` (a thickness of tissue: 2 absorbs as much light as
// 2 mm did). These two numbers suffice for most patients.
TransferFunction adjusted(const TransferFunction& function, double shift, double density);

enum class TransferPreset : std::uint8_t { bone, soft_tissue, skin, vessels };
inline constexpr std::array<TransferPreset, 4> transfer_presets = {TransferPreset::bone, TransferPreset::soft_tissue,
                                                                   TransferPreset::skin, TransferPreset::vessels};
// "bone", "soft_tissue", "skin", "vessels"
std::string_view name_of(TransferPreset preset);
TransferFunction preset_function(TransferPreset preset);

}  // namespace bodkin::imaging
