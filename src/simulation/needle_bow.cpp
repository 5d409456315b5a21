#include "simulation/needle_bow.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bodkin::simulation {

namespace {

constexpr double effective_share = 0.7;       // of the free length: clamped at the hub, held across at the skin
constexpr double shortest_outside = 1.0;      // mm; less does not buckle
constexpr double straightening_speed = 50.0;  // mm/s
constexpr double least_bow = 0.2;             // mm, that is an event
constexpr double surely_less = 0.999;         // despite the rounding of a product in place of a quotient

}  // namespace

NeedleBow::NeedleBow(const anatomy::Case& patient, double dt)
    : rigid_(patient.description.haptics.mechanics != anatomy::Mechanics::physical),
      length_(patient.description.needle.length),
      stiffness_(anatomy::bending_stiffness(patient.description.needle)),
      of_clamped_(std::numbers::pi * std::numbers::pi * stiffness_),
      straightening_(straightening_speed * dt) {
  for (const anatomy::TissueProperties& tissue : patient.library.tissues()) young_[tissue.id] = tissue.physical.young;
}

void NeedleBow::begin() noexcept {
  softest_ = on_support_ = hand_ = tip_ = bow_ = last_ = 0.0;
  fresh_ = true;
  over_ = false;
}

double NeedleBow::strength() const noexcept {
  const double outside = length_ - tip_;
  double least = std::numeric_limits<double>::infinity();
  if (outside > shortest_outside) {
    const double held = effective_share * outside;
    least = of_clamped_ / (held * held);
  }
  if (softest_ > 0.0) least = std::min(least, on_support_);
  return least;
}

bool NeedleBow::bows_under(double force) const noexcept {
  const double held = effective_share * (length_ - tip_);
  if (force * held * held < surely_less * of_clamped_ && (softest_ == 0.0 || force < on_support_)) return false;
  return force >= strength();
}

AxialMotion NeedleBow::tip_motion(const AxialMotion& hand) noexcept {
  if (rigid_) return hand;
  const double advance = fresh_ ? 0.0 : hand.depth - hand_;
  hand_ = hand.depth;
  fresh_ = false;
  const bool bows = bows_under(last_);
  if (bows && advance > 0.0) {
    bow_ += advance;
  } else if (bow_ > 0.0) {
    bow_ = std::max(0.0, bow_ + std::min(0.0, advance));
    if (!bows) bow_ = std::max(0.0, bow_ - straightening_);
  }
  AxialMotion tip = hand;
  tip.depth = hand.depth - bow_;
  if (bow_ > 0.0) tip.velocity = 0.0;
  tip_ = tip.depth;
  return tip;
}

double NeedleBow::limited(double resistance, anatomy::TissueId tissue, forces::TickEvents& events) noexcept {
  if (rigid_) return resistance;
  if (const double here = young_[tissue]; here > 0.0 && tip_ > 0.0 && (softest_ == 0.0 || here < softest_)) {
    softest_ = here;
    on_support_ = 2.0 * std::sqrt(softest_ * stiffness_);
  }
  last_ = resistance;
  if (bow_ == 0.0) over_ = false;
  if (bow_ == 0.0 && !bows_under(resistance)) return resistance;
  const double most = strength();
  if (!over_ && bow_ > least_bow) {
    over_ = true;
    events.push({forces::EventKind::needle_buckled, tissue, tip_, most});
  }
  return std::min(resistance, most);
}

}  // namespace bodkin::simulation
