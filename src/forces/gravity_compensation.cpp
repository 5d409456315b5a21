#include "forces/gravity_compensation.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "core/error.h"
#include "forces/model_input.h"

namespace bodkin::forces {

anatomy::GravitySettings fit_gravity(std::span<const GravitySample> samples, const Vec3& up) {
  if (samples.empty()) {
    throw InputError("gravity_compensation: there is no sample to fit; hold the device still at four places or more");
  }
  anatomy::GravitySettings settings;
  settings.up = up;
  double sum = 0.0;
  for (const GravitySample& sample : samples) {
    if (!sample.position.allFinite() || !std::isfinite(sample.force)) {
      throw InputError("gravity_compensation: a sample is not a finite number; measure it again");
    }
    settings.centre += sample.position / static_cast<double>(samples.size());
    sum += sample.force;
  }
  settings.weight = sum / static_cast<double>(samples.size());
  if (samples.size() < 4) return settings;
  Mat3 spread = Mat3::Zero();
  Vec3 moment = Vec3::Zero();
  for (const GravitySample& sample : samples) {
    const Vec3 arm = sample.position - settings.centre;
    spread += arm * arm.transpose();
    moment += arm * (sample.force - settings.weight);
  }
  // Directions not spanned by the samples get no slope rather than an arbitrary one.
  spread += Mat3::Identity() * (1e-9 * spread.trace() + 1e-12);
  settings.slope = spread.ldlt().solve(moment);
  return settings;
}

GravityCompensation::GravityCompensation(const anatomy::GravitySettings& settings) : settings_(settings) {
  constexpr auto model = "gravity_compensation";
  check_range(model, "length of the upward direction", settings.up.norm(), {0.999, 1.001}, "");
  check(settings, model);
}

Vec3 GravityCompensation::step(const Vec3& position) const noexcept {
  const double weight = settings_.weight + settings_.slope.dot(position - settings_.centre);
  if (!std::isfinite(weight)) return Vec3::Zero();
  return settings_.up * std::clamp(weight, 0.0, settings_.limit);
}

}  // namespace bodkin::forces
