#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "anatomy/force_settings.h"
#include "anatomy/tissue.h"
#include "core/axial_motion.h"
#include "forces/channel_memory.h"
#include "forces/events.h"
#include "forces/resistance_model.h"
#include "forces/stop_clock.h"

namespace bodkin::forces {

// Throws InputError for settings or tissues outside their ranges; `model` is named in the message.
void check_tracking_wall(const anatomy::TissueLibrary& library, const anatomy::TrackingWallSettings& settings,
                         const char* model);

// Throws InputError when a tissue or layer has a spring that the patient's device cannot render stably.
void require_stable_walls(const anatomy::Case& patient, const anatomy::TrackingWallSettings& settings);
// The stiffest tissue, N/mm.
double stiffest_wall(const anatomy::TissueLibrary& library);

// A spring whose wall W follows the tip at the distance D = f_R / K_t, so that the force stops growing at f_R; at
// rest the wall catches up with the tip and the force fades; a channel that was cut before is free to its old depth.
// Alamilla, Moreau, Redarce 2018, eq. 3-7, Fig. 3 and 4:
//
//   inserting   W = max(W, x - D)                          (eq. 3, 4 behind the gate of Fig. 4)
//   stopped     W = W_s + (x_s - W_s) min(1, t / T)        (eq. 5, 6; W_s, x_s at the stop, t since then)
//   always      R = K_t max(0, x - W)                      (eq. 7)
//
// On withdrawal the spring unloads along its own line, then R = 0 until the tip passes the deepest depth of the
// channel again. A border between layers rebases W so that R is continuous when K_t changes. The stored energy, K_t
// (x - W)^2 / 2, is only released, so the wall is passive, except when `strict`.
//
// In three dimensions the scalar law runs along the frozen insertion line: F_hand = -R u, wall at entry + W u.
class TrackingWall : public ResistanceDefaults {
 public:
  using Settings = anatomy::TrackingWallSettings;
  static constexpr ResistanceTraits traits = {
      .name = "tracking_wall",
      .passes_layers = true,
      .can_relax = true,
      .diagnostics = {{{"wall_mm", "position W of the wall"}}},
  };

  // Throws InputError for a setting outside its range. `dt`: s, 1e-6 to 0.1. `resolution`: mm, of the measured depth;
  // 0 = without noise.
  TrackingWall(const anatomy::TissueLibrary& library, const anatomy::TrackingWallSettings& settings, double dt,
               double resolution = 0.0);
  // From a patient: also refuses settings that the device cannot render stably.
  TrackingWall(const anatomy::Case& patient, const anatomy::TrackingWallSettings& settings, double dt);

  // The needle meets the skin at `entry` along the unit `direction`: opens a new channel or enters a known one.
  void begin(const Vec3& entry, const Vec3& direction) noexcept;
  // R in N, 0 to `limit`. `tissue` at the tip chooses the layer unless the settings give layers by depth.
  // Events: contact, withdrawn, fault (unusable motion: R = 0, state unchanged).
  double step(const AxialMotion& motion, anatomy::TissueId tissue, TickEvents& events) noexcept;
  ResistanceForce step(const NeedleInTissue& needle, TickEvents& events) noexcept;
  // Forgets all state, including the channels.
  void reset() noexcept;

  // W, mm along the line.
  double wall() const noexcept { return wall_; }
  const ChannelMemory& channels() const noexcept { return channels_; }
  double firm_stiffness() const noexcept { return firm_stiffness_; }
  ModelDiagnostics diagnostics() const noexcept { return {wall_}; }

 private:
  enum class Mode : std::uint8_t { outside, free, insert, stop, unload };

  const anatomy::TrackingWallTissue& layer_at(double depth, anatomy::TissueId tissue) const noexcept;
  void rebase(double depth, double stiffness) noexcept;

  anatomy::TrackingWallSettings settings_;
  std::array<anatomy::TrackingWallTissue, 256> tissues_;  // 256, by TissueId
  double dt_;
  ChannelMemory channels_;
  Mode mode_ = Mode::outside;
  double wall_ = 0.0;        // W, mm
  double stiffness_ = 0.0;   // K_t of the layer to which W refers, N/mm
  double stop_wall_ = 0.0;   // W_s, mm
  double stop_depth_ = 0.0;  // x_s, mm
  StopClock clock_;
  double last_stop_ = 0.0;  // x_t0 of eq. 7, for `strict`, mm
  double firm_stiffness_;   // of the stiffest tissue, N/mm
};

}  // namespace bodkin::forces
