#pragma once

#include "imaging/ultrasound/echo_rows.h"
#include "imaging/ultrasound/scan_lines.h"
#include "imaging/ultrasound/sound_beam.h"
#include "imaging/ultrasound/ultrasound.h"

namespace bodkin::imaging {

// How much of a full mirror's echo comes back from a steel shaft whose axis makes an angle with the beam, as the
// squared sine of it: a mirror's lobe about the right angle, and a little from its roughness in all directions.
double shaft_echo(double sine_squared) noexcept;

// Draws a needle, its pose in the probe's frame, into the echoes: the shaft where scanlines meet it, as bright as its
// angle and its distance from the slice let it be, with the tail of its inner reflections and the shadow behind it;
// and its tip, which throws sound in all directions.
void add_needle(const EchoRows& rows, const ScanLines& lines, const SoundBeam& beam,
                const NeedleInSound& needle) noexcept;

}  // namespace bodkin::imaging
