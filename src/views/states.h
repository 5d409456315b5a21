#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace bodkin::views {

// Where a practice session is. One owner (StateMachine) changes it; every view sees it in the frame.
enum class State : std::uint8_t {
  no_case,      // the start page
  preparing,    // a patient is read, a station is put together
  ready,        // the patient lies there, the needle waits
  aiming,       // the needle hovers over the skin under the pointer
  touching,     // the tip presses on the skin, which has not given way
  in_tissue,    // the tip is in the body
  warning,      // the tip is where it must not be
  reached,      // the tip is at the target
  held,         // the needle stays, the hand is free
  paused,       // the card with Resume, Again, End, Leave
  faulted,      // the guard took the force away
  device_lost,  // the device does not answer
  ended         // the results
};
inline constexpr int state_count = 13;

// What can happen to it.
enum class Signal : std::uint8_t {
  case_chosen,
  prepared,
  cancelled,  // also: it failed
  pointer_on_patient,
  pointer_off_patient,
  touched,
  lifted,      // the tip is outside of the body again
  punctured,   // the skin gave way
  forbidden,   // the tip is in a forbidden structure or on bone
  safe_again,  // it has been out of there for 1.5 s, or the person has seen the warning
  target_reached,
  target_left,
  hold,
  release,
  pause,
  resume,
  guard_fault,
  armed,
  device_gone,
  device_back,
  end,
  again,
  leave
};
inline constexpr int signal_count = 23;

std::string_view name_of(State state) noexcept;    // "in_tissue"
std::string_view name_of(Signal signal) noexcept;  // "punctured"

// One edge of the graph of states.
struct Edge {
  State from;
  Signal signal;
  State to;
};
// All edges whose end is fixed. `release`, `resume`, `armed` and `device_back` lead to where their state came from.
std::span<const Edge> edges() noexcept;

// The state, and where an interruption came from.
class StateMachine {
 public:
  State state() const noexcept { return state_; }
  // Follows the edge of the present state for `signal`. False, and nothing changed, where there is none.
  bool apply(Signal signal) noexcept;
  // The state that an interruption (held, paused, faulted, device_lost) goes back to; otherwise the present one.
  State underlying() const noexcept;

 private:
  State state_ = State::no_case;
  State interrupted_ = State::no_case;  // where held, paused, faulted and device_lost came from
};

// The needle is in the body or touches it.
bool needle_is_down(State state) noexcept;
// An attempt runs, interrupted or not.
bool is_attempt(State state) noexcept;

}  // namespace bodkin::views
