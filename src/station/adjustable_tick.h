#pragma once

#include <array>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "session/number_change.h"

#include "simulation/changing_tick.h"

namespace bodkin::station {

// The inputs of the present insertion, from shortly before the skin was touched; outside, those of the last moment.
class InsertionInputs {
 public:
  static constexpr std::size_t most = 600'000;  // ten minutes at 1 kHz

  // Ticks in their order, from one thread.
  void keep(const simulation::TickRecord& record);
  struct Begin {
    std::uint64_t tick = 0;
    anatomy::BreathState breath;  // before the tick
  };
  // Any thread: the state at the first input; empty: there is none.
  std::optional<Begin> first() const;
  // Any thread: whether the insertion is longer than `most`, or ticks of it were lost.
  bool is_incomplete() const;
  // Any thread: the inputs from `tick` on, at most `count`.
  std::vector<simulation::TickInput> from(std::uint64_t tick, std::size_t count) const;

 private:
  void forget_all_but(std::size_t count);

  mutable std::mutex lock_;  // guards all members below
  std::vector<simulation::TickInput> inputs_;
  std::vector<anatomy::BreathState> breaths_;  // after each input
  anatomy::BreathState before_;                // before the first one
  std::uint64_t first_ = 0;
  bool is_in_ = false, is_incomplete_ = false;
};

// The haptic tick of a session whose numbers can be changed while it runs. A thread creates the tick with the new
// numbers and feeds it the inputs of the present insertion; the servo feeds it the newest ones, takes it over
// (simulation::ChangingTick), and never waits. With a deformable body the same tick continues, and those parameters
// of its contact that may change are replaced step by step (fem::ContactNumbers).
class AdjustableTick {
 public:
  using Note = std::function<void(session::NumberChange)>;

  // `first`: the initial tick of the session, of `patient`; must outlive the object.
  AdjustableTick(std::shared_ptr<const anatomy::Case> patient, simulation::HapticTick& first);
  ~AdjustableTick();
  AdjustableTick(const AdjustableTick&) = delete;
  AdjustableTick& operator=(const AdjustableTick&) = delete;

  // Servo thread only: computes tick number `tick`; the numbers are consecutive.
  simulation::TickOutput step(std::uint64_t tick, const simulation::TickInput& input) noexcept;
  // Servo thread only: number of changes taken over.
  std::uint32_t applied_changes() const noexcept { return applied_changes_; }
  // One thread: stores the input of a tick.
  void keep(const simulation::TickRecord& record) { inputs_.keep(record); }

  // One thread, the observer's. `note` receives each change once it takes effect, on a separate thread. Throws
  // InputError; see HandSession.
  void request_change(const anatomy::HapticSettings& haptics, const std::vector<anatomy::TissueProperties>& tissues,
                      Note note);
  std::string take_refusal();
  // After the last step: ensures that all changes in effect have been noted. The observer's thread.
  void stop();

 private:
  // A tick that will take over.
  struct Next {
    Next(const anatomy::Case& from, session::NumberChange change);

    session::NumberChange change;
    anatomy::Case patient;
    simulation::HapticTick tick;
    std::uint64_t next = 0;  // the first tick whose input it has not processed
    enum class State { offered, missed, applied, settled };
    std::atomic<State> state{State::offered};
  };

  // Numbers of the contact with a deformable body that will take effect.
  struct NextContact {
    session::NumberChange change;
    fem::ContactNumbers numbers;
    std::atomic<bool> is_applied{false};
  };

  void work();
  void prepare_tick(const session::NumberChange& change);
  void prepare_contact(const session::NumberChange& change);
  bool lead(Next& next) const;
  bool wait_for(std::unique_ptr<Next> next);
  bool is_over() const;

  static constexpr std::size_t recent_ticks = 1024;
  static constexpr int catch_up = 8;  // steps of the new tick per step of the servo, until it has caught up

  std::shared_ptr<const anatomy::Case> patient_;
  simulation::ChangingTick current_;
  InsertionInputs inputs_;
  // Used by the servo.
  std::array<simulation::TickInput, recent_ticks> recent_;
  Next* settling_ = nullptr;
  std::uint32_t applied_changes_ = 0;
  std::atomic<Next*> offered_{nullptr};
  std::atomic<NextContact*> offered_contact_{nullptr};

  mutable std::mutex lock_;  // guards the next three members
  std::condition_variable changed_;
  std::optional<session::NumberChange> wanted_;
  std::string refusal_;
  bool stopping_ = false;
  Note note_;                                        // for the requests; set before the thread starts
  std::unique_ptr<Next> now_, before_;               // used by the thread; the latter may still fade out
  std::unique_ptr<NextContact> contact_;             // used by the thread; the servo may read it
  simulation::BodyPort* body_;                       // of the first tick; null: a rigid patient
  std::vector<forces::DiagnosticName> diagnostics_;  // of the session
  std::thread thread_;                               // started by the first request
};

}  // namespace bodkin::station
