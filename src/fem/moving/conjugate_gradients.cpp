#include "fem/moving/conjugate_gradients.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bodkin {

namespace {

double inner_product(const NodeVectors& a, const NodeVectors& b) noexcept {
  return a.cwiseProduct(b).sum();
}

}  // namespace

ConjugateGradients::ConjugateGradients(std::size_t nodes) {
  for (NodeVectors* vector : {&residual_, &direction_, &turned_, &product_})
    vector->setZero(4, static_cast<Eigen::Index>(nodes));
}

int ConjugateGradients::solve(const NodeMatrix& matrix, const NodeVectors& right, const GradientsSettings& settings,
                              NodeVectors& x) noexcept {
  matrix.multiply_by_inverse_diagonal(right, turned_);
  const double asked = inner_product(right, turned_);
  matrix.multiply(x, product_);
  residual_ = right - product_;
  matrix.multiply_by_inverse_diagonal(residual_, turned_);
  direction_ = turned_;
  double left = inner_product(residual_, turned_);
  const double enough = settings.tolerance * settings.tolerance * std::max(asked, left);
  if (!std::isfinite(left) || !std::isfinite(asked)) {
    x.setConstant(std::numeric_limits<double>::quiet_NaN());
    return 0;
  }
  int iteration = 0;
  while (iteration < settings.most_iterations && left > enough) {
    ++iteration;
    matrix.multiply(direction_, product_);
    const double bend = inner_product(direction_, product_);
    if (!(bend > 0.0)) break;
    const double step = left / bend;
    x += step * direction_;
    residual_ -= step * product_;
    matrix.multiply_by_inverse_diagonal(residual_, turned_);
    const double now = inner_product(residual_, turned_);
    direction_ = turned_ + (now / left) * direction_;
    left = now;
  }
  return iteration;
}

}  // namespace bodkin
