#include "station/pressed_patient.h"

#include <utility>

#include "patient/prepared_body.h"
#include <fmt/format.h>

#include "core/error.h"
#include "fem/solid/patient_body.h"

namespace bodkin {

namespace {

constexpr double same_line = 5.0;  // mm, within which a line that was refused is not tried again

CondensedBody without_compliance(const CondensedBody& body) {
  return {body.nodes, body.mesh_nodes, body.tissues, {}};
}

bool is_near(const NeedlePath& one, const NeedlePath& other) {
  return (one.entry - other.entry).norm() < same_line && (one.target - other.target).norm() < same_line;
}

}  // namespace

PressedPatient::PressedPatient(const Case& patient, const BodyDescription& body, const PressedBodySettings& settings)
    : description_(body), led_{patient.corridor.path, without_compliance(*patient.corridor.body)} {
  moving_ = std::make_unique<MovingBody>(
      body, settings, [this](std::shared_ptr<CondensedBody> corridor) { take(std::move(corridor)); });
}

void PressedPatient::tell(double seconds, const NodeForces& of_mesh) noexcept {
  moving_->press_needle(of_mesh);
  moving_->tell_time(seconds);
}

void PressedPatient::take(std::shared_ptr<CondensedBody> corridor) {
  const std::lock_guard lock(exchange_);
  if (wanted_ && wanted_->body.mesh_nodes == corridor->mesh_nodes) led_ = *std::exchange(wanted_, std::nullopt);
  if (led_.body.mesh_nodes != corridor->mesh_nodes) return;  // led elsewhere meanwhile
  corridor->tissues = led_.body.tissues;
  next_ = PreparedCorridor{.body = std::move(corridor),
                           .path = led_.path,
                           .aimed_at = {},
                           .state = ++corridors_,
                           .at_rest = led_.body.nodes};
}

std::optional<PreparedCorridor> PressedPatient::next_corridor() {
  if (failed()) return {};
  const std::lock_guard lock(exchange_);
  return std::exchange(next_, std::nullopt);
}

// Only the watching thread changes where the corridor is led, so that between two locks that stays as it was.
std::optional<std::string> PressedPatient::look(const Pose& needle, const Case& patient) {
  if (failed()) return {};
  const DeformableBodySettings& settings = *body_of(patient.description.haptics.resistance);
  PreparedCorridor now;
  {
    const std::lock_guard lock(exchange_);
    if (waiting_ && !wanted_) {
      waiting_ = false;
      return "the deformable body is prepared where the needle aimed";
    }
    if (waiting_ && moving_->lead_failed()) {
      waiting_ = false;
      refused_ = std::exchange(wanted_, std::nullopt)->path;
      return "the deformable body cannot be prepared where the needle aims: its corridor was not made";
    }
    if (waiting_) return {};
    now.path = led_.path;
    now.body = std::make_shared<const CondensedBody>(led_.body);
  }
  const NeedlePath& planned = patient.corridor.path;
  const std::optional<NeedlePath> path = aimed_path(needle, patient.tissues, planned.length());
  if (!path || covers(now, *path, settings) || (refused_ && is_near(*refused_, *path))) return {};
  return lead(*path, patient);
}

std::optional<std::string> PressedPatient::lead(const NeedlePath& path, const Case& patient) {
  const DeformableBodySettings& settings = *body_of(patient.description.haptics.resistance);
  Led led{path, {}};
  std::vector<std::string> notes;
  try {
    led.body.mesh_nodes = corridor_about(description_, path, settings, notes);
  } catch (const InputError& error) {
    refused_ = path;
    return fmt::format("the deformable body cannot be prepared where the needle aims: {}", error.what());
  }
  for (const std::uint32_t node : led.body.mesh_nodes) led.body.nodes.push_back(description_.mesh.nodes[node]);
  led.body.tissues = stiffest_tissues(description_, led.body.mesh_nodes);
  take_tissues_of_voxels(led.body, patient);
  std::vector<std::uint32_t> nodes = led.body.mesh_nodes;
  {
    const std::lock_guard lock(exchange_);
    wanted_ = std::move(led);
  }
  waiting_ = true;
  moving_->lead_corridor(std::move(nodes));
  return "the needle aims where the deformable body is not prepared: that is being done, wait outside until it is";
}

}  // namespace bodkin
