#pragma once

#include "anatomy/force_settings.h"
#include "anatomy/tissue.h"
#include "core/axial_motion.h"
#include "forces/channel_memory.h"
#include "forces/cutting_edge.h"
#include "forces/events.h"
#include "forces/resistance_model.h"

namespace bodkin::forces {

// Force of needle insertion as a sum of three (Simone and Okamura 2002; Okamura, Simone, O'Leary 2004):
//
//   R = stiffness + friction + cutting
//   stiffness  a1 x + a2 x^2 before the puncture, 0 after
//   friction   after it, per mm inserted: C sgn v + b v for |v| >= Dv/2, within the band up to D   (modified Karnopp)
//   cutting    0 before, constant after
//
// Karnopp's band needs the force that a hand applies, which a simulator does not know; inside the band a Dahl spring
// (see shaft_friction.h) holds with at most D. Cutting acts where tissue is still whole (cutting_edge.h). Passive.
class ThreeComponent : public ResistanceDefaults {
 public:
  using Settings = anatomy::ThreeComponentSettings;
  static constexpr ResistanceTraits traits = {
      .name = "three_component",
      .has_shaft_friction = true,
      .diagnostics = {{{"cutting_N", "cutting force"}, {"friction_N", "friction of the shaft"}}},
  };

  // Throws InputError for a setting outside its range.
  explicit ThreeComponent(const anatomy::ThreeComponentSettings& settings);
  // From a patient: also refuses settings that the device cannot render stably.
  ThreeComponent(const anatomy::Case& patient, const anatomy::ThreeComponentSettings& settings, double dt);

  // The needle meets the capsule at `entry` along the unit `direction`; a punctured channel (1 mm, 3 degrees) stays
  // open.
  void begin(const Vec3& entry, const Vec3& direction) noexcept;
  // R in N, -limit to limit. Events: contact, puncture (value = force), withdrawn, fault.
  double step(const AxialMotion& motion, anatomy::TissueId tissue, TickEvents& events) noexcept;
  ResistanceForce step(const NeedleInTissue& needle, TickEvents& events) noexcept;
  void reset() noexcept;

  ModelDiagnostics diagnostics() const noexcept { return {cutting_, friction_}; }

 private:
  double friction(const AxialMotion& motion) noexcept;

  anatomy::ThreeComponentSettings settings_;
  bool is_skin_ = false;    // the membrane, with mechanics="physical"
  ChannelMemory channels_;  // depths of punctured channels
  CuttingEdge edge_;
  double stretch_ = 0.0;                   // z, mm
  double last_depth_ = 0.0;                // mm
  double cutting_ = 0.0, friction_ = 0.0;  // N, of the last tick
  bool inside_ = false, punctured_ = false;
};

}  // namespace bodkin::forces
