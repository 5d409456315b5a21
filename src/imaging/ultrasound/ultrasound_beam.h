#pragma once

#include "imaging/ultrasound/probe.h"
#include "imaging/ultrasound/settings.h"

namespace bodkin::imaging {

// The beam of a probe: the widths of a point's echo, as full widths at half maximum of its amplitude, there and back.
// All three are Gaussian in shape. An aperture `a` focused at `F` sends a beam whose pressure at depth z falls to
// half within sqrt((1.21 lambda z / a)^2 + (a (1 - z / F))^2): diffraction and, away from the focus, geometry.
struct UltrasoundBeam {
  double wavelength = 0.3;  // mm
  double pulse = 0.3;       // mm along the line: half of the pulse's length, because the echo travels there and back
  double sent = 10.0;       // mm of face that transmit
  double focus = 40.0;      // mm
  double aperture = 40.0;   // mm of the whole face; receiving, the aperture grows to keep `f_number` at every depth
  double f_number = 2.0;
  double height = 6.0;  // mm of an element across the slice
  double lens = 60.0;   // mm, its focus

  // mm across the lines within the slice.
  double lateral(double depth) const;
  // mm across the slice.
  double elevation(double depth) const;
};

UltrasoundBeam ultrasound_beam(const anatomy::UltrasoundProbe& probe, const UltrasoundSettings& settings);

// Standard deviation of a Gaussian, as a fraction of its full width at half maximum.
inline constexpr double deviation_of_width = 0.42466090;

}  // namespace bodkin::imaging
