#include "training/pressed_patient.h"

#include <algorithm>
#include <utility>

namespace bodkin {

PressedPatient::PressedPatient(const Case& patient, const BodyDescription& body, const PressedBodySettings& settings)
    : path_(patient.corridor.path),
      tissues_(patient.corridor.body->tissues),
      of_mesh_(body.mesh.nodes.size(), static_cast<std::uint32_t>(patient.corridor.body->nodes.size())) {
  const std::vector<std::uint32_t>& names = patient.corridor.body->mesh_nodes;
  for (std::size_t node = 0; node < names.size(); ++node) of_mesh_[names[node]] = static_cast<std::uint32_t>(node);
  moving_ = std::make_unique<MovingBody>(
      body, settings, [this](std::shared_ptr<CondensedBody> corridor) { take(std::move(corridor)); });
}

void PressedPatient::tell(double seconds, const NodeForces& of_mesh) noexcept {
  NodeForces of_corridor = of_mesh;
  const std::size_t count = std::min(of_mesh.count, NodeForces::capacity);
  of_corridor.count = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t node = of_mesh.nodes[i].node;
    if (node >= of_mesh_.size() || of_mesh_[node] >= tissues_.size()) continue;
    NodeForce& force = of_corridor.nodes[of_corridor.count++];
    force = of_mesh.nodes[i];
    force.node = of_mesh_[node];
  }
  moving_->press_needle(of_corridor);
  moving_->tell_time(seconds);
}

void PressedPatient::take(std::shared_ptr<CondensedBody> corridor) {
  corridor->tissues = tissues_;
  const std::lock_guard lock(exchange_);
  next_ = PreparedCorridor{.body = std::move(corridor), .path = path_, .aimed_at = {}, .state = ++corridors_};
}

std::optional<PreparedCorridor> PressedPatient::next_corridor() {
  if (failed()) return {};
  const std::lock_guard lock(exchange_);
  return std::exchange(next_, std::nullopt);
}

}  // namespace bodkin
