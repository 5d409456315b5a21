// A rigid, smooth, circular punch on a half space: F = 2 a E d / (1 - nu^2) (Johnson, Contact Mechanics 1985, 3.4).
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <numbers>

#include "tests/fem/lattice_body.h"
#include "tests/sanitized.h"
#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "fem/solid/elastic_body.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

constexpr double punch_young = 0.02, punch_poisson = 0.3;

// The distance of lattice plane `i` of `count` from the middle: nearly even within the punch, then growing, 60 in the
// end.
double punch_plane(double i, std::uint32_t count) {
  return std::sinh(std::asinh(60.0) * i / (count - 1));
}

// A half space of `count` lattice planes in depth, held at its bottom, with the punch at its top: the corridor is the
// nodes under it, within 1 mm of the origin.
BodyDescription half_space(std::uint32_t count) {
  const std::uint32_t n = 2 * count - 1, kept = n * n * count;
  const TetrahedralMesh lattice = kuhn_lattice(n, n - 1.0);  // nodes at whole numbers
  BodyDescription body;
  for (std::uint32_t node = 0; node < kept; ++node) {
    const Vec3 from_middle = lattice.nodes[node] - Vec3::Constant(count - 1.0);
    body.mesh.nodes.emplace_back(from_middle.unaryExpr([count](double i) { return punch_plane(i, count); }));
  }
  for (const auto& element : lattice.elements)
    if (*std::max_element(element.begin(), element.end()) < kept) body.mesh.elements.push_back(element);
  body.mesh.tissues.assign(body.mesh.elements.size(), tissue::soft);
  body.materials.set(tissue::soft, {punch_young, punch_poisson});
  body.fixed = nodes_beyond(body.mesh, Vec3(0.0, 0.0, -59.9), Vec3(0.0, 0.0, -1.0));
  for (std::uint32_t node = 0; node < kept; ++node)
    if (body.mesh.nodes[node].z() == 0.0 && body.mesh.nodes[node].head<2>().norm() <= 1.0)
      body.corridor.push_back(node);
  return body;
}

// Force over displacement against the closed form. The punch's radius is that of the circle with as much surface as
// its nodes stand for.
double force_ratio(std::uint32_t count) {
  const CondensedBody body = condense(half_space(count));
  const auto nodes = static_cast<Eigen::Index>(body.nodes.size());
  const auto width_at = [count](double x) {
    const double i = std::asinh(x) / std::asinh(60.0) * (count - 1);
    return 0.5 * (punch_plane(i + 1.0, count) - punch_plane(i - 1.0, count));
  };
  double surface = 0.0;
  for (const Vec3& node : body.nodes) surface += width_at(node.x()) * width_at(node.y());
  const double radius = std::sqrt(surface / std::numbers::pi);
  // Smooth: it holds its nodes in depth and lets them slide sideways.
  const Eigen::MatrixXd upright = body.compliance(Eigen::seqN(2, nodes, 3), Eigen::seqN(2, nodes, 3));
  const double stiffness = upright.llt().solve(Eigen::VectorXd::Ones(nodes)).sum();
  return stiffness / (2.0 * radius * punch_young / (1.0 - punch_poisson * punch_poisson));
}

TEST(RigidPunch, comes_to_the_closed_form_as_the_mesh_is_refined) {
  std::vector<std::uint32_t> counts = {9, 13};
  if (!sanitized) counts.push_back(18);
  if (std::getenv("BODKIN_LARGE_BODIES") != nullptr) counts.push_back(26);  // 67,626 nodes
  double before = 0.05;
  for (const std::uint32_t count : counts) {
    const double error = std::abs(force_ratio(count) - 1.0);
    std::cout << "  " << count << " planes deep: the force is " << 100.0 * error << " % off\n";
    EXPECT_LT(error, before);
    before = error;
  }
  EXPECT_LT(before, 0.025);
}

}  // namespace
}  // namespace bodkin
