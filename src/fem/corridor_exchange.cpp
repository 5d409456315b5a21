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

void CorridorExchange::leave(std::unique_ptr<NeedleInCorridor> left) noexcept {
  if (left != nullptr) waiting_.give_back(std::move(left));
}

bool CorridorExchange::exchange() noexcept {
  follows_ = false;
  std::unique_ptr<NeedleInCorridor> taken = waiting_.take();
  if (taken == nullptr) {
    taken = std::move(coming_);
  } else {
    leave(std::move(coming_));
  }
  if (taken == nullptr) return false;
  remember_punctures(*held_, *taken);
  held_.swap(taken);
  leave(std::move(taken));
  return true;
}

bool CorridorExchange::take_newest() noexcept {
  return !held_->needle.touches() && exchange();
}

bool CorridorExchange::go_on_in_newest() noexcept {
  if (!follows_) {
    if (!held_->needle.holds() || !waiting_.waits()) return false;
    std::unique_ptr<NeedleInCorridor> taken = waiting_.take();
    if (taken == nullptr) return false;
    leave(std::move(coming_));
    coming_ = std::move(taken);
    follows_ = coming_->needle.begin_to_follow(held_->needle);
    return false;
  }
  const FollowState state = coming_->needle.follow(held_->needle);
  follows_ = state == FollowState::under_way;
  if (state != FollowState::done) return false;
  held_.swap(coming_);
  leave(std::move(coming_));
  return true;
}

void CorridorExchange::begin(const Vec3& entry, const Vec3& direction) noexcept {
  exchange();
  held_->needle.begin(entry, direction);
}

}  // namespace bodkin
