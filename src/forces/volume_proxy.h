#pragma once

#include <array>
#include <memory>
#include <vector>

#include "anatomy/force_settings.h"
#include "core/geometry.h"
#include "forces/events.h"
#include "forces/haptic_field.h"
#include "forces/rail.h"
#include "forces/resistance_model.h"

namespace bodkin::forces {

// One proxy step, eq. 2-5, in a field whose unit gradient is `normal` (zero where the field is flat).
Vec3 advance_proxy(const Vec3& proxy, const Vec3& tip, const Vec3& normal, const anatomy::ProxyProperties& properties,
                   double stiffness, anatomy::ProxyVariant variant, bool two_sided, double dt) noexcept;

// Haptic rendering of a volume with a proxy (Faerber, Heller, Handels, section 2.1.2, eq. 1-5; after Lundin et al.
// 2002): a spring k ties the tip x_t to a proxy x_p that moves only as the field V and the tissue allow.
//
//   d = x_t - x_p,  N = grad V / |grad V|,  dn = d . N,  t = d - dn N
//   dn > T_N/k     x_p += N (dn - T_N/k)                  eq. 3;  dn < 0: x_p += N dn  (a wall is one-sided)
//   |t| > T_T/k    x_p += (t/|t|) (|t| - T_T/k)           eq. 4;  where V is flat t = d
//   e = x_p - x_p at the start:  drag     x_p -= e/|e| min(|e|, R_d/k)                eq. 5
//                                viscous  x_p -= e (1 - k dt/(k dt + R_v))
//   F_hand = -k (x_t - x_p)                               eq. 1
//
// With drag, the proxy moves in a tick as far as the tip does and at most 200 mm/s (our choice) farther, so that a
// released force falls in the same time at every rate; the viscosity of the other variant has the same effect.
//
// T_N is scaled by smoothstep(|grad V|/g_ref), so that walls fade with their gradient. Every move of the proxy
// shortens d, so stored energy is only released: passive. With a rail the proxy is projected onto the insertion line
// before the force is computed. Readings: docs/models/volume_proxy.md.
class VolumeProxy : public ResistanceDefaults {
 public:
  using Settings = anatomy::VolumeProxySettings;
  static constexpr ResistanceTraits traits = {
      .name = "volume_proxy",
      .has_lateral_force = true,
      .passes_layers = true,
      .diagnostics = {{{"proxy_x_mm", "proxy, L"}, {"proxy_y_mm", "proxy, P"}, {"proxy_z_mm", "proxy, S"}}},
  };

  // Throws InputError for a setting outside its range. `dt`: s, 1e-6 to 0.1. `field` must outlive the object.
  VolumeProxy(const anatomy::TissueLibrary& library, const anatomy::VolumeProxySettings& settings,
              const HapticField& field, double dt);
  // From a patient, whose field it computes and owns: also refuses settings that the device cannot render stably.
  VolumeProxy(const anatomy::Case& patient, const anatomy::VolumeProxySettings& settings, double dt);

  // Force on the hand, LPS N, at most `limit`. `rail`: nullptr = the tip is free. The first call puts the proxy at
  // the tip. A tip that is not finite or farther than 1e4 mm: zero, a `fault` event, state unchanged.
  Vec3 step(const Vec3& tip, const Rail* rail, TickEvents& events) noexcept;
  void begin(const Vec3& entry, const Vec3& direction) noexcept;
  ResistanceForce step(const NeedleInTissue& needle, TickEvents& events) noexcept;
  void reset() noexcept { placed_ = false; }

  const Vec3& proxy() const noexcept { return proxy_; }
  double firm_stiffness() const noexcept { return settings_.stiffness; }
  ModelDiagnostics diagnostics() const noexcept { return {proxy_.x(), proxy_.y(), proxy_.z()}; }

 private:
  VolumeProxy(const anatomy::Case& patient, const anatomy::VolumeProxySettings& settings,
              std::unique_ptr<HapticField> field, double dt);
  anatomy::ProxyProperties properties(const FieldSample& here) const noexcept;
  Vec3 released(const Vec3& wanted, const Vec3& tip) const noexcept;

  anatomy::VolumeProxySettings settings_;
  std::array<anatomy::VolumeProxyTissue, 256> tissues_;  // 256, by TissueId
  std::unique_ptr<HapticField> own_field_;               // of a patient
  const HapticField* field_;
  double dt_;
  Vec3 proxy_ = Vec3::Zero(), last_tip_ = Vec3::Zero();
  Vec3 entry_ = Vec3::Zero();       // of the frozen line
  Vec3 direction_ = Vec3::UnitZ();  // of it
  bool placed_ = false;
};

}  // namespace bodkin::forces
