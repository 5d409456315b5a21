#pragma once

#include "anatomy/force_settings.h"
#include "anatomy/tissue.h"
#include "core/axial_motion.h"
#include "forces/channel_memory.h"
#include "forces/cutting_edge.h"
#include "forces/events.h"
#include "forces/resistance_model.h"
#include "forces/voigt_law.h"

namespace bodkin::forces {

// U = k dx^2 (a^4/4 + a^3 + a^2)/6, N mm, a = x/dx: energy stored by the cubic law of voigt_law.h at x >= 0.
constexpr double stored_energy(double stiffness, double spacing, double x) noexcept {
  const double a = x / spacing;
  return stiffness * spacing * spacing * a * a * (a * a / 4.0 + a + 1.0) / 6.0;
}

// Puncture as fracture (Azar and Hayward 2008; Mahvash and Dupont 2010; Barnett et al. 2015; Khadem et al. 2016). A
// membrane deforms elastically and ruptures when its stored energy suffices for the crack:
//
//   before   R = k dx a (a+1)(a+2)/6,  a = x/dx          until U(x) >= J w t_m
//   after    R = J_behind w, where tissue is still whole (cutting_edge.h); J in N/mm, 1 N/mm = 1000 J/m^2
//
// No velocity is needed; the needle's toughness and width decide. Passive.
class Fracture : public ResistanceDefaults {
 public:
  using Settings = anatomy::FractureSettings;
  static constexpr ResistanceTraits traits = {
      .name = "fracture",
      .diagnostics = {{{"stored_N_mm", "energy stored in the membrane"}, {"wall_mm", "depth W to which it is cut"}}},
  };

  // Throws InputError for a setting outside its range.
  explicit Fracture(const anatomy::FractureSettings& settings);
  // From a patient: also refuses settings that the device cannot render stably.
  Fracture(const anatomy::Case& patient, const anatomy::FractureSettings& settings, double dt);

  void begin(const Vec3& entry, const Vec3& direction) noexcept;
  // R in N, 0 to `limit`. Events: contact, puncture (value = force), withdrawn, fault.
  double step(const AxialMotion& motion, anatomy::TissueId tissue, TickEvents& events) noexcept;
  ResistanceForce step(const NeedleInTissue& needle, TickEvents& events) noexcept;
  void reset() noexcept;
  // N/mm, tangent stiffness of the membrane at rupture.
  double stiffness_at_rupture() const noexcept;
  double firm_stiffness() const noexcept { return settings_.cutting_stiffness; }
  ModelDiagnostics diagnostics() const noexcept { return {stored_, torn_ ? edge_.wall() : 0.0}; }

 private:
  anatomy::FractureSettings settings_;
  bool is_skin_ = false;  // the membrane, with mechanics="physical"
  VoigtLaw membrane_;
  ChannelMemory channels_;  // depths of torn channels
  CuttingEdge edge_;
  double stored_ = 0.0;  // N mm, in the membrane while it is whole
  bool inside_ = false, torn_ = false;
};

}  // namespace bodkin::forces
