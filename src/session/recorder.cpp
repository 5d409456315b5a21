#include "session/recorder.h"

#include <chrono>
#include <utility>

namespace bodkin::session {

namespace {

constexpr auto nap = std::chrono::milliseconds(5);
constexpr auto save_interval = std::chrono::milliseconds(250);

}  // namespace

Recorder::Recorder(SessionWriter writer, Observer observer, std::size_t capacity, std::shared_ptr<SecondLink> second)
    : writer_(std::move(writer)),
      observer_(std::move(observer)),
      ring_(capacity),
      second_(std::move(second)),
      thread_([this] { work(); }) {}

Recorder::~Recorder() {
  stop();
}

void Recorder::push(const simulation::TickRecord& record) noexcept {
  if (!ring_.push(record)) ++lost_;
}

void Recorder::take_samples() {
  if (!second_) return;
  SecondSample sample;
  while (second_->samples.pop(sample)) writer_.append(sample);
}

void Recorder::follow(std::shared_ptr<BodyLog> body) {
  const std::lock_guard guard(lock_);
  followed_ = std::move(body);
}

void Recorder::drain_body_log() {
  if (!body_) return;
  AppliedBodyStep applied;
  while (body_->applied_steps.pop(applied)) writer_.append(applied);
  fem::BodyStep step;
  while (body_->steps->pop(step)) writer_.append(step);
}

void Recorder::note(NumberChange change) {
  const std::lock_guard guard(lock_);
  notes_.changes.push_back(std::move(change));
}

void Recorder::note(const ScanSample& sample) {
  const std::lock_guard guard(lock_);
  notes_.scans.push_back(sample);
}

void Recorder::note(ScannedPart part) {
  const std::lock_guard guard(lock_);
  notes_.scanned.push_back(std::move(part));
}

void Recorder::take_notes() {
  Notes notes;
  {
    const std::lock_guard guard(lock_);
    std::swap(notes, notes_);
    if (followed_) body_ = std::move(followed_);
  }
  for (const NumberChange& change : notes.changes) writer_.append(change);
  for (const ScanSample& sample : notes.scans) writer_.append(sample);
  for (const ScannedPart& part : notes.scanned) writer_.append(part);
}

void Recorder::work() {
  try {
    simulation::TickRecord record;
    auto saved = std::chrono::steady_clock::now();
    for (bool last = false; !last;) {
      take_notes();
      // Checked before the ring is emptied: everything pushed before the request is still recorded.
      last = stopping_.load(std::memory_order_acquire);
      while (ring_.pop(record)) {
        drain_body_log();  // before the chunk with the tick is saved
        writer_.append(record);
        if (observer_) observer_(record);
      }
      take_samples();
      drain_body_log();
      take_notes();
      const auto now = std::chrono::steady_clock::now();
      if (now - saved >= save_interval) {
        writer_.commit();
        saved = now;
      }
      if (!last) std::this_thread::sleep_for(nap);
    }
    writer_.commit();
  } catch (...) {
    failure_ = std::current_exception();
    failed_.store(true, std::memory_order_release);
  }
}

void Recorder::stop() {
  stopping_.store(true, std::memory_order_release);
  if (thread_.joinable()) thread_.join();
}

void Recorder::finish(const std::optional<SessionTimings>& timings) {
  stop();
  if (failure_) std::rethrow_exception(failure_);
  writer_.finish(timings);
}

}  // namespace bodkin::session
