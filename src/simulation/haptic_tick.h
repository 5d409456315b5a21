#pragma once

#include <memory>
#include <span>

#include "anatomy/case.h"
#include "simulation/body_port.h"
#include "simulation/tick_record.h"

namespace bodkin::simulation {

// The one function that a servo calls a thousand times a second: from the needle in tissue to the force on the hand,
// through the governor. Deterministic: the same case and the same inputs give the same bits. step() allocates
// nothing, locks nothing, throws nothing and reads no clock; the case must outlive the object.
//
// A patient who breathes (anatomy::Breathing) does so in the time of the ticks. The models see the needle in the
// material: where it would be if the tissue at its tip had not moved. Depths and tissues refer to the material.
class HapticTick {
 public:
  // Throws InputError when the case's parameters make a model impossible or the case has no tissues.
  explicit HapticTick(const anatomy::Case& patient);
  ~HapticTick();
  HapticTick(HapticTick&&) noexcept;
  HapticTick& operator=(HapticTick&&) noexcept;

  TickOutput step(const TickInput& input) noexcept;
  // The deformable body that the needle meets; null for a resistance without one. Valid as long as this object.
  BodyPort* body() noexcept;

  // Before the ticks: the patient holds the breath permanently, for curves of tissue at rest.
  void hold_breath() noexcept;

  // Before the ticks: sets the state of breathing, for a tick that takes over from another.
  void set_breath(const anatomy::BreathState& moment) noexcept;

  // Names of TickOutput::diagnostics; valid as long as this object.
  std::span<const forces::DiagnosticName> diagnostic_names() const noexcept;

  // s; 1 / rate of the case.
  double dt() const noexcept;
  // The smallest factor by which a tissue's stiffness had to be reduced for the device; 1 = none.
  double stiffness_scale() const noexcept;
  // Restores the state after construction: needle outside, no punctures, governor armed.
  void reset() noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bodkin::simulation
