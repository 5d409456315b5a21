#pragma once

#include "tracking/tool_sightings.h"

#include "core/geometry.h"

namespace bodkin::tracking {

// Where a tracked tool is at each moment, for a hand that is asked a thousand times a second: between two pictures in
// which it was seen on a straight line, in the time of the pictures. A live one is shown as late as its pictures
// come, so that its speed is that of the hand; footage is played in its own time, and waits where it is tracked more
// slowly.
//
// A pose that is lost or uncertain is no place: the tool rests at the last one, and counts as unseen, until it is
// seen again and has been reached at no more than 300 mm/s and 5 rad/s, as a hand would. It never moves faster than
// 900 mm/s.
class ToolMotion {
 public:
  struct Place {
    Pose pose = Pose::Identity();  // LPS mm
    bool seen = false;             // it is there; false: it was there last
    bool over = false;             // the footage has ended
  };

  // At rest where a first picture shows it; footage begins at `begin`, s.
  void start(const Pose& pose, double begin) noexcept;
  // `now`: s of the live pictures' clock. `elapsed`: s since the step before. Allocates nothing, waits for nothing.
  const Place& step(ToolFeed& feed, double now, double elapsed) noexcept;

 private:
  void advance_clock(const ToolFeed& feed, double now, double elapsed) noexcept;
  bool aim(const ToolFeed& feed, Pose& goal) const noexcept;

  ToolSighting before_, after_;
  bool has_after_ = false;
  bool lost_ = true;  // until it has been reached
  bool began_ = false;
  double time_ = 0.0;  // s, of the pictures
  double due_ = 0.0;   // s, what it should be of a live one
  Place place_;
};

}  // namespace bodkin::tracking
