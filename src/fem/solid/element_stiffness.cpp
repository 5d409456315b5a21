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

namespace {

// Contribution of fibres to the block between two corners, per volume. The order of each sum is invariant under an
// exchange of the corners.
Mat3 fibre_block(const Vec3& ga, const Vec3& gb, const ElasticConstants& material) {
  const Vec3& f = material.fibre;
  const double fa = f.dot(ga), fb = f.dot(gb), both = fa * fb, dot = ga.dot(gb);
  Mat3 block;
  for (Eigen::Index j = 0; j < 3; ++j) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      const double along = (f[i] * fa) * (f[j] * fb);
      const double coupling = (f[j] * fb) * ga[i] + (f[i] * fa) * gb[j];
      const double shear =
          (((f[i] * ga[j]) * fb + (f[j] * gb[i]) * fa) + ((f[i] * f[j]) * dot + (i == j ? both : 0.0)));
      block(i, j) = (material.coupling * coupling + 0.5 * material.shear * shear) + material.tension * along;
    }
  }
  return block;
}

}  // namespace

Mat3 stiffness_block(const TetrahedronGradients& element, const ElasticConstants& constants, std::size_t a,
                     std::size_t b) {
  const Vec3 &ga = element.gradient[a], &gb = element.gradient[b];
  const LameConstants& material = constants.across;
  const double across = material.mu * ga.dot(gb);
  Mat3 block;
  for (Eigen::Index j = 0; j < 3; ++j) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      const double volumetric = material.lambda * (ga[i] * gb[j]), shear = material.mu * (ga[j] * gb[i]);
      block(i, j) = element.volume * ((volumetric + shear) + (i == j ? across : 0.0));
    }
  }
  if (!constants.fibre.isZero(0.0)) block += element.volume * fibre_block(ga, gb, constants);
  return block;
}

Eigen::Matrix<double, 12, 12> element_stiffness(const std::array<Vec3, 4>& corners, const ElasticMaterial& material) {
  const TetrahedronGradients element = tetrahedron_gradients(corners);
  const ElasticConstants constants = elastic_constants(material);
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
