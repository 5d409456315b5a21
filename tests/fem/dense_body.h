#pragma once

// Bodies for tests of contact: their compliance is computed without the engine's code.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "anatomy/condensed_body.h"
#include "core/random.h"

namespace bodkin::checks {

using namespace bodkin::anatomy;

// The displacement of one point by a unit force at another in an elastic space without end (Kelvin's solution, Love
// 1927, art. 130), with distances no shorter than about `smear`, so that a node may push itself. The matrix of all
// pairs is positive definite on the lattices below (a Cholesky factorisation that fails would fail the tests).
inline Mat3 kelvin(const Vec3& from, const Vec3& to, double modulus, double poisson, double smear) {
  const double shear = modulus / (2.0 * (1.0 + poisson));
  const double factor = 1.0 / (16.0 * 3.14159265358979323846 * shear * (1.0 - poisson));
  const Vec3 apart = to - from;
  const double distance = std::sqrt(apart.squaredNorm() + smear * smear);
  return factor / distance *
         ((3.0 - 4.0 * poisson) * Mat3::Identity() + apart * apart.transpose() / (distance * distance));
}

inline void fill_compliance(CondensedBody& body, double modulus, double smear) {
  const auto count = static_cast<Eigen::Index>(body.nodes.size());
  body.compliance.resize(3 * count, 3 * count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) {
      body.compliance.block<3, 3>(3 * i, 3 * j) = kelvin(
          body.nodes[static_cast<std::size_t>(i)], body.nodes[static_cast<std::size_t>(j)], modulus, 0.3, smear);
    }
  }
}

// `across` x `across` x `along` nodes, `spacing` mm apart, around the z axis from z = 0 on, all of one tissue.
inline CondensedBody kelvin_body(int across, int along, double spacing, double modulus = 0.02,
                                 TissueId tissue_id = tissue::soft) {
  CondensedBody body;
  for (int k = 0; k < along; ++k) {
    for (int j = 0; j < across; ++j) {
      for (int i = 0; i < across; ++i) {
        body.mesh_nodes.push_back(static_cast<std::uint32_t>(body.nodes.size()));
        body.nodes.emplace_back(spacing * (i - across / 2), spacing * (j - across / 2), spacing * k);
        body.tissues.push_back(tissue_id);
      }
    }
  }
  fill_compliance(body, modulus, 0.4 * spacing);
  return body;
}

// The same places as contact points, each at a node of a mesh that has these nodes.
inline CondensedBody as_points(CondensedBody body) {
  body.mesh_nodes.clear();
  for (std::uint32_t node = 0; node < body.nodes.size(); ++node)
    body.in_mesh.push_back({{node, node, node, node}, {1.0, 0.0, 0.0, 0.0}});
  return body;
}

// Up to three orthonormal directions, at random.
inline Mat3 random_frame(Random& random) {
  Vec3 a(random.normal(), random.normal(), random.normal());
  a.normalize();
  Vec3 b(random.normal(), random.normal(), random.normal());
  b = (b - b.dot(a) * a).normalized();
  Mat3 frame;
  frame << a, b, a.cross(b);
  return frame;
}

}  // namespace bodkin::checks
