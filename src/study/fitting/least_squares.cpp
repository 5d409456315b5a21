#include "study/fitting/least_squares.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <Eigen/SVD>
#include <boost/math/distributions/fisher_f.hpp>
#include <ceres/ceres.h>

#include "core/error.h"

namespace bodkin::study {

namespace {

constexpr double difference_step = 1e-5;  // of a scale
constexpr double silent_column = 1e-9;    // a column this small against the largest, by scale, counts as zero
constexpr double takes_part = 0.1;        // share of a direction's largest component that counts

// The problem with every parameter divided by its scale.
class ScaledResiduals : public ceres::CostFunction {
 public:
  explicit ScaledResiduals(const LeastSquaresProblem& problem) : problem_(problem) {
    set_num_residuals(static_cast<int>(problem.samples));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(problem.scale.size()));
  }

  bool Evaluate(double const* const* scaled, double* residuals, double** jacobians) const override {
    std::vector<double> x(problem_.scale.size());
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] = std::clamp(scaled[0][i] * problem_.scale[i], problem_.low[i], problem_.high[i]);
    problem_.residuals(x, {residuals, problem_.samples});
    if (jacobians != nullptr && jacobians[0] != nullptr) {
      const Eigen::MatrixXd slope = jacobian(problem_, x);
      for (Eigen::Index i = 0; i < slope.rows(); ++i)
        for (Eigen::Index j = 0; j < slope.cols(); ++j)
          jacobians[0][i * slope.cols() + j] = slope(i, j) * problem_.scale[static_cast<std::size_t>(j)];
    }
    return std::all_of(residuals, residuals + problem_.samples, [](double r) { return std::isfinite(r); });
  }

 private:
  const LeastSquaresProblem& problem_;
};

}  // namespace

std::vector<double> least_squares(const LeastSquaresProblem& problem, const std::vector<double>& start, int steps) {
  const std::size_t count = start.size();
  if (count == 0) return {};
  std::vector<double> scaled(count);
  for (std::size_t i = 0; i < count; ++i)
    scaled[i] = std::clamp(start[i], problem.low[i], problem.high[i]) / problem.scale[i];

  ceres::Problem equations;
  equations.AddResidualBlock(std::make_unique<ScaledResiduals>(problem).release(), nullptr,
                             scaled.data());  // owned by it
  for (std::size_t i = 0; i < count; ++i) {
    equations.SetParameterLowerBound(scaled.data(), static_cast<int>(i), problem.low[i] / problem.scale[i]);
    equations.SetParameterUpperBound(scaled.data(), static_cast<int>(i), problem.high[i] / problem.scale[i]);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = steps;
  options.function_tolerance = 1e-9;
  options.parameter_tolerance = 1e-8;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;  // the same sums in the same order on every machine
  ceres::Solver::Summary summary;
  ceres::Solve(options, &equations, &summary);
  if (summary.termination_type == ceres::FAILURE) throw SystemError("the solver failed: " + summary.message);

  std::vector<double> x(count);
  for (std::size_t i = 0; i < count; ++i)
    x[i] = std::clamp(scaled[i] * problem.scale[i], problem.low[i], problem.high[i]);
  return x;
}

Eigen::MatrixXd jacobian(const LeastSquaresProblem& problem, const std::vector<double>& x) {
  Eigen::MatrixXd result(problem.samples, x.size());
  std::vector<double> above(problem.samples), here(problem.samples), below(problem.samples);
  problem.residuals(x, here);
  for (std::size_t j = 0; j < x.size(); ++j) {
    const double step = difference_step * problem.scale[j];
    std::vector<double> up = x, down = x;
    up[j] = std::min(x[j] + step, problem.high[j]);
    down[j] = std::max(x[j] - step, problem.low[j]);
    const double width_up = up[j] - x[j], width_down = x[j] - down[j];
    problem.residuals(up, above);
    problem.residuals(down, below);
    for (std::size_t i = 0; i < problem.samples; ++i) {
      // If the residual jumps on one side, the slope is taken from the other.
      double slope = 0.0;
      if (width_up > 0.0) slope = (above[i] - here[i]) / width_up;
      if (width_down > 0.0) {
        const double other = (here[i] - below[i]) / width_down;
        if (!(width_up > 0.0) || std::abs(other) < std::abs(slope)) slope = other;
      }
      result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = slope;
    }
  }
  return result;
}

Degeneracy flattest_direction(const Eigen::MatrixXd& jacobian, const std::vector<double>& scale, double tolerance) {
  Eigen::VectorXd norms(jacobian.cols());
  for (Eigen::Index j = 0; j < jacobian.cols(); ++j)
    norms(j) = jacobian.col(j).norm() * scale[static_cast<std::size_t>(j)];
  const double largest = norms.size() > 0 ? norms.maxCoeff() : 0.0;
  for (Eigen::Index j = norms.size() - 1; j >= 0; --j)
    if (!(norms(j) > silent_column * largest)) return {true, {static_cast<std::size_t>(j)}};
  if (norms.size() < 2) return {};
  Eigen::MatrixXd normalised = jacobian;
  for (Eigen::Index j = 0; j < jacobian.cols(); ++j) normalised.col(j).normalize();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(normalised, Eigen::ComputeThinV);
  const Eigen::VectorXd& values = svd.singularValues();
  if (values(values.size() - 1) > tolerance * values(0)) return {};
  Degeneracy flat{true, {}};
  const Eigen::VectorXd direction = svd.matrixV().col(values.size() - 1).cwiseAbs();
  for (Eigen::Index j = 0; j < direction.size(); ++j)
    if (direction(j) > takes_part * direction.maxCoeff()) flat.parameters.push_back(static_cast<std::size_t>(j));
  return flat;
}

Eigen::MatrixXd inverse_normal_matrix(const Eigen::MatrixXd& jacobian) {
  const Eigen::VectorXd norms = jacobian.colwise().norm();
  const Eigen::MatrixXd normalised = jacobian * norms.cwiseInverse().asDiagonal();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(normalised, Eigen::ComputeThinV);
  const Eigen::MatrixXd root =
      norms.cwiseInverse().asDiagonal() * svd.matrixV() * svd.singularValues().cwiseInverse().asDiagonal();
  return root * root.transpose();
}

double joint_quantile(double alpha, std::size_t parameters, std::size_t degrees_of_freedom) {
  const auto count = static_cast<double>(parameters);
  const boost::math::fisher_f distribution(count, static_cast<double>(degrees_of_freedom));
  return std::sqrt(count * boost::math::quantile(boost::math::complement(distribution, alpha)));
}

}  // namespace bodkin::study
