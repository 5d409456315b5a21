#include "views/states.h"

#include <map>
#include <set>
#include <utility>

#include <gtest/gtest.h>

namespace bodkin::views {
namespace {

// A machine in state `wanted`, reached by edges from the start; nothing if unreachable.
std::optional<StateMachine> machine_in(State wanted) {
  std::vector<StateMachine> waiting = {StateMachine()};
  std::set<State> seen = {State::no_case};
  for (std::size_t i = 0; i < waiting.size(); ++i) {
    if (waiting[i].state() == wanted) return waiting[i];
    for (const Edge& edge : edges()) {
      if (edge.from != waiting[i].state() || !seen.insert(edge.to).second) continue;
      StateMachine next = waiting[i];
      next.apply(edge.signal);
      waiting.push_back(next);
    }
  }
  return std::nullopt;
}

TEST(States, every_state_can_be_reached_from_the_start) {
  for (int state = 0; state < state_count; ++state) {
    const std::optional<StateMachine> machine = machine_in(static_cast<State>(state));
    EXPECT_TRUE(machine.has_value()) << name_of(static_cast<State>(state));
  }
}

TEST(States, every_edge_leads_where_the_table_says) {
  for (const Edge& edge : edges()) {
    std::optional<StateMachine> machine = machine_in(edge.from);
    ASSERT_TRUE(machine.has_value());
    EXPECT_TRUE(machine->apply(edge.signal)) << name_of(edge.from) << " " << name_of(edge.signal);
    EXPECT_EQ(machine->state(), edge.to) << name_of(edge.from) << " " << name_of(edge.signal);
  }
}

TEST(States, a_signal_has_one_meaning_in_a_state) {
  std::set<std::pair<State, Signal>> seen;
  for (const Edge& edge : edges()) {
    EXPECT_TRUE(seen.insert({edge.from, edge.signal}).second) << name_of(edge.from) << " " << name_of(edge.signal);
  }
}

TEST(States, what_the_table_does_not_name_changes_nothing) {
  std::map<std::pair<State, Signal>, State> named;
  for (const Edge& edge : edges()) named[{edge.from, edge.signal}] = edge.to;
  const std::set<std::pair<State, Signal>> back = {{State::held, Signal::release},
                                                   {State::paused, Signal::resume},
                                                   {State::faulted, Signal::armed},
                                                   {State::device_lost, Signal::device_back}};
  for (int from = 0; from < state_count; ++from) {
    for (int signal = 0; signal < signal_count; ++signal) {
      const std::pair key{static_cast<State>(from), static_cast<Signal>(signal)};
      if (named.contains(key) || back.contains(key)) continue;
      std::optional<StateMachine> machine = machine_in(key.first);
      ASSERT_TRUE(machine.has_value());
      EXPECT_FALSE(machine->apply(key.second)) << name_of(key.first) << " " << name_of(key.second);
      EXPECT_EQ(machine->state(), key.first);
    }
  }
}

TEST(States, an_interruption_goes_back_to_where_it_came_from) {
  const std::pair<Signal, Signal> interruptions[] = {{Signal::hold, Signal::release},
                                                     {Signal::pause, Signal::resume},
                                                     {Signal::guard_fault, Signal::armed},
                                                     {Signal::device_gone, Signal::device_back}};
  for (const State from :
       {State::ready, State::aiming, State::touching, State::in_tissue, State::warning, State::reached}) {
    for (const auto& [begin, end] : interruptions) {
      std::optional<StateMachine> machine = machine_in(from);
      ASSERT_TRUE(machine.has_value());
      EXPECT_TRUE(machine->apply(begin));
      EXPECT_EQ(machine->underlying(), from);
      EXPECT_TRUE(machine->apply(end));
      EXPECT_EQ(machine->state(), from);
    }
  }
}

TEST(States, an_interruption_within_an_interruption_goes_back_to_the_needle) {
  std::optional<StateMachine> machine = machine_in(State::in_tissue);
  ASSERT_TRUE(machine.has_value());
  machine->apply(Signal::hold);
  machine->apply(Signal::pause);
  machine->apply(Signal::resume);
  EXPECT_EQ(machine->state(), State::in_tissue);
}

TEST(States, no_needle_is_left_in_a_patient_by_leaving_a_held_session) {
  for (const State from : {State::held, State::paused, State::faulted, State::device_lost}) {
    std::optional<StateMachine> machine = machine_in(from);
    ASSERT_TRUE(machine.has_value());
    EXPECT_TRUE(machine->apply(Signal::end));
    EXPECT_EQ(machine->state(), State::ended);
  }
}

}  // namespace
}  // namespace bodkin::views
