#pragma once

#include "tracking/tool_sightings.h"

#include "core/geometry.h"

namespace bodkin::tracking {

// The pose of a tracked tool at any time, for a hand that is read a thousand times a second: between two images in
// which it was seen it moves on a straight line, in the time of the images. A live tool is shown with the delay of
// its images, so that its speed is that of the hand; footage is played in its own time, and waits if tracking is
// slower.
//
// A lost or uncertain pose is not used: the tool rests at the last one, and counts as unseen, until it is seen again
// and has been reached at no more than 300 mm/s and 5 rad/s, as by a hand. It never moves faster than 900 mm/s.
class ToolMotion {
 public:
  struct Place {
    Pose pose = Pose::Identity();  // LPS mm
    bool seen = false;             // false: it was there last
    bool over = false;             // the footage has ended
  };

  // Starts at rest at the pose of a first image; footage begins at `begin`, s.
  void start(const Pose& pose, double begin) noexcept;
  // `now`: s of the live images' clock. `elapsed`: s since the previous step. Allocates nothing, waits for nothing.
  const Place& step(ToolFeed& feed, double now, double elapsed) noexcept;

 private:
  void advance_clock(const ToolFeed& feed, double now, double elapsed) noexcept;
  bool aim(const ToolFeed& feed, Pose& goal) const noexcept;

  ToolSighting before_, after_;
  bool has_after_ = false;
  bool lost_ = true;  // until it has been reached
  bool began_ = false;
  double time_ = 0.0;  // s, of the pictures
  double due_ = 0.0;   // s, its intended value for a live tool
  Place place_;
};

}  // namespace bodkin::tracking
