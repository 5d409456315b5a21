#pragma once

#include <optional>

#include "station/hand_session.h"

#include "haptics/servo_tick.h"
#include "haptics/workspace_map.h"

namespace bodkin::station {

// Moves the body in the workspace of a running device (WorkspaceMap::move_body), and stops it where the needle
// touches it: a needle that goes in meets a body that rests. Knows where the body is on its way by gliding itself, as
// the servo does.
class BodyGlide {
 public:
  // The needle is in the body or touches it.
  static bool touches(const HandSnapshot& needle);

  // `time`: s, by any clock that goes on. `begin`: the workspace that the servo began with.
  void order(const Vec3& middle, const Mat3& rotation, double time, haptics::ServoTick& servo,
             const haptics::WorkspaceSettings& begin);
  // Every few milliseconds.
  void follow(const HandSnapshot& needle, double time, haptics::ServoTick& servo);

  // On its way, or at its end; nothing: it was never moved.
  const std::optional<haptics::WorkspaceMap>& place() const { return place_; }

 private:
  void send(const Vec3& middle, const Mat3& rotation, haptics::ServoTick& servo);

  std::optional<haptics::WorkspaceMap> place_;
  double time_ = 0.0;  // s, of its last step
};

}  // namespace bodkin::station
