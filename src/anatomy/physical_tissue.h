#pragma once

#include <string_view>

#include "anatomy/needle.h"
#include "core/parameter.h"
#include "core/settings_check.h"

namespace bodkin::anatomy {

// Properties of a tissue that a needle meets, independent of the force model: the force that its boundary bears
// before puncture, and its friction on the shaft. Force models derive their parameters from it (forces/needle_law.h)
// when a case says mechanics="physical". Force and friction are those of a reference needle; the laws convert them to
// others. puncture_force = 0 and friction = 0: no force. docs/evidence.md has every source.
struct PhysicalTissue {
  double puncture_force = 0.0;
  double spread = 0.0;
  double exponent = 1.0;
  double reference_diameter = 0.7176;
  NeedleTip reference_tip = NeedleTip::quincke;
  double dimpling = 2.0;
  double cutting_share = 0.0;
  double friction = 0.0;
  double static_ratio = 1.2;
  double young = 0.0;

  template <typename S = PhysicalTissue>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"puncture_force_N", &S::puncture_force, Range{0.0, 100.0}, "N",
                  "at which the boundary gives way to the reference needle; 0: at once", Origin::literature},
        Parameter{"spread", &S::spread, Range{0.0, 10.0}, "",
                  "standard deviation of the puncture force between people, divided by it; 0: unknown",
                  Origin::literature},
        Parameter{"exponent", &S::exponent, Range{0.0, 3.0}, "",
                  "of the diameter in the puncture force: 1 the width of a cut, 2 the area of a hole",
                  Origin::literature},
        Parameter{"reference_diameter_mm", &S::reference_diameter, above(0.0, 20.0), "mm",
                  "outer diameter of the reference needle", Origin::literature},
        Parameter{"reference_tip", &S::reference_tip, "tip of the reference needle", Origin::literature},
        Parameter{"dimpling_mm", &S::dimpling, above(0.0, 50.0), "mm",
                  "by which the boundary is pushed in before it gives way", Origin::literature},
        Parameter{"cutting_share", &S::cutting_share, Range{0.0, 1.0}, "",
                  "of the force that tears the boundary, that cutting on inside takes; 0: the boundary alone resists",
                  Origin::literature},
        Parameter{"friction_MPa", &S::friction, Range{0.0, 1.0}, "MPa", "force per area of the sliding shaft",
                  Origin::choice},
        Parameter{"static_ratio", &S::static_ratio, Range{1.0, 10.0}, "",
                  "friction before the shaft slides, divided by that of the sliding shaft", Origin::choice},
        Parameter{"young_MPa", &S::young, Range{0.0, 1e6}, "MPa",
                  "Young's modulus across the fibres, as a needle meets it; supports a bending needle; 0: not known",
                  Origin::literature}};
  }
};

}  // namespace bodkin::anatomy
