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

// The inputs of the present insertion, from a moment before the skin was touched; outside, those of the last moment.
class InsertionInputs {
 public:
  static constexpr std::size_t most = 600'000;  // ten minutes at 1 kHz

  // Ticks in their order, from one thread.
  void keep(const simulation::TickRecord& record);
  struct Begin {
    std::uint64_t tick = 0;
    anatomy::BreathMoment breath;  // before it
  };
  // Any thread: the first one; nothing: none is there.
  std::optional<Begin> first() const;
  // Any thread: the insertion is longer than `most`, or ticks of it were lost.
  bool is_incomplete() const;
  // Any thread: those from `tick` on, at most `count`.
  std::vector<simulation::TickInput> from(std::uint64_t tick, std::size_t count) const;

 private:
  void forget_all_but(std::size_t count);

  mutable std::mutex lock_;  // guards all below
  std::vector<simulation::TickInput> inputs_;
  std::vector<anatomy::BreathMoment> breaths_;  // after each
  anatomy::BreathMoment before_;                // the first one
  std::uint64_t first_ = 0;
  bool is_in_ = false, is_incomplete_ = false;
};

// The haptic tick of a session whose numbers can be changed while it runs. A thread makes the tick with the new
// numbers and leads it through the inputs of the present insertion; the servo leads it through the newest, takes it
// over (simulation::ChangingTick), and waits for nothing. With a deformable body the same tick continues, and those
// parameters of its contact that may change are replaced step by step (fem::ContactNumbers).
class FeltNumbers {
 public:
  using Note = std::function<void(session::NumberChange)>;

  // `first`: the tick of `patient` with which the session begins; must outlive the object.
  FeltNumbers(std::shared_ptr<const anatomy::Case> patient, simulation::HapticTick& first);
  ~FeltNumbers();
  FeltNumbers(const FeltNumbers&) = delete;
  FeltNumbers& operator=(const FeltNumbers&) = delete;

  // Servo thread only: the tick number `tick`, which come one after the other.
  simulation::TickOutput step(std::uint64_t tick, const simulation::TickInput& input) noexcept;
  // The same thread: how many changes have been taken.
  std::uint32_t taken() const noexcept { return taken_; }
  // One thread: what was stepped.
  void keep(const simulation::TickRecord& record) { inputs_.keep(record); }

  // One thread, the observer's. `note` gets each change once it acts, on a thread of its own. Throws InputError; see
  // HandSession.
  void order(const anatomy::HapticSettings& haptics, const std::vector<anatomy::TissueProperties>& tissues,
             Note note);
  std::string take_refusal();
  // After the last step: what acts has been noted. The observer's thread.
  void stop();

 private:
  // A tick that is to take over.
  struct Next {
    Next(const anatomy::Case& from, session::NumberChange change);

    session::NumberChange change;
    anatomy::Case patient;
    simulation::HapticTick tick;
    std::uint64_t next = 0;  // the tick whose input it has not gone through
    enum class State { offered, missed, taken, settled };
    std::atomic<State> state{State::offered};
  };

  // Numbers of the contact with a deformable body that are to act.
  struct NextContact {
    session::NumberChange change;
    fem::ContactNumbers numbers;
    std::atomic<bool> is_taken{false};
  };

  void work();
  void bring_in(const session::NumberChange& change);
  void bring_in_contact(const session::NumberChange& change);
  bool lead(Next& next) const;
  bool wait_for(std::unique_ptr<Next> next);
  bool is_over() const;

  static constexpr std::size_t recent_ticks = 1024;
  static constexpr int catch_up = 8;  // steps of the new tick in one of the servo's, until it has caught up

  std::shared_ptr<const anatomy::Case> patient_;
  simulation::ChangingTick felt_;
  InsertionInputs inputs_;
  // The servo's.
  std::array<simulation::TickInput, recent_ticks> recent_;
  Next* settling_ = nullptr;
  std::uint32_t taken_ = 0;
  std::atomic<Next*> offered_{nullptr};
  std::atomic<NextContact*> offered_contact_{nullptr};

  mutable std::mutex lock_;  // guards the three below
  std::condition_variable changed_;
  std::optional<session::NumberChange> wanted_;
  std::string refusal_;
  bool stopping_ = false;
  Note note_;                                        // of the orders; set before the thread begins
  std::unique_ptr<Next> now_, before_;               // the thread's; the latter may fade
  std::unique_ptr<NextContact> contact_;             // the thread's; the servo may look at it
  simulation::BodyPort* body_;                       // of the first tick; null: a rigid patient
  std::vector<forces::DiagnosticName> diagnostics_;  // of the session
  std::thread thread_;                               // begins with the first order
};

}  // namespace bodkin::station
