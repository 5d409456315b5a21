#include "simulation/deformable_resistance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "core/error.h"
#include "fem/shaft_stiffness.h"
#include "forces/beam.h"
#include "forces/needle_law.h"
#include "simulation/touching_tissue.h"

namespace bodkin::simulation {

namespace {

constexpr double least_cosine = 0.2;  // between needle and line, as in EmbeddedNeedle

// The contact points of the planned line, or the nodes of the corridor, as the resistance needs them.
const std::shared_ptr<const anatomy::CondensedBody>& body_in(const anatomy::Case& patient, bool of_points) {
  const std::shared_ptr<const anatomy::CondensedBody>& body = patient.prepared.body;
  if (body != nullptr && body->has_contact_points() == of_points) return body;
  throw InputError(
      std::string(anatomy::name_of(patient.description.haptics.resistance)) +
      " needs the deformable body of the case, and none was prepared; make a mesh with: bodkin case mesh");
}

double stiffness_on_path(const anatomy::CondensedBody& body, const anatomy::NeedlePath& path,
                         const anatomy::EmbeddedNeedleSettings& settings) {
  return fem::shaft_stiffness(body, path.entry, path.direction(), path.length() + settings.points_beyond,
                              settings.most_nodes);
}

// The body on a spring: it moves all nodes alike, like the hand, so the spring's compliance is added to every pair of
// nodes.
std::shared_ptr<const anatomy::CondensedBody> on_spring(const std::shared_ptr<const anatomy::CondensedBody>& body,
                                                        double compliance) {
  if (compliance == 0.0) return body;
  auto softer = std::make_shared<anatomy::CondensedBody>(*body);
  for (Eigen::Index column = 0; column < softer->compliance.cols(); ++column) {
    for (Eigen::Index row = column % 3; row < softer->compliance.rows(); row += 3)
      softer->compliance(row, column) += compliance;
  }
  return softer;
}

bool is_bevelled(anatomy::NeedleTip tip) {
  return tip == anatomy::NeedleTip::quincke || tip == anatomy::NeedleTip::tuohy || tip == anatomy::NeedleTip::chiba;
}

fem::NeedleRelaxation relaxation_in(const anatomy::Case& patient, double spring) {
  return {patient.description.haptics.parts.relaxation, spring};
}

// The needle of the case as a beam; none for a rigid needle.
std::optional<fem::NeedleBeam> beam_in(const anatomy::Case& patient, const anatomy::NeedleBendingSettings& settings) {
  const anatomy::Needle& needle = patient.description.needle;
  if (settings.cut_offset > 0.0 && !settings.flexible) {
    throw InputError("embedded_needle: cut_offset_mm is " + std::to_string(settings.cut_offset) +
                     " for a needle that does not bend; give flexible=true as well, or leave it out");
  }
  if (settings.cut_offset > 0.0 && !is_bevelled(needle.tip)) {
    throw InputError(
        "embedded_needle: cut_offset_mm is " + std::to_string(settings.cut_offset) + ", but a " +
        anatomy::to_string(needle.tip) +
        " needle has no bevel and cuts straight; leave it out, or take a quincke, tuohy or chiba needle");
  }
  if (!settings.flexible) return {};
  const double bore = settings.stylet ? 0.0 : needle.inner_diameter;
  return fem::NeedleBeam({.rigidity = forces::bending_stiffness(settings.modulus, needle.outer_diameter, bore),
                          .length = needle.length,
                          .hold = settings.hold,
                          .cut_offset = settings.cut_offset});
}

// mm along the line: the rest depth of the tissue at the tip, behind every border that has given way.
double material_in(const fem::EmbeddedNeedleForce& found) noexcept {
  return std::max(found.material_depth, found.opened_depth + 2.0 * beside_boundary);
}

// Reports a punctured tissue.
void report(const std::optional<fem::TissuePuncture>& puncture, forces::TickEvents& events) noexcept {
  if (puncture) events.push({forces::EventKind::puncture, puncture->tissue, puncture->depth, puncture->force});
}

}  // namespace

DeformableShaft::DeformableShaft(const anatomy::Case& patient, const anatomy::EmbeddedNeedleSettings& settings,
                                 double dt)
    : bone_(patient), deforms_(goes_by_material(patient.description.haptics)) {
  const std::shared_ptr<const anatomy::CondensedBody>& body = body_in(patient, true);
  const double found = stiffness_on_path(*body, patient.prepared.path, settings);
  const double rendered = std::min(found, patient.description.device.stiffness);
  if (rendered < found) scale_ = rendered / found;
  if (rendered < found) spring_ = 1.0 / rendered - 1.0 / found;
  body_ = on_spring(body, spring_);
  needle_ = std::make_unique<fem::EmbeddedNeedle>(*body_, contact_tissues(patient), settings, dt,
                                                  beam_in(patient, settings.bending), nullptr,
                                                  relaxation_in(patient, spring_));
}

DeformableShaft::DeformableShaft(const DeformableShaft& other, const anatomy::Case& patient,
                                 const fem::ContactLine& line, const anatomy::EmbeddedNeedleSettings& settings,
                                 double dt)
    : scale_(other.scale_),
      body_(std::shared_ptr<const anatomy::CondensedBody>(), &line.body()),
      spring_(other.spring_),
      needle_(std::make_unique<fem::EmbeddedNeedle>(
          *body_, contact_tissues(patient), settings, dt, beam_in(patient, settings.bending),
          line.other().size() > 0 ? &line.other() : nullptr, relaxation_in(patient, other.spring_))),
      bone_(patient),
      deforms_(other.deforms_),
      surface_compliance_(other.body_->compliance.topLeftCorner<3, 3>()),
      surface_strength_(contact_tissues(patient)[other.body_->tissues[0]].puncture_force) {}

void DeformableShaft::begin_growing(const Vec3& entry, const Vec3& direction, bool open) noexcept {
  needle_->begin_growing(
      entry, direction,
      {.compliance = open ? 0.0 : direction.dot(surface_compliance_ * direction), .strength = surface_strength_});
  bone_.reset();
  direction_ = direction;
  beyond_ = false;
  growing_ = true;
}

void DeformableShaft::extend(std::size_t points, bool complete) noexcept {
  needle_->extend(points, complete);
  growing_ = !complete;
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

forces::ResistanceForce DeformableShaft::step(const forces::NeedleInTissue& needle,
                                              forces::TickEvents& events) noexcept {
  const double bone = bone_.step(needle.motion.depth, needle.tissue, events);
  // At bone the needle in the body ends where the hand's line meets the depth of the bone.
  const double cosine = needle.axis.dot(direction_);
  const Vec3 line = cosine > least_cosine ? Vec3(needle.axis / cosine) : direction_;
  const Vec3 short_of = -bone_.behind() * line;
  Pose pose = Pose::Identity();
  pose.translation() = needle.tip + short_of;
  pose.linear().col(0) = needle.side;
  pose.linear().col(1) = needle.axis.cross(needle.side);
  pose.linear().col(2) = needle.axis;
  const fem::EmbeddedNeedleForce& found = needle_->step(pose, bone_.behind());
  coupling_offset_ = -short_of - spring_ * found.on_hand.force;
  tip_force_ = found.tip_force;
  nodes_ = static_cast<double>(found.nodes);
  report(found.puncture, events);
  puncture_ = found.puncture;
  const bool beyond = found.beyond && !growing_;
  if (beyond && !beyond_ && !bone_.met())  // at bone the points end, as it does not move
    events.push({forces::EventKind::points_passed, needle.tissue, needle.motion.depth, 0.0});
  beyond_ = beyond;
  const Vec3 across = found.on_hand.force + found.resistance * direction_;
  const Vec3 square = across - across.dot(line) * direction_;  // to the needle; its torque
  return {.along = found.resistance + bone,
          .across = across,
          .torque = found.on_hand.torque + short_of.cross(square),
          .material = deforms_ ? material_in(found) : std::numeric_limits<double>::infinity(),
          .inside = found.beyond ? anatomy::tissue::air : found.inside,
          .pushed = found.beyond ? anatomy::tissue::air : found.pushed,
          .in_contact = needle.motion.depth > 0.0};
}

DeformableTip::DeformableTip(const anatomy::Case& patient, const anatomy::ClosestNodeSettings& settings, double dt)
    : body_(body_in(patient, false)),
      bone_(patient),
      tissues_(patient.tissues),
      line_(static_cast<std::size_t>(settings.longest / fem::ClosestNodeContact::layer_step), anatomy::tissue::air),
      dt_(dt) {
  const double device = patient.description.device.stiffness;
  for (const fem::ContactTissue& tissue : contact_tissues(patient)) {
    if (tissue.stiffness > device) scale_ = std::min(scale_, device / tissue.stiffness);
  }
  const fem::ContactNumbers numbers = contact_numbers(patient, settings);
  anatomy::ClosestNodeSettings possible = settings;
  possible.presliding = numbers.presliding;
  contact_ = std::make_unique<fem::ClosestNodeContact>(*body_, numbers.tissues, possible, dt);
}

void DeformableTip::begin(const Vec3& entry, const Vec3& direction) noexcept {
  for (std::size_t i = 0; i < line_.size(); ++i) {
    const double depth = fem::ClosestNodeContact::layer_step * static_cast<double>(i);
    line_[i] = anatomy::nearest<anatomy::TissueId>(tissues_, Vec3(entry + depth * direction), anatomy::tissue::air);
  }
  if (change_.is_active()) contact_->set_numbers(change_.last());
  contact_->begin(entry, direction, line_);
  bone_.reset();
  entry_ = entry;
  direction_ = direction;
}

void DeformableTip::change_numbers(const fem::ContactNumbers& numbers) noexcept {
  if (!touches_) return contact_->set_numbers(numbers);
  change_.begin(contact_->numbers(), numbers, static_cast<int>(std::lround(contact_change_time / dt_)));
}

void DeformableTip::reset() noexcept {
  contact_->reset();
  bone_.reset();
  touches_ = false;
}

forces::ResistanceForce DeformableTip::step(const forces::NeedleInTissue& needle,
                                            forces::TickEvents& events) noexcept {
  if (change_.is_active()) contact_->set_numbers(change_.next());
  const double bone = bone_.step(needle.motion.depth, needle.tissue, events);
  const fem::ClosestNodeForce found = contact_->step(needle.tip - bone_.behind() * direction_);
  report(found.puncture, events);
  touches_ = needle.motion.depth > 0.0;
  const bool pushes = found.node && found.tip_force > 0.0;
  return {.along = found.resistance + bone,
          .material = pushes ? std::max(0.0, (body_->nodes[*found.node] - entry_).dot(direction_))
                             : std::numeric_limits<double>::infinity(),
          .in_contact = touches_};
}

}  // namespace bodkin::simulation
