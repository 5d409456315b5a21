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

// What a session's header keeps of a body that moves by itself (SessionHeader::moving_body), JSON; and what it was
// made of. Throws InputError for a text that is not one.
std::string moving_body_text(const fem::BodySolverSettings& settings, std::size_t nodes);
// `left`: the needles that were left in the session's body; those that were not made part of the moving one, in
// sessions of Bodkin before this, are not part of it.
fem::BodySolverSettings moving_body_settings(const std::string& text,
                                             const std::vector<anatomy::NeedlePath>& left = {});

// Throws InputError when the needle met a body that moved by itself, and the session does not have all that is
// needed to move it again.
void check_moved_body(const Session& session);

// Moves the body of a session again: the same steps with the same probe, each met by the needle in the same tick.
class MovedBody {
 public:
  // `body`, of the case, and `port`, of the tick that is recomputed, may be null when the session's body did not
  // move by itself. Throws InputError as check_moved_body() does, and when there is no body to move.
  MovedBody(const Session& session, const fem::BodyDescription* body, simulation::BodyPort* port);

  // Before each tick.
  void prepare_for(std::uint64_t tick) noexcept;
  // One sentence when a step came out otherwise than in the session; empty: none did.
  std::string difference() const;

 private:
  void step() noexcept;

  const Session& session_;
  std::vector<BodyTaken>::const_iterator next_;
  std::unique_ptr<fem::DeformableBodySolver> solver_;  // null: nothing moves
  std::shared_ptr<fem::BodyMotion> motion_;
  fem::BodyField field_;
  bool failed_ = false;          // a step failed: from then on the needle meets the body at rest
  std::uint64_t different_ = 0;  // the first step that is; 0: none
};

}  // namespace bodkin::session
