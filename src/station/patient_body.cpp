#include "station/patient_body.h"

#include <utility>

#include "patient/prepared_body.h"
#include <fmt/format.h>

#include "core/error.h"
#include "fem/solid/patient_body.h"

namespace bodkin::station {

namespace {

constexpr double same_line = 5.0;  // mm, within which a refused line is not tried again

anatomy::CondensedBody without_compliance(const anatomy::CondensedBody& body) {
  if (body.has_contact_points()) {
    throw InputError(
        "--body is 'moving', which needs a needle that meets nodes of the mesh, and this one meets points of its "
        "line; "
        "leave out contact=points");
  }
  return {body.nodes, body.mesh_nodes, body.tissues, {}};
}

bool is_near(const anatomy::NeedlePath& one, const anatomy::NeedlePath& other) {
  return (one.entry - other.entry).norm() < same_line && (one.target - other.target).norm() < same_line;
}

}  // namespace

PatientBody::PatientBody(const anatomy::Case& patient, const fem::BodyDescription& body,
                         const fem::BodySolverSettings& settings)
    : description_(body), present_{patient.corridor.path, without_compliance(*patient.corridor.body)} {
  thread_ = std::make_unique<fem::BodyThread>(
      body, settings, [this](std::shared_ptr<anatomy::CondensedBody> corridor) { publish(std::move(corridor)); });
}

void PatientBody::set_needle(double seconds, const fem::NodeForces& of_mesh) noexcept {
  thread_->set_needle_forces(of_mesh);
  thread_->set_time(seconds);
}

void PatientBody::publish(std::shared_ptr<anatomy::CondensedBody> corridor) {
  const std::lock_guard lock(exchange_);
  if (wanted_ && wanted_->body.mesh_nodes == corridor->mesh_nodes) present_ = *std::exchange(wanted_, std::nullopt);
  if (present_.body.mesh_nodes != corridor->mesh_nodes) return;  // the corridor was moved elsewhere meanwhile
  corridor->tissues = present_.body.tissues;
  next_ = anatomy::PreparedCorridor{.body = std::move(corridor),
                                    .path = present_.path,
                                    .aimed_at = {},
                                    .state = ++corridors_,
                                    .at_rest = present_.body.nodes};
}

std::optional<anatomy::PreparedCorridor> PatientBody::take_corridor() {
  if (failed()) return {};
  const std::lock_guard lock(exchange_);
  return std::exchange(next_, std::nullopt);
}

// Only the observer moves the corridor, so wanted_ and present_ do not change between the two locks.
std::optional<std::string> PatientBody::follow(const Pose& needle, const anatomy::Case& patient) {
  if (failed()) return {};
  const anatomy::DeformableBodySettings& settings = *anatomy::body_of(patient.description.haptics.resistance);
  anatomy::PreparedCorridor now;
  {
    const std::lock_guard lock(exchange_);
    if (waiting_ && !wanted_) {
      waiting_ = false;
      return "the deformable body is prepared where the needle aimed";
    }
    if (waiting_ && thread_->move_failed()) {
      waiting_ = false;
      refused_ = std::exchange(wanted_, std::nullopt)->path;
      return "the deformable body cannot be prepared where the needle aims: its corridor was not made";
    }
    if (waiting_) return {};
    now.path = present_.path;
    now.body = std::make_shared<const anatomy::CondensedBody>(present_.body);
  }
  const anatomy::NeedlePath& planned = patient.corridor.path;
  const std::optional<anatomy::NeedlePath> path = patient::aimed_path(needle, patient.tissues, planned.length());
  if (!path || fem::covers(now, *path, settings) || (refused_ && is_near(*refused_, *path))) return {};
  return move_to(*path, patient);
}

std::optional<std::string> PatientBody::move_to(const anatomy::NeedlePath& path, const anatomy::Case& patient) {
  const anatomy::DeformableBodySettings& settings = *anatomy::body_of(patient.description.haptics.resistance);
  Line line{path, {}};
  std::vector<std::string> notes;
  try {
    line.body.mesh_nodes = fem::corridor_about(description_, path, settings, notes);
  } catch (const InputError& error) {
    refused_ = path;
    return fmt::format("the deformable body cannot be prepared where the needle aims: {}", error.what());
  }
  for (const std::uint32_t node : line.body.mesh_nodes) line.body.nodes.push_back(description_.mesh.nodes[node]);
  line.body.tissues = fem::stiffest_tissues(description_, line.body.mesh_nodes);
  fem::take_tissues_of_voxels(line.body, patient);
  std::vector<std::uint32_t> nodes = line.body.mesh_nodes;
  {
    const std::lock_guard lock(exchange_);
    wanted_ = std::move(line);
  }
  waiting_ = true;
  thread_->move_corridor(std::move(nodes));
  return "the needle aims where the deformable body is not prepared: that is being done, wait outside until it is";
}

}  // namespace bodkin::station
