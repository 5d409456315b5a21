#pragma once

#include <vector>

#include "anatomy/needle_path.h"
#include "core/geometry.h"

namespace bodkin::app {

// How the body lies in the workspace of the device that holds the needle.
struct BodyPlace {
  Vec3 middle = Vec3::Zero();        // LPS mm, what lies in the middle of the workspace
  Mat3 rotation = Mat3::Identity();  // operator's axes (right, away, up) to patient

  bool operator==(const BodyPlace&) const = default;
};

// Where a station puts the body for this path: prone, head away from the operator.
BodyPlace usual_place(const anatomy::NeedlePath& path);

// The place of the body, with the steps that led to it.
class BodyMover {
 public:
  // Another patient or path: nothing was moved.
  void begin(const BodyPlace& usual);
  // A hand takes the body: what follows is one step.
  void take();
  void place(const BodyPlace& place) { now_ = place; }
  // One step back; false: there is none.
  bool undo();
  // As at the beginning, itself a step.
  void reset();

  const BodyPlace& now() const noexcept { return now_; }
  bool is_moved() const { return !(now_ == usual_); }

 private:
  BodyPlace usual_, now_;
  std::vector<BodyPlace> before_;
};

}  // namespace bodkin::app
