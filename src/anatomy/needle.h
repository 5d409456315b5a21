#pragma once

#include <optional>
#include <span>
#include <string>

namespace bodkin {

enum class NeedleTip { quincke, whitacre, tuohy, chiba, trephine, filiform };

// A straight tube (or a solid needle, inner diameter 0). Lengths in mm.
struct Needle {
  int gauge = 22;                  // Birmingham-type gauge; 0 = not a gauge needle
  double outer_diameter = 0.7176;  // mm, > 0
  double inner_diameter = 0.413;   // mm, 0 <= inner < outer
  double length = 90.0;            // mm, hub to tip
  NeedleTip tip = NeedleTip::quincke;
};

// Nominal tube of a gauge.
struct GaugeSize {
  int gauge;
  double outer_diameter;  // mm
  double inner_diameter;  // mm
};

// Nominal sizes, gauges 10 to 34, in order (needle tubing table, nominal values; 32 to 34 partly recalled).
std::span<const GaugeSize> gauge_sizes();
// The row of a gauge, or nothing when the table does not hold it.
std::optional<GaugeSize> gauge_size(int gauge);

std::string to_string(NeedleTip tip);
std::optional<NeedleTip> needle_tip_from(const std::string& name);

}  // namespace bodkin
