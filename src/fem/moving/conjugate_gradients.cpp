#include "fem/moving/conjugate_gradients.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bodkin::fem {

namespace {

constexpr double rounding = 1e-12;  // squared: part of the right side not worth solving for
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double nothing = 1e-40;  // N mm; below it single precision would stagnate

double inner_product(const SingleVectors& a, const SingleVectors& b) noexcept {
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (Eigen::Index node = 0; node < a.cols(); ++node)
    sum += a.col(node).cast<double>().cwiseProduct(b.col(node).cast<double>());
  return sum.sum();
}

}  // namespace

ConjugateGradients::ConjugateGradients(std::size_t nodes) {
  const auto count = static_cast<Eigen::Index>(nodes);
  product_.setZero(4, count);
  for (SingleVectors* vector :
       {&right_, &change_, &residual_, &scaled_, &direction_, &way_, &above_, &back_, &back_scaled_})
    vector->setZero(4, count);
}

// Residual and D times it; returns their product, right^T M^-1 right.
double ConjugateGradients::begin(const NodeMatrix& matrix, const NodeVectors& right) noexcept {
  right_ = right.cast<float>();
  residual_.setZero();
  scaled_.setZero();
  matrix.solve_lower(right_, residual_, scaled_);
  return inner_product(residual_, scaled_);
}

int ConjugateGradients::solve(const NodeMatrix& matrix, const NodeVectors& right, const GradientsSettings& settings,
                              NodeVectors& x) noexcept {
  const double asked = begin(matrix, right);
  matrix.multiply(x, product_);
  product_ = right - product_;
  double left = begin(matrix, product_);
  if (!std::isfinite(left) || !std::isfinite(asked)) {
    x.setConstant(not_a_number);
    return 0;
  }
  const double tolerance = settings.tolerance * settings.tolerance;
  const double enough = std::max(tolerance * std::max(left, rounding * asked), nothing);
  for (SingleVectors* vector : {&change_, &way_, &above_, &back_, &back_scaled_}) vector->setZero();
  direction_ = scaled_;
  int iteration = 0;
  while (iteration < settings.most_iterations && left > enough) {
    ++iteration;
    // With p the direction and t the transformed step, the system's matrix times p is t + (D + L)^-1 (p - D t), and p
    // - D t is L^T t.
    matrix.solve_upper(direction_, way_, above_);
    matrix.solve_lower(above_, back_, back_scaled_);
    back_ += way_;
    const double bend = inner_product(direction_, back_);
    if (!(bend > 0.0) && std::isfinite(bend)) break;
    const auto step = static_cast<float>(left / bend);
    change_ += step * way_;
    residual_ -= step * back_;
    scaled_ -= step * (direction_ - above_ + back_scaled_);
    const double now = inner_product(residual_, scaled_);
    direction_ = scaled_ + static_cast<float>(now / left) * direction_;
    left = now;
    if (!std::isfinite(left)) change_.setConstant(static_cast<float>(not_a_number));
  }
  x += change_.cast<double>();
  return iteration;
}

}  // namespace bodkin::fem
