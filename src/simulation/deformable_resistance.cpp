#include "simulation/deformable_resistance.h"

#include <algorithm>
#include <string>

#include "core/error.h"
#include "fem/shaft_stiffness.h"

namespace bodkin {

namespace {

constexpr double least_friction_share = 0.1;  // of the device's stiffness, left to the friction's spring
constexpr double least_presliding = 0.01;     // N/mm, that ClosestNodeContact takes

const std::shared_ptr<const CondensedBody>& body_in(const Case& patient) {
  if (patient.body != nullptr) return patient.body;
  throw InputError(
      std::string(name_of(patient.description.haptics.resistance)) +
      " needs the deformable body of the case, and none was prepared; make a mesh with: bodkin case mesh");
}

ContactTissues tissues_in(const Case& patient) {
  ContactTissues tissues;
  for (const TissueProperties& tissue : patient.library.tissues()) {
    const DeformableTissue& here = tissue.deformable;
    tissues[tissue.id] = {
        .friction = here.friction, .puncture_force = here.puncture_force, .stiffness = here.stiffness};
  }
  return tissues;
}

double stiffness_on_path(const Case& patient, const EmbeddedNeedleSettings& settings) {
  const auto& path = patient.description.procedure.path;
  if (!path) return 0.0;
  return shaft_stiffness(*body_in(patient), path->entry, path->direction(),
                         path->length() + settings.body.corridor_beyond, settings.capture_radius, settings.spacing,
                         settings.most_nodes);
}

// The body on a spring: a shaft in it that has the stiffness `found` then has `rendered`. Moving all nodes alike is
// what the hand does, so to every pair of them the spring's compliance is added.
std::shared_ptr<const CondensedBody> on_spring(const std::shared_ptr<const CondensedBody>& body, double found,
                                               double rendered) {
  if (rendered >= found) return body;
  auto softer = std::make_shared<CondensedBody>(*body);
  const double compliance = 1.0 / rendered - 1.0 / found;
  for (Eigen::Index column = 0; column < softer->compliance.cols(); ++column) {
    for (Eigen::Index row = column % 3; row < softer->compliance.rows(); row += 3)
      softer->compliance(row, column) += compliance;
  }
  return softer;
}

// What a tissue that gave way is told as.
void tell(const std::optional<TissuePuncture>& puncture, TickEvents& events) noexcept {
  if (!puncture) return;
  events.push({EventKind::puncture, puncture->tissue, puncture->depth, puncture->force});
  if (puncture->tissue == tissue::ligamentum_flavum)
    events.push({EventKind::loss_of_resistance, puncture->tissue, puncture->depth, puncture->force});
}

}  // namespace

DeformableShaft::DeformableShaft(const Case& patient, const EmbeddedNeedleSettings& settings, double dt)
    : bone_(patient) {
  const double found = stiffness_on_path(patient, settings);
  const double rendered = std::min(found, patient.description.device.stiffness);
  if (rendered < found) scale_ = rendered / found;
  body_ = on_spring(body_in(patient), found, rendered);
  needle_ = std::make_unique<EmbeddedNeedle>(*body_, tissues_in(patient), settings, dt);
}

void DeformableShaft::begin(const Vec3& entry, const Vec3& direction) noexcept {
  needle_->begin(entry, direction);
  bone_.reset();
  direction_ = direction;
  beyond_ = false;
}

void DeformableShaft::reset() noexcept {
  needle_->reset();
  bone_.reset();
  beyond_ = false;
}

ResistanceForce DeformableShaft::step(const NeedleInTissue& needle, TickEvents& events) noexcept {
  const double bone = bone_.step(needle.motion.depth, needle.tissue, events);
  Pose pose = Pose::Identity();
  pose.translation() = needle.tip - bone_.behind() * direction_;
  pose.linear().col(0) = needle.side;
  pose.linear().col(1) = needle.axis.cross(needle.side);
  pose.linear().col(2) = needle.axis;
  const EmbeddedNeedleForce& found = needle_->step(pose);
  tell(found.puncture, events);
  if (found.beyond && !beyond_ && !bone_.met())  // at bone the nodes end, for it does not move
    events.push({EventKind::corridor_left, needle.tissue, needle.motion.depth, 0.0});
  beyond_ = found.beyond;
  return {.along = found.resistance + bone,
          .across = found.on_hand.force + found.resistance * direction_,
          .torque = found.on_hand.torque,
          .in_contact = needle.motion.depth > 0.0};
}

DeformableTip::DeformableTip(const Case& patient, const ClosestNodeSettings& settings, double dt) : bone_(patient) {
  const double device = patient.description.device.stiffness;
  ContactTissues tissues = tissues_in(patient);
  double firm = 0.0;
  for (ContactTissue& tissue : tissues) {
    if (tissue.stiffness > device) scale_ = std::min(scale_, device / tissue.stiffness);
    tissue.stiffness = std::min(tissue.stiffness, device);
    firm = std::max(firm, tissue.stiffness);
  }
  ClosestNodeSettings possible = settings;
  possible.presliding =
      std::min(settings.presliding, std::max({device - firm, least_friction_share * device, least_presliding}));
  contact_ = std::make_unique<ClosestNodeContact>(*body_in(patient), tissues, possible, dt);
}

void DeformableTip::begin(const Vec3& entry, const Vec3& direction) noexcept {
  contact_->begin(entry, direction);
  bone_.reset();
  direction_ = direction;
}

void DeformableTip::reset() noexcept {
  contact_->reset();
  bone_.reset();
}

ResistanceForce DeformableTip::step(const NeedleInTissue& needle, TickEvents& events) noexcept {
  const double bone = bone_.step(needle.motion.depth, needle.tissue, events);
  const ClosestNodeForce found = contact_->step(needle.tip - bone_.behind() * direction_);
  tell(found.puncture, events);
  return {.along = found.resistance + bone, .in_contact = needle.motion.depth > 0.0};
}

}  // namespace bodkin
