#pragma once

#include "imaging/ultrasound/echo_lines.h"
#include "imaging/ultrasound/scan_lines.h"
#include "imaging/ultrasound/ultrasound.h"
#include "imaging/ultrasound/ultrasound_beam.h"

namespace bodkin::imaging {

// The fraction of a perfect mirror's echo that returns from a steel shaft at an angle to the beam, by the squared
// sine of the angle: a mirror's lobe about the right angle, and a little from its roughness in all directions.
double shaft_echo(double sine_squared) noexcept;

// Draws a needle, its pose in the probe's frame, into the echoes: the shaft where scan lines meet it, with a
// brightness by its angle and its distance from the slice, the tail of its inner reflections and the shadow behind
// it; and its tip, which scatters sound in all directions.
void add_needle(const EchoLines& rows, const ScanLines& lines, const UltrasoundBeam& beam,
                const NeedleInUltrasound& needle) noexcept;

}  // namespace bodkin::imaging
