#pragma once

#include "core/geometry.h"
#include "haptics/device.h"

namespace bodkin::haptics {

// s from the tick that computes a force to the force at the hand: the device's own delay and, if the loop is ours,
// the period until the next exchange sends it. `rate`: Hz.
double force_delay(const DeviceAbilities& device, double rate) noexcept;

// The largest stiffness that a device may be asked to render at `rate`, for each axis of the operator's frame.
struct StableStiffness {
  double published = 0.0;          // N/mm, of the device or of its profile; 0 = unknown
  double delay = 0.0;              // s, force_delay()
  double by_delay = 0.0;           // N/mm, the part of it that the delay allows
  Vec3 by_encoder = Vec3::Zero();  // N/mm, allowed by encoder and friction; infinity if either is unknown
  Vec3 axis = Vec3::Zero();        // N/mm, the least of these; 0 = unknown

  // N/mm allowed for springs in every direction.
  double weakest() const noexcept { return axis.minCoeff(); }
  // N/mm allowed for a spring along a line within `spread` rad of `direction` (unit): K n n^T stays within each
  // axis's limit if K times the sum of n_i^2 / axis_i is at most 1. The minimum over these lines.
  double along(const Vec3& direction, double spread = 0.0) const noexcept;
  bool is_cut() const noexcept { return weakest() < published; }
};

// A sampled wall of stiffness K, computed every T and felt d periods late, is passive with the damping b (device and
// hand that holds it) for
//
//   K < 2 b / (T (1 + 2 d))
//
// (Colgate and Schenkel 1994 for d = 0; with delay Hulin, Albu-Schaeffer and Hirzinger, IEEE Trans. Control Systems
// Technology 22 (2014) 1297-1309, doi:10.1109/TCST.2013.2283372, which is also the limit of stability for a mass that
// is not very light). No maker publishes b, but a stiffness that the device renders stably gives a lower bound of it:
// the published one was rendered by a loop that responds within its own tick, d = the device's own delay as its
// driver states it. This bound is used, so K falls as (1 + 2 d_published) / (1 + 2 d).
//
// A published stiffness holds for every direction, and therefore for each axis.
//
// Counts of an encoder of resolution q are stable for K < 2 c / q with dry friction c (Abbott and Okamura, IEEE
// Trans. Robotics 21 (2005) 952-964). `friction`: N along each axis; 0 = unknown.
StableStiffness stable_stiffness(const DeviceAbilities& device, double rate,
                                 const Vec3& friction = Vec3::Zero()) noexcept;

}  // namespace bodkin::haptics
