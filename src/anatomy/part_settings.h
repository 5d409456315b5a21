#pragma once

#include <array>
#include <string_view>
#include <tuple>

#include "core/parameter.h"

namespace bodkin::anatomy {

// Settings of parts added to a resistance: the bevel's deflection, the returning fluid, the syringe on the hub.
// Tables: core/parameter.h.

// Settings of the part `bevel_tip`.
struct BevelTipSettings {
  double curvature = 0.005;
  double stiffness = 0.1;
  double limit = 1.0;

  static constexpr auto parameters() {
    using S = BevelTipSettings;
    return std::tuple{Parameter{"curvature_per_mm", &S::curvature, Range{0.0, 0.1}, "1/mm",
                                "kappa, of needle and tissue; 0 for a symmetric tip", Origin::choice},
                      Parameter{"stiffness_N_per_mm", &S::stiffness, Range{0.0, 10.0}, "N/mm",
                                "of the tissue that pulls the tip to the path that the bevel cuts", Origin::choice},
                      Parameter{"limit_N", &S::limit, Range{1e-3, 100.0}, "N", "largest force", Origin::choice}};
  }
};

// Settings of the part `fingertip` (Fingertip).
struct FingertipSettings {
  double modulus = 0.04;
  double radius = 6.0;
  double reach = 40.0;
  double limit = 6.0;

  static constexpr auto parameters() {
    using S = FingertipSettings;
    return std::tuple{
        Parameter{"modulus_MPa", &S::modulus, Range{0.001, 1.0}, "MPa",
                  "of the soft tissue between skin and bone under a pressing finger", Origin::choice},
        Parameter{"radius_mm", &S::radius, Range{2.0, 15.0}, "mm", "of the fingertip", Origin::choice},
        Parameter{"reach_mm", &S::reach, Range{10.0, 100.0}, "mm",
                  "deeper bone is not felt: the tissue yields as if there were bone just there", Origin::choice},
        Parameter{"limit_N", &S::limit, Range{0.1, 20.0}, "N", "largest force", Origin::choice}};
  }
};

// Settings of CsfFlow; in a case bore and length are those of its needle.
struct CsfFlowSettings {
  double opening_pressure = 145.0;
  double needle_bore = 0.413;  // of 22G
  double needle_length = 90.0;
  double viscosity = 1e-9;
  double manometer_bore = 1.5;
  bool manometer = true;
  bool stylet = false;
  double pressure_volume_index = 0.0;
  double times_faster = 1.0;

  static constexpr auto parameters() {
    using S = CsfFlowSettings;
    return std::tuple{
        Parameter{"opening_pressure_mm", &S::opening_pressure, Range{0.0, 1000.0}, "mm",
                  "of fluid; 14.5 (SD 3.7) cm lying (Gilland et al. 1974)", Origin::literature},
        Parameter{"viscosity_MPa_s", &S::viscosity, Range{1e-10, 1e-8}, "MPa s", "of the fluid, 0.7 to 1.0 mPa s",
                  Origin::literature},
        Parameter{"manometer_bore_mm", &S::manometer_bore, Range{0.5, 10.0}, "mm", "of the manometer's tube",
                  Origin::choice},
        Parameter{"manometer", &S::manometer, "the fluid rises in a manometer; false: it drips", Origin::choice},
        Parameter{"stylet", &S::stylet, "the stylet is in, nothing flows", Origin::choice},
        Parameter{"pressure_volume_index_mL", &S::pressure_volume_index, Range{0.0, 200.0}, "mL",
                  "of fluid whose loss lowers the pressure to a tenth, about 25 (Marmarou et al. 1978); 0: it stays",
                  Origin::choice},
        Parameter{"times_faster", &S::times_faster, Range{1.0, 100.0}, "",
                  "so much faster the fluid rises and collects than it would, for a lesson that has no time to wait",
                  Origin::choice}};
  }
  static constexpr auto unwritten() {
    using S = CsfFlowSettings;
    return std::tuple{
        Parameter{"needle_bore_mm", &S::needle_bore, Range{0.05, 3.0}, "mm", "of the case's needle", Origin::choice},
        Parameter{"needle_length_mm", &S::needle_length, Range{10.0, 300.0}, "mm", "of the case's needle",
                  Origin::choice}};
  }
};

enum class SyringeFilling {
  saline,  // nearly rigid: compliance of line, plunger seal and a small bubble
  air      // C = V/(P_atm + P)
};
constexpr std::array<std::string_view, 2> enumeration_names(SyringeFilling) {
  return {"saline", "air"};
}

// Settings of Syringe; in a case bore and length of the needle are those of its needle.
struct SyringeSettings {
  SyringeFilling filling = SyringeFilling::saline;
  double bore = 15.0;
  double air_volume = 2000.0;
  double saline_compliance = 100.0;
  double needle_bore = 1.194;  // of 16G
  double needle_length = 80.0;
  double viscosity = 1e-9;
  double friction = 0.3;
  double thumb_force = 5.0;

  static constexpr auto parameters() {
    using S = SyringeSettings;
    return std::tuple{Parameter{"filling", &S::filling, "of the barrel", Origin::choice},
                      Parameter{"bore_mm", &S::bore, Range{2.0, 40.0}, "mm",
                                "of the barrel: 11.1 N at 62.7 kPa are 177 mm^2", Origin::literature},
                      Parameter{"air_volume_mm3", &S::air_volume, Range{10.0, 20000.0}, "mm^3",
                                "of the gas at rest, with air", Origin::choice},
                      Parameter{"saline_compliance_mm3_per_MPa", &S::saline_compliance, Range{0.1, 1e5}, "mm^3/MPa",
                                "of the chamber with saline", Origin::choice},
                      Parameter{"viscosity_MPa_s", &S::viscosity, Range{1e-11, 1e-6}, "MPa s",
                                "saline 1e-9, air 1.8e-11", Origin::literature},
                      Parameter{"friction_N", &S::friction, Range{0.0, 20.0}, "N", "of the plunger", Origin::choice},
                      Parameter{"thumb_force_N", &S::thumb_force, Range{0.0, 50.0}, "N",
                                "with which the thumb presses the plunger while the needle is in", Origin::choice}};
  }
  static constexpr auto unwritten() {
    using S = SyringeSettings;
    return std::tuple{
        Parameter{"needle_bore_mm", &S::needle_bore, Range{0.1, 5.0}, "mm", "of the case's needle", Origin::choice},
        Parameter{"needle_length_mm", &S::needle_length, Range{10.0, 300.0}, "mm", "of the case's needle",
                  Origin::choice}};
  }
};

}  // namespace bodkin::anatomy
