#pragma once

#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

#include "core/latest_value.h"
#include "fem/display_field.h"
#include "fem/node_forces.h"

namespace bodkin {

// How the visible points of a body have moved.
struct DisplayMoment {
  std::uint64_t frame = 0;           // counts the pictures that were made; 0: none yet
  std::vector<float> displacements;  // mm, x y z of every point in turn
  double left_out = 0.0;             // N of the needle's forces that the picture does not show (no columns)
};

// Makes the field for the eyes again and again on a thread of its own, from the newest forces that the tick has told
// it. Neither the tick nor whoever draws ever waits: both exchange values through LatestValue.
class DisplayThread {
 public:
  // `rate`: pictures a second, 1 to 1000. Throws InputError when it is not.
  explicit DisplayThread(DisplayField field, double rate = 60.0);

  // The tick's thread only; wait-free.
  void tell(const NodeForces& forces) noexcept { forces_.write(forces); }
  // The drawing thread only: the newest picture, which stays as it is until the next call.
  const DisplayMoment& moment() noexcept { return moments_.read(); }

 private:
  void run(const std::stop_token& stop, double rate);

  DisplayField field_;
  LatestValue<NodeForces> forces_;
  LatestValue<DisplayMoment> moments_;
  std::jthread thread_;  // the last member: it uses the others
};

}  // namespace bodkin
