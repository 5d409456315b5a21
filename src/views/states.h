#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace bodkin::views {

// The state of a practice session. One owner (StateMachine) changes it; every view gets it in the frame.
enum class State : std::uint8_t {
  no_case,      // the start page
  preparing,    // a patient is loaded, a station is assembled
  ready,        // the patient is loaded, the needle waits
  aiming,       // the needle hovers over the skin under the pointer
  touching,     // the tip presses on the skin, which is not punctured yet
  in_tissue,    // the tip is in the body
  warning,      // the tip is in a forbidden place
  reached,      // the tip is at the target
  held,         // the needle stays, the hand is free
  paused,       // the card with Resume, Again, End, Leave
  faulted,      // the guard has removed the force
  device_lost,  // the device does not respond
  ended         // the results
};
inline constexpr int state_count = 13;

// The events that change the state.
enum class Signal : std::uint8_t {
  case_chosen,
  prepared,
  cancelled,  // or failed
  pointer_on_patient,
  pointer_off_patient,
  touched,
  lifted,      // the tip is outside of the body again
  punctured,   // the skin gave way
  forbidden,   // the tip is in a forbidden structure or on bone
  safe_again,  // it has been safe for 1.5 s, or the person has acknowledged the warning
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
// All edges with a fixed end. `release`, `resume`, `armed` and `device_back` return to the state before.
std::span<const Edge> edges() noexcept;

// The state, and the state before an interruption.
class StateMachine {
 public:
  State state() const noexcept { return state_; }
  // Follows the edge of the present state for `signal`. Returns false, without a change, if there is none.
  bool apply(Signal signal) noexcept;
  // The state to which an interruption (held, paused, faulted, device_lost) returns; otherwise the present one.
  State underlying() const noexcept;

 private:
  State state_ = State::no_case;
  State interrupted_ = State::no_case;  // before held, paused, faulted and device_lost
};

// Whether the needle is in the body or touches it.
bool needle_is_down(State state) noexcept;
// Whether an attempt runs, interrupted or not.
bool is_attempt(State state) noexcept;

}  // namespace bodkin::views
