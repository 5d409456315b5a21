#pragma once

#include "anatomy/volume.h"

namespace bodkin::imaging {

// The pose of a hand-held probe: a point on the skin, the probe's angles to it and the depth by which it is pressed
// in. When slid along the body it stays on the skin and keeps its angles.
class ProbeOnSkin {
 public:
  // Anywhere: `pose` is the probe's (its frame: ultrasound/probe.h), on the skin or not.
  explicit ProbeOnSkin(const Pose& pose);
  // On the skin at `face`, whose normal is `outward` (unit).
  ProbeOnSkin(const Pose& pose, const Vec3& outward);

  // The probe's pose, including the press.
  Pose pose() const;
  // mm that the face is moved beyond the skin along the probe's depth; negative: lifted off.
  double press() const { return press_; }
  void press(double millimetres);

  // Moves the face over the skin, mm along the probe's marked axis and across the slice. Returns false, without
  // moving, if there is no skin.
  bool slide(const anatomy::TissueVolume& tissues, double along, double across);
  // rad about the depth axis: the slice turns on the spot.
  void rotate(double angle);
  // rad about the marked axis: the slice fans.
  void tilt(double angle);
  // rad about the axis across the slice: the probe rocks within its slice.
  void rock(double angle);

 private:
  Pose pose_;     // not pressed
  Vec3 outward_;  // unit
  double press_ = 0.0;
};

}  // namespace bodkin::imaging
