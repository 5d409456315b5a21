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

// Decouples a servo thread, which must never wait, from the disk: records pass through a ring to a separate thread,
// which saves them at least four times a second.
class Recorder {
 public:
  // Called on the recorder's thread with every record, in order.
  using Observer = std::function<void(const simulation::TickRecord&)>;

  static constexpr std::size_t usual_capacity = 16384;  // 16 s at 1 kHz

  // `capacity`: records that may wait when the disk is slow. `second`: its samples are saved too; may be null.
  explicit Recorder(SessionWriter writer, Observer observer = {}, std::size_t capacity = usual_capacity,
                    std::shared_ptr<SecondLink> second = nullptr);
  // Ends the thread; pushed records are saved, but the session does not count as finished.
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  // Servo thread only; wait-free. A record that finds the ring full is dropped and counted.
  void push(const simulation::TickRecord& record) noexcept;
  // Before the first push(): also saves the log of a body with motion of its own.
  void follow(std::shared_ptr<BodyLog> body);
  // Any thread; waits for a copy at most. Saved with the ticks.
  void note(NumberChange change);
  void note(const ScanSample& sample);
  void note(ScannedPart part);
  // Saves the rest and closes the session. Rethrows an error of the recorder's thread.
  void finish(const std::optional<SessionTimings>& timings = {});

  // Whether the thread has stopped because of a disk error; finish() reports it. Any thread.
  bool failed() const noexcept { return failed_.load(std::memory_order_acquire); }
  // Records lost so far. Servo thread only, or after finish().
  std::uint64_t lost() const noexcept { return lost_; }

 private:
  void work();
  void take_samples();
  void drain_body_log();
  void take_notes();
  void stop();

  // Rare data, from threads that may wait for a copy.
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
  std::shared_ptr<BodyLog> body_;  // used by the recorder's thread; may be null
  Notes notes_;
  std::uint64_t lost_ = 0;
  std::atomic<bool> stopping_{false};
  std::atomic<bool> failed_{false};
  std::exception_ptr failure_;
  std::thread thread_;
};

}  // namespace bodkin::session
