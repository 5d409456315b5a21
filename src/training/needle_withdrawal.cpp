#include "training/needle_withdrawal.h"

#include <algorithm>

#include "session/tick_codec.h"

namespace bodkin::training {

NeedleWithdrawal::NeedleWithdrawal(const Procedure& procedure, const anatomy::Case& patient,
                                   const std::optional<Vec3>& target)
    : when_(procedure.withdrawal_ends), target_(target) {
  for (const Goal& goal : procedure.goals) {
    const anatomy::TissueProperties* const tissue = goal.tissue.empty() ? nullptr : patient.library.find(goal.tissue);
    if (tissue != nullptr) tissues_.push_back(tissue->id);
    if (!goal.event.empty()) events_.push_back(goal.event);
    if (goal.by != GoalKind::near_target) continue;
    within_ = std::max(within_, goal.within > 0.0 ? goal.within : patient.description.procedure.target_tolerance);
  }
}

bool NeedleWithdrawal::reaches_goal(const Moment& moment) const {
  const auto is_goal = [&](anatomy::TissueId tissue) {
    return std::find(tissues_.begin(), tissues_.end(), tissue) != tissues_.end();
  };
  for (const session::SessionEvent& each : moment.events) {
    if (each.event.kind == forces::EventKind::tissue_entered && is_goal(each.event.tissue)) return true;
    if (std::find(events_.begin(), events_.end(), session::event_kind_name(each.event.kind)) != events_.end())
      return true;
  }
  if (!moment.is_inside) return false;
  return is_goal(moment.tissue) || (target_ && (moment.tip - *target_).norm() <= within_);
}

void NeedleWithdrawal::follow(const Moment& moment) {
  was_inside_ = was_inside_ || moment.is_inside;
  reached_ = reached_ || reaches_goal(moment);
  remaining_.reset();
  const bool may_end = when_ == WithdrawalEnds::always || (when_ == WithdrawalEnds::after_goal && reached_);
  if (!moment.is_outside || !was_inside_ || !may_end) return outside_since_.reset();
  if (!outside_since_) outside_since_ = moment.time;
  remaining_ = std::max(0.0, patience - (moment.time - *outside_since_));
}

}  // namespace bodkin::training
