#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace bodkin::study {

// min over x of sum r_i(x)^2 with low <= x <= high. `scale` is the typical size of a parameter's changes, > 0: steps
// and tolerances are relative to it. `residuals` is called only within the bounds, may have kinks and jumps, and
// fills all `samples` values.
struct LeastSquaresProblem {
  std::size_t samples = 0;
  std::vector<double> low, high, scale;  // parameters
  std::function<void(std::span<const double> x, std::span<double> residuals)> residuals;
};

// Trust-region minimum from `start` (Levenberg-Marquardt of Ceres), at most `steps` steps.
std::vector<double> least_squares(const LeastSquaresProblem& problem, const std::vector<double>& start, int steps);

// dr_i / dx_j at x, samples x parameters; differences to the side on which r_i changes less, so that a jump does not
// count as a slope.
Eigen::MatrixXd jacobian(const LeastSquaresProblem& problem, const std::vector<double>& x);

// A direction of the parameters along which the residuals do not change, to numerical precision.
struct Degeneracy {
  bool found = false;
  std::vector<std::size_t> parameters;  // columns that take part in it, in order
};

// The flattest direction of a Jacobian with equally weighted columns: degenerate when its singular value is below
// `tolerance` times the largest one, or when a column is (nearly) zero relative to its scale.
Degeneracy flattest_direction(const Eigen::MatrixXd& jacobian, const std::vector<double>& scale, double tolerance);

// (J'J)^-1 of a Jacobian that is not degenerate; parameters x parameters.
Eigen::MatrixXd inverse_normal_matrix(const Eigen::MatrixXd& jacobian);

// The extent of the joint confidence region of all parameters along each of them, in standard errors: sqrt(n F), F
// the value that Fisher's F with n and `degrees_of_freedom` exceeds with the probability `alpha`, 0 < alpha < 1.
double joint_quantile(double alpha, std::size_t parameters, std::size_t degrees_of_freedom);

}  // namespace bodkin::study
