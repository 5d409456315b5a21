#pragma once

#include <array>
#include <cstdint>

#include "anatomy/part_settings.h"
#include "anatomy/volume.h"
#include "core/geometry.h"
#include "forces/events.h"

namespace bodkin::forces {

struct FingertipState {
  double force = 0.0;        // N, against the motion of the finger
  double indentation = 0.0;  // mm under the skin, in the middle of the fingertip
  double cover = 0.0;        // mm of soft tissue over the bone there; the reach if no bone is felt
  double firmness = 0.0;     // N/mm, of the tissue under the whole fingertip
  bool touching = false;
};

// A finger on the skin that feels bone through the soft tissue. Nine points of its pad press on columns of tissue,
// each from the skin to the bone under it (Winkler's foundation):
//
//   F = sum over i of (A/9) E d_i / t_i  +  wall        A = pi r^2, t_i at most the reach, at least 5 mm
//
// d_i: indentation at point i. In the last third before the bone, a wall of half the device's stiffness is added. The
// finger moves only with the hand, so it slides without friction.
class Fingertip {
 public:
  // Throws InputError for settings out of range. `tissues` must outlive the object; `stiffness`: N/mm that the
  // device renders stably; `dt`: s, 1e-6 to 0.1.
  Fingertip(const anatomy::TissueVolume& tissues, const anatomy::FingertipSettings& settings, double stiffness,
            double dt);

  // `tip`: the middle of the pad, LPS mm; `axis`: unit, the direction of pressing. Pushes `palpated` once for each
  // place that was pressed by at least 2 mm for 0.3 s.
  const FingertipState& step(const Vec3& tip, const Vec3& axis, TickEvents& events) noexcept;
  void reset() noexcept;

 private:
  static constexpr std::size_t points = 9;

  bool is_air(const Vec3& place) const noexcept;
  double depth_under_skin(const Vec3& place, const Vec3& axis) const noexcept;
  double cover_of_bone(const Vec3& skin, const Vec3& axis) const noexcept;
  void notice_place(const Vec3& tip, const Vec3& axis, TickEvents& events) noexcept;

  const anatomy::TissueVolume& tissues_;
  anatomy::FingertipSettings settings_;
  double stiffness_, dt_;
  std::array<double, points> covers_{};  // mm, follow the cover of each point with a delay of 20 ms
  FingertipState state_;
  Vec3 place_ = Vec3::Zero();  // LPS mm, where this press began
  double pressed_ = 0.0;       // s at that place
  bool reported_ = false;      // `palpated` was pushed for that place
};

}  // namespace bodkin::forces
