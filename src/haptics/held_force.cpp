#include "haptics/held_force.h"

#include <algorithm>

namespace bodkin::haptics {

void HeldForce::send(const Vec3& force) noexcept {
  sent_[count_ & (capacity - 1)] = {force, time_};
  ++count_;
}

void HeldForce::command(const Vec3& force) noexcept {
  if (later_) {
    waiting_ = force;
  } else {
    send(force);
  }
}

Vec3 HeldForce::step(double dt) noexcept {
  const double begin = time_;
  time_ += dt;
  if (later_) send(waiting_);
  Vec3 sum = Vec3::Zero();
  double until = time_;
  const std::size_t oldest = count_ > capacity ? count_ - capacity : 0;
  for (std::size_t i = count_; i > oldest && until > begin; --i) {
    const Sent& sent = sent_[(i - 1) & (capacity - 1)];
    const double from = std::max(begin, sent.time + delay_);
    if (from >= until) continue;
    sum += (until - from) * sent.force;
    until = from;
  }
  return sum / dt;
}

}  // namespace bodkin::haptics
