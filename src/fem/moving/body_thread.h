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
#include "fem/moving/deformable_body_solver.h"

namespace bodkin::fem {

// Snapshot of a moving body for display and supervision.
struct BodySnapshot {
  std::vector<float> displacements;  // mm, 3 per node of the mesh, x y z in turn
  std::uint64_t steps = 0;           // made so far
  Wrench on_probe;                   // N and N mm, about the probe's origin
  std::uint32_t probe_nodes = 0;     // held by the probe
  bool settled = true;
  std::uint32_t corridors = 0;   // made so far
  std::uint32_t faults = 0;      // steps that failed: the body kept its last state
  bool corridor_failed = false;  // the last corridor could not be made: the previous one stays
};

// The force of the body on a probe, small enough to be read in every tick of the hand that holds it.
struct ProbeReading {
  Wrench on_probe;            // N and N mm, about the probe's origin
  Vec3 probe = Vec3::Zero();  // mm: where the probe was in that step
  std::uint32_t nodes = 0;    // held by the probe; 0: no contact, and on_probe has no meaning
  std::uint64_t steps = 0;    // made so far
};

// Runs a DeformableBodySolver on a thread of its own. The thread reads no clock: the time is set from outside, by the
// haptic tick for example, and the thread makes a step whenever the time has advanced by one step, polling about a
// thousand times a second. If it falls behind it skips steps, and the body moves in slow motion. Corridors are made
// on a second thread, one at a time, while the body keeps moving.
//
// Except move_corridor(), which takes a lock, every function is wait-free and belongs to one thread, named with it.
// Both threads end with the object.
class BodyThread {
 public:
  // Receives every new corridor on the thread that makes them. If it throws, the snapshot says corridor_failed.
  using CorridorTaker = std::function<void(std::shared_ptr<anatomy::CondensedBody>)>;

  // Checks the arguments and starts at rest, with the corridor that condense() makes. Throws InputError. All
  // corridors have the same mesh nodes (CondensedBody::mesh_nodes), in the same order, until move_corridor().
  BodyThread(const BodyDescription& body, const BodySolverSettings& settings, CorridorTaker take_corridor);

  // Clock's thread: s, from any origin.
  void set_time(double seconds) noexcept { time_.store(seconds, std::memory_order_relaxed); }
  // Probe's thread; empty: no probe touches the body.
  void move_probe(const std::optional<Pose>& probe) noexcept { probe_.write(probe); }
  // Haptic thread, after every tick: the needle's forces on nodes of the mesh (BodyPort::node_forces).
  void set_needle_forces(const NodeForces& forces) noexcept { needle_.write(forces); }
  // Any one thread: moves the corridor to other nodes of the mesh. A corridor of them is made as soon as the body has
  // settled, pressed or not. If it cannot be made, the corridor stays, and the snapshot says corridor_failed.
  void move_corridor(std::vector<std::uint32_t> nodes);
  // Any thread: whether the last move_corridor() failed.
  bool move_failed() const noexcept { return move_failed_.load(std::memory_order_acquire); }
  // Observer's thread: the newest snapshot, unchanged until the next call.
  const BodySnapshot& snapshot() noexcept { return snapshots_.read(); }
  // Probe's thread: the newest reading, unchanged until the next call.
  const ProbeReading& reading() noexcept { return readings_.read(); }
  // Any thread: how many steps failed so far.
  std::uint32_t faults() const noexcept { return faults_.load(std::memory_order_acquire); }

 private:
  // Owner of `state_`: the body's thread in `idle`, `made` and `failed`, the maker's thread in `wanted`.
  enum class Corridor : std::uint8_t { idle, wanted, made, failed };

  void run(const std::stop_token& stop) noexcept;
  void make_corridors(const std::stop_token& stop) noexcept;
  void make_step() noexcept;
  void request_corridor() noexcept;
  bool make_corridor(const std::stop_token& stop) noexcept;
  void publish_snapshot() noexcept;

  DeformableBodySolver solver_;
  CorridorTaker take_corridor_;
  double step_time_;  // s
  std::atomic<double> time_{0.0};
  LatestValue<std::optional<Pose>> probe_;
  LatestValue<NodeForces> needle_;
  BodySnapshot next_;  // of the body's thread
  LatestValue<BodySnapshot> snapshots_;
  LatestValue<ProbeReading> readings_;
  std::atomic<std::uint32_t> faults_{0};
  BodyState state_;  // of the corridor that is being made
  std::atomic<Corridor> corridor_{Corridor::idle};
  std::mutex moving_;                    // guards nodes_
  std::vector<std::uint32_t> nodes_;     // written by move_corridor(), taken by the maker's thread
  std::atomic<bool> move_asked_{false};  // a corridor of nodes_ has not been requested yet
  std::atomic<bool> move_failed_{false};
  std::jthread maker_;  // the last two members: they use the others
  std::jthread thread_;
};

}  // namespace bodkin::fem
