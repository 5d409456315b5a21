#include "fem/moving/corotational_tangent.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "fem/moving/nearest_rotation.h"
#include "fem/solid/element_stiffness.h"

namespace bodkin::fem {

namespace {

// An element as it is strained: gradients turned, and B of the header.
struct StrainedElement {
  TetrahedronGradients turned;
  LameConstants material;
  Mat3 stress_stiffness = Mat3::Zero();  // B, MPa
};

Mat3 skew(const Vec3& v) {
  Mat3 matrix;
  matrix << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return matrix;
}

StrainedElement strained(const BodyDescription& body, const Eigen::Ref<const Eigen::MatrixXd>& places,
                         std::size_t element, StressStiffness stress) {
  const auto& nodes = body.mesh.elements[element];
  std::array<Vec3, 4> corners;
  for (std::size_t a = 0; a < 4; ++a) corners[a] = body.mesh.nodes[nodes[a]];
  StrainedElement found{tetrahedron_gradients(corners),
                        lame_constants(*body.materials.find(body.mesh.tissues[element]))};
  Mat3 deformation = Mat3::Zero();
  for (std::size_t a = 0; a < 4; ++a)
    deformation += places.col(nodes[a]).head<3>() * found.turned.gradient[a].transpose();
  const Mat3 rotation = nearest_rotation(deformation).toRotationMatrix();
  const Mat3 product = rotation.transpose() * deformation;
  const Mat3 stretch = 0.5 * (product + product.transpose());
  const Mat3 y = stretch.trace() * Mat3::Identity() - stretch;
  const double mu = found.material.mu;
  const double numerator = 2.0 * (found.material.lambda * (stretch.trace() - 3.0) - 2.0 * mu);
  const Eigen::SelfAdjointEigenSolver<Mat3> principal(y);
  Vec3 values;
  for (Eigen::Index i = 0; i < 3; ++i) {
    // A flat or inverted element: Y may be singular. No state of rest has one; the bound keeps what follows finite.
    values(i) = 2.0 * mu + numerator / std::max(principal.eigenvalues()(i), 1e-3);
    if (stress == StressStiffness::positive) values(i) = std::max(values(i), 0.0);
  }
  const Mat3 axes = rotation * principal.eigenvectors();
  found.stress_stiffness = axes * values.asDiagonal() * axes.transpose();
  for (Vec3& gradient : found.turned.gradient) gradient = rotation * gradient;
  return found;
}

Mat3 tangent_block(const StrainedElement& element, std::size_t a, std::size_t b) {
  return stiffness_block(element.turned, element.material, a, b) +
         0.5 * element.turned.volume *
             (skew(element.turned.gradient[a]).transpose() * element.stress_stiffness *
              skew(element.turned.gradient[b]));
}

void hold_nodes(std::span<const std::uint8_t> held, ElasticSystem& system) {
  BlockMatrix& matrix = system.stiffness;
  double stiffest = 0.0;
  for (std::uint32_t column = 0; column < matrix.nodes; ++column)
    stiffest = std::max(stiffest, matrix.block[matrix.start[column]].diagonal().maxCoeff());
  const auto is_held = [&](std::uint32_t node) { return held[system.mesh_nodes[node]] != 0; };
  for (std::uint32_t column = 0; column < matrix.nodes; ++column) {
    for (std::size_t at = matrix.start[column]; at < matrix.start[column + 1]; ++at) {
      const std::uint32_t row = matrix.row[at];
      if (row != column && (is_held(row) || is_held(column))) matrix.block[at].setZero();
    }
    if (is_held(column)) matrix.block[matrix.start[column]] = tangent_holding * stiffest * Mat3::Identity();
  }
}

}  // namespace

void assemble_tangent(const BodyDescription& body, const Eigen::Ref<const Eigen::MatrixXd>& places,
                      std::span<const std::uint8_t> held, StressStiffness stress, ElasticSystem& system) {
  BlockMatrix& matrix = system.stiffness;
  std::fill(matrix.block.begin(), matrix.block.end(), Mat3::Zero());
  for (std::size_t element = 0; element < body.mesh.elements.size(); ++element) {
    const StrainedElement here = strained(body, places, element, stress);
    for (std::size_t b = 0; b < 4; ++b) {
      const std::uint32_t column = system.free_nodes[body.mesh.elements[element][b]];
      if (column == ElasticSystem::fixed) continue;
      const auto first = matrix.row.begin() + static_cast<std::ptrdiff_t>(matrix.start[column]);
      const auto last = matrix.row.begin() + static_cast<std::ptrdiff_t>(matrix.start[column + 1]);
      for (std::size_t a = 0; a < 4; ++a) {
        const std::uint32_t row = system.free_nodes[body.mesh.elements[element][a]];
        if (row == ElasticSystem::fixed || row < column) continue;
        const auto place = static_cast<std::size_t>(std::lower_bound(first, last, row) - matrix.row.begin());
        matrix.block[place] += tangent_block(here, a, b);
      }
    }
  }
  for (std::uint32_t column = 0; column < matrix.nodes; ++column) {
    Mat3& diagonal = matrix.block[matrix.start[column]];
    diagonal = (0.5 * (diagonal + diagonal.transpose())).eval();
  }
  if (!held.empty()) hold_nodes(held, system);
}

}  // namespace bodkin::fem
