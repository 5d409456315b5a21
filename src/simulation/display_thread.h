#pragma once

#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

#include "core/latest_value.h"
#include "fem/display_field.h"
#include "fem/node_forces.h"

namespace bodkin::simulation {

// Snapshot for display: how the visible points of a body have moved.
struct DisplaySnapshot {
  std::uint64_t frame = 0;           // counts the snapshots made; 0: none yet
  std::vector<float> displacements;  // mm, x y z of every point in turn
  double left_out = 0.0;             // N of the needle's forces on nodes that have no columns, which the field omits
};

// Computes the displacements for display repeatedly on a thread of its own, from the newest forces of the tick.
// Neither the tick nor the drawing thread ever waits: both exchange values through LatestValue.
class DisplayThread {
 public:
  // `rate`: snapshots per second, 1 to 1000. Throws InputError for another rate.
  explicit DisplayThread(fem::DisplayField field, double rate = 60.0);

  // The tick's thread only; wait-free.
  void set_forces(const fem::NodeForces& forces) noexcept { forces_.write(forces); }
  // The drawing thread only: the newest snapshot, unchanged until the next call.
  const DisplaySnapshot& snapshot() noexcept { return snapshots_.read(); }

 private:
  void run(const std::stop_token& stop, double rate);

  fem::DisplayField field_;
  LatestValue<fem::NodeForces> forces_;
  LatestValue<DisplaySnapshot> snapshots_;
  std::jthread thread_;  // the last member: it uses the others
};

}  // namespace bodkin::simulation
