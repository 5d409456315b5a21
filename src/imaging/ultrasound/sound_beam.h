#pragma once

#include "imaging/ultrasound/probe.h"
#include "imaging/ultrasound/settings.h"

namespace bodkin::imaging {

// The beam of a probe: how wide a point's echo is drawn, as full widths at half maximum of its amplitude, there and
// back. All three are Gaussian in shape. An aperture `a` that focuses at `F` sends a beam whose pressure at depth z
// falls to half within sqrt((1.21 lambda z / a)^2 + (a (1 - z / F))^2): diffraction and, away from the focus,
// geometry.
struct SoundBeam {
  double wavelength = 0.3;  // mm
  double pulse = 0.3;       // mm along the line: half of the pulse's length, because the echo travels there and back
  double sent = 10.0;       // mm of face that send
  double focus = 40.0;      // mm
  double aperture = 40.0;   // mm of face that there are; listening, they open to keep `f_number` at every depth
  double f_number = 2.0;
  double height = 6.0;  // mm of an element across the slice
  double lens = 60.0;   // mm, its focus

  // mm across the lines within the slice.
  double lateral(double depth) const;
  // mm across the slice.
  double elevation(double depth) const;
};

SoundBeam sound_beam(const anatomy::UltrasoundProbe& probe, const UltrasoundSettings& settings);

// Standard deviation of a Gaussian, of its full width at half maximum.
inline constexpr double deviation_of_width = 0.42466090;

}  // namespace bodkin::imaging
