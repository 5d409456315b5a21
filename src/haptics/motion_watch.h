#pragma once

#include <array>
#include <cstddef>

#include "core/geometry.h"

namespace bodkin::haptics {

// The motion of a device's hand, as needed for safety: speed, rest, jumps and readings that stand still. Uses
// positions when the device reports no velocity. step() is noexcept and allocates nothing.
class MotionWatch {
 public:
  // `dt`: s, the nominal period.
  explicit MotionWatch(double dt) noexcept;

  // A finite pose (mm), the velocity that the device reports (mm/s, NaN = none), s since the last one.
  void step(const Pose& hand, const Vec3& velocity, double dt) noexcept;
  void reset() noexcept;

  // mm since the last reading.
  const Vec3& moved() const noexcept { return moved_; }
  // rad about the operator's axes since the last reading, exact for small turns.
  const Vec3& turned() const noexcept { return turned_; }
  // mm/s of this tick: as reported, or else from the change since the last reading.
  double speed() const noexcept { return speed_; }
  // mm/s over the last 10 ms, only from positions, so that a coarse encoder at rest does not appear as motion.
  double mean_speed() const noexcept { return mean_speed_; }
  // mm/s and rad/s, means over the last 3 ms: recent enough for damping.
  const Vec3& recent_velocity() const noexcept { return recent_velocity_; }
  const Vec3& recent_turning() const noexcept { return recent_turning_; }
  // Whether no bit of the pose has changed since the last reading.
  bool is_still() const noexcept { return still_; }
  // More than 5 mm in one tick, and faster than 3 m/s: not possible for a hand.
  bool jumped() const noexcept { return jumped_; }

 private:
  static constexpr std::size_t capacity = 64;  // a power of two above 10 ms at 4 kHz

  struct Reading {
    Vec3 position = Vec3::Zero();
    Vec3 turned = Vec3::Zero();  // rad, the sum of all turns until then
    double time = 0.0;           // s
  };

  // Change of `of` per second since the given number of readings ago, or since the first one.
  Vec3 rate_since(std::size_t back, Vec3 Reading::*of) const noexcept;

  double dt_;
  std::size_t window_;  // readings in 10 ms
  std::size_t recent_;  // readings in 3 ms
  std::array<Reading, capacity> readings_{};
  std::size_t seen_ = 0;
  double time_ = 0.0;
  Pose last_ = Pose::Identity();
  Vec3 moved_ = Vec3::Zero();
  Vec3 turned_ = Vec3::Zero();
  Vec3 all_turned_ = Vec3::Zero();  // rad
  double speed_ = 0.0;
  double mean_speed_ = 0.0;
  Vec3 recent_velocity_ = Vec3::Zero();
  Vec3 recent_turning_ = Vec3::Zero();
  bool still_ = false;
  bool jumped_ = false;
};

}  // namespace bodkin::haptics
