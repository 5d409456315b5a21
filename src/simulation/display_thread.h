#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <thread>
#include <vector>

#include "core/latest_value.h"
#include "fem/display_field.h"
#include "fem/growing_field.h"
#include "fem/node_forces.h"

namespace bodkin::simulation {

// Snapshot for display: the displacements of a body's visible points.
struct DisplaySnapshot {
  std::uint64_t frame = 0;           // counts the snapshots made; 0: none yet
  std::uint64_t field = 0;           // counts the calls of DisplayThread::show()
  std::vector<float> displacements;  // mm, x y z of every point, one point after another
  double left_out = 0.0;             // N of the needle's forces on nodes without columns, which the display omits
};

// Computes the displacements for display repeatedly on its own thread, from the newest forces of the tick. Neither
// the tick nor the drawing thread ever waits: both exchange values through LatestValue.
class DisplayThread {
 public:
  // `rate`: snapshots per second, 1 to 1000. Throws InputError for another rate.
  explicit DisplayThread(fem::DisplayField field, double rate = 60.0);
  explicit DisplayThread(std::unique_ptr<fem::GrowingField> field, double rate = 60.0);

  // The tick's thread only; wait-free.
  void set_forces(const fem::NodeForces& forces) noexcept { forces_.write(forces); }
  // The drawing thread only: nodes of the mesh held by something (GrowingField::hold).
  void hold(std::span<const std::uint32_t> nodes);
  // The drawing thread only: from now on the snapshots show this field, at rest until its first one is computed.
  void show(std::unique_ptr<fem::GrowingField> field);
  // The drawing thread only: the newest snapshot, unchanged until the next call.
  const DisplaySnapshot& snapshot() noexcept;

 private:
  void run(const std::stop_token& stop, double rate);
  bool take_next(DisplaySnapshot& now);

  std::unique_ptr<fem::GrowingField> field_;
  LatestValue<fem::NodeForces> forces_;
  LatestValue<std::vector<std::uint32_t>> held_;
  std::vector<std::uint32_t> reported_held_;  // used by the drawing thread
  LatestValue<DisplaySnapshot> snapshots_;
  DisplaySnapshot at_rest_;  // used by the drawing thread until the first snapshot of the newest field
  std::mutex lock_;          // guards the next two members; the tick never takes it
  std::unique_ptr<fem::GrowingField> next_;
  std::uint64_t next_field_ = 0;
  std::jthread thread_;  // the last member: it uses the others
};

}  // namespace bodkin::simulation
