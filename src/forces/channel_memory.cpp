#include "forces/channel_memory.h"

#include <cmath>
#include <numbers>

#include "core/repeatable.h"
#include "forces/model_input.h"

namespace bodkin::forces {

ChannelMemory::ChannelMemory(double same_distance, double same_angle) : same_distance_(same_distance) {
  check_range("channel_memory", "distance of entries of one channel", same_distance, {0.0, 100.0}, "mm");
  check_range("channel_memory", "angle between directions of one channel", same_angle, {0.0, 90.0}, "deg");
  same_cosine_ = repeatable::cos(same_angle * std::numbers::pi / 180.0);
}

bool ChannelMemory::enter(const Vec3& entry, const Vec3& direction) noexcept {
  for (std::size_t i = 0; i < size_; ++i) {
    if ((channels_[i].entry - entry).norm() <= same_distance_ &&
        channels_[i].direction.dot(direction) >= same_cosine_) {
      current_ = i;
      return false;
    }
  }
  if (size_ < capacity) {
    current_ = size_++;
  } else {
    current_ = oldest_;
    oldest_ = (oldest_ + 1) % capacity;
  }
  channels_[current_] = {entry, direction, 0.0};
  return true;
}

void ChannelMemory::clear() noexcept {
  channels_.fill({});
  current_ = oldest_ = size_ = 0;
}

}  // namespace bodkin::forces
