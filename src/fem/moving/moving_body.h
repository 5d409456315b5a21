#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "core/latest_value.h"
#include "fem/moving/pressed_body.h"

namespace bodkin {

// What the eyes see of a moving body, and how it is.
struct BodyPicture {
  std::vector<float> displacements;  // mm, 3 a node of the mesh, x y z in turn
  std::uint64_t steps = 0;           // made so far
  Wrench on_probe;                   // N and N mm, about the probe's origin
  std::uint32_t probe_nodes = 0;     // that the probe holds
  bool settled = true;
  std::uint32_t corridors = 0;   // made so far
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
  // Hears of every new corridor, on the body's thread: CorridorExchange::offer, say. What it throws is
  // corridor_failed.
  using CorridorTaker = std::function<void(std::shared_ptr<const CondensedBody>)>;

  // Checks all and starts, at rest: the corridor is that of condense(). Throws InputError. The names of the
  // corridor's nodes (CondensedBody::mesh_nodes) are the same in all corridors, and in the same order.
  MovingBody(const BodyDescription& body, const PressedBodySettings& settings, CorridorTaker take_corridor);

  // Whoever keeps the time: s, since any moment.
  void tell_time(double seconds) noexcept { time_.store(seconds, std::memory_order_relaxed); }
  // Whoever tracks the probe; empty: it is away.
  void move_probe(const std::optional<Pose>& probe) noexcept { probe_.write(probe); }
  // Haptic thread: what the needle does to the nodes of its corridor (EmbeddedNeedle::node_forces), after every tick.
  void press_needle(const NodeForces& forces) noexcept { needle_.write(forces); }
  // Whoever draws: the newest picture, which stays as it is until the next call.
  const BodyPicture& picture() noexcept { return picture_.read(); }

 private:
  void run(const std::stop_token& stop) noexcept;
  void make_step() noexcept;
  bool make_corridor() noexcept;
  void show() noexcept;

  PressedBody pressed_;
  CorridorTaker take_corridor_;
  double pace_;  // s of a step
  std::atomic<double> time_{0.0};
  LatestValue<std::optional<Pose>> probe_;
  LatestValue<NodeForces> needle_;
  BodyPicture next_;  // of the thread
  LatestValue<BodyPicture> picture_;
  std::jthread thread_;  // last: it is the first to end
};

}  // namespace bodkin
