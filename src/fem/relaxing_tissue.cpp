#include "fem/relaxing_tissue.h"

#include <algorithm>
#include <cmath>

#include "core/repeatable.h"
#include "core/settings_check.h"
#include "fem/upper_triangular.h"

namespace bodkin::fem {

RelaxingTissue::RelaxingTissue(std::span<const anatomy::PronyTerm> terms, double dt, std::size_t most_points,
                               double spring)
    : spring_(spring), stride_(upper_triangular::padded(3 * most_points)) {
  if (terms.empty()) return;
  anatomy::ForceParts parts;
  parts.relaxation.assign(terms.begin(), terms.end());
  check(parts, "embedded_needle");
  for (const anatomy::PronyTerm& term : terms) {
    check(term, "embedded_needle");
    shares_.push_back(term.share);
    decays_.push_back(repeatable::exp(-dt / term.time));
  }
  parts_.assign(shares_.size() * stride_, 0.0);
  by_removed_ = parts_;
  faded_.assign(stride_, 0.0);
  moved_ = removed_ = faded_;
}

void RelaxingTissue::clear() noexcept {
  for (std::vector<double>* each : {&parts_, &by_removed_, &faded_, &moved_, &removed_})
    std::fill(each->begin(), each->end(), 0.0);
  points_ = touched_ = 0;
}

// mm/N, of row and column in the frame: displacement of `one` by a force at `other` by S, without the spring.
double RelaxingTissue::between(const ShaftCompliance& compliance, std::size_t one, std::size_t other) const noexcept {
  const double all =
      one >= other ? compliance.row(one / 3, one % 3)[other] : compliance.row(other / 3, other % 3)[one];
  return one % 3 == other % 3 ? all - spring_ : all;
}

// The removed points, f = 0, and their effect on others continue to relax.
void RelaxingTissue::step(const ShaftCompliance& compliance, std::span<const double> forces) noexcept {
  if (!relaxes()) return;
  for (std::size_t i = 0; i < 3 * touched_; ++i) {
    const double elastic = faded_[i] + (i < 3 * points_ ? forces[i] : 0.0), moved_elastically = removed_[i];
    faded_[i] = removed_[i] = 0.0;
    for (std::size_t k = 0; k < shares_.size(); ++k) {
      double &part = parts_[k * stride_ + i], &moved = by_removed_[k * stride_ + i];
      const double gain = (1.0 - decays_[k]) * shares_[k];
      part = decays_[k] * part + gain * elastic;
      moved = decays_[k] * moved + gain * moved_elastically;
      faded_[i] += part;
      removed_[i] += moved;
    }
  }
  find_moved(compliance);
}

void RelaxingTissue::find_moved(const ShaftCompliance& compliance) noexcept {
  compliance.displace(faded_, moved_);
  Vec3 sum = Vec3::Zero();
  for (std::size_t p = 0; p < points_; ++p) sum += Eigen::Map<const Vec3>(faded_.data() + 3 * p);
  for (std::size_t i = 0; i < 3 * points_; ++i)
    moved_[i] += removed_[i] - spring_ * sum(static_cast<Eigen::Index>(i % 3));
}

// The point's displacement as a removed point becomes its own as a present one: nothing jumps.
void RelaxingTissue::added(const ShaftCompliance& compliance) noexcept {
  if (!relaxes()) return;
  for (; points_ < compliance.size(); ++points_) {
    const std::size_t first = 3 * points_;
    for (std::size_t k = 0; k < shares_.size(); ++k) {
      const double* const part = parts_.data() + k * stride_ + first;
      for (std::size_t i = 0; i < first; ++i) {
        double moved = 0.0;
        for (std::size_t c = 0; c < 3; ++c) moved += between(compliance, first + c, i) * part[c];
        by_removed_[k * stride_ + i] -= moved;
        removed_[i] -= moved;
      }
    }
    touched_ = std::max(touched_, points_ + 1);
    for (std::size_t c = 0; c < 3; ++c) {
      double& moved = moved_[first + c];
      moved = removed_[first + c];
      for (std::size_t j = 0; j < first + 3; ++j) moved += between(compliance, first + c, j) * faded_[j];
    }
  }
}

void RelaxingTissue::removing_last(const ShaftCompliance& compliance) noexcept {
  if (!relaxes() || points_ == 0) return;
  const std::size_t first = 3 * --points_;
  for (std::size_t k = 0; k < shares_.size(); ++k) {
    const double* const part = parts_.data() + k * stride_ + first;
    for (std::size_t i = 0; i < first; ++i) {
      double moved = 0.0;
      for (std::size_t c = 0; c < 3; ++c) moved += between(compliance, first + c, i) * part[c];
      by_removed_[k * stride_ + i] += moved;
      removed_[i] += moved;
    }
  }
}

void RelaxingTissue::drop_removed() noexcept {
  if (!relaxes()) return;
  for (std::size_t i = 3 * points_; i < 3 * touched_; ++i) {
    faded_[i] = removed_[i] = 0.0;
    for (std::size_t k = 0; k < shares_.size(); ++k) parts_[k * stride_ + i] = by_removed_[k * stride_ + i] = 0.0;
  }
  touched_ = points_;
}

void RelaxingTissue::exchange(const ShaftCompliance& compliance) noexcept {
  if (!relaxes()) return;
  points_ = std::min(points_, compliance.size());
  find_moved(compliance);
  added(compliance);
}

// The springs parallel to the dampers, and the one without a damper: s_k = g_k e - q_k, and (1 - sum g_k) e.
double RelaxingTissue::stored_energy(const ShaftCompliance& compliance,
                                     std::span<const double> forces) const noexcept {
  const auto energy = [&](const auto& force) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 3 * points_; ++i) {
      sum += 0.5 * force(i) * between(compliance, i, i) * force(i);
      for (std::size_t j = 0; j < i; ++j) sum += force(i) * between(compliance, i, j) * force(j);
    }
    return sum;
  };
  double lasting = 1.0, sum = 0.0;
  for (std::size_t k = 0; k < shares_.size(); ++k) {
    lasting -= shares_[k];
    if (shares_[k] == 0.0) continue;
    const double* const part = parts_.data() + k * stride_;
    sum += energy([&](std::size_t i) { return shares_[k] * (forces[i] + faded_[i]) - part[i]; }) / shares_[k];
  }
  sum += lasting * energy([&](std::size_t i) { return forces[i] + faded_[i]; });
  Vec3 on_spring = Vec3::Zero();
  for (std::size_t p = 0; p < points_; ++p) on_spring += Eigen::Map<const Vec3>(forces.data() + 3 * p);
  return sum + 0.5 * spring_ * on_spring.squaredNorm();
}

}  // namespace bodkin::fem
