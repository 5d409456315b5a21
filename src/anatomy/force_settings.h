#pragma once

#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "anatomy/part_settings.h"
#include "anatomy/resistance_settings.h"
#include "core/geometry.h"

namespace bodkin::anatomy {

// A case's choice of force models: one resistance, one constraint, parts that add to them, compensation. Properties
// of tissues are in the tissue library. Tables: core/parameter.h.

// --- constraints -------------------------------------------------------------------------------------------------

// Settings of the `line_spring` constraint (Heng 2004 eq. 9).
struct LineSpringSettings {
  static constexpr std::string_view element = "line_spring";
  double stiffness = 0.5;
  double damping = 0.0;
  double limit = 3.0;

  template <typename S = LineSpringSettings>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"stiffness_N_per_mm", &S::stiffness, Range{0.0, 100.0}, "N/mm", "k_c", Origin::choice},
        Parameter{"damping_N_s_per_mm", &S::damping, Range{0.0, 1.0}, "N s/mm", "b_c", Origin::choice},
        Parameter{"limit_N", &S::limit, above(0.0, 100.0), "N", "largest force", Origin::choice}};
  }
};

// Settings of Pivot.
struct PivotSettings {
  static constexpr std::string_view element = "pivot";
  double stiffness = 0.2;
  double gain = 1.0;
  double limit = 2.0;
  double shortest_outside = 20.0;
  double largest_angle = 0.3;

  template <typename S = PivotSettings>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"stiffness_N_per_mm", &S::stiffness, Range{0.0, 10.0}, "N/mm", "k_t", Origin::choice},
        Parameter{"gain", &S::gain, Range{0.0, 10.0}, "", "c", Origin::choice},
        Parameter{"limit_N", &S::limit, Range{1e-3, 100.0}, "N", "largest force", Origin::paper},
        Parameter{"shortest_outside_mm", &S::shortest_outside, Range{1.0, 500.0}, "mm", "l_2 is never taken smaller",
                  Origin::choice},
        Parameter{"largest_angle_rad", &S::largest_angle, Range{0.01, 1.0}, "rad",
                  "the deflection grows no further; the paper wants much less than 1 rad", Origin::choice}};
  }
};

// Settings of Rail.
struct RailSettings {
  static constexpr std::string_view element = "rail";
  double stiffness = 0.5;
  double limit = 3.0;
  double torsion = 1000.0;
  double full_depth = 40.0;
  double torque_limit = 188.0;

  template <typename S = RailSettings>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"stiffness_N_per_mm", &S::stiffness, Range{0.0, 10.0}, "N/mm", "k, across the line",
                  Origin::choice},
        Parameter{"limit_N", &S::limit, Range{1e-3, 100.0}, "N", "largest force across the line", Origin::choice},
        Parameter{"torsion_N_mm_per_rad", &S::torsion, Range{0.0, 1e5}, "N mm/rad", "kappa_0, at full depth",
                  Origin::choice},
        Parameter{"full_depth_mm", &S::full_depth, Range{1.0, 500.0}, "mm",
                  "depth_ref, where the torque is fully grown", Origin::choice},
        Parameter{"torque_limit_N_mm", &S::torque_limit, Range{1e-3, 1e4}, "N mm",
                  "largest torque; continuous yaw and pitch torque of the Phantom Premium 1.5", Origin::paper}};
  }
};

// Settings of Beam.
struct BeamSettings {
  static constexpr std::string_view element = "beam";
  double modulus = 193000.0;
  bool stylet = false;
  double largest_stiffness = 1.0;
  double limit = 2.0;
  double smoothing = 20.0;

  template <typename S = BeamSettings>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"modulus_MPa", &S::modulus, Range{1000.0, 500000.0}, "MPa", "E, of stainless steel AISI 304",
                  Origin::literature},
        Parameter{"stylet", &S::stylet, "the bore is filled: the needle bends as a solid rod", Origin::choice},
        Parameter{"largest_stiffness_N_per_mm", &S::largest_stiffness, Range{0.01, 10.0}, "N/mm", "of the device",
                  Origin::choice},
        Parameter{"limit_N", &S::limit, Range{1e-3, 100.0}, "N",
                  "largest force; as Kwon et al. 2001 use for the same role", Origin::choice},
        Parameter{"smoothing_Hz", &S::smoothing, Range{1.0, 400.0}, "Hz", "low pass on the length outside",
                  Origin::choice}};
  }
};

// The needle is free to leave its line.
struct NoConstraint {
  static constexpr std::string_view element = "none";
  static constexpr auto parameters() { return std::tuple{}; }
};

// All constraints; to add one, its settings above and its name here. The model with these settings says so in its
// source (forces/constraint_model.h).
using ConstraintSettings = std::variant<LineSpringSettings, PivotSettings, RailSettings, BeamSettings, NoConstraint>;
inline constexpr auto constraint_names = element_names(std::type_identity<ConstraintSettings>());

// --- parts -------------------------------------------------------------------------------------------------------

// One decaying part of an elastic force.
struct PronyTerm {
  double share = 0.5;
  double time = 0.2;

  template <typename S = PronyTerm>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"share", &S::share, Range{0.0, 1.0}, "", "g_i, of the force; all together 1 at most",
                  Origin::choice},
        Parameter{"time_s", &S::time, Range{1e-3, 1e4}, "s", "tau_i, in which it decays", Origin::choice}};
  }
};

// Settings of NeedleGrasp.
struct NeedleGraspSettings {
  double one_way = 1.67;
  double two_way = 0.52;
  double point = 1.0;
  double turns_to_wind = 2.0;

  template <typename S = NeedleGraspSettings>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"one_way", &S::one_way, Range{0.0, 10.0}, "",
                  "rise of the pull-out force after turning one way (Langevin et al. 2001: +167 %)",
                  Origin::literature},
        Parameter{"two_way", &S::two_way, Range{0.0, 10.0}, "",
                  "rise after turning to and fro (+52 %); at most one_way", Origin::literature},
        Parameter{"point", &S::point, Range{0.1, 10.0}, "",
                  "factor at an acupuncture point (1.18 compared with control points)", Origin::literature},
        Parameter{"turns_to_wind", &S::turns_to_wind, Range{0.1, 100.0}, "turns", "after which 63 % are reached",
                  Origin::choice}};
  }
  static constexpr auto relations() {
    return std::tuple{AtMost{&NeedleGraspSettings::two_way, &NeedleGraspSettings::one_way}};
  }
};

// The parts added to the resistance.
struct ForceParts {
  // For `embedded_needle`, `spring_damper_wall` and `tracking_wall` without leash.
  std::vector<PronyTerm> relaxation;
  // For resistances without shaft friction of their own (ResistanceTraits::has_shaft_friction).
  std::optional<ShaftFrictionSettings> shaft_friction;
  // Multiplies the shaft friction by the effect of turning the needle; for `layered`, `shaft_friction` and
  // resistances with that part.
  std::optional<NeedleGraspSettings> needle_grasp;
  // For every resistance.
  std::optional<BevelTipSettings> bevel_tip;
  std::optional<CsfFlowSettings> csf_flow;
  std::optional<SyringeSettings> syringe;
  std::optional<FingertipSettings> fingertip;

  template <typename S = ForceParts>
  static constexpr auto parameters() {
    return std::tuple{ChildElements{"relaxation", &S::relaxation, "a decaying part of an elastic force", 4},
                      ChildElement{"shaft_friction", &S::shaft_friction, "friction of the shaft"},
                      ChildElement{"needle_grasp", &S::needle_grasp, "tissue that winds up on a turning needle"},
                      ChildElement{"bevel_tip", &S::bevel_tip, "the pull of the tissue on a bevel"},
                      ChildElement{"csf_flow", &S::csf_flow, "fluid that returns through the needle"},
                      ChildElement{"syringe", &S::syringe, "a thumb on the plunger of a syringe on the hub"},
                      ChildElement{"fingertip", &S::fingertip, "a finger that feels the skin before the needle"}};
  }
  static constexpr auto relations() {
    return std::tuple{
        Relation<ForceParts>{[](const ForceParts& parts) {
                               double sum = 0.0;
                               for (const PronyTerm& term : parts.relaxation) sum += term.share;
                               return sum <= 1.0;
                             },
                             "the shares of the elements relaxation add up to more than 1, expected at most 1"}};
  }
};

// --- compensation ------------------------------------------------------------------------------------------------

// Settings of GravityCompensation; a device profile's values, from fit_gravity or entered by hand.
struct GravitySettings {
  Vec3 up = Vec3::UnitZ();  // in the frame in which forces are commanded; files state it with any length
  double weight = 0.0;
  Vec3 slope = Vec3::Zero();
  Vec3 centre = Vec3::Zero();
  double limit = 3.0;

  template <typename S = GravitySettings>
  static constexpr auto parameters() {
    constexpr Range slope_range = {-0.1, 0.1}, centre_range = {-1e4, 1e4}, up_range = {-1000.0, 1000.0};
    constexpr std::string_view slope_is = "change of the weight with position; 0: a constant force";
    constexpr std::string_view up_is = "direction against gravity, of any length";
    return std::tuple{
        Parameter{"weight_N", &S::weight, Range{0.0, 20.0}, "N", "m_eff g, at the centre", Origin::choice},
        Component{"slope_x_N_per_mm", &S::slope, 0, slope_range, "N/mm", slope_is, Origin::choice},
        Component{"slope_y_N_per_mm", &S::slope, 1, slope_range, "N/mm", slope_is, Origin::choice},
        Component{"slope_z_N_per_mm", &S::slope, 2, slope_range, "N/mm", slope_is, Origin::choice},
        Component{"centre_x_mm", &S::centre, 0, centre_range, "mm", "of the workspace", Origin::choice},
        Component{"centre_y_mm", &S::centre, 1, centre_range, "mm", "of the workspace", Origin::choice},
        Component{"centre_z_mm", &S::centre, 2, centre_range, "mm", "of the workspace", Origin::choice},
        Parameter{"limit_N", &S::limit, Range{1e-3, 20.0}, "N", "largest force", Origin::choice},
        Component{"up_x", &S::up, 0, up_range, "", up_is, Origin::choice}.joint(),
        Component{"up_y", &S::up, 1, up_range, "", up_is, Origin::choice}.joint(),
        Component{"up_z", &S::up, 2, up_range, "", up_is, Origin::choice}.joint()};
  }
};

}  // namespace bodkin::anatomy
