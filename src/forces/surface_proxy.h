#pragma once

#include <array>
#include <cstddef>

#include "anatomy/force_settings.h"
#include "anatomy/surface.h"
#include "core/geometry.h"
#include "forces/events.h"
#include "forces/resistance_model.h"
#include "forces/triangle_tree.h"

namespace bodkin::forces {

// The displacement of a point pulled by `pull` (mm) and held back by up to three planes.
struct ConstrainedMotion {
  Vec3 slide = Vec3::Zero();        // mm; zero in a corner that holds the point altogether
  std::array<double, 3> load = {};  // mm of spring on each plane, 0 where it does not hold; all 0 in a corner
  std::size_t holding = 0;          // planes that hold: those with a load, or all in a corner
};

// Projection of `pull` onto the cone {w : n_i . w >= 0} of the first `count` (0 to 3) unit normals, with its
// multipliers: slide = pull + sum load_i n_i; slide . n_i = 0 or load_i = 0. In a corner nothing slides, so the loads
// are not computed.
ConstrainedMotion constrained_motion(const Vec3& pull, const std::array<Vec3, 3>& normals,
                                     std::size_t count) noexcept;

// Contact of a point with a surface: the god-object of Zilles and Salisbury (1995), which Ruspini, Kolarov and Khatib
// (1997) call the virtual proxy, with the friction cone of Harwin and Melder (2002). A spring k ties the tip x_t to a
// proxy x_p that stays outside and moves as near to the tip as the faces allow:
//
//   F_hand = -k (x_t - x_p)
//   w = projection of x_t - x_p onto {w : n_i . w >= 0},  faces i that x_p touches, at most 3;   N = k sum load_i
//   k |w| <= mu N             x_p sticks; mu = mu_s at first touch and after `stick_after` at rest, else mu_d
//   otherwise                 x_p += w (1 - mu_d N / (k |w|)) k dt / (k dt + b),  stopped by the next face
//
// On one face this is the circle that the friction cone with its apex in the tip cuts out of the face. A tick repeats
// it, at most `most_rounds` times, until nothing moves; what then remains is done in the next tick. Every segment
// that the proxy travels is tested against the surface, so that it passes through no wall however thin or fast, and
// every segment shortens the spring: passive. Readings and limits: docs/models/surface_proxy.md.
class SurfaceProxy {
 public:
  static constexpr int most_rounds = 12;
  static constexpr double clearance = 1e-4;  // mm between proxy and face, so that rounding never puts it behind

  // Throws InputError for a setting outside its range. `dt`: s, 1e-6 to 0.1. Copies the triangles into a tree.
  SurfaceProxy(const anatomy::SurfaceProxySettings& settings, const anatomy::Surface& surface, double dt);

  // Force on the hand, LPS N, at most `limit`. The first call puts the proxy at the tip; if that is inside, there is
  // no force until the tip has left. A tip that is not finite or farther than 1e4 mm: zero, a `fault` event, state
  // unchanged.
  Vec3 step(const Vec3& tip, TickEvents& events) noexcept;
  void reset() noexcept;

  const Vec3& proxy() const noexcept { return proxy_; }
  // Number of faces that held the proxy in the last tick, 0 to 3.
  std::size_t constraints() const noexcept { return count_; }
  // Whether the proxy slid in the last tick.
  bool sliding() const noexcept { return at_rest_ == 0.0; }

 private:
  static constexpr double long_at_rest = 1e9;  // s

  void follow(const Vec3& tip) noexcept;

  anatomy::SurfaceProxySettings settings_;
  TriangleTree tree_;
  double dt_;
  Vec3 proxy_ = Vec3::Zero();
  std::array<Vec3, 3> normals_ = {};  // count_: the faces that hold the proxy
  std::size_t count_ = 0;
  double at_rest_ = long_at_rest;  // s since the proxy slid
  bool placed_ = false;
};

// `surface_proxy` on the skin of a patient (anatomy/tissue_surface.h): palpation with the tip, which never enters.
class SurfaceProxyResistance : public ResistanceDefaults {
 public:
  using Settings = anatomy::SurfaceProxySettings;
  static constexpr ResistanceTraits traits = {
      .name = "surface_proxy",
      .has_lateral_force = true,
      .has_shaft_friction = true,  // the shaft is never in tissue
      .diagnostics = {{{"proxy_x_mm", "proxy, L"},
                       {"proxy_y_mm", "proxy, P"},
                       {"proxy_z_mm", "proxy, S"},
                       {"faces", "faces that hold the proxy"}}},
  };

  // Computes the skin surface, which takes a second for a torso. Throws InputError for settings out of range, a
  // patient without tissues and a spring that the device cannot render stably.
  SurfaceProxyResistance(const anatomy::Case& patient, const anatomy::SurfaceProxySettings& settings, double dt);

  void begin(const Vec3& entry, const Vec3& direction) noexcept;
  ResistanceForce step(const NeedleInTissue& needle, TickEvents& events) noexcept;
  void reset() noexcept { model_.reset(); }

  double firm_stiffness() const noexcept { return stiffness_; }
  ModelDiagnostics diagnostics() const noexcept {
    return {model_.proxy().x(), model_.proxy().y(), model_.proxy().z(), static_cast<double>(model_.constraints())};
  }

 private:
  SurfaceProxy model_;
  double stiffness_;
  Vec3 direction_ = Vec3::UnitZ();
};

}  // namespace bodkin::forces
