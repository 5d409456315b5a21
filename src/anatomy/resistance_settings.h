#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "anatomy/deformable_settings.h"
#include "anatomy/registered_settings.h"
#include "anatomy/tissue_forces.h"

namespace bodkin::anatomy {

// Settings of the resistances of a case, and the list of all. Properties of tissues are in the tissue library.
// Tables: core/parameter.h.

enum class LayeredLaw : std::uint8_t {
  cubic,  // eq. 2 as printed
  sum     // the piecewise sum of elements that the text before eq. 2 describes
};
constexpr std::array<std::string_view, 2> enumeration_names(LayeredLaw) {
  return {"cubic", "sum"};
}

// Settings of the `layered` resistance that are not properties of a tissue.
struct LayeredSettings {
  static constexpr std::string_view element = "layered";
  LayeredLaw law = LayeredLaw::cubic;
  bool strict = false;
  double layer = 0.5;

  template <typename S = LayeredSettings>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"law", &S::law, "eq. 2 as printed, or the piecewise sum that the text before it describes",
                  Origin::paper},
        Parameter{"strict", &S::strict, "the break rule of eq. 3 to the letter", Origin::choice},
        Parameter{"layer_mm", &S::layer, Range{0.1, 2.0}, "mm", "between tissue samples along the path",
                  Origin::choice}};
  }
};

// Settings of SpringDamperWall.
struct SpringDamperWallSettings {
  static constexpr std::string_view element = "spring_damper_wall";
  double stiffness = 0.5;
  double damping = 0.0002;  // a device of 1 N/mm at 1 kHz renders at most 0.00025 with this stiffness
  double wall = 0.0;
  double limit = 8.5;

  template <typename S = SpringDamperWallSettings>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"stiffness_N_per_mm", &S::stiffness, Range{0.0, 100.0}, "N/mm", "K; the paper's tuned K_t",
                  Origin::paper},
        Parameter{"damping_N_s_per_mm", &S::damping, Range{0.0, 1.0}, "N s/mm", "B", Origin::choice},
        Parameter{"wall_mm", &S::wall, Range{-1000.0, 1000.0}, "mm", "x_w, where the wall stands", Origin::choice},
        Parameter{"limit_N", &S::limit, Range{1e-3, 100.0}, "N", "largest force; the peak of a Phantom Premium 1.5",
                  Origin::choice}};
  }
};

// A layer given by the depth at which it begins instead of by its tissue.
struct TrackingWallDepthLayer {
  double from = 0.0;
  TrackingWallTissue layer;

  template <typename S = TrackingWallDepthLayer>
  static constexpr auto parameters() {
    return std::tuple{Parameter{"from_mm", &S::from, Range{0.0, 1000.0}, "mm",
                                "below the surface; 0 for the first layer, then rising", Origin::choice},
                      Inlined{&S::layer}};
  }
};

// Settings of TrackingWall and TrackingWallLeash.
struct TrackingWallSettings {
  static constexpr std::string_view element = "tracking_wall";
  bool leash = false;
  double surface = 0.0;
  double catch_up = 0.5;
  bool strict = false;
  double limit = 8.5;
  double channel_radius = 1.0;
  double channel_tilt = 3.0;
  std::vector<TrackingWallDepthLayer> layers;

  template <typename S = TrackingWallSettings>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"leash", &S::leash, "the wall is a point that may leave the line", Origin::choice},
        Parameter{"surface_mm", &S::surface, Range{-1000.0, 1000.0}, "mm", "w0, the surface of the patient",
                  Origin::choice},
        Parameter{"catch_up_s", &S::catch_up, Range{1e-3, unbounded}, "s",
                  "from a stop to no force; INF: the wall holds where it is", Origin::choice},
        Parameter{"strict", &S::strict, "eq. 7 to the letter: no force below the last stop; active, see the page",
                  Origin::choice},
        Parameter{"limit_N", &S::limit, Range{1e-3, 100.0}, "N", "largest force", Origin::choice},
        Parameter{"channel_radius_mm", &S::channel_radius, Range{0.0, 100.0}, "mm",
                  "entries closer than this share a channel", Origin::choice},
        Parameter{"channel_tilt_deg", &S::channel_tilt, Range{0.0, 90.0}, "deg",
                  "directions closer than this share a channel", Origin::choice},
        ChildElements{"layer", &S::layers, "used instead of the tissues, if any", 1000}};
  }
  static constexpr auto relations() {
    return std::tuple{Rising{&TrackingWallSettings::layers, &TrackingWallDepthLayer::from, 0.0}};
  }
};

// Settings of DepthProfile.
struct DepthProfileSettings {
  static constexpr std::string_view element = "depth_profile";
  double skin_stiffness = 0.3;
  double puncture_depth = 5.0;
  double trailing = 2.0;
  double bone_stiffness = 1.0;
  double limit = 6.0;
  double release = 0.02;
  double filter = 30.0;
  double stiffening = 20.0;
  double hysteresis = 1.0;
  double channel_radius = 1.0;
  double channel_tilt = 3.0;

  template <typename S = DepthProfileSettings>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"skin_stiffness_N_per_mm", &S::skin_stiffness, Range{0.01, 10.0}, "N/mm", "k_skin", Origin::choice},
        Parameter{"puncture_depth_mm", &S::puncture_depth, Range{0.1, 50.0}, "mm", "X_d, at which the skin gives way",
                  Origin::choice},
        Parameter{"trailing_mm", &S::trailing, Range{0.01, 50.0}, "mm",
                  "X_d2, length of the trailing spring; at most puncture_depth_mm", Origin::choice},
        Parameter{"bone_stiffness_N_per_mm", &S::bone_stiffness, Range{0.01, 10.0}, "N/mm",
                  "k_bone; the device's limit at most", Origin::choice},
        Parameter{"limit_N", &S::limit, Range{1e-3, 100.0}, "N", "largest force", Origin::paper},
        Parameter{"release_s", &S::release, Range{0.0, 1.0}, "s", "until the force is zero on withdrawal",
                  Origin::choice},
        Parameter{"filter_Hz", &S::filter, Range{1.0, 400.0}, "Hz", "low pass on k", Origin::choice},
        Parameter{"stiffening_N_per_mm_s", &S::stiffening, Range{0.1, 1000.0}, "N/(mm s)", "fastest rise of k",
                  Origin::choice},
        Parameter{"hysteresis_mm", &S::hysteresis, Range{0.0, 5.0}, "mm",
                  "way before a change of tissue is taken back; a voxel", Origin::choice},
        Parameter{"channel_radius_mm", &S::channel_radius, Range{0.0, 100.0}, "mm",
                  "entries closer than this share a puncture", Origin::choice},
        Parameter{"channel_tilt_deg", &S::channel_tilt, Range{0.0, 90.0}, "deg",
                  "directions closer than this share a puncture", Origin::choice}};
  }
  static constexpr auto relations() {
    return std::tuple{AtMost{&DepthProfileSettings::trailing, &DepthProfileSettings::puncture_depth}};
  }
};

// How the field of `volume_proxy` is computed from CT and tissues.
struct HapticFieldSettings {
  double ct_range = 0.2;
  double lowest_hounsfield = -200.0;
  double highest_hounsfield = 1500.0;
  double smoothing = 1.0;

  template <typename S = HapticFieldSettings>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"field_ct_range", &S::ct_range, Range{0.0, 10.0}, "",
                  "what the CT adds from lowest to highest HU, on the scale of the labels", Origin::choice},
        Parameter{"field_lowest_HU", &S::lowest_hounsfield, Range{-2000.0, 3000.0}, "HU",
                  "below it the CT adds nothing", Origin::choice},
        Parameter{"field_highest_HU", &S::highest_hounsfield, Range{-2000.0, 4000.0}, "HU",
                  "above it no more is added; at least 1 HU above the lowest", Origin::choice},
        Parameter{"field_smoothing_voxels", &S::smoothing, Range{0.0, 3.0}, "voxels",
                  "standard deviation of the Gaussian on V_label", Origin::choice}};
  }
  static constexpr auto relations() {
    return std::tuple{AtMost{&HapticFieldSettings::lowest_hounsfield, &HapticFieldSettings::highest_hounsfield, 1.0}};
  }
};

// A point of a transfer function of V; the properties are linear between points and constant outside.
struct TransferPoint {
  double value = 0.0;
  ProxyProperties properties;

  template <typename S = TransferPoint>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"value", &S::value, Range{-100.0, 100.0}, "", "V; rising from point to point", Origin::choice},
        Inlined{&S::properties}};
  }
};

enum class ProxyVariant : std::uint8_t {
  drag,    // eq. 5 as printed: a force that does not depend on speed
  viscous  // a force in proportion to speed
};
constexpr std::array<std::string_view, 2> enumeration_names(ProxyVariant) {
  return {"drag", "viscous"};
}

// Settings of VolumeProxy.
struct VolumeProxySettings {
  static constexpr std::string_view element = "volume_proxy";
  double stiffness = 0.5;
  double gradient_reference = 0.1;
  double gradient_least = 1e-4;
  ProxyVariant variant = ProxyVariant::drag;
  bool two_sided = false;
  double limit = 8.5;
  HapticFieldSettings field;
  std::vector<TransferPoint> transfer;

  template <typename S = VolumeProxySettings>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"stiffness_N_per_mm", &S::stiffness, Range{0.01, 10.0}, "N/mm", "k, from the tip to the proxy",
                  Origin::choice},
        Parameter{"gradient_reference_per_mm", &S::gradient_reference, Range{1e-6, 1000.0}, "1/mm",
                  "g_ref, from which on T_N is complete", Origin::choice},
        Parameter{"gradient_least_per_mm", &S::gradient_least, Range{0.0, 1000.0}, "1/mm",
                  "g_min: flatter is homogeneous; at most gradient_reference_per_mm", Origin::choice},
        Parameter{"variant", &S::variant, "eq. 5 as printed, or a force in proportion to speed", Origin::paper},
        Parameter{"two_sided", &S::two_sided, "T_N also on leaving dense tissue", Origin::choice},
        Parameter{"limit_N", &S::limit, Range{1e-3, 100.0}, "N", "largest force; the peak of the Phantom Premium 1.5",
                  Origin::paper},
        Inlined{&S::field},
        ChildElements{"transfer_point", &S::transfer,
                      "a transfer function of the value V, used instead of the tissues, if any", 1000}};
  }
  template <typename S = VolumeProxySettings>
  static constexpr auto relations() {
    return std::tuple{AtMost{&S::gradient_least, &S::gradient_reference},
                      Rising{&S::transfer, &TransferPoint::value, std::numeric_limits<double>::quiet_NaN()}};
  }
};

// Friction of one direction, per mm of inserted shaft.
struct KarnoppFriction {
  double coulomb = 0.0;
  double viscous = 0.0;
  double static_force = 0.0;

  template <typename S = KarnoppFriction>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"coulomb_N_per_mm", &S::coulomb, Range{0.0, 10.0}, "N/mm", "C", Origin::literature},
        Parameter{"viscous_N_s_per_mm2", &S::viscous, Range{0.0, 1.0}, "N s/mm^2", "b", Origin::literature},
        Parameter{"static_N_per_mm", &S::static_force, Range{0.0, 10.0}, "N/mm", "D", Origin::literature}};
  }
};

// Settings of ThreeComponent. Friction: Okamura et al. 2004, bovine liver, recalled.
struct ThreeComponentSettings {
  static constexpr std::string_view element = "three_component";
  double linear = 0.02;
  double quadratic = 0.03;
  double puncture_force = 0.85;
  double cutting_force = 0.3;
  double cutting_stiffness = 1.0;
  KarnoppFriction inwards = {0.01196, 0.00021213, 0.01845};
  KarnoppFriction outwards = {0.01057, 0.00029308, 0.01823};
  double dead_band = 1.0;
  double hold = 0.1;
  double limit = 8.5;

  template <typename S = ThreeComponentSettings>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"linear_N_per_mm", &S::linear, Range{0.0, 10.0}, "N/mm", "a1, of the capsule", Origin::choice},
        Parameter{"quadratic_N_per_mm2", &S::quadratic, Range{0.0, 10.0}, "N/mm^2",
                  "a2, of the capsule; not both zero", Origin::choice},
        Parameter{"puncture_force_N", &S::puncture_force, Range{0.01, 50.0}, "N", "at which the capsule gives way",
                  Origin::choice},
        Parameter{"cutting_force_N", &S::cutting_force, Range{0.0, 50.0}, "N",
                  "constant after the puncture; at most puncture_force_N", Origin::choice},
        Parameter{"cutting_stiffness_N_per_mm", &S::cutting_stiffness, Range{0.01, 100.0}, "N/mm",
                  "of the onset of cutting", Origin::choice},
        Parameter{"dead_band_mm_per_s", &S::dead_band, Range{0.01, 100.0}, "mm/s",
                  "D_v: slower than half of it is at rest", Origin::choice},
        Parameter{"hold_N_per_mm2", &S::hold, Range{0.001, 100.0}, "N/mm^2",
                  "sigma, spring of the friction at rest, per mm of shaft", Origin::choice},
        Parameter{"limit_N", &S::limit, Range{1e-3, 100.0}, "N", "largest force", Origin::choice},
        ChildElement{"inwards", &S::inwards, "friction of a shaft that goes in"},
        ChildElement{"outwards", &S::outwards, "friction of a shaft that comes out"}};
  }
  template <typename S = ThreeComponentSettings>
  static constexpr auto relations() {
    return std::tuple{
        AtMost{&S::cutting_force, &S::puncture_force},
        Relation<S>{[](const S& s) { return s.linear != 0.0 || s.quadratic != 0.0; },
                    "linear_N_per_mm and quadratic_N_per_mm2 are both 0, expected one of them above 0"}};
  }
};

// Settings of Fracture.
struct FractureSettings {
  static constexpr std::string_view element = "fracture";
  double stiffness = 0.05;
  double spacing = 1.0;
  double toughness = 1.0;
  double width = 0.8;
  double thickness = 1.0;
  double cutting_stiffness = 1.0;
  double cutting_toughness = 0.1;
  double limit = 8.5;

  template <typename S = FractureSettings>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"stiffness_N_per_mm", &S::stiffness, Range{0.001, 10.0}, "N/mm",
                  "k, of the cubic law before rupture", Origin::choice},
        Parameter{"spacing_mm", &S::spacing, Range{0.1, 10.0}, "mm", "dx, of the cubic law", Origin::choice},
        Parameter{"toughness_N_per_mm", &S::toughness, Range{1e-4, 100.0}, "N/mm", "J, of the membrane",
                  Origin::choice},
        Parameter{"width_mm", &S::width, Range{0.05, 5.0}, "mm", "w, of the crack: about the needle's diameter",
                  Origin::choice},
        Parameter{"thickness_mm", &S::thickness, Range{0.01, 20.0}, "mm", "t_m, of the membrane", Origin::choice},
        Parameter{"cutting_stiffness_N_per_mm", &S::cutting_stiffness, Range{0.01, 100.0}, "N/mm",
                  "of the onset of cutting", Origin::choice},
        Parameter{"cutting_toughness_N_per_mm", &S::cutting_toughness, Range{0.0, 100.0}, "N/mm",
                  "J, of the tissue behind the membrane", Origin::choice},
        Parameter{"limit_N", &S::limit, Range{1e-3, 100.0}, "N", "largest force", Origin::choice}};
  }
};

// Settings of ShaftFriction, as a resistance of its own or as a part.
struct ShaftFrictionSettings {
  static constexpr std::string_view element = "shaft_friction";
  double stribeck_velocity = 5.0;

  template <typename S = ShaftFrictionSettings>
  static constexpr auto parameters() {
    return std::tuple{Parameter{"stribeck_velocity_mm_per_s", &S::stribeck_velocity, Range{0.01, 1000.0}, "mm/s",
                                "v_s, at which static has become Coulomb friction", Origin::choice}};
  }
};

// Settings of SurfaceProxy.
struct SurfaceProxySettings {
  static constexpr std::string_view element = "surface_proxy";
  double stiffness = 1.0;
  double static_friction = 0.3;
  double dynamic_friction = 0.2;
  double stick_after = 0.02;
  double viscosity = 0.0;
  double limit = 8.5;

  static constexpr auto parameters() {
    using S = SurfaceProxySettings;
    return std::tuple{
        Parameter{"stiffness_N_per_mm", &S::stiffness, Range{0.01, 10.0}, "N/mm", "k, of the skin", Origin::choice},
        Parameter{"static_friction", &S::static_friction, Range{0.0, 10.0}, "", "mu_s; at least mu_d",
                  Origin::choice},
        Parameter{"dynamic_friction", &S::dynamic_friction, Range{0.0, 10.0}, "", "mu_d", Origin::choice},
        Parameter{"stick_after_s", &S::stick_after, Range{0.0, 1.0}, "s", "at rest after which mu_s holds again",
                  Origin::choice},
        Parameter{"viscosity_N_s_per_mm", &S::viscosity, Range{0.0, 1.0}, "N s/mm", "b, against sliding",
                  Origin::choice},
        Parameter{"limit_N", &S::limit, Range{1e-3, 100.0}, "N", "largest force; the peak of a Phantom Premium 1.5",
                  Origin::paper}};
  }
  static constexpr auto relations() {
    return std::tuple{AtMost{&SurfaceProxySettings::dynamic_friction, &SurfaceProxySettings::static_friction}};
  }
};

// All resistances; to add one, its settings above and its name here. The model with these settings says so in its
// source (forces/resistance_model.h).
using ResistanceSettings =
    std::variant<LayeredSettings, SpringDamperWallSettings, TrackingWallSettings, DepthProfileSettings,
                 VolumeProxySettings, ThreeComponentSettings, FractureSettings, ShaftFrictionSettings,
                 EmbeddedNeedleSettings, ClosestNodeSettings, SurfaceProxySettings, RegisteredSettings>;

// The names of models as case files write them, in the order of the variant: of each its struct's `element`.
template <typename... Models>
constexpr std::array<std::string_view, sizeof...(Models)> element_names(
    std::type_identity<std::variant<Models...>> /*of*/) {
  return {Models::element...};
}
inline constexpr auto resistance_names = element_names(std::type_identity<ResistanceSettings>());

// That of the one that is chosen.
template <typename... Models>
std::string_view name_of(const std::variant<Models...>& settings) {
  return std::visit([](const auto& model) { return model.element; }, settings);
}

// The name of the model: that of name_of(), or the one under which the program registered it.
inline std::string_view model_name(const ResistanceSettings& settings) {
  const auto* registered = std::get_if<RegisteredSettings>(&settings);
  return registered == nullptr ? name_of(settings) : std::string_view(registered->name);
}

// What the deformable body of a resistance is made with; nullptr when the resistance needs none.
inline const DeformableBodySettings* body_of(const ResistanceSettings& settings) {
  return std::visit(
      [](const auto& model) -> const DeformableBodySettings* {
        if constexpr (requires { model.body; }) return &model.body;
        return nullptr;
      },
      settings);
}

}  // namespace bodkin::anatomy
