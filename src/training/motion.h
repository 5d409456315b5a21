#pragma once

#include <optional>
#include <vector>

#include "training/attempt.h"

namespace bodkin::training {

// The tip's motion without the noise of the device: filtered by a Gaussian that halves the power at 10 Hz, without
// delay, and sampled at 100 Hz. Third differences of positions at 1 kHz would be only noise.
struct Motion {
  double interval = 0.01;    // s between points
  std::vector<double> time;  // s since the first tick
  std::vector<Vec3> tip;     // LPS mm
  std::vector<char> inside;  // of the tick in the middle
};
Motion filtered_motion(const Attempt& attempt);

// mm; sum of the distances between neighbouring points that are both in the body.
double path_length(const Motion& motion);

// mm/s of the tip at each point, by central differences.
std::vector<double> speeds(const Motion& motion);

// deg/s of the needle at each point, including rotation about its axis, over 50 ms around the point, so that noise of
// the rotation does not count.
std::vector<double> turning_speeds(const Attempt& attempt, const Motion& motion);

// 1 during action: a change to above `fast` counts once it has lasted for over `lasting` s, from its beginning, and
// so does the change back. `interval`: s between the speeds.
std::vector<char> in_action(const std::vector<double>& speed, double interval, double fast, double lasting);

// 1 at the points of the motion at which the needle is in action by TrainUS's definition: its tip moves faster than
// action_mm_per_s, or it turns faster than action_deg_per_s, for over action_s.
std::vector<char> needle_in_action(const Attempt& attempt, const Motion& motion);

// Smoothness of the motion from the first point in the body to the point at time `until` (s): the logarithmic
// dimensionless jerk
//
//   LDLJ = -ln( T^3 / v_peak^2 * integral of |j|^2 dt )
//
// (Hogan and Sternad 2009; Balasubramanian, Melendez-Calderon and Burdet 2012). A single movement of least jerk has
// -ln(204.8) = -5.32; hesitation and correction make it lower. Empty for less than 0.1 s or without motion.
std::optional<double> smoothness(const Motion& motion, double until);

// mm/s^2.5; the square root of the integral of |j|^2 over the same motion. Empty for less than 0.1 s.
std::optional<double> root_of_jerk(const Motion& motion, double until);

// Involuntary trembling of the tip in the body.
struct Tremor {
  double amplitude = 0.0;  // mm, root mean square of the motion from 4 to 12 Hz, over all directions
  double frequency = 0.0;  // Hz, of the largest power in that band
};
// Welch's estimate: windows of one second, half overlapping, Hann-weighted, each without its linear trend. Only
// windows wholly in the body count; empty without one.
std::optional<Tremor> tremor(const Attempt& attempt);

}  // namespace bodkin::training
