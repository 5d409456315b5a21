#pragma once

#include <array>
#include <cstdint>

#include "scene/camera.h"

namespace bodkin::scene {

// Directions of view. The keys 0 to 6 of the 3-D view select them in this order.
enum class StandardView : std::uint8_t {
  operator_side,  // over the entry, from behind the needle's side
  posterior,
  anterior,
  left,
  right,
  superior,
  inferior
};
inline constexpr int standard_view_count = 7;

// The subject of a standard view: the path of the needle, or the middle of the body without one.
struct ViewSubject {
  Vec3 middle = Vec3::Zero();       // LPS mm, in the middle of the image
  Vec3 direction = -Vec3::UnitY();  // unit, into the body
  double height = 170.0;            // mm, height of the image at `middle`
};

// The camera of a standard view. From the operator's side the needle's line is seen at an angle of 55 degrees, with
// the head of the patient up.
Camera standard_view(StandardView view, const ViewSubject& subject);

// Rotated about the focus: by `right` and `down` rad as if the body was dragged at its middle.
Camera turned(const Camera& camera, double right, double down);
// Moved so that points at the focus' distance follow the pointer by this many pixels of an image `height` pixels
// high.
Camera panned(const Camera& camera, double right, double down, int height);
// Nearer by `factor` (above 1: larger), towards `place` at a pixel's ray; the distance stays within 60 and 3000 mm.
Camera zoomed(const Camera& camera, double factor, const Vec3& place);

// A smooth motion from one camera to another.
class CameraFlight {
 public:
  // `duration`: s, above 0.
  CameraFlight(const Camera& from, const Camera& to, double duration = 0.35);
  // At `time` s since the beginning; the last camera from `duration` on.
  Camera at(double time) const;
  bool ended(double time) const { return time >= duration_; }

 private:
  Camera from_, to_;
  double duration_;
};

}  // namespace bodkin::scene
