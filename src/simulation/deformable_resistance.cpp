#include "simulation/deformable_resistance.h"

#include <algorithm>
#include <string>

#include "core/error.h"
#include "fem/shaft_stiffness.h"

namespace bodkin {

namespace {

constexpr double body_share = 0.5;            // of the device's stiffness, that the tissue about the shaft may take
constexpr double least_friction_share = 0.1;  // of the device's stiffness, left to the friction's spring

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

// The factor by which the body has to be softer for the device.
double scale_for(const Case& patient, const CondensedBody& body, const EmbeddedNeedleSettings& settings) {
  const auto& path = patient.description.procedure.path;
  if (!path) return 1.0;
  const double stiffness =
      shaft_stiffness(body, path->entry, path->direction(), path->length() + settings.body.corridor_beyond,
                      settings.capture_radius, settings.spacing, settings.most_nodes);
  const double wanted = body_share * patient.description.device.stiffness;
  return stiffness > wanted ? wanted / stiffness : 1.0;
}

std::shared_ptr<const CondensedBody> softened(const std::shared_ptr<const CondensedBody>& body, double scale) {
  if (scale == 1.0) return body;
  auto softer = std::make_shared<CondensedBody>(*body);
  softer->compliance /= scale;
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
    : scale_(scale_for(patient, *body_in(patient), settings)),
      body_(softened(body_in(patient), scale_)),
      needle_(std::make_unique<EmbeddedNeedle>(*body_, tissues_in(patient), settings, dt)),
      bone_(patient, (1.0 - body_share) * patient.description.device.stiffness) {}

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
  Pose pose = Pose::Identity();
  pose.translation() = needle.tip;
  pose.linear().col(0) = needle.side;
  pose.linear().col(1) = needle.axis.cross(needle.side);
  pose.linear().col(2) = needle.axis;
  const EmbeddedNeedleForce& found = needle_->step(pose);
  tell(found.puncture, events);
  const double bone = bone_.step(needle.motion.depth, needle.tissue, events);
  const bool beyond = found.beyond && !bone_.met();  // bone does not move, it has no nodes
  if (beyond && !beyond_) events.push({EventKind::corridor_left, needle.tissue, needle.motion.depth, 0.0});
  beyond_ = beyond;
  return {.along = found.resistance + bone,
          .across = found.on_hand.force + found.resistance * direction_,
          .torque = found.on_hand.torque,
          .in_contact = needle.motion.depth > 0.0};
}

DeformableTip::DeformableTip(const Case& patient, const ClosestNodeSettings& settings, double dt)
    : bone_(patient, patient.description.device.stiffness) {
  const double device = patient.description.device.stiffness;
  ContactTissues tissues = tissues_in(patient);
  double firm = 0.0;
  for (ContactTissue& tissue : tissues) {
    if (tissue.stiffness > device) scale_ = std::min(scale_, device / tissue.stiffness);
    tissue.stiffness = std::min(tissue.stiffness, device);
    firm = std::max(firm, tissue.stiffness);
  }
  ClosestNodeSettings possible = settings;
  possible.presliding = std::min(settings.presliding, std::max(device - firm, least_friction_share * device));
  contact_ = std::make_unique<ClosestNodeContact>(*body_in(patient), tissues, possible, dt);
}

void DeformableTip::begin(const Vec3& entry, const Vec3& direction) noexcept {
  contact_->begin(entry, direction);
  bone_.reset();
}

void DeformableTip::reset() noexcept {
  contact_->reset();
  bone_.reset();
}

ResistanceForce DeformableTip::step(const NeedleInTissue& needle, TickEvents& events) noexcept {
  const ClosestNodeForce found = contact_->step(needle.tip);
  tell(found.puncture, events);
  const double bone = bone_.step(needle.motion.depth, needle.tissue, events);
  return {.along = found.resistance + bone, .in_contact = needle.motion.depth > 0.0};
}

}  // namespace bodkin
