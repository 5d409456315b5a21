#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "anatomy/case.h"
#include "fem/closest_node.h"
#include "fem/contact_line.h"
#include "fem/embedded_needle.h"
#include "forces/resistance_model.h"
#include "simulation/bone_wall.h"

namespace bodkin::simulation {

// The resistances of a deformable body (docs/fem-contact.md) in the tick, in one of its corridors. The patient must
// outlive them; its library says what a needle meets in each tissue. Throw InputError when the corridor has no body,
// or for settings or tissues out of range.

// `embedded_needle`: all nodes along the shaft. Where these are stiffer along the planned path than the device can
// render, the hand feels the body through a spring, which leaves stiffness_scale() of that stiffness and every force.
// With `bending.flexible` the needle of the case bends: its tube and length are those of the description. Throws
// InputError for a needle that is no beam (NeedleBeam), and for a cut_offset of one that does not bend or has no
// bevel.
//
// In a corridor about a state in which the body is pressed (PreparedCorridor::state) the needle meets the surface
// where it is now: as far along the line as the node has sunk that lay nearest to the entry. Depths stay those of the
// body at rest, as the voxels are.
class DeformableShaft {
 public:
  using Settings = anatomy::EmbeddedNeedleSettings;
  static constexpr forces::ResistanceTraits traits = {
      .name = "embedded_needle",
      .holds_laterally = true,
      .has_shaft_friction = true,
      .diagnostics = {{{"tip_N", "force at the tip"},
                       {"ahead_mm", "hand ahead of the needle in the body"},
                       {"nodes", "nodes of the mesh on the shaft"}}},
  };

  DeformableShaft(const anatomy::Case& patient, const anatomy::PreparedCorridor& corridor,
                  const anatomy::EmbeddedNeedleSettings& settings, double dt);

  // In contact points of the needle's own lines, as they become known in `line`, of the same body as `other`.
  DeformableShaft(const DeformableShaft& other, const anatomy::Case& patient, const fem::ContactLine& line,
                  const anatomy::EmbeddedNeedleSettings& settings, double dt);

  void begin(const Vec3& entry, const Vec3& direction) noexcept;
  // The same in points that extend() adds before a tick; `complete`: no more will come. Until the first is there the
  // tip pushes on the surface with the compliance that the prepared line's has, unless it is `open` there.
  void begin_growing(const Vec3& entry, const Vec3& direction, bool open) noexcept;
  void extend(std::size_t points, bool complete) noexcept;
  // mm, of the points that extend() added, in their order; below 0 for one that is not there.
  double point_depth(std::size_t point) const noexcept { return needle_->point_depth(point); }
  bool has_contact_points() const noexcept { return body_->has_contact_points(); }
  // Of the last step, where something gave way.
  const std::optional<fem::TissuePuncture>& puncture() const noexcept { return puncture_; }
  void open(const Vec3& place, anatomy::TissueId tissue) noexcept { needle_->open(place, tissue); }
  // mm/N, of the spring that the body stands on for the device's sake.
  double spring() const noexcept { return spring_; }
  void reset() noexcept;
  forces::ResistanceForce step(const forces::NeedleInTissue& needle, forces::TickEvents& events) noexcept;
  // mm by which the hand's needle is ahead of the one in the body: the spring between them, and bone.
  Vec3 ahead() const noexcept { return ahead_; }
  // What was punctured in another corridor.
  void take_punctures(const DeformableShaft& other) noexcept { needle_->take_punctures(*other.needle_); }
  // See EmbeddedNeedle: transfers an inserted needle from another one. Bone stays where that one met it.
  bool holds() const noexcept { return needle_->holds(); }
  bool begin_to_follow(const DeformableShaft& other) noexcept { return needle_->begin_to_follow(*other.needle_); }
  fem::FollowState follow(const DeformableShaft& other) noexcept;
  // Forces on the tissue in the last tick, by node of the mesh.
  fem::NodeForces node_forces() const noexcept { return fem::of_mesh(needle_->node_forces(), *body_); }
  double stiffness_scale() const noexcept { return scale_; }
  forces::ModelDiagnostics diagnostics() const noexcept { return {tip_force_, ahead_.norm(), nodes_}; }

 private:
  double scale_ = 1.0;
  std::shared_ptr<const anatomy::CondensedBody> body_;
  double spring_ = 0.0;  // mm/N, compliance of the spring that the body stands on
  Vec3 ahead_ = Vec3::Zero();
  double tip_force_ = 0.0, nodes_ = 0.0;         // N, count; of the last tick
  std::unique_ptr<fem::EmbeddedNeedle> needle_;  // refers to the body
  BoneWall bone_;
  bool deforms_;  // the tip's tissue is that of the deformed material
  Vec3 direction_ = Vec3::UnitZ();
  bool beyond_ = false;                     // the needle has left the corridor
  bool growing_ = false;                    // more contact points will come
  Mat3 surface_compliance_ = Mat3::Zero();  // mm/N, of the prepared line's first point
  double surface_strength_ = 0.0;           // N, at which its tissue gives way
  std::optional<fem::TissuePuncture> puncture_;
  // Of a body that is pressed: its nodes at rest, by which its surface is found again; else none.
  std::vector<Vec3> at_rest_;
  double sunk_ = 0.0;  // mm along the line by which the surface lies deeper than at rest
};

// `closest_node`: the paper's scheme, one node at the tip. Tissues that are stiffer than the device can render are as
// stiff as it can; stiffness_scale() gives the factor.
class DeformableTip {
 public:
  using Settings = anatomy::ClosestNodeSettings;
  static constexpr forces::ResistanceTraits traits = {
      .name = "closest_node",
      .has_shaft_friction = true,
      .diagnostics = {{{"ahead_mm", "hand ahead of the needle in the body"}}},
  };

  DeformableTip(const anatomy::Case& patient, const anatomy::PreparedCorridor& corridor,
                const anatomy::ClosestNodeSettings& settings, double dt);

  void begin(const Vec3& entry, const Vec3& direction) noexcept;
  void reset() noexcept;
  forces::ResistanceForce step(const forces::NeedleInTissue& needle, forces::TickEvents& events) noexcept;
  Vec3 ahead() const noexcept { return bone_.behind() * direction_; }
  void take_punctures(const DeformableTip& other) noexcept { contact_->take_punctures(*other.contact_); }
  fem::NodeForces node_forces() const noexcept { return fem::of_mesh(contact_->node_forces(), *body_); }
  double stiffness_scale() const noexcept { return scale_; }
  forces::ModelDiagnostics diagnostics() const noexcept { return {ahead().norm()}; }

 private:
  double scale_ = 1.0;
  std::shared_ptr<const anatomy::CondensedBody> body_;
  BoneWall bone_;
  const anatomy::TissueVolume& tissues_;
  std::vector<anatomy::TissueId> line_;  // along the line, every ClosestNodeContact::layer_step
  std::unique_ptr<fem::ClosestNodeContact> contact_;
  Vec3 entry_ = Vec3::Zero(), direction_ = Vec3::UnitZ();
};

}  // namespace bodkin::simulation
