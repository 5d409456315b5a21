#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "core/latest_value.h"
#include "fem/body_motion.h"
#include "fem/moving/deformable_body_solver.h"

namespace bodkin::fem {

// Snapshot of a moving body for display and supervision.
struct BodySnapshot {
  std::vector<float> displacements;  // mm, 3 per node of the mesh, x y z in turn
  std::uint64_t steps = 0;           // completed so far
  Wrench on_probe;                   // N and N mm, about the probe's origin; including the needle's part
  std::uint32_t probe_nodes = 0;     // held by the probe
  std::vector<std::uint32_t> held;   // the first `held_count` are these nodes; none after a fault
  std::size_t held_count = 0;
  std::span<const std::uint32_t> held_nodes() const noexcept { return {held.data(), held_count}; }
  std::uint32_t faults = 0;  // failed steps, after which the body kept its last state
};

// The force of the body on a probe, small enough to be read in every tick of the hand that holds it.
struct ProbeReading {
  Wrench on_probe;            // N and N mm, about the probe's origin; including by_needle
  Wrench by_needle;           // the part of it caused by a needle in the hand, see push_probe()
  Vec3 probe = Vec3::Zero();  // mm: position of the probe in that step
  std::uint32_t nodes = 0;    // held by the probe; 0: no contact, and on_probe is undefined
  std::uint64_t steps = 0;    // completed so far
};

// Runs a DeformableBodySolver on its own thread. The thread reads no clock: the time is set from outside, for example
// by the haptic tick, and the thread makes a step whenever the time has advanced by one step, polling about a
// thousand times a second. If it falls behind it skips steps, and the body moves in slow motion. After a failed step
// the body keeps its state, and the needle meets it at rest.
//
// Every function is wait-free and belongs to one thread, named with it. The thread ends with the object.
class BodyThread {
 public:
  // Checks the arguments and starts at rest. Throws InputError. `breath`: of a patient who may breathe: everything
  // else about the body is computed for the tissue after expiration, which a probe meets where breathing has moved
  // it.
  BodyThread(const BodyDescription& body, const BodySolverSettings& settings,
             const std::optional<anatomy::BreathField>& breath = {});

  // Clock's thread: s, from any origin, and depth of inspiration, 0 to 1.
  void set_time(double seconds, double drawn_in = 0.0) noexcept {
    drawn_in_.store(drawn_in, std::memory_order_relaxed);
    time_.store(seconds, std::memory_order_relaxed);
  }
  // Probe's thread; empty: no probe touches the body.
  void move_probe(const std::optional<Pose>& probe) noexcept { probe_.write(probe); }
  // Needle's thread: the effect of a needle in the body on the nodes that the probe holds, N, and N mm about their
  // middle (BodyPort::on_held). The probe feels it in the next step. The body's own motion ignores the needle, whose
  // effect is in the needle's own equations.
  void push_probe(const Wrench& by_needle) noexcept { by_needle_.write(by_needle); }
  // The motion of the body, for the needle in it (BodyPort::move_with); empty after a failed step.
  const std::shared_ptr<BodyMotion>& motion() const noexcept { return motion_; }
  // Every step, for the recorder's thread, each before its motion; steps are dropped while the ring is full.
  const std::shared_ptr<BodySteps>& steps() const noexcept { return steps_; }
  // Observer's thread: the newest snapshot, unchanged until the next call.
  const BodySnapshot& snapshot() noexcept { return snapshots_.read(); }
  // Probe's thread: the newest reading, unchanged until the next call.
  const ProbeReading& reading() noexcept { return readings_.read(); }
  // Any thread: the nodes of the mesh that a probe can hold.
  std::span<const std::uint32_t> surface() const noexcept { return solver_.press().surface(); }
  // Any thread: whether a step has failed.
  bool failed() const noexcept { return failed_.load(std::memory_order_acquire); }

 private:
  void run(const std::stop_token& stop) noexcept;
  void make_step() noexcept;
  void publish() noexcept;

  DeformableBodySolver solver_;
  double step_time_;  // s
  std::optional<anatomy::BreathField> breath_;
  std::atomic<double> time_{0.0}, drawn_in_{0.0};
  LatestValue<std::optional<Pose>> probe_;
  LatestValue<Wrench> by_needle_;
  BodySnapshot next_;  // used by the body thread
  LatestValue<BodySnapshot> snapshots_;
  LatestValue<ProbeReading> readings_;
  BodyField field_;                    // used by the body thread
  std::optional<Pose> probe_of_step_;  // used by the body thread
  std::shared_ptr<BodyMotion> motion_;
  std::shared_ptr<BodySteps> steps_;
  std::atomic<bool> failed_{false};
  std::jthread thread_;  // the last member: it uses the others
};

}  // namespace bodkin::fem
