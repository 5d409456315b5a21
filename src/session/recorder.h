#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "session/body_log.h"
#include "session/second_link.h"
#include "session/session_file.h"

#include "core/single_producer_ring.h"

namespace bodkin::session {

// Stands between a servo thread, which must never wait, and the disk: records go through a ring to a thread of their
// own, which saves them at least four times a second.
class Recorder {
 public:
  // Called on the recorder's thread with every record, in order.
  using Observer = std::function<void(const simulation::TickRecord&)>;

  static constexpr std::size_t usual_capacity = 16384;  // 16 s at 1 kHz

  // `capacity`: records that may wait when the disk is slow. `second`: whose samples are saved too; may be null.
  explicit Recorder(SessionWriter writer, Observer observer = {}, std::size_t capacity = usual_capacity,
                    std::shared_ptr<SecondLink> second = nullptr);
  // Ends the thread; what was pushed is saved, but the session does not count as finished.
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  // Servo thread only; wait-free. A record that finds the ring full is lost and counted.
  void push(const simulation::TickRecord& record) noexcept;
  // Before the first push(): a body moves by itself, of which this is saved too.
  void follow(std::shared_ptr<BodyLog> body);
  // Any thread; waits for a copy at most. Saved with the ticks.
  void note(NumberChange change);
  void note(const ScanSample& sample);
  void note(ScannedPart part);
  // Saves what is left and closes the session. Throws what went wrong on the recorder's thread.
  void finish(const std::optional<SessionTimings>& timings = {});

  // The thread has stopped because the disk refused; finish() says why. Any thread.
  bool failed() const noexcept { return failed_.load(std::memory_order_acquire); }
  // Records lost so far. Servo thread only, or after finish().
  std::uint64_t lost() const noexcept { return lost_; }

 private:
  void work();
  void take_samples();
  void take_body();
  void take_notes();
  void stop();

  // What comes seldom, from threads that may wait for a copy.
  struct Notes {
    std::vector<NumberChange> changes;
    std::vector<ScanSample> scans;
    std::vector<ScannedPart> scanned;
  };

  SessionWriter writer_;
  Observer observer_;
  SingleProducerRing<simulation::TickRecord> ring_;
  std::shared_ptr<SecondLink> second_;
  std::mutex lock_;  // guards `notes_` and `followed_`
  std::shared_ptr<BodyLog> followed_;
  std::shared_ptr<BodyLog> body_;  // of the recorder's thread; may be null
  Notes notes_;
  std::uint64_t lost_ = 0;
  std::atomic<bool> stopping_{false};
  std::atomic<bool> failed_{false};
  std::exception_ptr failure_;
  std::thread thread_;
};

}  // namespace bodkin::session
