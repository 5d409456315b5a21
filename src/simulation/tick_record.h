#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "anatomy/breathing.h"
#include "core/geometry.h"
#include "forces/diagnostics.h"
#include "forces/events.h"

namespace bodkin::simulation {

// The thumb on the plunger of a syringe, in steps that a recording keeps in one byte.
class Thumb {
 public:
  static constexpr double step = 0.2;  // N

  // As in the case: its thumb_force_N.
  constexpr Thumb() = default;
  // `force`: N, 0 to 50.8; values out of range are clamped, NaN becomes 0.
  static Thumb of_force(double force) noexcept {
    const double steps = force > 0.0 ? std::min(std::round(force / step), 254.0) : 0.0;
    return from_byte(static_cast<std::uint8_t>(1.0 + steps));
  }
  static constexpr Thumb from_byte(std::uint8_t byte) noexcept {
    Thumb thumb;
    thumb.byte_ = byte;
    return thumb;
  }

  constexpr std::uint8_t byte() const noexcept { return byte_; }  // 0: as in the case
  constexpr std::optional<double> force() const noexcept {        // N; empty: as in the case
    return byte_ == 0 ? std::nullopt : std::optional(step * (byte_ - 1));
  }

 private:
  std::uint8_t byte_ = 0;
};

// Actions of the other hand on the skin and at the needle's hub, and the request to the patient, in the four bits of
// a recording.
struct OtherHand {
  bool finger = false;           // a fingertip is at the position of the needle's tip; for the part `fingertip`
  bool stylet_moved = false;     // the stylet is not where the case has it; for the part `csf_flow`
  bool manometer_moved = false;  // the manometer is not where the case has it
  bool breath_held = false;      // the patient is asked to hold the breath; for a breathing patient

  constexpr std::uint8_t byte() const noexcept {
    return static_cast<std::uint8_t>((finger ? 1 : 0) | (stylet_moved ? 2 : 0) | (manometer_moved ? 4 : 0) |
                                     (breath_held ? 8 : 0));
  }
  // Empty for a byte above 15.
  static constexpr std::optional<OtherHand> from_byte(unsigned byte) noexcept {
    if (byte > 15U) return std::nullopt;
    return OtherHand{(byte & 1U) != 0, (byte & 2U) != 0, (byte & 4U) != 0, (byte & 8U) != 0};
  }
};

// Input of one tick: the pose of the needle in the device, and the actions of the other hand.
struct TickInput {
  Pose needle = Pose::Identity();  // LPS mm, origin at the tip, third axis hub to tip
  Thumb thumb = {};                // for the part `syringe`
  OtherHand other = {};
};

// Result of one tick. Recordings, plots and metrics are derived from it.
struct TickOutput {
  Wrench requested;         // by the models, on the hand, LPS
  Wrench applied;           // after the governor
  double depth = 0.0;       // mm along the frozen line; negative or 0 outside
  double velocity = 0.0;    // mm/s, inwards
  double resistance = 0.0;  // N along the needle, positive pushes out
  double constraint = 0.0;  // N, size of the constraint force
  double energy = 0.0;      // N mm given by the hand to the tissue along the needle, as passivity counts it
  anatomy::TissueId tissue = anatomy::tissue::air;  // at the tip
  bool in_contact = false;
  double drawn_in = 0.0;        // inspiration, 0 to 1; this and the next follow from the ticks and are not recorded
  anatomy::BreathState breath;  // after the tick
  std::uint8_t limits = 0;      // governor flags, see haptics/force_governor.h
  forces::Diagnostics diagnostics{};  // of the resistance, in the order of HapticTick::diagnostic_names(); 0 outside
  forces::TickEvents events;
};

// One tick of a recording. Time is tick * dt.
struct TickRecord {
  std::uint64_t tick = 0;
  TickInput input;
  TickOutput output;
};

}  // namespace bodkin::simulation
