#pragma once

// Every resistance and every constraint that a case can choose, in the variants that behave differently.
#include <algorithm>
#include <memory>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "tests/fem/dense_body.h"
#include "tests/simulation/slab_patient.h"

#include "anatomy/case.h"
#include "io/tissue_library_file.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;

struct NamedResistance {
  std::string name;
  ResistanceSettings settings;
  ForceParts parts;
  bool active = false;  // documented: may give energy on closed paths
  double paths = 1.0;   // part of the usual number of closed paths that is enough
};

inline void PrintTo(const NamedResistance& resistance, std::ostream* out) {
  *out << resistance.name;
}

// Those that are listed, and each other model of the variant with its defaults.
template <typename Named, typename... Models>
std::vector<Named> with_the_rest(std::vector<Named> listed, std::type_identity<std::variant<Models...>> /*of*/) {
  const auto add = [&listed](const auto& settings) {
    const auto is_it = [&](const Named& one) { return name_of(one.settings) == settings.element; };
    if (settings.element == RegisteredSettings::element || std::any_of(listed.begin(), listed.end(), is_it)) return;
    Named other;
    other.name = settings.element;
    other.settings = settings;
    listed.push_back(std::move(other));
  };
  (add(Models()), ...);
  return listed;
}

inline std::vector<NamedResistance> all_resistances() {
  ForceParts rubbing, relaxing;
  rubbing.shaft_friction.emplace();
  relaxing.relaxation = {{0.4, 0.2}, {0.2, 2.0}};
  return with_the_rest<NamedResistance>(
      {{"layered", LayeredSettings{}, {}},
       {"layered_sum", LayeredSettings{.law = LayeredLaw::sum}, {}},
       {"layered_strict", LayeredSettings{.strict = true}, {}},
       {"spring_damper_wall", SpringDamperWallSettings{.damping = 0.0001}, {}},
       {"spring_damper_wall_relaxing", SpringDamperWallSettings{.damping = 0.0}, relaxing},
       {"tracking_wall", TrackingWallSettings{}, {}},
       {"tracking_wall_rubbing", TrackingWallSettings{}, rubbing},
       {"tracking_wall_relaxing", TrackingWallSettings{.catch_up = 1e6}, relaxing},
       {"tracking_wall_strict", TrackingWallSettings{.strict = true}, {}, true},
       {"tracking_wall_leash", TrackingWallSettings{.leash = true}, {}},
       {"depth_profile", DepthProfileSettings{}, {}},
       {"depth_profile_rubbing", DepthProfileSettings{}, rubbing},
       {"volume_proxy_drag", VolumeProxySettings{}, {}},
       {"volume_proxy_viscous", VolumeProxySettings{.variant = ProxyVariant::viscous}, {}},
       {"volume_proxy_two_sided", VolumeProxySettings{.two_sided = true}, {}},
       {"volume_proxy_of_value",
        VolumeProxySettings{.transfer = {{0.0, {}}, {0.4, {0.8, 0.2, 0.2, 0.0}}, {1.0, {6.0, 4.0, 0.5, 0.0}}}},
        {}},
       {"three_component", ThreeComponentSettings{}, {}},
       {"fracture", FractureSettings{}, {}},
       {"fracture_rubbing", FractureSettings{}, rubbing},
       {"shaft_friction", ShaftFrictionSettings{}, {}},
       {"embedded_needle", EmbeddedNeedleSettings{}, {}},
       {"embedded_needle_bending",
        EmbeddedNeedleSettings{.bending = {.flexible = true, .cut_offset = 0.1}},
        {},
        false,
        0.05},
       {"surface_proxy", SurfaceProxySettings{.stiffness = 0.5}, {}},
       {"surface_proxy_sliding",
        SurfaceProxySettings{.stiffness = 0.5, .static_friction = 0.0, .dynamic_friction = 0.0},
        {}},
       // Half of the 11 mm that its nodes are apart; taking over from a stiff node is active.
       {"closest_node", ClosestNodeSettings{.capture_radius = 5.5}, {}, true}},
      std::type_identity<ResistanceSettings>());
}

struct NamedConstraint {
  std::string name;
  ConstraintSettings settings;
  bool active = false;  // documented: its stiffness changes with depth at no cost along the needle
};

inline void PrintTo(const NamedConstraint& constraint, std::ostream* out) {
  *out << constraint.name;
}

inline std::vector<NamedConstraint> all_constraints() {
  return with_the_rest<NamedConstraint>({{"line_spring", LineSpringSettings{}},
                                         {"pivot", PivotSettings{}, true},
                                         {"rail", RailSettings{}, true},
                                         {"beam", BeamSettings{}, true},
                                         {"none", NoConstraint{}}},
                                        std::type_identity<ConstraintSettings>());
}

// Nodes about the z axis, down to the bone of the slabs, which does not move and has none.
inline std::shared_ptr<const CondensedBody> slab_body(const TissueVolume& tissues, int across, int along,
                                                      double spacing) {
  auto body = std::make_shared<CondensedBody>(checks::kelvin_body(across, along, spacing, 0.2));
  for (std::size_t node = 0; node < body->nodes.size(); ++node)
    body->tissues[node] = nearest<TissueId>(tissues, body->nodes[node] + Vec3(0.0, 0.0, 0.6), tissue::air);
  return body;
}

// The slabs of slab_patient() with the tissues supplied with Bodkin and a CT, 40 mm wide.
inline Case patient_for(const NamedResistance& resistance, const NamedConstraint& constraint, double rate = 1000.0) {
  Case patient;
  patient.library = default_tissue_library();
  const std::vector<TissueId> slabs = spine_slabs();
  Grid grid;
  grid.size = {40, 40, static_cast<int>(slabs.size()) + 8};
  grid.origin = {-19.5, -19.5, -7.5};
  patient.tissues = TissueVolume(grid);
  patient.ct = CtVolume(grid);
  for (int k = 0; k < grid.size[2]; ++k) {
    const TissueId id = k < 8 ? tissue::air : slabs[static_cast<std::size_t>(k - 8)];
    const auto hounsfield = static_cast<std::int16_t>(patient.library.find(id)->hounsfield);
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        patient.tissues.at(i, j, k) = id;
        patient.ct.at(i, j, k) = hounsfield;
      }
    }
  }
  HapticSettings& haptics = patient.description.haptics;
  haptics.rate = rate;
  haptics.resistance = resistance.settings;
  haptics.parts = resistance.parts;
  haptics.constraint = constraint.settings;
  if (body_of(resistance.settings) != nullptr) {
    static const auto fine =
        std::make_shared<const CondensedBody>(checks::as_points(*slab_body(patient.tissues, 1, 22, 2.0)));
    static const std::shared_ptr<const CondensedBody> coarse = slab_body(patient.tissues, 3, 4, 11.0);
    patient.prepared = {std::holds_alternative<ClosestNodeSettings>(resistance.settings) ? coarse : fine,
                        NeedlePath{Vec3::Zero(), Vec3(0.0, 0.0, 40.0)}};
  }
  return patient;
}

}  // namespace bodkin
