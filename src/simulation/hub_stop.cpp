#include "simulation/hub_stop.h"

#include <algorithm>

namespace bodkin::simulation {

namespace {

constexpr double hub_slack = 0.5;  // mm that the hub must lift before its next contact

}  // namespace

double HubStop::step(double depth, double held, anatomy::TissueId tissue, forces::TickEvents& events) noexcept {
  if (depth < length_ - hub_slack) touches_ = false;
  if (depth < length_) return 0.0;
  if (!touches_) {
    touches_ = true;
    events.push({forces::EventKind::hub_contact, tissue, depth, 0.0});
  }
  return std::max(stiffness_ - held, 0.5 * stiffness_) * (depth - length_);
}

}  // namespace bodkin::simulation
