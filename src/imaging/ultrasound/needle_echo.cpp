#include "imaging/ultrasound/needle_echo.h"

#include <algorithm>
#include <cmath>

namespace bodkin::imaging {

namespace {

constexpr double steel_reflects = 0.93;    // pressure, 46.3 against 1.63 MRayl
constexpr double roughness = 0.12;         // fraction of the shaft's echo radiated in all directions
constexpr double entering = 0.35;          // of the echo: the first one from inside
constexpr double ringing = 0.75;           // of an inner echo, for the next one
constexpr double steel_to_tissue = 0.266;  // 1540 / 5790 m/s: apparent shortening for inner echoes
constexpr int rings = 14;
constexpr double shadow = 0.45;  // of the sound absorbed by a shaft in the middle of the slice
constexpr double tip_echo = 0.5;

double gauss(double x, double width) noexcept {
  const double ratio = x / (width * deviation_of_width);
  return std::exp(-0.5 * ratio * ratio);
}

// The shaft's echo on one line.
void draw_shaft(const EchoLines& rows, const UltrasoundBeam& beam, double spacing, double depth, int line,
                double off_slice, double sine_squared, double diameter) noexcept {
  const double sample = depth / spacing;
  if (!(sample >= 0.0) || sample >= rows.samples - 1) return;
  const double seen = gauss(off_slice, beam.elevation(depth));
  if (seen < 1e-3) return;
  const double reaches = static_cast<double>(rows.amplitude[rows.at(static_cast<int>(sample), line)]);
  const double echo = reaches * seen * steel_reflects * shaft_echo(sine_squared);
  const float left = static_cast<float>(1.0 - shadow * seen);
  for (int k = static_cast<int>(sample) + 1; k < rows.samples; ++k) {
    rows.in_phase[rows.at(k, line)] *= left;
    rows.quadrature[rows.at(k, line)] *= left;
  }
  const double apart = diameter * steel_to_tissue / spacing;
  rows.add(sample, line, echo);
  double tail = entering * echo;
  for (int ring = 1; ring <= rings; ++ring, tail *= ringing) rows.add(sample + ring * apart, line, tail);
}

}  // namespace

double shaft_echo(double sine_squared) noexcept {
  const double s2 = sine_squared * sine_squared, s4 = s2 * s2;
  return (1.0 - roughness) * s4 * s4 * s4 + roughness;
}

void add_needle(const EchoLines& rows, const ScanLines& lines, const UltrasoundBeam& beam,
                const NeedleInUltrasound& needle) noexcept {
  const Vec3 tip = needle.pose.translation(), axis = needle_axis(needle.pose);
  if (!tip.allFinite() || !axis.allFinite()) return;
  const double diameter = needle.needle.outer_diameter;
  for (int line = 0; line < rows.lines; ++line) {
    const Vec3 origin = lines.origin(line), direction = lines.direction(line);
    // origin + depth direction = tip - behind axis, in the scan plane
    const double turn = axis.x() * direction.y() - axis.y() * direction.x();
    if (std::abs(turn) < 1e-6) continue;  // along the line: no echo
    const Vec3 to_tip = tip - origin;
    const double behind = (to_tip.x() * direction.y() - to_tip.y() * direction.x()) / turn;
    if (behind < 0.0 || behind > needle.needle.length) continue;
    const Vec3 met = tip - behind * axis;
    const double depth = direction.dot(Vec3(met.x(), met.y(), 0.0) - origin);
    const double cosine = direction.dot(axis);
    draw_shaft(rows, beam, lines.spacing, depth, line, met.z(), 1.0 - cosine * cosine, diameter);
  }
  const Eigen::Vector2d at = lines.place(Vec3(tip.x(), tip.y(), 0.0));
  if (!(at.x() >= 0.0) || at.x() >= rows.lines - 1 || !(at.y() >= 0.0) || at.y() >= rows.samples - 1) return;
  const int near = static_cast<int>(at.x());
  const double seen = gauss(tip.z(), beam.elevation(at.y() * lines.spacing));
  // A point is drawn as wide as the beam, whose weights add up to 1: times their number it is as bright as a line.
  const double spread = std::max(1.0, beam.lateral(at.y() * lines.spacing) / lines.apart(at.y() * lines.spacing));
  const double part = at.x() - near;
  for (const int line : {near, near + 1}) {
    const double share = line == near ? 1.0 - part : part;
    const double reaches = static_cast<double>(rows.amplitude[rows.at(static_cast<int>(at.y()), line)]);
    rows.add(at.y(), line, reaches * seen * tip_echo * spread * share);
  }
}

}  // namespace bodkin::imaging
