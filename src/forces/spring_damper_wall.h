#pragma once

#include "anatomy/force_settings.h"
#include "anatomy/tissue.h"
#include "core/axial_motion.h"
#include "forces/events.h"
#include "forces/resistance_model.h"

namespace bodkin::forces {

// The simplest wall of haptic rendering, at a fixed depth; the baseline that `tracking_wall` improves on:
//
//   R = max(0, K (x - x_w) + B v)   for x >= x_w,   0 otherwise        (Alamilla, Moreau, Redarce 2018, eq. 2)
//
// x depth of the tip mm, v its speed mm/s, both positive inwards; R pushes the hand out. It has no memory of any
// kind: no puncture, no relaxation, no channel. Entering at speed makes one bounded step B v. docs/models has more.
class SpringDamperWall : public ResistanceDefaults {
 public:
  using Settings = anatomy::SpringDamperWallSettings;
  static constexpr ResistanceTraits traits = {
      .name = "spring_damper_wall",
      .can_relax = true,
      .diagnostics = {{{"penetration_mm", "depth behind the wall"}}},
  };

  // Throws InputError for a setting outside its range.
  explicit SpringDamperWall(const anatomy::SpringDamperWallSettings& settings);
  // From a patient: also refuses settings that the device cannot render stably.
  SpringDamperWall(const anatomy::Case& patient, const anatomy::SpringDamperWallSettings& settings, double dt);

  // R in N, 0 to `limit`. Unusable motion (model_input.h): 0 and a `fault` event.
  double step(const AxialMotion& motion, anatomy::TissueId tissue, TickEvents& events) noexcept;
  ResistanceForce step(const NeedleInTissue& needle, TickEvents& events) noexcept;
  void begin(const Vec3&, const Vec3&) noexcept {}
  void reset() noexcept {}

  double firm_stiffness() const noexcept { return settings_.stiffness; }
  ModelDiagnostics diagnostics() const noexcept { return {penetration_}; }

 private:
  anatomy::SpringDamperWallSettings settings_;
  double penetration_ = 0.0;  // mm
};

}  // namespace bodkin::forces
