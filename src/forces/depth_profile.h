#pragma once

#include <array>
#include <cstdint>

#include "anatomy/force_settings.h"
#include "anatomy/tissue.h"
#include "core/axial_motion.h"
#include "core/one_pole.h"
#include "forces/channel_memory.h"
#include "forces/events.h"
#include "forces/resistance_model.h"

namespace bodkin::forces {

// The spring without damping of the KAIST spine biopsy simulator (Kwon, Kyung, Kwon, Ra, Park, Kang, Zeng, Cleary
// 2001, section 3.1, Fig. 7), reconstructed: the flow chart is lost; this agrees with everything that the text says
// about it.
//
//   skin, whole     F = k_skin d                    until d >= Xd: punctured
//   tissue          F = k(tissue, d) (d - Xr)       advancing: Xr = max(Xr, d - Xd2); withdrawing: F falls to 0 in
//                                                   20 ms along its own spring, then Xr = d; resting: Xr holds
//   bone            F = max(k_bone (d - Xb), F of the tissue before)     Xb where bone was met; left when d < Xb
//   organ           F = 0 and an event
//   R = clamp(F, 0, limit)
//
// d depth mm, Xr reference mm, k N/mm. A rise of k is compensated by moving Xr (F continuous), a fall lowers F: the
// stored energy k (d - Xr)^2 / 2 never grows on its own, so the model is passive.
class DepthProfile : public ResistanceDefaults {
 public:
  using Settings = anatomy::DepthProfileSettings;
  static constexpr ResistanceTraits traits = {
      .name = "depth_profile",
      .passes_layers = true,
      .diagnostics = {{{"reference_mm", "depth Xr where the spring is slack"}}},
  };

  // Throws InputError for a setting outside its range. `dt`: s, 1e-6 to 0.1.
  DepthProfile(const anatomy::TissueLibrary& library, const anatomy::DepthProfileSettings& settings, double dt);
  // From a patient: also refuses settings that the device cannot render stably.
  DepthProfile(const anatomy::Case& patient, const anatomy::DepthProfileSettings& settings, double dt);

  // The needle meets the skin at `entry` along the unit `direction`; a known puncture offers no resistance.
  void begin(const Vec3& entry, const Vec3& direction) noexcept;
  // R in N, 0 to `limit`. Events: contact, puncture (value = force), bone_contact, bone_left, tissue_entered
  // (an organ, once per entry), withdrawn, fault (unusable motion: R = 0, state unchanged).
  double step(const AxialMotion& motion, anatomy::TissueId tissue, TickEvents& events) noexcept;
  ResistanceForce step(const NeedleInTissue& needle, TickEvents& events) noexcept;
  // Forgets all state, including the punctures.
  void reset() noexcept;

  double firm_stiffness() const noexcept { return firm_stiffness_; }
  ModelDiagnostics diagnostics() const noexcept { return {reference_}; }

 private:
  void settle(double depth, anatomy::TissueId tissue) noexcept;
  double filtered_stiffness(double depth) noexcept;
  void change_stiffness(double depth, double k) noexcept;
  double soft_force(const AxialMotion& motion) noexcept;
  double skin_force(const AxialMotion& motion, TickEvents& events) noexcept;
  void watch_bone(double depth, anatomy::TissueId tissue, TickEvents& events) noexcept;

  anatomy::DepthProfileSettings settings_;
  std::array<anatomy::DepthProfileTissue, 256> tissues_;  // 256, by TissueId
  double dt_;
  OnePole filter_;
  ChannelMemory punctures_;
  bool inside_ = false, punctured_ = false, in_bone_ = false;
  anatomy::TissueId settled_ = anatomy::tissue::air;   // the tip's tissue after hysteresis
  anatomy::TissueId previous_ = anatomy::tissue::air;  // the tissue before that
  double changed_at_ = 0.0;                            // depth of the last change, mm
  double bone_;                                        // Xb, mm; infinity while no bone is known
  double reference_ = 0.0;                             // Xr, mm
  double k_ = 0.0;                                     // stiffness to which Xr refers, N/mm
  double releasing_ = 0.0;                             // ticks of withdrawal so far
  double firm_stiffness_ = 0.0;                        // N/mm, of skin, bone and the stiffest tissue
};

}  // namespace bodkin::forces
