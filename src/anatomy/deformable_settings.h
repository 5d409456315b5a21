#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/parameter.h"
#include "core/settings_check.h"

namespace bodkin::anatomy {

// How a case's mesh becomes a deformable body: its stiffness and its fixed nodes.
struct DeformableBodySettings {
  double stiffness_scale = 10.0;
  bool fix_bone = true;
  bool fix_cut = true;
  double fix_beyond = 1000.0;

  template <typename S = DeformableBodySettings>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"stiffness_scale", &S::stiffness_scale, Range{0.001, 1000.0}, "",
                  "factor on Young's modulus of every tissue", Origin::choice},
        Parameter{"fix_bone", &S::fix_bone, "bone and metal do not move", Origin::choice},
        Parameter{"fix_cut", &S::fix_cut, "faces where the mesh ends inside the patient do not move", Origin::choice},
        Parameter{"fix_beyond_mm", &S::fix_beyond, Range{1.0, 1000.0}, "mm",
                  "along the planned path behind the entry: deeper nodes do not move", Origin::choice}};
  }
};

// Which nodes of a deformable body the needle can meet: the corridor.
struct CorridorSettings {
  double radius = 25.0;
  double beyond = 15.0;
  double nodes = 1000.0;

  template <typename S = CorridorSettings>
  static constexpr auto parameters() {
    return std::tuple{Parameter{"corridor_radius_mm", &S::radius, Range{1.0, 200.0}, "mm", "about the planned path",
                                Origin::choice},
                      Parameter{"corridor_beyond_mm", &S::beyond, Range{0.0, 200.0}, "mm",
                                "length of the corridor behind the target", Origin::choice},
                      Parameter{"corridor_nodes", &S::nodes, Range{10.0, 5000.0}, "",
                                "at most, those nearest to the path", Origin::choice}};
  }
};

// How the hand holds a needle's hub.
enum class NeedleHold : std::uint8_t {
  clamped,  // the hand determines position and orientation
  pinned    // position only: the hub turns freely, as in a gimbal without motors
};
constexpr std::array<std::string_view, 2> enumeration_names(NeedleHold) {
  return {"clamped", "pinned"};
}

// Whether and how the needle of a case bends in a deformable body (NeedleBeam).
struct NeedleBendingSettings {
  bool flexible = false;
  double modulus = 193000.0;
  bool stylet = false;
  NeedleHold hold = NeedleHold::clamped;
  double cut_offset = 0.0;

  template <typename S = NeedleBendingSettings>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"flexible", &S::flexible, "the needle bends", Origin::choice},
        Parameter{"modulus_MPa", &S::modulus, Range{1000.0, 500000.0}, "MPa", "E, of stainless steel AISI 304",
                  Origin::literature},
        Parameter{"stylet", &S::stylet, "the bore is filled: the needle bends as a solid rod", Origin::choice},
        Parameter{"hold", &S::hold, "place and angle of the hub are the hand's, or its place alone", Origin::choice},
        Parameter{"cut_offset_mm", &S::cut_offset, Range{0.0, 2.0}, "mm",
                  "distance from its axis at which a bevel cuts, towards its point; 0: it cuts straight",
                  Origin::choice}};
  }
};

// Settings of EmbeddedNeedle.
struct EmbeddedNeedleSettings {
  static constexpr std::string_view element = "embedded_needle";
  double tip_radius = 1.0;
  double point_spacing = 1.0;
  double points_beyond = 15.0;
  double capture_radius = 1.5;
  double puncture_time = 0.030;
  std::size_t most_nodes = 150;  // along the shaft; 1 to 160; not a setting of a case
  DeformableBodySettings body;
  NeedleBendingSettings bending;

  template <typename S = EmbeddedNeedleSettings>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"tip_radius_mm", &S::tip_radius, Range{0.2, 5.0}, "mm", "of the disk over which the tip pushes",
                  Origin::choice},
        Parameter{"point_spacing_mm", &S::point_spacing, Range{0.5, 5.0}, "mm", "between points of one tissue",
                  Origin::choice},
        Parameter{"points_beyond_mm", &S::points_beyond, Range{0.0, 200.0}, "mm",
                  "of the needle's line behind the target that has points", Origin::choice},
        Parameter{"capture_radius_mm", &S::capture_radius, Range{0.05, 20.0}, "mm",
                  "of the line past a point, at most, within which it takes full hold of the shaft", Origin::choice},
        Parameter{"puncture_time_s", &S::puncture_time, Range{0.001, 1.0}, "s",
                  "in which the force of a puncture goes", Origin::choice},
        Inlined{&S::bending},
        Inlined{&S::body}};
  }
  // Names from versions in which the shaft met nodes of the mesh.
  static constexpr std::array<EarlierName, 5> earlier_names() {
    return {{{"corridor_beyond_mm", "points_beyond_mm"},
             {"contact"},
             {"spacing_mm"},
             {"corridor_radius_mm"},
             {"corridor_nodes"}}};
  }
};

// Settings of ClosestNodeContact.
struct ClosestNodeSettings {
  static constexpr std::string_view element = "closest_node";
  double capture_radius = 2.0;
  double presliding = 1.0;
  double relaxation = 0.030;
  double layer = 0.5;
  double longest = 300.0;
  CorridorSettings corridor;
  DeformableBodySettings body;

  template <typename S = ClosestNodeSettings>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"capture_radius_mm", &S::capture_radius, Range{0.05, 50.0}, "mm",
                  "r_cap; half the edge of an element", Origin::choice},
        Parameter{"presliding_N_per_mm", &S::presliding, Range{0.01, 100.0}, "N/mm",
                  "by which friction grows before the shaft slides", Origin::choice},
        Parameter{"relaxation_s", &S::relaxation, Range{0.001, 1.0}, "s",
                  "in which a punctured node goes back to its place", Origin::choice},
        Parameter{"layer_mm", &S::layer, Range{0.1, 10.0}, "mm",
                  "between the places where the tissue beside the shaft is looked up", Origin::choice},
        Parameter{"longest_mm", &S::longest, Range{1.0, 1000.0}, "mm", "of shaft in tissue", Origin::choice},
        Inlined{&S::corridor},
        Inlined{&S::body}};
  }
};

}  // namespace bodkin::anatomy
