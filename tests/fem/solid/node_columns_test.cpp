#include "fem/solid/node_columns.h"

#include <memory>
#include <vector>

#include "tests/fem/solid/whole_body.h"
#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
using checks::small_block;
using checks::WholeBody;
namespace {

// Against one dense solution of the whole body, alone and with two left needles.
TEST(NodeColumns, are_how_points_move_by_forces_on_any_nodes) {
  const std::shared_ptr<const BodyDescription> body = small_block();
  const auto whole = std::make_shared<const ContactBody>(body);
  Random random(11);
  std::vector<Vec3> points;
  for (int i = 0; i < 40; ++i)
    points.emplace_back(random.uniform(0.0, 36.0), random.uniform(0.0, 30.0), random.uniform(0.0, checks::top));
  points.emplace_back(200.0, 0.0, 0.0);  // beside the mesh
  const std::vector<PointInMesh> places = find_points(body->mesh, points);
  std::vector<std::uint32_t> nodes = {body->fixed.front()};  // which moves nothing
  for (std::uint32_t node = 1; node < body->mesh.nodes.size(); node += 13) nodes.push_back(node);
  ASSERT_GT(nodes.size(), 8U) << "more than a batch";
  Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(body->mesh.nodes.size()),
                                                3 * static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i)
    loads.block<3, 3>(3 * static_cast<Eigen::Index>(nodes[i]), 3 * static_cast<Eigen::Index>(i)).setIdentity();
  const std::vector<NeedlePath> needles = {{Vec3(20.0, 14.0, checks::top), Vec3(23.0, 12.0, 6.0)},
                                           {Vec3(12.0, 10.0, checks::top), Vec3(12.0, 14.0, 8.0)}};
  Eigen::MatrixXd alone;
  for (const std::vector<NeedlePath>& left : {std::vector<NeedlePath>(), needles}) {
    WholeBody dense(*body);
    for (const NeedlePath& needle : left) dense.leave(needle.entry, needle.target);
    const Eigen::MatrixXd expected = at_places(places, dense.solve(loads).moved);
    const NodeColumns columns(whole, places, LeftNeedleForces(whole.get(), left));
    const Eigen::MatrixXd found = columns.of(nodes).cast<double>();
    ASSERT_EQ(found.rows(), expected.rows());
    ASSERT_EQ(found.cols(), expected.cols());
    EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 3e-6 * expected.cwiseAbs().maxCoeff()) << left.size();
    if (left.empty()) {
      alone = expected;
    } else {
      EXPECT_GT((expected - alone).cwiseAbs().maxCoeff(), 0.005 * alone.cwiseAbs().maxCoeff());
    }
  }
}

}  // namespace
}  // namespace bodkin
