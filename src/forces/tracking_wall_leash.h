#pragma once

#include "anatomy/tissue.h"
#include "core/geometry.h"
#include "forces/events.h"
#include "forces/tracking_wall.h"

namespace bodkin::forces {

// The tracking wall on a path that may bend: the wall is a point W on a leash behind the tip P.
//
//   d = P - W;   if |d| > D: W = P - D d/|d|;   F_hand = -K_t d        D = f_R / K_t
//
// Depth is measured along the direction at entry, x = (P - entry) . u. At rest W catches up with P as in
// TrackingWall. When the tip has backed off until the leash no longer points inwards (d . u <= 0) the force is zero,
// until x passes the deepest depth of this entry again. Without that rule the leash would be friction that pulls
// inwards on withdrawal. Uses surface = 0 and ignores `strict` and the memory of channels: every entry starts without
// history.
class TrackingWallLeash : public ResistanceDefaults {
 public:
  using Settings = anatomy::TrackingWallSettings;
  static constexpr ResistanceTraits traits = {
      .name = "tracking_wall",
      .passes_layers = true,
      .diagnostics = {{{"wall_mm", "position W of the wall"}}},
  };

  // Throws InputError for a setting outside its range. `dt`: s, 1e-6 to 0.1. `resolution`: mm, of the measured depth;
  // 0 = without noise.
  TrackingWallLeash(const anatomy::TissueLibrary& library, const anatomy::TrackingWallSettings& settings, double dt,
                    double resolution = 0.0);
  // From a patient: also refuses settings that the device cannot render stably.
  TrackingWallLeash(const anatomy::Case& patient, const anatomy::TrackingWallSettings& settings, double dt);

  void begin(const Vec3& entry, const Vec3& direction) noexcept;
  // Force on the hand, LPS N, at most `limit`. `motion` is that of the depth x. Events: contact, withdrawn, fault.
  Vec3 step(const Vec3& tip, const AxialMotion& motion, anatomy::TissueId tissue, TickEvents& events) noexcept;
  ResistanceForce step(const NeedleInTissue& needle, TickEvents& events) noexcept;
  void reset() noexcept;

  // W, LPS mm.
  const Vec3& wall() const noexcept { return wall_; }
  double firm_stiffness() const noexcept { return firm_stiffness_; }
  // W along the line.
  ModelDiagnostics diagnostics() const noexcept { return {(wall_ - entry_).dot(direction_)}; }

 private:
  const anatomy::TrackingWallTissue& layer_at(double depth, anatomy::TissueId tissue) const noexcept;

  anatomy::TrackingWallSettings settings_;
  std::array<anatomy::TrackingWallTissue, 256> tissues_;  // 256, by TissueId
  double dt_;
  Vec3 entry_ = Vec3::Zero();
  Vec3 direction_ = Vec3::UnitZ();
  Vec3 wall_ = Vec3::Zero();
  Vec3 stop_wall_ = Vec3::Zero(), stop_tip_ = Vec3::Zero();
  StopClock clock_;
  double stiffness_ = 0.0;  // K_t of the layer to which W refers, N/mm; 0 outside
  double deepest_ = 0.0;    // mm
  bool inside_ = false, free_ = false, stopped_ = false;
  double firm_stiffness_;  // of the stiffest tissue, N/mm
};

}  // namespace bodkin::forces
