#include "views/states.h"

#include <array>

namespace bodkin::views {

namespace {

using enum State;

// States in which interruptions can begin.
constexpr std::array attempt_states = {ready, aiming, touching, in_tissue, warning, reached};

constexpr std::array fixed_edges = {
    Edge{no_case, Signal::case_chosen, preparing},
    Edge{ended, Signal::case_chosen, preparing},
    Edge{preparing, Signal::prepared, ready},
    Edge{preparing, Signal::cancelled, no_case},
    Edge{ready, Signal::pointer_on_patient, aiming},
    Edge{ready, Signal::touched, touching},
    Edge{aiming, Signal::pointer_off_patient, ready},
    Edge{aiming, Signal::touched, touching},
    Edge{touching, Signal::lifted, aiming},
    Edge{touching, Signal::punctured, in_tissue},
    Edge{touching, Signal::forbidden, warning},
    Edge{in_tissue, Signal::lifted, aiming},
    Edge{in_tissue, Signal::forbidden, warning},
    Edge{in_tissue, Signal::target_reached, reached},
    Edge{warning, Signal::safe_again, in_tissue},
    Edge{warning, Signal::lifted, aiming},
    Edge{reached, Signal::target_left, in_tissue},
    Edge{reached, Signal::forbidden, warning},
    Edge{reached, Signal::lifted, aiming},
    Edge{held, Signal::end, ended},
    Edge{held, Signal::again, preparing},
    Edge{held, Signal::leave, no_case},
    Edge{paused, Signal::end, ended},
    Edge{paused, Signal::again, preparing},
    Edge{paused, Signal::leave, no_case},
    Edge{faulted, Signal::end, ended},
    Edge{faulted, Signal::again, preparing},
    Edge{faulted, Signal::leave, no_case},
    Edge{device_lost, Signal::end, ended},
    Edge{device_lost, Signal::again, preparing},
    Edge{device_lost, Signal::leave, no_case},
    Edge{ended, Signal::again, preparing},
    Edge{ended, Signal::leave, no_case},
};

// From every state of an attempt.
struct Exit {
  Signal signal;
  State to;
};
constexpr std::array exits = {Exit{Signal::hold, held},           Exit{Signal::pause, paused},
                              Exit{Signal::guard_fault, faulted}, Exit{Signal::device_gone, device_lost},
                              Exit{Signal::end, ended},           Exit{Signal::again, preparing},
                              Exit{Signal::leave, no_case}};

// A held or paused session can still lose its force or its device.
constexpr std::array deeper_edges = {Edge{held, Signal::pause, paused},
                                     Edge{held, Signal::guard_fault, faulted},
                                     Edge{held, Signal::device_gone, device_lost},
                                     Edge{paused, Signal::guard_fault, faulted},
                                     Edge{paused, Signal::device_gone, device_lost},
                                     Edge{faulted, Signal::device_gone, device_lost}};

constexpr std::size_t total = fixed_edges.size() + deeper_edges.size() + attempt_states.size() * exits.size();

constexpr std::array<Edge, total> all_edges = [] {
  std::array<Edge, total> all{};
  std::size_t count = 0;
  for (const Edge& edge : fixed_edges) all[count++] = edge;
  for (const Edge& edge : deeper_edges) all[count++] = edge;
  for (const State from : attempt_states) {
    for (const Exit& each : exits) all[count++] = {from, each.signal, each.to};
  }
  return all;
}();

constexpr std::array<std::string_view, state_count> state_names = {
    "no_case", "preparing", "ready",  "aiming",  "touching",    "in_tissue", "warning",
    "reached", "held",      "paused", "faulted", "device_lost", "ended"};
constexpr std::array<std::string_view, signal_count> signal_names = {"case_chosen",
                                                                     "prepared",
                                                                     "cancelled",
                                                                     "pointer_on_patient",
                                                                     "pointer_off_patient",
                                                                     "touched",
                                                                     "lifted",
                                                                     "punctured",
                                                                     "forbidden",
                                                                     "safe_again",
                                                                     "target_reached",
                                                                     "target_left",
                                                                     "hold",
                                                                     "release",
                                                                     "pause",
                                                                     "resume",
                                                                     "guard_fault",
                                                                     "armed",
                                                                     "device_gone",
                                                                     "device_back",
                                                                     "end",
                                                                     "again",
                                                                     "leave"};

bool is_interruption(State state) noexcept {
  return state == held || state == paused || state == faulted || state == device_lost;
}

// The signal that ends an interruption.
bool ends_interruption(State state, Signal signal) noexcept {
  return (state == held && signal == Signal::release) || (state == paused && signal == Signal::resume) ||
         (state == faulted && signal == Signal::armed) || (state == device_lost && signal == Signal::device_back);
}

}  // namespace

std::string_view name_of(State state) noexcept {
  return state_names[static_cast<std::size_t>(state)];
}

std::string_view name_of(Signal signal) noexcept {
  return signal_names[static_cast<std::size_t>(signal)];
}

std::span<const Edge> edges() noexcept {
  return all_edges;
}

bool StateMachine::apply(Signal signal) noexcept {
  if (ends_interruption(state_, signal)) {
    state_ = interrupted_;
    return true;
  }
  for (const Edge& edge : all_edges) {
    if (edge.from != state_ || edge.signal != signal) continue;
    if (is_interruption(edge.to) && !is_interruption(state_)) interrupted_ = state_;
    state_ = edge.to;
    return true;
  }
  return false;
}

State StateMachine::underlying() const noexcept {
  return is_interruption(state_) ? interrupted_ : state_;
}

bool needle_is_down(State state) noexcept {
  return state == touching || state == in_tissue || state == warning || state == reached;
}

bool is_attempt(State state) noexcept {
  return state != no_case && state != preparing && state != ended;
}

}  // namespace bodkin::views
