#pragma once

#include <array>
#include <cstdint>

#include "scene/camera.h"

namespace bodkin::scene {

// Directions to look at a patient from. The keys 0 to 6 of the 3-D view choose them in this order.
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

// What a standard view is made for: the path of the needle, or the middle of the body where there is none.
struct ViewSubject {
  Vec3 middle = Vec3::Zero();       // LPS mm, in the middle of the picture
  Vec3 direction = -Vec3::UnitY();  // unit, into the body
  double height = 170.0;            // mm that the picture is high at `middle`
};

// The camera of a standard view. From the operator's side the needle's line is seen from 55 degrees beside it, with
// the head of the patient up.
Camera standard_view(StandardView view, const ViewSubject& subject);

// Turned about the focus: by `right` and `down` rad as if the body was taken at the middle and drawn there.
Camera turned(const Camera& camera, double right, double down);
// Moved so that what is at the focus' distance follows the pointer by so many pixels of a picture `height` pixels
// high.
Camera panned(const Camera& camera, double right, double down, int height);
// Nearer by `factor` (above 1: larger), towards `place` at a pixel's ray; the distance stays within 60 and 3000 mm.
Camera zoomed(const Camera& camera, double factor, const Vec3& place);

// A smooth way from one camera to another.
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
