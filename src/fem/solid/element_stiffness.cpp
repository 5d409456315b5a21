#include "fem/solid/element_stiffness.h"

#include <Eigen/Geometry>

namespace bodkin::fem {

TetrahedronGradients tetrahedron_gradients(const std::array<Vec3, 4>& corners) {
  const Vec3 a = corners[1] - corners[0], b = corners[2] - corners[0], c = corners[3] - corners[0];
  const double six_volumes = a.cross(b).dot(c);
  TetrahedronGradients result;
  result.volume = six_volumes / 6.0;
  result.gradient[1] = b.cross(c) / six_volumes;
  result.gradient[2] = c.cross(a) / six_volumes;
  result.gradient[3] = a.cross(b) / six_volumes;
  result.gradient[0] = -(result.gradient[1] + result.gradient[2] + result.gradient[3]);
  return result;
}

Mat3 stiffness_block(const TetrahedronGradients& element, const LameConstants& material, std::size_t a,
                     std::size_t b) {
  const Vec3 &ga = element.gradient[a], &gb = element.gradient[b];
  const double across = material.mu * ga.dot(gb);
  Mat3 block;
  for (Eigen::Index j = 0; j < 3; ++j) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      const double volumetric = material.lambda * (ga[i] * gb[j]), shear = material.mu * (ga[j] * gb[i]);
      block(i, j) = element.volume * ((volumetric + shear) + (i == j ? across : 0.0));
    }
  }
  return block;
}

Eigen::Matrix<double, 12, 12> element_stiffness(const std::array<Vec3, 4>& corners, const ElasticMaterial& material) {
  const TetrahedronGradients element = tetrahedron_gradients(corners);
  const LameConstants constants = lame_constants(material);
  Eigen::Matrix<double, 12, 12> stiffness;
  for (std::size_t a = 0; a < 4; ++a) {
    for (std::size_t b = 0; b < 4; ++b) {
      stiffness.block<3, 3>(static_cast<Eigen::Index>(3 * a), static_cast<Eigen::Index>(3 * b)) =
          stiffness_block(element, constants, a, b);
    }
  }
  return stiffness;
}

}  // namespace bodkin::fem
