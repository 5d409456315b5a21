#pragma once

#include "anatomy/volume.h"

namespace bodkin::imaging {

// Where a hand holds a probe: a place on the skin, how the probe stands on it and how far it is pressed in. Slid
// along the body it stays on the skin and keeps its angle to it.
class ProbeOnSkin {
 public:
  // As it is: `pose` is the probe's (its frame: ultrasound/probe.h), on the skin or not.
  explicit ProbeOnSkin(const Pose& pose);
  // On the skin at `face`, which points `outward` (unit).
  ProbeOnSkin(const Pose& pose, const Vec3& outward);

  // The probe's pose, pressed in.
  Pose pose() const;
  // mm that the face is moved beyond the skin along the probe's depth; negative: lifted off.
  double press() const { return press_; }
  void press(double millimetres);

  // Moves the face over the skin, mm along the probe's marked side and across the slice. False, and nothing moves,
  // where there is no skin.
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
