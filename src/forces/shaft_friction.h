#pragma once

#include <array>
#include <cmath>
#include <span>

#include "anatomy/force_settings.h"
#include "anatomy/tissue.h"
#include "core/axial_motion.h"
#include "core/repeatable.h"
#include "forces/events.h"
#include "forces/resistance_model.h"
#include "forces/tissue_path.h"

namespace bodkin::forces {

// Friction of the whole shaft that is in tissue: sums of the tissues' values per mm (ShaftFrictionTissue).
struct ShaftContact {
  double coulomb = 0.0;       // Fc, N
  double static_force = 0.0;  // Fs, N
  double stiffness = 0.0;     // sigma0, N/mm
  double viscous = 0.0;       // sigma2, N s/mm
};

// Sums over the layers (each `layer` mm thick) down to `depth` mm. Never throws.
ShaftContact shaft_contact(std::span<const anatomy::TissueId> layers, double layer, double depth,
                           const std::array<anatomy::ShaftFrictionTissue, 256>& tissues) noexcept;

// g(v) = Fc + (Fs - Fc) exp(-(v/vs)^2), N: the friction at steady speed without its viscous part.
inline double stribeck(const ShaftContact& contact, double velocity, double stribeck_velocity) noexcept {
  const double ratio = velocity / stribeck_velocity;
  return contact.coulomb + (contact.static_force - contact.coulomb) * repeatable::exp(-ratio * ratio);
}

// Friction with memory between needle and tissue: Dahl (1968), and LuGre (Canudas de Wit et al. 1995) when Fs > Fc.
// Tissue sticks to the shaft and stretches by z before it slides:
//
//   dz/dx = 1 - sigma0 z sgn(dx) / g(v);   F = sigma0 z + sigma2 v          (LuGre with sigma1 = 0; Dahl: Fs = Fc)
//
// over a motion dx, solved exactly: z_ss = g/sigma0 sgn(dx);  z <- z_ss + (z - z_ss) exp(-sigma0 |dx| / g).
// Explicit Euler would need steps of microseconds. At rest z, and so the force, stays. As the length in contact
// grows, z is kept and the sums grow. Passive. R > 0 on insertion, R < 0 on withdrawal.
class ShaftFriction {
 public:
  // Throws InputError for a setting outside its range.
  explicit ShaftFriction(const anatomy::ShaftFrictionSettings& settings);

  void begin() noexcept { fresh_ = true; }
  // R in N. Unusable motion: 0, a `fault` event and an unchanged state.
  double step(const AxialMotion& motion, const ShaftContact& contact, TickEvents& events) noexcept;
  void reset() noexcept { begin(); }

  // z, mm.
  double stretch() const noexcept { return stretch_; }

 private:
  double stribeck_velocity_;
  double stretch_ = 0.0;     // z, mm
  double last_depth_ = 0.0;  // mm
  bool fresh_ = true;
};

// The friction of the shaft in the tissues of a patient along the frozen line: as a resistance of its own, and as the
// part added to resistances without shaft friction.
class ShaftFrictionResistance : public ResistanceDefaults {
 public:
  using Settings = anatomy::ShaftFrictionSettings;
  static constexpr ResistanceTraits traits = {
      .name = "shaft_friction",
      .has_shaft_friction = true,
      .uses_grip = true,
      .diagnostics = {{{"stretch_mm", "stretch z of the tissue on the shaft"}}},
  };

  // Throws InputError for settings or tissues outside their ranges. `firm`: N/mm of the device's stiffness already
  // used by another resistance, see ResistanceDefaults::firm_stiffness().
  ShaftFrictionResistance(const anatomy::Case& patient, const anatomy::ShaftFrictionSettings& settings, double dt,
                          double firm = 0.0);

  void begin(const Vec3& entry, const Vec3& direction) noexcept;
  ResistanceForce step(const NeedleInTissue& needle, TickEvents& events) noexcept;
  void reset() noexcept { model_.reset(); }

  ModelDiagnostics diagnostics() const noexcept { return {model_.stretch()}; }

 private:
  ShaftFriction model_;
  std::array<anatomy::ShaftFrictionTissue, 256> tissues_;  // 256, by TissueId
  TissuePath path_;
  const anatomy::TissueVolume* volume_;
  double budget_;  // N/mm that the tissue's spring on the shaft may have
};

}  // namespace bodkin::forces
