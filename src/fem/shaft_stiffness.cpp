#include "fem/shaft_stiffness.h"

#include <algorithm>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "fem/contact_nodes.h"

namespace bodkin::fem {

double shaft_stiffness(const anatomy::CondensedBody& body, const Vec3& entry, const Vec3& direction, double length,
                       std::size_t most_nodes) {
  ContactNodes nodes(body);
  nodes.begin(entry, direction, {});
  std::vector<Eigen::Index> rows;
  for (const ContactNode& node : nodes.along()) {
    if (node.depth > length || rows.size() >= 3 * most_nodes) break;
    for (Eigen::Index axis = 0; axis < 3; ++axis) rows.push_back(3 * Eigen::Index{node.index} + axis);
  }
  if (rows.empty()) return 0.0;
  const auto count = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd together(count, 3);
  for (Eigen::Index row = 0; row < count; ++row) together.row(row) = Vec3::Unit(row % 3).transpose();
  const Eigen::MatrixXd compliance = body.compliance(rows, rows);
  const Mat3 stiffness = together.transpose() * compliance.llt().solve(together);
  return Eigen::SelfAdjointEigenSolver<Mat3>(stiffness, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

}  // namespace bodkin::fem
