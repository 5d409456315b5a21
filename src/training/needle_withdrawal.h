#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "session/session_file.h"

#include "anatomy/case.h"
#include "core/geometry.h"
#include "training/procedure.h"

namespace bodkin::training {

// Whether a running attempt is over because its needle was taken out: it has been in the body, was withdrawn wholly,
// and has stayed outside for `patience`, if the procedure says so (Procedure::withdrawal_ends). Reinsertion restarts
// the wait.
class NeedleWithdrawal {
 public:
  static constexpr double patience = 5.0;  // s, our choice: enough time to reinsert

  // The state of the attempt at one time.
  struct Moment {
    double time = 0.0;        // s, by any one clock
    bool is_inside = false;   // the skin is punctured
    bool is_outside = false;  // the needle touches nothing, and is not being brought to the skin
    anatomy::TissueId tissue = anatomy::tissue::air;     // at the tip
    Vec3 tip = Vec3::Zero();                             // LPS mm, position after expiration of the tissue at the tip
    std::span<const session::SessionEvent> events = {};  // since the previous moment
  };

  // Without an attempt: nothing ends it.
  NeedleWithdrawal() = default;
  // `target`: of the planned path, LPS mm; empty: none is planned.
  NeedleWithdrawal(const Procedure& procedure, const anatomy::Case& patient, const std::optional<Vec3>& target);

  void follow(const Moment& moment);
  // s until the attempt is over, 0: it is; empty: the needle is not out, or may stay out.
  std::optional<double> remaining() const noexcept { return remaining_; }

 private:
  bool reaches_goal(const Moment& moment) const;

  WithdrawalEnds when_ = WithdrawalEnds::never;
  std::vector<anatomy::TissueId> tissues_;  // of the goals
  std::vector<std::string> events_;
  std::optional<Vec3> target_;
  double within_ = -std::numeric_limits<double>::infinity();  // mm from the target
  bool was_inside_ = false, reached_ = false;
  std::optional<double> outside_since_, remaining_;
};

}  // namespace bodkin::training
