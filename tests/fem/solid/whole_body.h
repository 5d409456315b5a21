#pragma once

// A small body with left needles and held nodes, as the dense equations of all its nodes.
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "tests/fem/lattice_body.h"
#include <Eigen/LU>

#include "fem/solid/points_in_mesh.h"
#include "fem/solid/tip_compliance.h"

namespace bodkin::checks {

using namespace bodkin::anatomy;
using namespace bodkin::fem;

inline constexpr double young = 0.05, poisson = 0.3;  // MPa
inline constexpr double top = 24.0;                   // mm

inline std::shared_ptr<const BodyDescription> small_block() {
  BodyDescription body;
  body.mesh = kuhn_box({7, 6, 5}, Vec3(36.0, 30.0, top), 0.2, 3);
  body.materials.set(tissue::soft, {young, poisson});
  body.fixed = nodes_beyond(body.mesh, Vec3::Zero(), Vec3(0.0, 0.0, -1.0));
  return std::make_shared<const BodyDescription>(std::move(body));
}

// Element by element from the law that docs/fem.md states.
inline Eigen::MatrixXd dense_stiffness(const TetrahedralMesh& mesh) {
  const double lambda = young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
  const double mu = young / (2.0 * (1.0 + poisson));
  const auto size = 3 * static_cast<Eigen::Index>(mesh.nodes.size());
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(size, size);
  for (const auto& element : mesh.elements) {
    Mat3 edges;
    for (int i = 0; i < 3; ++i)
      edges.col(i) = mesh.nodes[element[static_cast<std::size_t>(i + 1)]] - mesh.nodes[element[0]];
    const double volume = std::abs(edges.determinant()) / 6.0;
    Eigen::Matrix<double, 3, 4> gradients;
    gradients.rightCols<3>() = edges.inverse().transpose();
    gradients.col(0) = -gradients.rightCols<3>().rowwise().sum();
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b < 4; ++b) {
        const Vec3 g = gradients.col(a), h = gradients.col(b);
        stiffness.block<3, 3>(3 * Eigen::Index{element[static_cast<std::size_t>(a)]},
                              3 * Eigen::Index{element[static_cast<std::size_t>(b)]}) +=
            volume * (lambda * g * h.transpose() + mu * h * g.transpose() + mu * g.dot(h) * Mat3::Identity());
      }
    }
  }
  return stiffness;
}

// The nodal forces of a force on a place.
inline Eigen::MatrixXd spread_of(const std::vector<PlaceInElement>& places, std::size_t nodes) {
  Eigen::MatrixXd spread =
      Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(nodes), 3 * static_cast<Eigen::Index>(places.size()));
  for (std::size_t p = 0; p < places.size(); ++p)
    for (std::size_t corner = 0; corner < 4; ++corner)
      spread.block<3, 3>(3 * Eigen::Index{places[p].nodes[corner]}, 3 * static_cast<Eigen::Index>(p)) +=
          places[p].weights[corner] * Mat3::Identity();
  return spread;
}

// All constraints on the body, as the dense equations of all its nodes.
class WholeBody {
 public:
  explicit WholeBody(const BodyDescription& body) : body_(body), stiffness_(dense_stiffness(body.mesh)) {
    for (const std::uint32_t node : body.fixed) hold(node);
  }
  void hold(std::uint32_t node) { held_.push_back(node); }
  // The points of a left needle each millimetre, the first half a millimetre deep.
  void leave(const Vec3& entry, const Vec3& tip) {
    const Vec3 along = (tip - entry).normalized();
    std::vector<Vec3> places;
    for (double depth = 0.5; depth <= (tip - entry).norm(); depth += 1.0) places.push_back(entry + depth * along);
    const Vec3 across = along.unitOrthogonal(), other = along.cross(across);
    const auto first = static_cast<Eigen::Index>(gains_.size());
    motions_.conservativeResize(first + 3 * static_cast<Eigen::Index>(places.size()), motions_.cols() + 5);
    motions_.bottomRows(3 * static_cast<Eigen::Index>(places.size())).setZero();
    motions_.topRightCorner(first, 5).setZero();
    const std::vector<PointInMesh> found = find_points(body_.mesh, places);
    for (std::size_t p = 0; p < places.size(); ++p) {
      bound_.push_back({found[p].nodes, found[p].weights});
      const auto row = first + 3 * static_cast<Eigen::Index>(p);
      motions_.block<3, 3>(row, motions_.cols() - 5).setIdentity();
      motions_.block<3, 1>(row, motions_.cols() - 2) = across.cross(Vec3(places[p] - entry));
      motions_.block<3, 1>(row, motions_.cols() - 1) = other.cross(Vec3(places[p] - entry));
      for (int i = 0; i < 3; ++i) gains_.push_back(gain_at(found[p]));
    }
  }
  // mm/N, isotropic: the mesh's missing compliance at a point on a shaft.
  double gain_at(const PointInMesh& place) const {
    Mat3 edges;
    const auto& nodes = body_.mesh.elements[place.element];
    for (int i = 0; i < 3; ++i)
      edges.col(i) = body_.mesh.nodes[nodes[static_cast<std::size_t>(i + 1)]] - body_.mesh.nodes[nodes[0]];
    const double edge = std::cbrt(6.0 * std::sqrt(2.0) * std::abs(edges.determinant()) / 6.0);
    return shaft_gain({young, poisson}, edge, 0.5)(0, 0);
  }

  struct Solution {
    Eigen::MatrixXd moved;    // of all nodes
    Eigen::MatrixXd forces;   // on the points of left needles
    Eigen::VectorXd energy;   // N mm, of the body and of what its mesh lacks, for each column
    Eigen::MatrixXd holding;  // forces on the nodes of hold(), 3 rows each, the last ones last
  };
  // `last_held`: mm, by which the nodes that were held last are moved, 3 rows each; the others stay.
  Solution solve(const Eigen::MatrixXd& loads, const Eigen::MatrixXd& last_held = {}) const {
    const Eigen::Index n = stiffness_.rows(), c = static_cast<Eigen::Index>(gains_.size()), m = motions_.cols(),
                       h = 3 * static_cast<Eigen::Index>(held_.size());
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(n + c + m + h, n + c + m + h);
    all.topLeftCorner(n, n) = stiffness_;
    const Eigen::MatrixXd spread = spread_of(bound_, body_.mesh.nodes.size());
    all.block(0, n, n, c) = -spread;
    all.block(n, 0, c, n) = spread.transpose();
    for (Eigen::Index i = 0; i < c; ++i) all(n + i, n + i) = gains_[static_cast<std::size_t>(i)];
    all.block(n, n + c, c, m) = -motions_;
    all.block(n + c, n, m, c) = motions_.transpose();
    for (Eigen::Index i = 0; i < h; ++i) {
      const Eigen::Index at = 3 * Eigen::Index{held_[static_cast<std::size_t>(i / 3)]} + i % 3;
      all(at, n + c + m + i) = -1.0;
      all(n + c + m + i, at) = 1.0;
    }
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(all.rows(), loads.cols());
    right.topRows(n) = loads;
    if (last_held.size() > 0) right.bottomRows(last_held.rows()) = last_held;
    const Eigen::MatrixXd found = all.fullPivLu().solve(right);
    Solution solution{found.topRows(n), found.middleRows(n, c), {}, found.bottomRows(h)};
    solution.energy = 0.5 * (solution.moved.cwiseProduct(stiffness_ * solution.moved)).colwise().sum().transpose();
    for (Eigen::Index i = 0; i < c; ++i)
      solution.energy += 0.5 * gains_[static_cast<std::size_t>(i)] * solution.forces.row(i).cwiseAbs2().transpose();
    return solution;
  }

 private:
  const BodyDescription& body_;
  Eigen::MatrixXd stiffness_;
  std::vector<std::uint32_t> held_;
  std::vector<PlaceInElement> bound_;
  std::vector<double> gains_;  // 3 a point
  Eigen::MatrixXd motions_ = Eigen::MatrixXd::Zero(0, 0);
};

// Nodes of the surface beside the line, as a probe holds them.
inline std::vector<std::uint32_t> pressed_nodes(const TetrahedralMesh& mesh) {
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t node = 0; node < mesh.nodes.size(); ++node) {
    const Vec3& at = mesh.nodes[node];
    if (at.z() > top - 1e-6 && at.x() > 20.0 && at.x() < 33.0 && at.y() < 20.0) nodes.push_back(node);
  }
  return nodes;
}

}  // namespace bodkin::checks
