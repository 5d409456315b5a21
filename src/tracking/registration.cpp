#include "tracking/registration.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::tracking {

namespace {

constexpr double least_extent = 0.5;     // mm, of the second largest extent of points that are not on a line
constexpr double least_flatness = 0.01;  // of it over the largest

Vec3 mean_of(const std::vector<Vec3>& points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

// Extents along the principal axes, ascending: standard deviations, mm.
Vec3 extents_of(const std::vector<Vec3>& points, Mat3* axes = nullptr) {
  const Vec3 middle = mean_of(points);
  Mat3 spread = Mat3::Zero();
  for (const Vec3& point : points) spread += (point - middle) * (point - middle).transpose();
  const Eigen::SelfAdjointEigenSolver<Mat3> solved(spread / static_cast<double>(points.size()));
  if (axes != nullptr) *axes = solved.eigenvectors();
  return solved.eigenvalues().cwiseMax(0.0).cwiseSqrt();
}

Similarity closed_form(const std::vector<Vec3>& fixed, const std::vector<Vec3>& moving, bool with_scale) {
  const Vec3 to = mean_of(fixed), from = mean_of(moving);
  Mat3 across = Mat3::Zero();
  double squares = 0.0;
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    across += (fixed[i] - to) * (moving[i] - from).transpose();
    squares += (moving[i] - from).squaredNorm();
  }
  const Eigen::JacobiSVD<Mat3> svd(across, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Vec3 signs = Vec3::Ones();
  if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0) signs.z() = -1.0;
  Similarity made;
  made.turn = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  made.scale = with_scale ? svd.singularValues().dot(signs) / squares : 1.0;
  made.shift = to - made.scale * (made.turn * from);
  return made;
}

// Of a symmetric, positive definite matrix.
Eigen::MatrixXd symmetric_inverse(const Eigen::MatrixXd& matrix) {
  return matrix.ldlt().solve(Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols()));
}

// The errors of the placement, if the covariances of the pairs were exact.
PlacementErrors propagated_errors(const Registration& registration, const std::vector<Vec3>& moving,
                                  const std::vector<Mat3>& covariances) {
  const int unknowns = registration.scaled ? 7 : 6;
  PlacementErrors errors;
  errors.middle = registration.fixed_from_moving * mean_of(moving);
  Matrix7 normal = Matrix7::Zero(), spread = Matrix7::Zero();
  for (std::size_t i = 0; i < moving.size(); ++i) {
    const auto slope = displacement(registration.fixed_from_moving * moving[i] - errors.middle);
    normal += slope.transpose() * slope;
    spread += slope.transpose() * covariances[i] * slope;
  }
  const Eigen::MatrixXd inverse = symmetric_inverse(normal.topLeftCorner(unknowns, unknowns));
  errors.covariance.topLeftCorner(unknowns, unknowns) = inverse * spread.topLeftCorner(unknowns, unknowns) * inverse;
  return errors;
}

// Quantile of chi-squared by Wilson and Hilferty (1931); `normal`: that of the normal distribution.
double chi_squared_quantile(double freedom, double normal) {
  const double part = 2.0 / (9.0 * freedom);
  return freedom * std::pow(std::max(1.0 - part + normal * std::sqrt(part), 0.02), 3);
}

double fre_of(const Similarity& placed, const std::vector<Vec3>& fixed, const std::vector<Vec3>& moving) {
  double squares = 0.0;
  for (std::size_t i = 0; i < fixed.size(); ++i) squares += (placed * moving[i] - fixed[i]).squaredNorm();
  return std::sqrt(squares / static_cast<double>(fixed.size()));
}

}  // namespace

Similarity Similarity::inverse() const {
  Similarity back;
  back.turn = turn.transpose();
  back.scale = 1.0 / scale;
  back.shift = -back.scale * (back.turn * shift);
  return back;
}

bool on_a_line(const std::vector<Vec3>& points) {
  const Vec3 extents = extents_of(points);
  return extents[1] < least_extent || extents[1] < least_flatness * extents[2];
}

Registration register_points(const std::vector<Vec3>& fixed, const std::vector<Vec3>& moving, bool with_scale) {
  const std::size_t least = with_scale ? 4 : 3;
  if (fixed.size() != moving.size()) {
    throw InputError(fmt::format("registration: {} fixed and {} moving points; every point needs its partner",
                                 fixed.size(), moving.size()));
  }
  if (fixed.size() < least) {
    throw InputError(fmt::format("registration: {} pairs of points; at least {} are needed{}", fixed.size(), least,
                                 with_scale ? " to find a scale" : ""));
  }
  Registration made;
  made.scaled = with_scale;
  const Vec3 extents = extents_of(moving).cwiseMin(extents_of(fixed));
  made.flatness = extents[2] > 0.0 ? extents[1] / extents[2] : 0.0;
  if (extents[1] < least_extent || made.flatness < least_flatness) {
    throw InputError(
        "registration: the points lie on a line, so the rotation about it is undetermined; add a point off that "
        "line");
  }
  made.fixed_from_moving = closed_form(fixed, moving, with_scale);
  double squares = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    made.residuals.push_back((made.fixed_from_moving * moving[i] - fixed[i]).norm());
    squares += made.residuals.back() * made.residuals.back();
    sum += made.residuals.back();
  }
  made.fre_rms = std::sqrt(squares / static_cast<double>(fixed.size()));
  made.fre_mean = sum / static_cast<double>(fixed.size());
  if (fixed.size() > least) {
    for (std::size_t out = 0; out < fixed.size(); ++out) {
      std::vector<Vec3> others_fixed = fixed, others_moving = moving;
      others_fixed.erase(others_fixed.begin() + static_cast<std::ptrdiff_t>(out));
      others_moving.erase(others_moving.begin() + static_cast<std::ptrdiff_t>(out));
      const Similarity without = closed_form(others_fixed, others_moving, with_scale);
      made.leave_one_out.push_back((without * moving[out] - fixed[out]).norm());
    }
  }
  return made;
}

double predicted_tre(const std::vector<Vec3>& moving, const Vec3& target, double fle, bool with_scale) {
  const auto count = static_cast<double>(moving.size());
  Mat3 axes;
  const Vec3 extents = extents_of(moving, &axes);
  const Vec3 middle = mean_of(moving);
  const Vec3 at = axes.transpose() * (target - middle);
  double sum = 0.0;
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    const double distance = at[a] * at[a] + at[b] * at[b];
    const double spread = extents[a] * extents[a] + extents[b] * extents[b];
    sum += distance / spread;
  }
  double squared = fle * fle / count * (1.0 + sum / 3.0);
  if (with_scale) squared += fle * fle / 3.0 * at.squaredNorm() / (count * extents.squaredNorm());
  return std::sqrt(squared);
}

ErrorInterval tre_interval(const Registration& registration, const std::vector<Vec3>& moving, const Vec3& target) {
  const auto count = static_cast<double>(moving.size());
  const double freedom = 3.0 * count - (registration.scaled ? 7.0 : 6.0);
  const double squares = count * registration.fre_rms * registration.fre_rms;
  // squares / (FLE^2 / 3) is chi-squared; normal quantiles of 5 and 95 %.
  const auto tre_of = [&](double quantile) {
    return predicted_tre(moving, target, std::sqrt(3.0 * squares / quantile), registration.scaled);
  };
  return {tre_of(chi_squared_quantile(freedom, 1.6449)), tre_of(freedom),
          tre_of(chi_squared_quantile(freedom, -1.6449))};
}

ErrorInterval error_interval(double variance, double freedom) {
  // Normal quantiles of 5 and 95 %.
  const auto rms_of = [&](double quantile) { return std::sqrt(variance * freedom / quantile); };
  return {rms_of(chi_squared_quantile(freedom, 1.6449)), rms_of(freedom),
          rms_of(chi_squared_quantile(freedom, -1.6449))};
}

Mat3 target_covariance(const Registration& registration, const std::vector<Vec3>& moving,
                       const std::vector<Mat3>& covariances, const Vec3& target) {
  return covariance_at(propagated_errors(registration, moving, covariances), registration.fixed_from_moving * target);
}

PlacementErrors placement_errors(const Registration& registration, const std::vector<Vec3>& moving,
                                 const std::vector<Mat3>& covariances) {
  const auto count = static_cast<Eigen::Index>(moving.size());
  const int unknowns = registration.scaled ? 7 : 6;
  PlacementErrors errors = propagated_errors(registration, moving, covariances);
  Eigen::MatrixXd slopes(3 * count, unknowns), spread = Eigen::MatrixXd::Zero(3 * count, 3 * count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto point = static_cast<std::size_t>(i);
    slopes.middleRows(3 * i, 3) =
        displacement(registration.fixed_from_moving * moving[point] - errors.middle).leftCols(unknowns);
    spread.block(3 * i, 3 * i, 3, 3) = covariances[point];
  }
  // The residual errors of the fit.
  const Eigen::MatrixXd left = Eigen::MatrixXd::Identity(3 * count, 3 * count) -
                               slopes * symmetric_inverse(slopes.transpose() * slopes) * slopes.transpose();
  const Eigen::MatrixXd rest = left * spread;
  const double expected = rest.trace();
  errors.freedom = 2.0 * expected * expected / (2.0 * (rest * rest).trace());
  errors.covariance *= static_cast<double>(count) * registration.fre_rms * registration.fre_rms / expected;
  return errors;
}

ErrorInterval tre_interval(const Registration& registration, const std::vector<Vec3>& moving,
                           const std::vector<Mat3>& covariances, const Vec3& target) {
  const PlacementErrors errors = placement_errors(registration, moving, covariances);
  return error_interval(covariance_at(errors, registration.fixed_from_moving * target).trace(), errors.freedom);
}

std::optional<double> hidden_scale(const std::vector<Vec3>& fixed, const std::vector<Vec3>& moving) {
  constexpr std::size_t least_points = 4;
  constexpr double least_difference = 0.002;
  // The 99.9 % quantile of F with 1 and 3k - 7 degrees of freedom, for 4 to 8 points; for more it is smaller.
  constexpr std::array<double, 5> exceeded = {47.2, 25.4, 19.7, 17.1, 15.7};
  if (fixed.size() != moving.size() || fixed.size() < least_points) return std::nullopt;
  const Similarity rigid = closed_form(fixed, moving, false), scaled = closed_form(fixed, moving, true);
  if (std::abs(scaled.scale - 1.0) <= least_difference) return std::nullopt;
  const double freedom = 3.0 * static_cast<double>(fixed.size()) - 7.0;
  const double without = std::pow(fre_of(rigid, fixed, moving), 2), with = std::pow(fre_of(scaled, fixed, moving), 2);
  const double bound = exceeded[std::min(fixed.size() - least_points, exceeded.size() - 1)];
  if ((without - with) * freedom <= bound * with) return std::nullopt;
  return scaled.scale;
}

std::vector<std::pair<std::size_t, std::size_t>> swapped_pairs(const std::vector<Vec3>& fixed,
                                                               const std::vector<Vec3>& moving, bool with_scale) {
  constexpr double least_gain = 3.0;  // of the FRE, and how much more than the best fit an exchange as good leaves
  struct Exchange {
    std::pair<std::size_t, std::size_t> points;
    double fre;
  };
  const double before = fre_of(closed_form(fixed, moving, with_scale), fixed, moving);
  std::vector<Exchange> better;
  std::vector<Vec3> exchanged = moving;
  for (std::size_t a = 0; a < moving.size(); ++a) {
    for (std::size_t b = a + 1; b < moving.size(); ++b) {
      std::swap(exchanged[a], exchanged[b]);
      const double after = fre_of(closed_form(fixed, exchanged, with_scale), fixed, exchanged);
      std::swap(exchanged[a], exchanged[b]);
      if (after < before / least_gain) better.push_back({{a, b}, after});
    }
  }
  std::stable_sort(better.begin(), better.end(),
                   [](const Exchange& one, const Exchange& other) { return one.fre < other.fre; });
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (const Exchange& one : better)
    if (one.fre <= least_gain * better.front().fre + 1e-9) found.push_back(one.points);
  return found;
}

}  // namespace bodkin::tracking
