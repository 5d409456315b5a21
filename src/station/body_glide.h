#pragma once

#include <optional>

#include "station/hand_session.h"

#include "haptics/servo_tick.h"
#include "haptics/workspace_map.h"

namespace bodkin::station {

// Moves the body in the workspace of a running device (WorkspaceMap::move_body), and stops it when the needle touches
// it: an inserted needle meets a body at rest. Computes the body's present place by the same motion as the servo.
class BodyGlide {
 public:
  // Whether the needle is in the body or touches it.
  static bool touches(const HandSnapshot& needle);

  // `time`: s, of any monotonic clock. `begin`: the servo's initial workspace.
  void request(const Vec3& middle, const Mat3& rotation, double time, haptics::ServoTick& servo,
               const haptics::WorkspaceSettings& begin);
  // To be called every few milliseconds.
  void follow(const HandSnapshot& needle, double time, haptics::ServoTick& servo);

  // The present place, during the motion or after it; empty: it was never moved.
  const std::optional<haptics::WorkspaceMap>& place() const { return place_; }

 private:
  void send(const Vec3& middle, const Mat3& rotation, haptics::ServoTick& servo);

  std::optional<haptics::WorkspaceMap> place_;
  double time_ = 0.0;  // s, of its last step
};

}  // namespace bodkin::station
