#pragma once

#include <array>
#include <cstddef>

#include "core/geometry.h"

namespace bodkin::forces {

// The channels that a needle has cut during a session, and the depth of each. Cut tissue does not have to be cut
// again, so a model asks here whether an entry is new. An entry belongs to a known channel when it lies within
// `same_distance` of that channel's entry and points within `same_angle` of its direction.
//
// Fixed capacity, no allocation; the 65th channel replaces the one that was opened first.
class ChannelMemory {
 public:
  static constexpr std::size_t capacity = 64;

  // `same_distance`: mm, >= 0. `same_angle`: degrees, 0 to 90.
  explicit ChannelMemory(double same_distance = 1.0, double same_angle = 3.0);

  // Makes the channel at `entry` along the unit vector `direction` the current one; true when it is a new one.
  bool enter(const Vec3& entry, const Vec3& direction) noexcept;
  // Deepest depth reached in the current channel, mm; 0 before the first.
  double deepest() const noexcept { return channels_[current_].deepest; }
  void deepen(double depth) noexcept {
    if (depth > channels_[current_].deepest) channels_[current_].deepest = depth;
  }
  std::size_t size() const noexcept { return size_; }
  // Forgets all channels.
  void clear() noexcept;

 private:
  struct Channel {
    Vec3 entry = Vec3::Zero();
    Vec3 direction = Vec3::UnitZ();
    double deepest = 0.0;  // mm
  };
  double same_distance_;
  double same_cosine_;
  std::size_t current_ = 0;
  std::size_t oldest_ = 0;
  std::size_t size_ = 0;
  std::array<Channel, capacity> channels_{};  // capacity; [0] serves until enter() is called
};

}  // namespace bodkin::forces
