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

  // As the case has it: its thumb_force_N.
  constexpr Thumb() = default;
  // `force`: N, 0 to 50.8; what is less, more or not a number is taken as the nearest, or as 0.
  static Thumb of_force(double force) noexcept {
    const double steps = force > 0.0 ? std::min(std::round(force / step), 254.0) : 0.0;
    return from_byte(static_cast<std::uint8_t>(1.0 + steps));
  }
  static constexpr Thumb from_byte(std::uint8_t byte) noexcept {
    Thumb thumb;
    thumb.byte_ = byte;
    return thumb;
  }

  constexpr std::uint8_t byte() const noexcept { return byte_; }  // 0: as the case has it
  constexpr std::optional<double> force() const noexcept {        // N; nothing: as the case has it
    return byte_ == 0 ? std::nullopt : std::optional(step * (byte_ - 1));
  }

 private:
  std::uint8_t byte_ = 0;
};

// What the other hand does with the skin and at the needle's hub, and what the patient is asked, in the four bits
// that a recording keeps.
struct OtherHand {
  bool finger = false;           // a fingertip is where the tip of the needle would be; for the part `fingertip`
  bool stylet_moved = false;     // the stylet is not as the case has it; for the part `csf_flow`
  bool manometer_moved = false;  // the same of the manometer
  bool breath_held = false;      // the patient is asked to hold the breath; for one who breathes

  constexpr std::uint8_t byte() const noexcept {
    return static_cast<std::uint8_t>((finger ? 1 : 0) | (stylet_moved ? 2 : 0) | (manometer_moved ? 4 : 0) |
                                     (breath_held ? 8 : 0));
  }
  // Nothing for a byte above 15.
  static constexpr std::optional<OtherHand> from_byte(unsigned byte) noexcept {
    if (byte > 15U) return std::nullopt;
    return OtherHand{(byte & 1U) != 0, (byte & 2U) != 0, (byte & 4U) != 0, (byte & 8U) != 0};
  }
};

// What goes into one tick: where the device holds the needle, and what the other hand does.
struct TickInput {
  Pose needle = Pose::Identity();  // LPS mm, origin at the tip, third axis hub to tip
  Thumb thumb = {};                // for the part `syringe`
  OtherHand other = {};
};

// What one tick found. Everything that is recorded, plotted and judged comes from here.
struct TickOutput {
  Wrench requested;         // what the models ask for, on the hand, LPS
  Wrench applied;           // what leaves through the governor
  double depth = 0.0;       // mm along the frozen line; negative or 0 outside
  double velocity = 0.0;    // mm/s, inwards
  double resistance = 0.0;  // N along the needle, positive pushes out
  double constraint = 0.0;  // N, size of the constraint force
  double energy = 0.0;      // N mm that the hand has given to the tissue along the needle, as passivity counts it
  anatomy::TissueId tissue = anatomy::tissue::air;  // at the tip
  bool in_contact = false;
  double drawn_in = 0.0;         // breath, 0 to 1; neither this nor the next is recorded, for the ticks give them
  anatomy::BreathMoment breath;  // after the tick
  std::uint8_t limits = 0;       // governor flags, see haptics/force_governor.h
  forces::Diagnostics diagnostics{};  // of the resistance, in the order of HapticTick::diagnostic_names(); 0 outside
  forces::TickEvents events;
};

// One tick as a recording keeps it. Time is tick * dt.
struct TickRecord {
  std::uint64_t tick = 0;
  TickInput input;
  TickOutput output;
};

}  // namespace bodkin::simulation
