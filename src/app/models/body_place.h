#pragma once

#include <vector>

#include "anatomy/needle_path.h"
#include "core/geometry.h"

namespace bodkin::app {

// The placement of the body in the workspace of the needle's device.
struct BodyPlace {
  Vec3 middle = Vec3::Zero();        // LPS mm, point in the middle of the workspace
  Mat3 rotation = Mat3::Identity();  // operator's axes (right, away, up) to patient

  bool operator==(const BodyPlace&) const = default;
};

// A station's default placement for this path: prone, head away from the operator.
BodyPlace usual_place(const anatomy::NeedlePath& path);

// The placement of the body, with its history.
class BodyMover {
 public:
  // For another patient or path: without history.
  void begin(const BodyPlace& usual);
  // Begins a step: the body is grabbed.
  void begin_step();
  void place(const BodyPlace& place) { now_ = place; }
  // Undoes a step; false: there is none.
  bool undo();
  // Back to the initial placement, itself a step.
  void reset();

  const BodyPlace& now() const noexcept { return now_; }
  bool is_moved() const { return !(now_ == usual_); }

 private:
  BodyPlace usual_, now_;
  std::vector<BodyPlace> before_;
};

}  // namespace bodkin::app
