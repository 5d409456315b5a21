#pragma once

// A needle of cubic Hermite elements on a body, all equations at once: the engine's equations without condensation.
#include <algorithm>
#include <vector>

#include <Eigen/Dense>

namespace bodkin::checks {

// These equations are badly conditioned when elements are short (that is one reason not to solve them in the tick),
// so they are solved with more digits.
using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

// Stiffness of Euler-Bernoulli elements between these places, mm: place and slope of each in turn.
inline LongMatrix hermite_stiffness(double rigidity, const std::vector<double>& places) {
  const auto size = static_cast<Eigen::Index>(2 * places.size());
  LongMatrix whole = LongMatrix::Zero(size, size);
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const long double l = static_cast<long double>(places[i + 1]) - places[i];
    Eigen::Matrix<long double, 4, 4> element;
    element << 12.0L, 6.0L * l, -12.0L, 6.0L * l,     //
        6.0 * l, 4.0 * l * l, -6.0 * l, 2.0 * l * l,  //
        -12.0, -6.0 * l, 12.0, -6.0 * l,              //
        6.0 * l, 2.0 * l * l, -6.0 * l, 4.0 * l * l;
    const auto at = static_cast<Eigen::Index>(2 * i);
    whole.block<4, 4>(at, at) += rigidity / (l * l * l) * element;
  }
  return whole;
}

// One plane or more of a needle that is held at the hub and by a body. Unknown are the places and slopes of all
// elements' ends and the forces, of the needle on the body, in rows that the caller numbers:
//
//   K v = -H^T f         H v + moved = S f       v at the hub prescribed, or its place alone
struct MonolithicNeedle {
  struct Row {
    int plane = -1;         // 0 or 1; -1: along the needle, where it does not bend
    double from_hub = 0.0;  // mm
  };
  double rigidity = 1.0, length = 90.0;  // N mm^2, mm
  bool pinned = false;

  // `compliance`: of the rows, with their softness, mm/N. `hub`: place and slope in each plane. `moved`: mm that each
  // row is to be moved beside where the needle is. Returns the forces, N.
  Eigen::VectorXd forces(const std::vector<Row>& rows, const Eigen::MatrixXd& compliance, const Eigen::Matrix2d& hub,
                         const Eigen::VectorXd& moved) const {
    std::vector<double> places{0.0, length};
    for (const Row& row : rows) {
      if (row.plane >= 0) places.push_back(row.from_hub);
    }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    const LongMatrix beam = hermite_stiffness(rigidity, places);
    const Eigen::Index ends = beam.rows(), count = static_cast<Eigen::Index>(rows.size());
    const Eigen::Index size = 2 * ends + count;
    LongMatrix matrix = LongMatrix::Zero(size, size);
    LongVector right = LongVector::Zero(size);
    for (Eigen::Index plane = 0; plane < 2; ++plane) {
      matrix.block(plane * ends, plane * ends, ends, ends) = beam;
      for (Eigen::Index held = 0; held < (pinned ? 1 : 2); ++held) {
        matrix.row(plane * ends + held).setZero();
        matrix(plane * ends + held, plane * ends + held) = 1.0;
        right(plane * ends + held) = hub(held, plane);
      }
    }
    matrix.bottomRightCorner(count, count) = -compliance.cast<long double>();
    right.tail(count) = -moved.cast<long double>();
    for (Eigen::Index i = 0; i < count; ++i) {
      const Row& row = rows[static_cast<std::size_t>(i)];
      if (row.plane < 0) continue;
      const auto place = std::lower_bound(places.begin(), places.end(), row.from_hub) - places.begin();
      const Eigen::Index at = row.plane * ends + 2 * place;
      matrix(2 * ends + i, at) = 1.0;
      matrix(at, 2 * ends + i) = 1.0;
    }
    const LongVector solution = matrix.partialPivLu().solve(right);
    return solution.tail(count).cast<double>();
  }
};

}  // namespace bodkin::checks
