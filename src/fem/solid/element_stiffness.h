#pragma once

#include <array>

#include <Eigen/Core>

#include "core/geometry.h"
#include "fem/solid/elastic_material.h"

namespace bodkin::fem {

// The gradients of the four shape functions of a linear tetrahedron, constant inside it, and its volume.
struct TetrahedronGradients {
  std::array<Vec3, 4> gradient;  // 1/mm; they add up to zero
  double volume = 0.0;           // mm^3, above 0
};

// The corners must span a positive volume.
TetrahedronGradients tetrahedron_gradients(const std::array<Vec3, 4>& corners);

// The stiffness between corners a and b, N/mm: the force on a for a displacement of b (Sutherland 2013, eq. 1),
//   K_ab[i][j] = V (lambda g_a[i] g_b[j] + mu g_a[j] g_b[i] + mu (g_a . g_b) delta_ij),
// plus the contribution of fibres (ElasticConstants).
// K_ba is the transpose of K_ab to the last bit.
Mat3 stiffness_block(const TetrahedronGradients& element, const ElasticConstants& material, std::size_t a,
                     std::size_t b);

// All blocks of one element: rows and columns x, y, z of the four corners.
Eigen::Matrix<double, 12, 12> element_stiffness(const std::array<Vec3, 4>& corners, const ElasticMaterial& material);

}  // namespace bodkin::fem
