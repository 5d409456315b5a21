#include "fem/moving/nearest_rotation.h"

#include <cmath>

#include <Eigen/Jacobi>

namespace bodkin::fem {

Eigen::Quaterniond nearest_rotation(const Mat3& matrix) noexcept {
  const double size = matrix.cwiseAbs().maxCoeff();
  if (!(size > 0.0) || !std::isfinite(size) || !matrix.allFinite()) return Eigen::Quaterniond::Identity();
  const Mat3 m = matrix / size;
  Eigen::Matrix4d horn;                                                                      // tr(R^T F) = q^T horn q
  horn << m.trace(), m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1),                //
      m(2, 1) - m(1, 2), m(0, 0) - m(1, 1) - m(2, 2), m(0, 1) + m(1, 0), m(0, 2) + m(2, 0),  //
      m(0, 2) - m(2, 0), m(0, 1) + m(1, 0), m(1, 1) - m(0, 0) - m(2, 2), m(1, 2) + m(2, 1),  //
      m(1, 0) - m(0, 1), m(0, 2) + m(2, 0), m(1, 2) + m(2, 1), m(2, 2) - m(0, 0) - m(1, 1);
  Eigen::Matrix4d vectors = Eigen::Matrix4d::Identity();
  constexpr int most_sweeps = 12;  // each squares the off-diagonal part, once it is small
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    bool changed = false;
    for (Eigen::Index p = 0; p < 3; ++p) {
      for (Eigen::Index q = p + 1; q < 4; ++q) {
        if (!(std::abs(horn(p, q)) > 1e-17)) continue;
        Eigen::JacobiRotation<double> turn;
        turn.makeJacobi(horn, p, q);
        horn.applyOnTheLeft(p, q, turn.adjoint());
        horn.applyOnTheRight(p, q, turn);
        vectors.applyOnTheRight(p, q, turn);
        changed = true;
      }
    }
    if (!changed) break;
  }
  Eigen::Index best = 0;
  horn.diagonal().maxCoeff(&best);
  const Eigen::Vector4d q = vectors.col(best).normalized();
  return {q(0), q(1), q(2), q(3)};
}

}  // namespace bodkin::fem
