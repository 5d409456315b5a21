#include "station/adjustable_tick.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/error.h"
#include "forces/model_settings.h"
#include "simulation/contact_settings.h"

namespace bodkin::station {

namespace {

constexpr std::size_t lead_in = 100;         // ticks before the skin was touched
constexpr std::chrono::milliseconds nap{1};  // between two looks at the servo
constexpr std::size_t at_once = 4096;        // inputs copied at a time

bool has(const forces::TickEvents& events, forces::EventKind kind) {
  return std::any_of(events.begin(), events.end(), [kind](const forces::Event& event) { return event.kind == kind; });
}

bool are_same(std::span<const forces::DiagnosticName> a, std::span<const forces::DiagnosticName> b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& x, const auto& y) { return x.name == y.name; });
}

}  // namespace

void InsertionInputs::keep(const simulation::TickRecord& record) {
  const std::lock_guard guard(lock_);
  const bool follows = record.tick == first_ + inputs_.size();
  if (is_in_ && (!follows || inputs_.size() >= most)) is_incomplete_ = true;
  if (has(record.output.events, forces::EventKind::withdrawn)) is_in_ = is_incomplete_ = false;
  if (!follows || is_incomplete_) {
    // After a gap it is the input after the tick: a millisecond does not matter where ticks were lost.
    before_ = follows && !breaths_.empty() ? breaths_.back() : record.output.breath;
    inputs_.clear();
    breaths_.clear();
    first_ = record.tick;
  }
  if (has(record.output.events, forces::EventKind::contact)) {
    is_in_ = true;
    forget_all_but(lead_in);
  }
  inputs_.push_back(record.input);
  breaths_.push_back(record.output.breath);
  if (!is_in_ && inputs_.size() > 2 * lead_in) forget_all_but(lead_in);
}

void InsertionInputs::forget_all_but(std::size_t count) {
  if (inputs_.size() <= count) return;
  const std::size_t gone = inputs_.size() - count;
  before_ = breaths_[gone - 1];
  breaths_.erase(breaths_.begin(), breaths_.begin() + static_cast<std::ptrdiff_t>(gone));
  inputs_.erase(inputs_.begin(), inputs_.begin() + static_cast<std::ptrdiff_t>(gone));
  first_ += gone;
}

std::optional<InsertionInputs::Begin> InsertionInputs::first() const {
  const std::lock_guard guard(lock_);
  if (inputs_.empty()) return std::nullopt;
  return Begin{first_, before_};
}

bool InsertionInputs::is_incomplete() const {
  const std::lock_guard guard(lock_);
  return is_incomplete_;
}

std::vector<simulation::TickInput> InsertionInputs::from(std::uint64_t tick, std::size_t count) const {
  const std::lock_guard guard(lock_);
  if (tick < first_ || tick >= first_ + inputs_.size()) return {};
  const auto begin = inputs_.begin() + static_cast<std::ptrdiff_t>(tick - first_);
  return {begin,
          begin + static_cast<std::ptrdiff_t>(std::min(count, static_cast<std::size_t>(inputs_.end() - begin)))};
}

AdjustableTick::Next::Next(const anatomy::Case& from, session::NumberChange made)
    : change(std::move(made)),
      patient([&] {
        anatomy::Case with = from;
        session::apply(change, with);
        return with;
      }()),
      tick(patient) {}

AdjustableTick::AdjustableTick(std::shared_ptr<const anatomy::Case> patient, simulation::HapticTick& first)
    : patient_(std::move(patient)),
      current_(first),
      body_(first.body()),
      diagnostics_(first.diagnostic_names().begin(), first.diagnostic_names().end()) {}

AdjustableTick::~AdjustableTick() {
  stop();
}

simulation::TickOutput AdjustableTick::step(std::uint64_t tick, const simulation::TickInput& input) noexcept {
  if (Next* const next = offered_.load(std::memory_order_acquire); next != nullptr) {
    const bool missed = tick - next->next >= recent_ticks;
    for (int i = 0; i < catch_up && !missed && next->next < tick; ++i)
      next->tick.step(recent_[next->next++ % recent_ticks]);
    if (missed) {
      next->state.store(Next::State::missed, std::memory_order_release);
      offered_.store(nullptr, std::memory_order_release);
    } else if (next->next == tick && current_.switch_to(next->tick)) {
      next->change.tick = tick;
      settling_ = next;
      ++applied_changes_;
      next->state.store(Next::State::applied, std::memory_order_release);
      offered_.store(nullptr, std::memory_order_release);
    }
  }
  if (NextContact* const next = offered_contact_.load(std::memory_order_acquire); next != nullptr) {
    body_->change_numbers(next->numbers);
    next->change.tick = next->change.from_tick = tick;
    ++applied_changes_;
    offered_contact_.store(nullptr, std::memory_order_relaxed);
    next->is_applied.store(true, std::memory_order_release);
  }
  recent_[tick % recent_ticks] = input;
  simulation::TickOutput output = current_.step(input);
  if (settling_ != nullptr && !current_.is_settling())
    std::exchange(settling_, nullptr)->state.store(Next::State::settled, std::memory_order_release);
  return output;
}

void AdjustableTick::request_change(const anatomy::HapticSettings& haptics,
                                    const std::vector<anatomy::TissueProperties>& tissues, Note note) {
  if (body_ != nullptr &&
      !simulation::differ_in_contact_alone(patient_->description.haptics, forces::model_settings(*patient_).tissues,
                                           haptics, tissues)) {
    throw InputError(
        "this takes effect from the next attempt on, because the deformable body is prepared with it; its capture "
        "radius, times, friction and puncture forces take effect at once");
  }
  if (haptics.rate != patient_->description.haptics.rate)
    throw InputError("another rate takes effect from the next attempt on");
  {
    const std::lock_guard guard(lock_);
    if (stopping_) return;
    wanted_ = session::NumberChange{0, 0, haptics, session::changed_tissues(tissues, patient_->library)};
    if (!thread_.joinable()) {
      note_ = std::move(note);
      thread_ = std::thread([this] { work(); });
    }
  }
  changed_.notify_one();
}

std::string AdjustableTick::take_refusal() {
  const std::lock_guard guard(lock_);
  return std::exchange(refusal_, {});
}

void AdjustableTick::stop() {
  {
    const std::lock_guard guard(lock_);
    stopping_ = true;
  }
  changed_.notify_one();
  if (thread_.joinable()) thread_.join();
}

bool AdjustableTick::is_over() const {
  const std::lock_guard guard(lock_);
  return stopping_;
}

void AdjustableTick::work() {
  for (;;) {
    session::NumberChange change;
    {
      std::unique_lock guard(lock_);
      changed_.wait(guard, [this] { return stopping_ || wanted_; });
      if (stopping_) return;
      change = std::move(*wanted_);
      wanted_.reset();
    }
    try {
      if (body_ != nullptr)
        prepare_contact(change);
      else
        prepare_tick(change);
    } catch (const InputError& refused) {
      const std::lock_guard guard(lock_);
      refusal_ = refused.what();
    }
  }
}

void AdjustableTick::prepare_tick(const session::NumberChange& change) {
  while (!is_over()) {
    if (inputs_.is_incomplete()) {
      throw InputError(
          "the needle has been in for more than ten minutes, or the disk was too slow; draw it out before you change "
          "a "
          "number");
    }
    auto next = std::make_unique<Next>(*patient_, change);
    if (next->tick.body() != nullptr || !are_same(next->tick.diagnostic_names(), diagnostics_))
      throw InputError("another force model takes effect from the next attempt on");
    if (!lead(*next)) continue;
    offered_.store(next.get(), std::memory_order_release);
    if (wait_for(std::move(next))) return;
  }
}

void AdjustableTick::prepare_contact(const session::NumberChange& change) {
  contact_ = std::make_unique<NextContact>();  // the servo has finished with the one before
  NextContact* const next = contact_.get();
  next->change = change;
  anatomy::Case with;
  with.description = patient_->description;
  with.library = patient_->library;
  session::apply(change, with);
  next->numbers = simulation::contact_numbers(with);
  offered_contact_.store(next, std::memory_order_release);
  while (!next->is_applied.load(std::memory_order_acquire) && !is_over()) std::this_thread::sleep_for(nap);
  if (next->is_applied.load(std::memory_order_acquire)) note_(next->change);
}

// Processes the available inputs; false: there are none yet.
bool AdjustableTick::lead(Next& next) const {
  const std::optional<InsertionInputs::Begin> first = inputs_.first();
  if (!first) {
    std::this_thread::sleep_for(nap);
    return false;
  }
  next.change.from_tick = next.next = first->tick;
  next.tick.set_breath(first->breath);
  for (std::size_t count = at_once; count == at_once;) {
    const std::vector<simulation::TickInput> inputs = inputs_.from(next.next, at_once);
    for (const simulation::TickInput& input : inputs) next.tick.step(input);
    count = inputs.size();
    next.next += count;
  }
  return true;
}

// Waits until it acts and the one before has faded. False: the servo was too far ahead.
bool AdjustableTick::wait_for(std::unique_ptr<Next> next) {
  using State = Next::State;
  for (bool is_noted = false;;) {
    const bool over = is_over();  // read before the state, so that a change active at the end is noted
    const State state = next->state.load(std::memory_order_acquire);
    const bool acts = state == State::applied || state == State::settled;
    if (acts && !std::exchange(is_noted, true)) note_(next->change);
    if (state == State::missed) return false;
    if (state == State::settled || over) break;
    std::this_thread::sleep_for(nap);
  }
  // Data that an abandoned servo may still read are kept until it ends.
  offered_.store(nullptr, std::memory_order_release);
  before_ = std::exchange(now_, std::move(next));
  if (!is_over()) before_.reset();
  return true;
}

}  // namespace bodkin::station
