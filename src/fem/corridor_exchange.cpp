#include "fem/corridor_exchange.h"

namespace bodkin {

namespace {

void swap_corridors(CondensedBody& a, CondensedBody& b) noexcept {
  a.nodes.swap(b.nodes);
  a.mesh_nodes.swap(b.mesh_nodes);
  a.tissues.swap(b.tissues);
  a.compliance.swap(b.compliance);
}

}  // namespace

CorridorExchange::CorridorExchange(const CondensedBody& first)
    : body_(first), slots_{first, CondensedBody{}, first} {}

void CorridorExchange::publish() noexcept {
  making_ = exchanged_.exchange(static_cast<std::uint8_t>(making_ | fresh), std::memory_order_acq_rel) & slot_mask;
}

bool CorridorExchange::take_newest(const EmbeddedNeedleForce& last) noexcept {
  if (!newer_waits() || last.nodes != 0 || last.tip_force != 0.0) return false;
  swap_corridors(body_, slots_[shell_]);
  shell_ = exchanged_.exchange(shell_, std::memory_order_acq_rel) & slot_mask;
  swap_corridors(body_, slots_[shell_]);
  return true;
}

}  // namespace bodkin
