#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "anatomy/tissue_forces.h"
#include "core/geometry.h"

namespace bodkin {

// What a case chooses of the force models: one resistance, one constraint, parts that add to them, compensation. What
// depends on the tissue stands in the tissue library. Origin of a default: [P] printed in the model's paper,
// [L] other literature, [D] our choice.

// --- resistances -------------------------------------------------------------------------------------------------

enum class LayeredLaw : std::uint8_t {
  cubic,  // eq. 2 as printed
  sum     // the piecewise sum of elements that the text before eq. 2 describes
};

// Settings of the `layered` resistance that are not properties of a tissue.
struct LayeredSettings {
  LayeredLaw law = LayeredLaw::cubic;
  bool strict = false;  // literal break rule of eq. 3
  double layer = 0.5;   // mm between tissue samples along the path; 0.1 to 2
};

// Settings of SpringDamperWall. [P] printed in the paper, [D] our choice.
struct SpringDamperWallSettings {
  double stiffness = 0.5;   // K, N/mm; 0 to 100 [P: the paper's tuned K_t]
  double damping = 0.0002;  // B, N s/mm; 0 to 1 [D: a device of 1 N/mm at 1 kHz renders at most 0.00025 beside K]
  double wall = 0.0;        // x_w, mm; -1000 to 1000
  double limit = 8.5;       // N; > 0 to 100 [D: peak of a Phantom Premium 1.5]
};

// A layer given by where it begins instead of by its tissue.
struct TrackingWallDepthLayer {
  double from = 0.0;  // mm below the surface; the first one 0, increasing
  TrackingWallTissue layer;
};

// Settings of TrackingWall and TrackingWallLeash. [P] printed in the paper, [D] our choice.
struct TrackingWallSettings {
  bool leash = false;                          // the wall is a point that may leave the line: TrackingWallLeash
  double surface = 0.0;                        // w0, mm; -1000 to 1000
  double catch_up = 0.5;                       // s; from a stop to no force; 1e-3 to infinity, infinity = hold [D]
  bool strict = false;                         // eq. 7 to the letter: no force below the last stop; active, see docs
  double limit = 8.5;                          // N; > 0 to 100 [D]
  double channel_radius = 1.0;                 // mm; entries closer than this share a channel; 0 to 100 [D]
  double channel_tilt = 3.0;                   // deg; likewise; 0 to 90 [D]
  std::vector<TrackingWallDepthLayer> layers;  // if any: used instead of the tissues
};

// Settings of DepthProfile. [P] printed in the paper, [D] our choice.
struct DepthProfileSettings {
  double skin_stiffness = 0.3;  // k_skin, N/mm; 0.01 to 10 [D]
  double puncture_depth = 5.0;  // Xd, mm; 0.1 to 50 [D]
  double trailing = 2.0;        // Xd2, mm; 0.01 to puncture_depth [D]
  double bone_stiffness = 1.0;  // k_bone, N/mm, the device's limit at most; 0.01 to 10 [D]
  double limit = 6.0;           // N; > 0 to 100 [P]
  double release = 0.02;        // s, force to zero on withdrawal; 0 to 1 [D]
  double filter = 30.0;         // Hz, low pass on k; 1 to 400 [D]
  double stiffening = 20.0;     // N/mm per s, fastest rise of k; 0.1 to 1000 [D]
  double hysteresis = 1.0;      // mm, a voxel: way before a tissue change is taken back; 0 to 5 [D]
  double channel_radius = 1.0;  // mm; entries closer than this share a puncture; 0 to 100 [D]
  double channel_tilt = 3.0;    // deg; likewise; 0 to 90 [D]
};

// How the field is made from CT and tissues.
struct HapticFieldSettings {
  double ct_range = 0.2;  // what the CT adds from lowest to highest HU, on the scale of the labels; 0 to 10 [D]
  double lowest_hounsfield = -200.0;   // HU, below it the CT adds nothing; -2000 to 3000 [D]
  double highest_hounsfield = 1500.0;  // HU, above it no more is added; above `lowest` [D]
  double smoothing = 1.0;              // voxels, standard deviation of the Gaussian on V_label; 0 to 3 [D]
};

// A point of a transfer function of V; between points the properties are linear, outside constant.
struct TransferPoint {
  double value = 0.0;
  ProxyProperties properties;
};

enum class ProxyVariant {
  drag,    // eq. 5 as printed: a force that does not depend on speed
  viscous  // a force in proportion to speed
};

// Settings of VolumeProxy. [D] our choice.
struct VolumeProxySettings {
  double stiffness = 0.5;           // k, N/mm; 0.01 to 10 [D]
  double gradient_reference = 0.1;  // g_ref, 1/mm; T_N is complete from this slope on; 1e-6 to 1000 [D]
  double gradient_least = 1e-4;     // g_min, 1/mm; flatter than this is homogeneous; 0 to gradient_reference [D]
  ProxyVariant variant = ProxyVariant::drag;
  bool two_sided = false;  // T_N also on leaving dense tissue
  double limit = 8.5;      // N; > 0 to 100 [P: peak of the Phantom Premium 1.5]
  HapticFieldSettings field;
  std::vector<TransferPoint> transfer;  // if any: transfer function of the value V, used instead of the tissues
};

// Friction of one direction, per mm of inserted shaft.
struct KarnoppFriction {
  double coulomb = 0.0;       // C, N/mm; 0 to 10
  double viscous = 0.0;       // b, N s/mm^2; 0 to 1
  double static_force = 0.0;  // D, N/mm; 0 to 10
};

// Settings of ThreeComponent. [L] Okamura et al. 2004, bovine liver, recalled; [D] our choice.
struct ThreeComponentSettings {
  double linear = 0.02;                                       // a1, N/mm; 0 to 10 [D]
  double quadratic = 0.03;                                    // a2, N/mm^2; 0 to 10, not both zero [D]
  double puncture_force = 0.85;                               // N, at which the capsule gives way; 0.01 to 50 [D]
  double cutting_force = 0.3;                                 // N, constant after; 0 to puncture_force [D]
  double cutting_stiffness = 1.0;                             // N/mm, of its onset; 0.01 to 100 [D]
  KarnoppFriction inwards = {0.01196, 0.00021213, 0.01845};   // [L]
  KarnoppFriction outwards = {0.01057, 0.00029308, 0.01823};  // [L]
  double dead_band = 1.0;  // Dv, mm/s: slower than half of it is at rest; 0.01 to 100 [D]
  double hold = 0.1;       // sigma, N/mm^2: spring of the friction at rest, per mm; 0.001 to 100 [D]
  double limit = 8.5;      // N; > 0 to 100 [D]
};

// Settings of Fracture. All [D] but where marked.
struct FractureSettings {
  double stiffness = 0.05;         // k, N/mm, of the cubic law before rupture; 0.001 to 10
  double spacing = 1.0;            // dx, mm; 0.1 to 10
  double toughness = 1.0;          // J, N/mm; 1e-4 to 100
  double width = 0.8;              // w, mm, of the crack: about the needle's diameter; 0.05 to 5
  double thickness = 1.0;          // t_m, mm, of the membrane; 0.01 to 20
  double cutting_stiffness = 1.0;  // N/mm, of the onset of cutting; 0.01 to 100
  double cutting_toughness = 0.1;  // J, N/mm, of the tissue behind; 0 to 100
  double limit = 8.5;              // N; > 0 to 100
};

// Settings of ShaftFriction, as a resistance of its own or as a part.
struct ShaftFrictionSettings {
  double stribeck_velocity = 5.0;  // vs, mm/s; 0.01 to 1000 [D]
};

// How a case's mesh becomes a deformable body: what holds it, and which nodes the needle can meet. All [D].
struct DeformableBodySettings {
  double corridor_radius = 25.0;   // mm about the planned path; 1 to 200
  double corridor_beyond = 15.0;   // mm that the corridor goes on behind the target; 0 to 200
  double corridor_nodes = 1000.0;  // at most, those nearest to the path; 10 to 5000
  double stiffness_scale = 10.0;   // factor on Young's modulus of every tissue; 0.001 to 1000
  bool fix_bone = true;            // bone and metal do not move
  bool fix_cut = true;             // nor do the faces where the mesh ends inside the patient
  double fix_beyond = 1000.0;      // mm along the planned path behind the entry: deeper nodes do not move; 1 to 1000
};

// How the hand has hold of a needle's hub.
enum class NeedleHold : std::uint8_t {
  clamped,  // place and angle are the hand's
  pinned    // its place alone: the hub turns freely, as in a gimbal without motors
};

// Whether the needle of a case bends in a deformable body, and how (NeedleBeam). [L] literature, [D] our choice.
struct NeedleBendingSettings {
  bool flexible = false;                  // [D]
  double modulus = 193000.0;              // E, MPa, of stainless steel AISI 304; 1000 to 500000 [L]
  bool stylet = false;                    // true: the bore is filled, the needle bends as a solid rod [D]
  NeedleHold hold = NeedleHold::clamped;  // [D]
  double cut_offset =
      0.0;  // mm beside its axis that a bevel cuts, towards its point; 0 to 2, 0 = it cuts straight [D]
};

// Settings of EmbeddedNeedle. All [D].
struct EmbeddedNeedleSettings {
  double capture_radius = 1.5;   // mm; nodes this close to the line are the needle's; 0.05 to 20 [half an edge of 3]
  double spacing = 0.5;          // mm of the line for which one node is kept; 0.05 to 20
  double puncture_time = 0.030;  // s in which the force of a puncture goes; 0.001 to 1
  std::size_t most_nodes = 150;  // along the shaft; 1 to 160
  DeformableBodySettings body;
  NeedleBendingSettings bending;
};

// Settings of ClosestNodeContact. All [D].
struct ClosestNodeSettings {
  double capture_radius = 2.0;  // r_cap, mm; half the edge of an element; 0.05 to 50
  double presliding = 1.0;      // N/mm by which friction grows before the shaft slides; 0.01 to 100
  double relaxation = 0.030;    // s in which a punctured node goes back to its place; 0.001 to 1
  double layer = 0.5;           // mm between the places where the tissue beside the shaft is looked up; 0.1 to 10
  double longest = 300.0;       // mm, of shaft in tissue; 1 to 1000
  DeformableBodySettings body;
};

using ResistanceSettings =
    std::variant<LayeredSettings, SpringDamperWallSettings, TrackingWallSettings, DepthProfileSettings,
                 VolumeProxySettings, ThreeComponentSettings, FractureSettings, ShaftFrictionSettings,
                 EmbeddedNeedleSettings, ClosestNodeSettings>;
// Names as case files write them, in the order of the variant.
inline constexpr std::array<std::string_view, std::variant_size_v<ResistanceSettings>> resistance_names = {
    "layered",         "spring_damper_wall", "tracking_wall",  "depth_profile",   "volume_proxy",
    "three_component", "fracture",           "shaft_friction", "embedded_needle", "closest_node"};
inline std::string_view name_of(const ResistanceSettings& settings) {
  return resistance_names[settings.index()];
}

// What the deformable body of a resistance is made with; nullptr when the resistance needs none.
inline const DeformableBodySettings* body_of(const ResistanceSettings& settings) {
  if (const auto* embedded = std::get_if<EmbeddedNeedleSettings>(&settings)) return &embedded->body;
  if (const auto* closest = std::get_if<ClosestNodeSettings>(&settings)) return &closest->body;
  return nullptr;
}

// --- constraints -------------------------------------------------------------------------------------------------

// Settings of the `line_spring` constraint (Heng 2004 eq. 9).
struct LineSpringSettings {
  double stiffness = 0.5;  // k_c, N/mm; >= 0
  double damping = 0.0;    // b_c, N s/mm; >= 0
  double limit = 3.0;      // N; > 0
};

// Settings of Pivot. [P] printed in the paper, [D] our choice.
struct PivotSettings {
  double stiffness = 0.2;          // k_t, N/mm; 0 to 10 [D]
  double gain = 1.0;               // c; 0 to 10 [D]
  double limit = 2.0;              // N; > 0 to 100 [P]
  double shortest_outside = 20.0;  // mm, l2 is never taken smaller; 1 to 500 [D]
  double largest_angle = 0.3;      // rad, the deflection grows no further; 0.01 to 1 ["much smaller than 1 rad" P]
};

// Settings of Rail. [P] printed in the paper, [D] our choice.
struct RailSettings {
  double stiffness = 0.5;       // k, N/mm, across the line; 0 to 10 [D]
  double limit = 3.0;           // N, across the line; > 0 to 100 [D]
  double torsion = 1000.0;      // kappa0, N mm/rad at full depth; 0 to 1e5 [D]
  double full_depth = 40.0;     // depth_ref, mm, where the torque is fully grown; 1 to 500 [D]
  double torque_limit = 188.0;  // N mm; > 0 to 1e4 [P: continuous yaw and pitch torque of the Phantom Premium 1.5]
};

// Settings of Beam. [P] printed in the paper, [L] other literature, [D] our choice.
struct BeamSettings {
  double modulus = 193000.0;       // E, MPa, of stainless steel AISI 304; 1000 to 500000 [L]
  bool stylet = false;             // true: the bore is filled, the needle bends as a solid rod [D]
  double largest_stiffness = 1.0;  // N/mm, of the device; 0.01 to 10 [D]
  double limit = 2.0;              // N; > 0 to 100 [D, as Kwon et al. 2001 use for the same role]
  double smoothing = 20.0;         // Hz, low pass on the length outside; 1 to 400 [D]
};

// The needle is free to leave its line.
struct NoConstraint {};

using ConstraintSettings = std::variant<LineSpringSettings, PivotSettings, RailSettings, BeamSettings, NoConstraint>;
// Names as case files write them, in the order of the variant.
inline constexpr std::array<std::string_view, std::variant_size_v<ConstraintSettings>> constraint_names = {
    "line_spring", "pivot", "rail", "beam", "none"};
inline std::string_view name_of(const ConstraintSettings& settings) {
  return constraint_names[settings.index()];
}

// --- parts -------------------------------------------------------------------------------------------------------

// One decaying part of an elastic force.
struct PronyTerm {
  double share = 0.5;  // g_i, 0 to 1 [D]
  double time = 0.2;   // tau_i, s; 1e-3 to 1e4 [D]
};

// Settings of NeedleGrasp.
struct NeedleGraspSettings {
  double one_way =
      1.67;  // rise of the pull-out force after turning one way; 0 to 10 [L: Langevin et al. 2001, +167 %]
  double two_way = 0.52;       // the same after turning to and fro; 0 to one_way [L: +52 %]
  double point = 1.0;          // factor at an acupuncture point; 0.1 to 10 [L: 1.18 beside control points]
  double turns_to_wind = 2.0;  // turns after which 63 % are reached; 0.1 to 100 [D]
};

// What is added to the resistance.
struct ForceParts {
  // At most 4 terms; for `spring_damper_wall` and `tracking_wall` without leash.
  std::vector<PronyTerm> relaxation;
  // For resistances without a friction of the shaft of their own: all but `layered`, `three_component` and
  // `shaft_friction`.
  std::optional<ShaftFrictionSettings> shaft_friction;
  // Multiplies the shaft's friction with what turning the needle has wound up; for `layered`, `shaft_friction` and
  // resistances with that part.
  std::optional<NeedleGraspSettings> needle_grasp;
};

// --- compensation ------------------------------------------------------------------------------------------------

// Settings of GravityCompensation; a device profile's values, found by fit_gravity or by hand.
struct GravitySettings {
  Vec3 up = Vec3::UnitZ();     // unit, against gravity, in the frame in which forces are commanded
  double weight = 0.0;         // m_eff g at the centre, N; 0 to 20
  Vec3 slope = Vec3::Zero();   // change of the weight with position, N/mm; each within +-0.1; zero: a constant force
  Vec3 centre = Vec3::Zero();  // mm, of the workspace
  double limit = 3.0;          // N; > 0 to 20 [D]
};

}  // namespace bodkin
