// The display of a body with left needles: against a dense solution of the whole body with them.
#include "fem/solid/left_needle_forces.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "tests/fem/solid/whole_body.h"
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "fem/solid/display_columns.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
using checks::small_block;
using checks::WholeBody;
namespace {

const std::vector<NeedlePath> drawn_needles = {{Vec3(17.9, 13.4, checks::top), Vec3(18.4, 14.1, 4.0)},
                                               {Vec3(8.0, 20.0, checks::top), Vec3(14.0, 17.0, 10.3)}};

TEST(LeftNeedleForces, what_is_drawn_of_the_tissue_is_the_dense_solution_with_the_needles_in_it) {
  BodyDescription description = *small_block();
  std::vector<bool> fixed(description.mesh.nodes.size(), false);
  for (const std::uint32_t node : description.fixed) fixed[node] = true;
  for (std::uint32_t node = 0; node < description.mesh.nodes.size(); node += 3)
    if (!fixed[node]) description.corridor.push_back(node);  // more than a batch
  const auto shared = std::make_shared<const BodyDescription>(description);
  const ContactBody whole(shared);
  const ElasticBody elastic(description, plan_body(description));
  Random random(5);
  std::vector<Vec3> points;
  for (int i = 0; i < 100; ++i) {  // one number after the other, as arguments are not for every compiler
    const double z = random.uniform(0.0, checks::top), y = random.uniform(0.0, 30.0), x = random.uniform(0.0, 36.0);
    points.emplace_back(x, y, z);
  }
  const std::vector<PointInMesh> places = find_points(description.mesh, points);

  NodeForces forces;
  Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(description.mesh.nodes.size()), 1);
  for (const std::uint32_t node : description.corridor) {
    NodeForce& here = forces.nodes[forces.count++];
    here.node = node;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      here.force[axis] = static_cast<float>(0.01 * random.normal());
      loads(3 * Eigen::Index{node} + static_cast<Eigen::Index>(axis)) = static_cast<double>(here.force[axis]);
    }
  }
  WholeBody dense(description);
  const Eigen::MatrixXd without = at_places(places, dense.solve(loads).moved);
  for (const NeedlePath& needle : drawn_needles) dense.leave(needle.entry, needle.target);
  const WholeBody::Solution solution = dense.solve(loads);
  const Eigen::MatrixXd expected = at_places(places, solution.moved);

  const LeftNeedleForces left(&whole, drawn_needles);
  const DisplayField field = display_columns(elastic, places, description.corridor, {}, left);
  std::vector<float> moved(3 * points.size());
  field.evaluate(forces, moved);
  const double largest = expected.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < expected.rows(); ++i)
    EXPECT_NEAR(moved[static_cast<std::size_t>(i)], expected(i, 0), 3e-6 * largest) << i;
  EXPECT_GT((expected - without).cwiseAbs().maxCoeff(), 0.01 * largest) << "it is to be seen";
  // By the forces that hold the tissue.
  const Eigen::MatrixXd alone = elastic.displacement(loads);
  EXPECT_LT((left.against(alone) - solution.forces).norm(), 1e-9 * solution.forces.norm());
}

TEST(LeftNeedleForces, there_are_none_without_a_needle_or_a_body_of_points) {
  const ContactBody whole(small_block());
  EXPECT_TRUE(LeftNeedleForces().empty());
  EXPECT_TRUE(LeftNeedleForces(nullptr, drawn_needles).empty());
  EXPECT_TRUE(LeftNeedleForces(&whole, {}).empty());
  EXPECT_FALSE(LeftNeedleForces(&whole, drawn_needles).empty());
  EXPECT_TRUE(
      LeftNeedleForces(&whole, std::vector<NeedlePath>{{Vec3(200.0, 0.0, 0.0), Vec3(210.0, 0.0, 0.0)}}).empty())
      << "beside the mesh";
  EXPECT_THROW(LeftNeedleForces(&whole, std::vector<NeedlePath>{{Vec3::Ones(), Vec3::Ones()}}), InputError);
}

}  // namespace
}  // namespace bodkin
