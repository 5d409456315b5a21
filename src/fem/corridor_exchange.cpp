#include "fem/corridor_exchange.h"

#include <algorithm>
#include <string>

#include "core/error.h"

namespace bodkin {

namespace {

const CondensedBody& body_with_names(const CondensedBody& body) {
  if (body.mesh_nodes.size() == body.nodes.size()) return body;
  throw InputError("corridor: " + std::to_string(body.nodes.size()) + " nodes and " +
                   std::to_string(body.mesh_nodes.size()) +
                   " names of them in the mesh, expected as many; prepare it again");
}

}  // namespace

CorridorExchange::NeedleInCorridor::NeedleInCorridor(std::shared_ptr<const CondensedBody> corridor,
                                                     const ContactTissues& tissues,
                                                     const EmbeddedNeedleSettings& settings, double dt,
                                                     std::uint32_t number_of_it)
    : body(std::move(corridor)), number(number_of_it), needle(body_with_names(*body), tissues, settings, dt) {
  names.reserve(body->mesh_nodes.size());
  for (const std::uint32_t name : body->mesh_nodes)
    names.emplace_back(name, static_cast<std::uint32_t>(names.size()));
  std::sort(names.begin(), names.end());
}

CorridorExchange::CorridorExchange(std::shared_ptr<const CondensedBody> first, const ContactTissues& tissues,
                                   const EmbeddedNeedleSettings& settings, double dt)
    : tissues_(tissues),
      settings_(settings),
      dt_(dt),
      held_(std::make_unique<NeedleInCorridor>(std::move(first), tissues, settings, dt, 0)) {}

std::uint32_t CorridorExchange::offer(std::shared_ptr<const CondensedBody> corridor) {
  auto ready = std::make_unique<NeedleInCorridor>(std::move(corridor), tissues_, settings_, dt_, offered_ + 1);
  waiting_.offer(std::move(ready));
  return ++offered_;
}

void CorridorExchange::remember_punctures(const NeedleInCorridor& from, NeedleInCorridor& to) noexcept {
  auto old = from.names.begin();
  for (const auto& [name, node] : to.names) {
    while (old != from.names.end() && old->first < name) ++old;
    if (old == from.names.end()) return;
    if (old->first == name && from.needle.punctured(old->second)) to.needle.remember_puncture(node);
  }
}

bool CorridorExchange::exchange() noexcept {
  std::unique_ptr<NeedleInCorridor> taken = waiting_.take();
  if (taken == nullptr) return false;
  remember_punctures(*held_, *taken);
  held_.swap(taken);
  waiting_.give_back(std::move(taken));
  return true;
}

bool CorridorExchange::take_newest() noexcept {
  return !held_->needle.touches() && exchange();
}

void CorridorExchange::begin(const Vec3& entry, const Vec3& direction) noexcept {
  exchange();
  held_->needle.begin(entry, direction);
}

}  // namespace bodkin
