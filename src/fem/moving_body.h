#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "core/latest_value.h"
#include "fem/corridor_exchange.h"
#include "fem/pressed_body.h"

namespace bodkin {

// What the eyes see of a moving body, and how it is.
struct BodyPicture {
  std::vector<float> displacements;  // mm, 3 a node of the mesh, x y z in turn
  std::uint64_t steps = 0;           // made so far
  Wrench on_probe;                   // N and N mm, about the probe's origin
  std::uint32_t probe_nodes = 0;     // that the probe holds
  bool settled = true;
  std::uint32_t corridors = 0;   // published so far
  std::uint32_t faults = 0;      // steps that failed: the body stayed where it was
  bool corridor_failed = false;  // the last corridor could not be made: the one before it stays
};

// A body that moves on its own time, on a thread of its own (PressedBody). Time is told from outside, by the haptic
// tick or by whoever has it: the thread reads no clock, makes a step whenever the time of one has passed, and looks
// for it about a thousand times a second. Where it falls behind it leaves steps out: the body then moves in slow
// motion. While a corridor is being made, no steps are.
//
// Every function below is wait-free and belongs to one thread each, as said. The thread ends with the object.
class MovingBody {
 public:
  // Checks all, makes the first corridor, of the body at rest, and starts. Throws InputError.
  MovingBody(const BodyDescription& body, const PressedBodySettings& settings);

  // Whoever keeps the time: s, since any moment.
  void tell_time(double seconds) noexcept { time_.store(seconds, std::memory_order_relaxed); }
  // Whoever tracks the probe; empty: it is away.
  void move_probe(const std::optional<Pose>& probe) noexcept { probe_.write(probe); }
  // Haptic thread: what the needle does to the nodes of its corridor (EmbeddedNeedle::node_forces), after every tick.
  void press_needle(const NodeForces& forces) noexcept { needle_.write(forces); }
  // Haptic thread, its end.
  CorridorExchange& corridors() noexcept { return *corridors_; }
  // Whoever draws: the newest picture, which stays as it is until the next call.
  const BodyPicture& picture() noexcept { return picture_.read(); }

 private:
  void run(const std::stop_token& stop) noexcept;
  void make_step() noexcept;
  void show() noexcept;

  PressedBody pressed_;
  double pace_;  // s of a step
  std::unique_ptr<CorridorExchange> corridors_;
  std::atomic<double> time_{0.0};
  LatestValue<std::optional<Pose>> probe_;
  LatestValue<NodeForces> needle_;
  BodyPicture next_;  // of the thread
  LatestValue<BodyPicture> picture_;
  std::jthread thread_;  // last: it is the first to end
};

}  // namespace bodkin
