#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/parameter.h"
#include "core/settings_check.h"

namespace bodkin::anatomy {

// Resistance of one tissue in each force model that asks the tissue. A tissue library (docs/case-format.md) fills
// these in; a tissue without values for a model gives no resistance. Tables: core/parameter.h. The numbers of a
// library have their sources in the library.

// How a tissue resists in the `layered` model (Heng 2004; docs/models/layered.md has the laws).
enum class LayeredKind : std::uint8_t {
  none,          // no force: air, cerebrospinal fluid, gas
  viscoelastic,  // skin, muscle, ligaments: pushes, breaks, then grips the shaft (eq. 2-5, 7)
  viscous,       // fat: drag in proportion to speed and length (eq. 6)
  rigid          // bone: a spring that never breaks (section 5.4)
};
constexpr std::array<std::string_view, 4> enumeration_names(LayeredKind) {
  return {"none", "viscoelastic", "viscous", "rigid"};
}

struct LayeredTissue {
  LayeredKind kind = LayeredKind::none;
  // viscoelastic, before puncture (eq. 2, 3)
  double stiffness = 0.0;
  double viscosity = 0.0;
  double element_spacing = 1.0;
  double break_force = 0.0;
  double break_force_rate = 0.0;
  // viscoelastic, after puncture: per mm of shaft in contact (eq. 4, 5, 7)
  double shaft_stiffness = 0.0;
  double shaft_viscosity = 0.0;
  double shaft_spacing = 0.5;
  double static_friction = 0.0;
  double dynamic_friction = 0.0;
  double roughness = 0.0;
  // viscous (eq. 6)
  double drag = 0.0;
  // rigid
  double contact_stiffness = 0.0;

  template <typename S = LayeredTissue>
  static constexpr auto parameters() {
    constexpr std::string_view soft = "viscoelastic";
    return std::tuple{
        Alternatives{&S::kind, "how the tissue resists"},
        Parameter{"stiffness_N_per_mm", &S::stiffness, above(0.0, 100.0), "N/mm", "k, of one element", Origin::choice}
            .only_of(soft),
        Parameter{"viscosity_N_s_per_mm", &S::viscosity, Range{0.0, 10.0}, "N s/mm", "rho, of one element",
                  Origin::choice}
            .only_of(soft),
        Parameter{"element_spacing_mm", &S::element_spacing, Range{0.01, 100.0}, "mm", "dx, between elements",
                  Origin::choice}
            .only_of(soft),
        Parameter{"break_force_N", &S::break_force, above(0.0, 100.0), "N", "H, at which the tissue gives way",
                  Origin::choice}
            .only_of(soft),
        Parameter{"break_force_rate_N_mm_per_s", &S::break_force_rate, Range{0.0, 1000.0}, "N mm/s",
                  "L, by which a fast needle lowers it; 0: speed has no effect", Origin::choice}
            .only_of(soft),
        Parameter{"shaft_stiffness_N_per_mm2", &S::shaft_stiffness, above(0.0, 100.0), "N/mm^2",
                  "k_s, of the grip on 1 mm of shaft", Origin::choice}
            .only_of(soft),
        Parameter{"shaft_viscosity_N_s_per_mm2", &S::shaft_viscosity, Range{0.0, 10.0}, "N s/mm^2",
                  "rho_s, of the grip on 1 mm of shaft", Origin::choice}
            .only_of(soft),
        Parameter{"shaft_spacing_mm", &S::shaft_spacing, Range{0.01, 100.0}, "mm", "dx_s, between places of grip",
                  Origin::choice}
            .only_of(soft),
        Parameter{"static_friction_N_per_mm", &S::static_friction, Range{0.0, 10.0}, "N/mm",
                  "S, at which the shaft slides", Origin::choice}
            .only_of(soft),
        Parameter{"dynamic_friction_N_per_mm", &S::dynamic_friction, Range{0.0, 10.0}, "N/mm", "D, while it slides",
                  Origin::choice}
            .only_of(soft),
        Parameter{"roughness", &S::roughness, from_to_below(0.0, 1.0), "", "delta, variation of the friction",
                  Origin::choice}
            .only_of(soft),
        Parameter{"drag_N_s_per_mm2", &S::drag, Range{0.0, 10.0}, "N s/mm^2", "rho_f, on 1 mm of shaft",
                  Origin::choice}
            .only_of("viscous"),
        Parameter{"contact_stiffness_N_per_mm", &S::contact_stiffness, above(0.0, 100.0), "N/mm",
                  "K_b; the device's limit bounds it", Origin::choice}
            .only_of("rigid")};
  }
  template <typename S = LayeredTissue>
  static constexpr auto relations() {
    return std::tuple{AtMost{&S::dynamic_friction, &S::static_friction, 0.0, "viscoelastic"}};
  }
};

// `tracking_wall` (Alamilla 2018).
struct TrackingWallTissue {
  double stiffness = 0.5;
  double force = 0.0;

  template <typename S = TrackingWallTissue>
  static constexpr auto parameters() {
    return std::tuple{Parameter{"stiffness_N_per_mm", &S::stiffness, Range{0.01, 100.0}, "N/mm",
                                "K_t, spring of the wall", Origin::choice},
                      Parameter{"force_N", &S::force, Range{0.0, 50.0}, "N",
                                "f_R, at which the wall begins to follow", Origin::choice}};
  }
};

// How `depth_profile` (Kwon 2001) treats a tissue.
enum class DepthProfileKind : std::uint8_t {
  nothing,  // air, gas, fluid: no force
  soft,     // cut: the trailing spring
  bone,     // never cut: a fixed spring
  organ     // must not be touched: no force and an event
};
constexpr std::array<std::string_view, 4> enumeration_names(DepthProfileKind) {
  return {"nothing", "soft", "bone", "organ"};
}

struct DepthProfileTissue {
  DepthProfileKind kind = DepthProfileKind::nothing;
  double stiffness = 0.4;
  double slope = 0.0;

  template <typename S = DepthProfileTissue>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"kind", &S::kind, "what happens behind the skin", Origin::choice},
        Parameter{"stiffness_N_per_mm", &S::stiffness, Range{0.0, 10.0}, "N/mm", "k at the skin", Origin::choice},
        Parameter{"slope_N_per_mm2", &S::slope, Range{-1.0, 1.0}, "N/mm^2",
                  "dk/dd, change of k with depth; k stays within 0 and 10 N/mm", Origin::choice}};
  }
};

// Effect of a tissue, or of a value of the field, on the proxy of `volume_proxy` (Faerber).
struct ProxyProperties {
  double penetrability = 0.0;
  double friction = 0.0;
  double drag = 0.0;
  double viscosity = 0.0;

  template <typename S = ProxyProperties>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"penetrability_N", &S::penetrability, Range{0.0, 50.0}, "N", "T_N, to go up the gradient",
                  Origin::choice},
        Parameter{"friction_N", &S::friction, Range{0.0, 50.0}, "N", "T_T, to slide across the gradient",
                  Origin::choice},
        Parameter{"drag_N", &S::drag, Range{0.0, 50.0}, "N", "R_d, of the variant drag", Origin::choice},
        Parameter{"viscosity_N_s_per_mm", &S::viscosity, Range{0.0, 10.0}, "N s/mm", "R_v, of the variant viscous",
                  Origin::choice}};
  }
};

struct VolumeProxyTissue {
  ProxyProperties properties;
  double field_value = 0.0;

  template <typename S = VolumeProxyTissue>
  static constexpr auto parameters() {
    return std::tuple{Inlined{&S::properties},
                      Parameter{"field_value", &S::field_value, Range{-10.0, 10.0}, "",
                                "V_label: the harder a tissue feels, the higher", Origin::choice}};
  }
};

// Friction per mm of shaft in contact with the tissue (Dahl, LuGre).
struct ShaftFrictionTissue {
  double coulomb = 0.0;
  double static_force = 0.0;
  double stiffness = 0.05;
  double viscous = 0.0;

  template <typename S = ShaftFrictionTissue>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"coulomb_N_per_mm", &S::coulomb, Range{0.0, 10.0}, "N/mm", "F_c, while the shaft slides",
                  Origin::choice},
        Parameter{"static_N_per_mm", &S::static_force, Range{0.0, 10.0}, "N/mm",
                  "F_s, at rest; equal to F_c: Dahl, more: LuGre", Origin::choice},
        Parameter{"stiffness_N_per_mm2", &S::stiffness, Range{1e-6, 100.0}, "N/mm^2", "sigma_0, of the bristles",
                  Origin::choice},
        Parameter{"viscous_N_s_per_mm2", &S::viscous, Range{0.0, 1.0}, "N s/mm^2", "sigma_2", Origin::choice}};
  }
  static constexpr auto relations() {
    return std::tuple{AtMost{&ShaftFrictionTissue::coulomb, &ShaftFrictionTissue::static_force}};
  }
};

// Effect of the tissue on a fluid that is pushed out of the needle's tip (`syringe`; Vaughan 2012).
struct SyringeTissue {
  double resistance = 0.05;
  double pressure = 0.0;

  template <typename S = SyringeTissue>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"resistance_MPa_s_per_mm3", &S::resistance, Range{0.0, 1e6}, "MPa s/mm^3",
                  "against the outflow; large: nothing flows", Origin::choice},
        Parameter{"pressure_MPa", &S::pressure, Range{-0.01, 0.05}, "MPa", "gauge, in the tissue", Origin::choice}};
  }
};

// Direction of the fibres of a tissue, as an axis of the patient.
enum class FibreAxis : std::uint8_t {
  none,       // no fibres
  superior,   // along the spine
  left,       // from side to side
  posterior,  // from front to back
};
constexpr std::array<std::string_view, 4> enumeration_names(FibreAxis) {
  return {"none", "superior", "left", "posterior"};
}

// Elastic properties of a tissue of a deformable body (docs/fem.md), and its resistance to a needle there
// (docs/fem-contact.md). young = 0: not stated, so the tissue cannot be in a mesh. Moduli along the fibres are used
// only for tissues with fibres; 0: equal to the moduli across them.
struct DeformableTissue {
  double young = 0.0;
  double poisson = 0.3;
  double friction = 0.0;
  double puncture_force = 0.0;
  double cutting_force = 0.0;
  double stiffness = 0.0;
  FibreAxis fibres = FibreAxis::none;
  double young_along = 0.0;
  double shear_along = 0.0;

  template <typename S = DeformableTissue>
  static constexpr auto parameters() {
    return std::tuple{Parameter{"young_MPa", &S::young, Range{1e-5, 1e6}, "MPa", "Young's modulus", Origin::choice},
                      Parameter{"poisson", &S::poisson, Range{0.0, 0.49}, "",
                                "Poisson's ratio; nearer to 1/2 linear tetrahedra lock", Origin::choice},
                      Parameter{"friction_N_per_mm", &S::friction, Range{0.0, 10.0}, "N/mm",
                                "mu_t, Coulomb force per mm of shaft", Origin::choice},
                      Parameter{"puncture_force_N", &S::puncture_force, Range{0.0, 100.0}, "N",
                                "F_p, along the needle, at which the tissue gives way; 0: at once", Origin::choice},
                      Parameter{"cutting_force_N", &S::cutting_force, Range{0.0, 100.0}, "N",
                                "F_c, along the needle, at which its tip cuts on inside the tissue", Origin::choice},
                      Parameter{"stiffness_N_per_mm", &S::stiffness, Range{0.0, 100.0}, "N/mm",
                                "k_target, of `closest_node` alone; 0: as the mesh has it", Origin::choice},
                      Parameter{"fibres", &S::fibres, "axis of the patient along which fibres run", Origin::choice},
                      Parameter{"young_along_MPa", &S::young_along, Range{0.0, 1e6}, "MPa",
                                "Young's modulus along the fibres; 0: as across them", Origin::choice},
                      Parameter{"shear_along_MPa", &S::shear_along, Range{0.0, 1e6}, "MPa",
                                "shear modulus along the fibres; 0: as across them", Origin::choice}};
  }
};

}  // namespace bodkin::anatomy
