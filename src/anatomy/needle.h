#pragma once

#include <optional>
#include <span>
#include <string>

#include "core/parameter.h"
#include "core/settings_check.h"

namespace bodkin::anatomy {

enum class NeedleTip { quincke, whitacre, tuohy, chiba, trephine, filiform, sprotte, diamond, conical };
constexpr std::array<std::string_view, 9> enumeration_names(NeedleTip) {
  return {"quincke", "whitacre", "tuohy", "chiba", "trephine", "filiform", "sprotte", "diamond", "conical"};
}

enum class NeedleMaterial { steel, nitinol };
constexpr std::array<std::string_view, 2> enumeration_names(NeedleMaterial) {
  return {"steel", "nitinol"};
}

// A straight tube (or a solid needle, inner diameter 0). Lengths in mm.
struct Needle {
  int gauge = 22;
  double outer_diameter = 0.7176;
  double inner_diameter = 0.413;
  double length = 90.0;
  NeedleTip tip = NeedleTip::quincke;
  double bevel_angle = 0.0;
  NeedleMaterial material = NeedleMaterial::steel;

  template <typename S = Needle>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"gauge", &S::gauge, Range{0.0, 34.0}, "", "Birmingham-type gauge, 10 to 34; 0: not a gauge needle",
                  Origin::choice},
        Parameter{"outer_diameter_mm", &S::outer_diameter, above(0.0, 20.0), "mm", "by default that of the gauge",
                  Origin::literature},
        Parameter{"inner_diameter_mm", &S::inner_diameter, Range{0.0, 20.0}, "mm",
                  "less than outer_diameter_mm; 0: a solid needle; by default that of the gauge", Origin::literature},
        Parameter{"length_mm", &S::length, Range{1.0, 1000.0}, "mm", "hub to tip", Origin::choice},
        Parameter{"tip", &S::tip, "how the tip is ground", Origin::choice},
        Parameter{"bevel_angle_deg", &S::bevel_angle, Range{0.0, 80.0}, "deg",
                  "between the bevel, or the side of a cone, and the axis; 0: what is usual for the tip",
                  Origin::choice},
        Parameter{"material", &S::material, "of the tube: Young's modulus 193 GPa of steel, 75 GPa of nitinol",
                  Origin::literature}};
  }
  static constexpr auto relations() {
    return std::tuple{
        Relation<Needle>{[](const Needle& needle) { return needle.inner_diameter < needle.outer_diameter; },
                         "inner_diameter_mm is not less than outer_diameter_mm, expected a tube or a solid needle"}};
  }
};

// Nominal tube of a gauge.
struct GaugeSize {
  int gauge;
  double outer_diameter;  // mm
  double inner_diameter;  // mm
};

// Nominal sizes, gauges 10 to 34, in order (needle tubing table, nominal values; 32 to 34 partly recalled).
std::span<const GaugeSize> gauge_sizes();
// The row of a gauge, or nothing when the table has none.
std::optional<GaugeSize> gauge_size(int gauge);

// deg, between bevel and axis: the needle's own, or the usual one of its tip.
double bevel_angle(const Needle& needle);
// N mm^2, resistance of the tube against bending: E pi (D^4 - d^4)/64.
double bending_stiffness(const Needle& needle);

std::string to_string(NeedleTip tip);
std::optional<NeedleTip> needle_tip_from(const std::string& name);

}  // namespace bodkin::anatomy
