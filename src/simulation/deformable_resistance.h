#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "anatomy/case.h"
#include "fem/closest_node.h"
#include "fem/contact_line.h"
#include "fem/embedded_needle.h"
#include "forces/resistance_model.h"
#include "simulation/body_port.h"
#include "simulation/bone_wall.h"
#include "simulation/contact_settings.h"

namespace bodkin::simulation {

// s, in which the parameters of a contact change step by step.
inline constexpr double contact_change_time = 0.1;

// The resistances of a deformable body (docs/fem-contact.md) in the tick. The patient must outlive them; its library
// has the contact properties of each tissue. Throw InputError when the patient has no body, or for settings or
// tissues out of range.

// `embedded_needle` on one line: all contact points along the shaft. If these are stiffer along the planned path than
// the device can render, the hand feels the body through a spring, which reduces the stiffness by stiffness_scale()
// and keeps every force. With `bending.flexible` the needle of the case bends: its tube and length are those of the
// description. Throws InputError for a needle that is not a beam (NeedleBeam), and for a cut_offset of one that does
// not bend or has no bevel. The part `relaxation` of the case applies to all its tissues.
class DeformableShaft {
 public:
  using Settings = anatomy::EmbeddedNeedleSettings;
  static constexpr forces::ResistanceTraits traits = {
      .name = "embedded_needle",
      .has_lateral_force = true,
      .has_shaft_friction = true,
      .relaxes_itself = true,
      .diagnostics = {{{"tip_N", "force at the tip"},
                       {"ahead_mm", "hand ahead of the needle in the body"},
                       {"nodes", "contact points on the shaft"}}},
  };

  // With the points of the patient's planned line.
  DeformableShaft(const anatomy::Case& patient, const anatomy::EmbeddedNeedleSettings& settings, double dt);
  // With contact points of the needle's own lines, as they become known in `line`, in the same body as `other`.
  DeformableShaft(const DeformableShaft& other, const anatomy::Case& patient, const fem::ContactLine& line,
                  const anatomy::EmbeddedNeedleSettings& settings, double dt);

  void begin(const Vec3& entry, const Vec3& direction) noexcept;
  // As begin(), in points that extend() adds before a tick; `complete`: no more will follow. Until the first is known
  // the tip pushes on a surface with the compliance of the prepared line's first point, unless it is `open` there.
  void begin_growing(const Vec3& entry, const Vec3& direction, bool open) noexcept;
  void extend(std::size_t points, bool complete) noexcept;
  // The needle has turned: the points behind the first `points`, at least those that it has reached(), are no longer
  // ahead of it; extend() adds others.
  void extend_from(std::size_t points) noexcept {
    needle_->keep_first(points);
    growing_ = true;
  }
  std::size_t reached() const noexcept { return needle_->reached(); }
  // The points are now coupled to other nodes held by something (EmbeddedNeedle::exchange).
  void exchange() noexcept { needle_->exchange(); }
  bool exchanges() const noexcept { return needle_->exchanges(); }
  bool exchanged() const noexcept { return needle_->exchanged(); }
  // Where it would continue from here, as of the last step.
  fem::EmbeddedNeedle::Continuation continuation() const noexcept { return needle_->continuation(); }
  // Whether it is past the last point of its line, without bone in front of it.
  bool past_line() const noexcept { return beyond_ && !bone_.met(); }
  // mm, of the points that extend() added, in their order; below 0 for one that does not exist.
  double point_depth(std::size_t point) const noexcept { return needle_->point_depth(point); }
  // The puncture of the last step, if any.
  const std::optional<fem::TissuePuncture>& puncture() const noexcept { return puncture_; }
  void open(const Vec3& place, anatomy::TissueId tissue) noexcept { needle_->open(place, tissue); }
  fem::ContactNumbers numbers() const noexcept { return needle_->numbers(); }
  void set_numbers(const fem::ContactNumbers& numbers) noexcept { needle_->set_numbers(numbers); }
  // mm/N, of the spring that supports the body, for the device's sake.
  double spring() const noexcept { return spring_; }
  void reset() noexcept;
  forces::ResistanceForce step(const forces::NeedleInTissue& needle, forces::TickEvents& events) noexcept;
  // mm from the needle in the body to the hand's needle: by the spring between them, and by bone.
  Vec3 coupling_offset() const noexcept { return coupling_offset_; }
  // Before a step: the body's own motion (EmbeddedNeedle::move_with).
  bool move_with(std::span<const float> of_mesh, const fem::BodyBreath& breath) noexcept {
    return needle_->move_with(of_mesh, breath);
  }
  // The tissue's own motion along the shaft (EmbeddedNeedle::carried_along_shaft).
  Pose tissue_motion() const noexcept { return needle_->carried_along_shaft(); }
  // Forces on the tissue in the last tick, by contact point; and the elastic forces for its present displacement, by
  // node of the mesh.
  const fem::NodeForces& point_forces() const noexcept { return needle_->node_forces(); }
  fem::NodeForces node_forces() const noexcept { return fem::of_mesh(needle_->elastic_forces(), *body_); }
  double stiffness_scale() const noexcept { return scale_; }
  forces::ModelDiagnostics diagnostics() const noexcept { return {tip_force_, coupling_offset_.norm(), nodes_}; }

 private:
  double scale_ = 1.0;
  std::shared_ptr<const anatomy::CondensedBody> body_;
  double spring_ = 0.0;  // mm/N, compliance of the spring that supports the body
  Vec3 coupling_offset_ = Vec3::Zero();
  double tip_force_ = 0.0, nodes_ = 0.0;         // N, count; of the last tick
  std::unique_ptr<fem::EmbeddedNeedle> needle_;  // refers to the body
  BoneWall bone_;
  bool deforms_;  // the tip's tissue is that of the deformed material
  Vec3 direction_ = Vec3::UnitZ();
  bool beyond_ = false;                     // the needle is past its last point
  bool growing_ = false;                    // more contact points will follow
  Mat3 surface_compliance_ = Mat3::Zero();  // mm/N, of the prepared line's first point
  double surface_strength_ = 0.0;           // N, puncture force of that point's tissue
  std::optional<fem::TissuePuncture> puncture_;
};

// `closest_node`: the paper's scheme, one node of the corridor at the tip. Tissues stiffer than the device can render
// are limited to its stiffness; stiffness_scale() gives the factor.
class DeformableTip final : public BodyPort {
 public:
  using Settings = anatomy::ClosestNodeSettings;
  static constexpr forces::ResistanceTraits traits = {
      .name = "closest_node",
      .has_shaft_friction = true,
      .diagnostics = {{{"ahead_mm", "hand ahead of the needle in the body"}}},
  };

  DeformableTip(const anatomy::Case& patient, const anatomy::ClosestNodeSettings& settings, double dt);

  void begin(const Vec3& entry, const Vec3& direction) noexcept;
  void reset() noexcept;
  forces::ResistanceForce step(const forces::NeedleInTissue& needle, forces::TickEvents& events) noexcept;
  void change_numbers(const fem::ContactNumbers& numbers) noexcept override;
  Vec3 coupling_offset() const noexcept override {
    return touches_ ? Vec3(bone_.behind() * direction_) : Vec3(Vec3::Zero());
  }
  fem::NodeForces node_forces() const noexcept override {
    return touches_ ? fem::of_mesh(contact_->node_forces(), *body_) : fem::NodeForces{};
  }
  double firm_stiffness() const noexcept { return 0.0; }
  double stiffness_scale() const noexcept { return scale_; }
  forces::ModelDiagnostics diagnostics() const noexcept { return {bone_.behind()}; }

 private:
  double scale_ = 1.0;
  std::shared_ptr<const anatomy::CondensedBody> body_;
  BoneWall bone_;
  const anatomy::TissueVolume& tissues_;
  std::vector<anatomy::TissueId> line_;  // along the line, every ClosestNodeContact::layer_step
  std::unique_ptr<fem::ClosestNodeContact> contact_;
  Vec3 entry_ = Vec3::Zero(), direction_ = Vec3::UnitZ();
  bool touches_ = false;  // as of the last step
  double dt_;
  fem::ContactChange change_;
};

}  // namespace bodkin::simulation
