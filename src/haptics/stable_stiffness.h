#pragma once

#include "haptics/device.h"

namespace bodkin::haptics {

// s from the tick that computes a force to the force at the hand: the device's own delay and, where the loop is ours,
// the period that passes before the next exchange sends it. `rate`: Hz.
double force_delay(const DeviceAbilities& device, double rate) noexcept;

// The greatest stiffness that a device may be asked to render at `rate`.
struct StableStiffness {
  double published = 0.0;   // N/mm, of the device or of its profile; 0 = unknown
  double delay = 0.0;       // s, force_delay()
  double by_delay = 0.0;    // N/mm, what the delay leaves of it
  double by_encoder = 0.0;  // N/mm, what the encoder and the friction allow; infinity where either is unknown
  double stiffness = 0.0;   // N/mm, the least of these; 0 = unknown
  bool is_cut() const noexcept { return stiffness < published; }
};

// A sampled wall of stiffness K, computed every T and felt d periods late, is passive with the damping b (device and
// hand that holds it) for
//
//   K < 2 b / (T (1 + 2 d))
//
// (Colgate and Schenkel 1994 for d = 0; with delay Hulin, Albu-Schaeffer and Hirzinger, IEEE Trans. Control Systems
// Technology 22 (2014) 1297-1309, doi:10.1109/TCST.2013.2283372, which is also the limit of stability for a mass that
// is not very light). No maker publishes b, but a stiffness that the device renders stably says how large it is at
// least: the published one was rendered by a loop that answers within its own tick, d = the device's own delay as its
// driver states it. What that proves is kept, so K falls as (1 + 2 d_published) / (1 + 2 d).
//
// Counts of an encoder of resolution q are stable for K < 2 c / q with dry friction c (Abbott and Okamura, IEEE
// Trans. Robotics 21 (2005) 952-964). `friction`: N; 0 = unknown.
StableStiffness stable_stiffness(const DeviceAbilities& device, double rate, double friction = 0.0) noexcept;

}  // namespace bodkin::haptics
