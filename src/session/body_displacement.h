#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "session/session_file.h"

#include "fem/moving/deformable_body_solver.h"
#include "simulation/body_port.h"

namespace bodkin::session {

// The record of a body with motion of its own in a session's header (SessionHeader::moving_body), JSON; and its
// settings. Throws InputError for an invalid text.
std::string moving_body_text(const fem::BodySolverSettings& settings, std::size_t nodes);
// `left`: the needles left in the session's body; in sessions of earlier versions of Bodkin they were not part of the
// moving body, and are not added.
fem::BodySolverSettings moving_body_settings(const std::string& text,
                                             const std::vector<anatomy::NeedlePath>& left = {});

// Throws InputError when the needle met a moving body, and the session lacks data that are needed to move it again.
void check_moved_body(const Session& session);

// Repeats the motion of a session's body: the same steps with the same probe, each met by the needle in the same
// tick.
class BodyDisplacement {
 public:
  // `body`, of the case, and `port`, of the recomputed tick, may be null for a session without a moving body. Throws
  // InputError as check_moved_body() does, and when there is no body to move.
  BodyDisplacement(const Session& session, const fem::BodyDescription* body, simulation::BodyPort* port);

  // Before each tick.
  void prepare_for(std::uint64_t tick) noexcept;
  // One sentence when a step differs from the session's; empty: none does.
  std::string difference() const;

 private:
  void step() noexcept;

  const Session& session_;
  std::vector<AppliedBodyStep>::const_iterator next_;
  std::unique_ptr<fem::DeformableBodySolver> solver_;  // null: no moving body
  std::shared_ptr<fem::BodyMotion> motion_;
  fem::BodyField field_;
  bool failed_ = false;          // a step failed: from then on the needle meets the body at rest
  std::uint64_t different_ = 0;  // the first step that differs; 0: none
};

}  // namespace bodkin::session
