#pragma once

// A needle along z into a body of kelvin_body(), and the force on its hand.
#include <algorithm>
#include <cmath>
#include <optional>

#include "tests/fem/dense_body.h"

#include "fem/embedded_needle.h"

namespace bodkin::checks {

using namespace bodkin::anatomy;
using namespace bodkin::fem;

// Soft everywhere, without punctures: the test sets the tissue's forces.
inline ContactTissues plain_tissues(double friction) {
  ContactTissues tissues;
  tissues.fill({.friction = friction});
  return tissues;
}

inline EmbeddedNeedleSettings narrow_settings() {
  EmbeddedNeedleSettings settings;
  settings.capture_radius = 0.6;
  return settings;
}

class NeedleRig {
 public:
  NeedleRig(const CondensedBody& body, const ContactTissues& tissues,
            const EmbeddedNeedleSettings& settings = narrow_settings(), const std::optional<NeedleBeam>& beam = {},
            const NeedleRelaxation& relaxation = {})
      : model(body, tissues, settings, 1e-3, beam, nullptr, relaxation) {
    begin();
  }
  void begin() {
    model.begin(Vec3::Zero(), Vec3::UnitZ());
    place_ = Vec3(0.0, 0.0, -1.0);
    work = way = 0.0;
    to(place_);
  }
  // One tick; the work of the hand with the force at the end of the way.
  const EmbeddedNeedleForce& to(const Vec3& tip) {
    force = model.step(needle_pose(tip, Vec3::UnitZ()));
    work -= force.on_hand.force.dot(tip - place_);
    way += (tip - place_).norm();
    place_ = tip;
    return force;
  }
  const EmbeddedNeedleForce& to(double depth) { return to(Vec3(place_.x(), place_.y(), depth)); }
  // At `speed` mm/s; returns the largest change of the force in a tick.
  double move(const Vec3& goal, double speed) {
    const Vec3 start = place_;
    const int ticks = std::max(1, static_cast<int>(std::ceil((goal - start).norm() / (speed * 1e-3) - 1e-9)));
    double largest = 0.0;
    for (int tick = 1; tick <= ticks; ++tick) {
      const Vec3 before = force.on_hand.force;
      to(Vec3(start + (goal - start) * (static_cast<double>(tick) / ticks)));
      largest = std::max(largest, (force.on_hand.force - before).norm());
    }
    return largest;
  }
  double move(double depth, double speed) { return move(Vec3(place_.x(), place_.y(), depth), speed); }

  EmbeddedNeedle model;
  EmbeddedNeedleForce force;
  double work = 0.0;  // N mm
  double way = 0.0;   // mm

 private:
  Vec3 place_ = Vec3::Zero();
};

}  // namespace bodkin::checks
