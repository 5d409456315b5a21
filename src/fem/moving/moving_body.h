#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
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

// What a probe meets, small enough for every tick of whoever holds it.
struct ProbeReading {
  Wrench on_probe;            // N and N mm, about the probe's origin
  Vec3 probe = Vec3::Zero();  // mm: where the probe was in that step
  std::uint32_t nodes = 0;    // that the probe holds; 0: it touches nothing, and the rest is of no use
  std::uint64_t steps = 0;    // made so far
};

// A body that moves on its own time, on a thread of its own (PressedBody). Time is told from outside, by the haptic
// tick or by whoever has it: the thread reads no clock, makes a step whenever the time of one has passed, and looks
// for it about a thousand times a second. Where it falls behind it leaves steps out: the body then moves in slow
// motion. Corridors are made on a second thread, one at a time, while the body goes on.
//
// Every function below is wait-free and belongs to one thread each, as said. The thread ends with the object.
class MovingBody {
 public:
  // Receives every new corridor on the thread that makes them. If it throws, the picture says corridor_failed.
  using CorridorTaker = std::function<void(std::shared_ptr<CondensedBody>)>;

  // Checks all and starts, at rest: the corridor is that of condense(). Throws InputError. The names of the
  // corridor's nodes (CondensedBody::mesh_nodes) are the same in all corridors, and in the same order, until others
  // are asked for (lead_corridor).
  MovingBody(const BodyDescription& body, const PressedBodySettings& settings, CorridorTaker take_corridor);

  // Whoever keeps the time: s, since any moment.
  void tell_time(double seconds) noexcept { time_.store(seconds, std::memory_order_relaxed); }
  // Whoever tracks the probe; empty: it is away.
  void move_probe(const std::optional<Pose>& probe) noexcept { probe_.write(probe); }
  // Haptic thread: what the needle does to nodes of the mesh (of_mesh() of EmbeddedNeedle::node_forces), after every
  // tick.
  void press_needle(const NodeForces& forces) noexcept { needle_.write(forces); }
  // Any one thread: other nodes of the mesh are the corridor from now on, where a needle aims, say; a corridor of
  // them is made as soon as the body has settled, whether it was pressed or not. Where that cannot be it stays as it
  // was, which is corridor_failed.
  void lead_corridor(std::vector<std::uint32_t> nodes);
  // Any thread: whether the corridor that was made last was led elsewhere and could not be.
  bool lead_failed() const noexcept { return lead_failed_.load(std::memory_order_acquire); }
  // Whoever draws: the newest picture, which stays as it is until the next call.
  const BodyPicture& picture() noexcept { return picture_.read(); }
  // Whoever holds the probe: the newest reading, which stays as it is until the next call.
  const ProbeReading& reading() noexcept { return reading_.read(); }
  // Any thread: how many steps failed so far.
  std::uint32_t faults() const noexcept { return faults_.load(std::memory_order_acquire); }

 private:
  // Who has the state and what is to be done with it: the body's thread in `idle`, `made` and `failed`, the maker's
  // in `wanted`.
  enum class Corridor : std::uint8_t { idle, wanted, made, failed };

  void run(const std::stop_token& stop) noexcept;
  void make_corridors(const std::stop_token& stop) noexcept;
  void make_step() noexcept;
  void ask_for_corridor() noexcept;
  bool make_corridor(const std::stop_token& stop) noexcept;
  void show() noexcept;

  PressedBody pressed_;
  CorridorTaker take_corridor_;
  double pace_;  // s of a step
  std::atomic<double> time_{0.0};
  LatestValue<std::optional<Pose>> probe_;
  LatestValue<NodeForces> needle_;
  BodyPicture next_;  // of the thread
  LatestValue<BodyPicture> picture_;
  LatestValue<ProbeReading> reading_;
  std::atomic<std::uint32_t> faults_{0};
  PressedState state_;  // of the corridor that is being made
  std::atomic<Corridor> corridor_{Corridor::idle};
  std::mutex leading_;                 // of who leads corridors and who makes them, which both may wait
  std::vector<std::uint32_t> led_to_;  // of both: nodes not yet taken up
  std::atomic<bool> led_{false};       // a corridor of them has not been asked for
  std::atomic<bool> lead_failed_{false};
  std::jthread maker_;  // the last two: they are the first to end
  std::jthread thread_;
};

}  // namespace bodkin
