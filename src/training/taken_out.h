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

// Whether an attempt that runs is over because its needle was taken out: it has been in the body, was drawn wholly
// out, and has stayed outside for `patience`, where the procedure has it so (Procedure::taken_out_ends). Going in
// again begins anew.
class TakenOut {
 public:
  static constexpr double patience = 5.0;  // s, our choice: time enough to go in again

  // What one moment of the attempt shows.
  struct Moment {
    double time = 0.0;        // s, on one clock
    bool is_inside = false;   // the skin has given way to the needle
    bool is_outside = false;  // the needle touches nothing, and nobody is bringing it to the skin
    anatomy::TissueId tissue = anatomy::tissue::air;  // at the tip
    Vec3 tip = Vec3::Zero();  // LPS mm, where what is at the tip lies when the patient has breathed out
    std::span<const session::SessionEvent> events = {};  // since the moment before
  };

  // Of no attempt: nothing ends it.
  TakenOut() = default;
  // `target`: of the planned path, LPS mm; nothing: none is planned.
  TakenOut(const Procedure& procedure, const anatomy::Case& patient, const std::optional<Vec3>& target);

  void follow(const Moment& moment);
  // s until the attempt is over, 0: it is; nothing: the needle is not out, or may stay out.
  std::optional<double> remaining() const noexcept { return remaining_; }

 private:
  bool reaches_goal(const Moment& moment) const;

  TakenOutEnds when_ = TakenOutEnds::never;
  std::vector<anatomy::TissueId> tissues_;  // of the goals
  std::vector<std::string> events_;
  std::optional<Vec3> target_;
  double within_ = -std::numeric_limits<double>::infinity();  // mm from the target
  bool was_inside_ = false, reached_ = false;
  std::optional<double> outside_since_, remaining_;
};

}  // namespace bodkin::training
