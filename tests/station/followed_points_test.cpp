#include "station/followed_points.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "tests/station/seen_block.h"
#include <gtest/gtest.h>

namespace bodkin {

namespace {

bool holds_within_a_minute(const std::function<bool()>& holds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!holds()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

// Free nodes of the block's face at the top, and below it, near x = 24 mm; the path runs at x = 0.
std::vector<std::uint32_t> nodes_beside(const SeenBlock& block, double depth) {
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t node = 0; node < block.body->mesh.nodes.size(); ++node) {
    const Vec3& at = block.body->mesh.nodes[node];
    if (std::abs(at.x() - 24.0) < 5.0 && std::abs(at.z()) < 5.0 && std::abs(at.y() + depth) < 3.6)
      nodes.push_back(node);
  }
  return nodes;
}

struct Followed {
  SeenBlock block = seen_block();
  ElasticBody elastic{*block.body, plan_body(*block.body)};
  std::shared_ptr<const ContactBody> whole = std::make_shared<const ContactBody>(block.body);
  std::vector<Vec3> points = {Vec3(20.0, -6.0, 3.0), Vec3(26.0, 0.0, -2.0), Vec3(1.0, -10.0, 1.0)};
  NodeForces forces;

  Followed() {
    for (const std::uint32_t node : nodes_beside(block, 14.0))
      forces.nodes[forces.count++] = {node, {0.2F, -1.0F, 0.1F}};
  }
  Eigen::VectorXd expected() const {
    Eigen::MatrixXd load = Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(block.body->mesh.nodes.size()), 1);
    for (std::size_t i = 0; i < forces.count; ++i)
      for (std::size_t c = 0; c < 3; ++c)
        load(static_cast<Eigen::Index>(3 * forces.nodes[i].node + c)) +=
            static_cast<double>(forces.nodes[i].force[c]);
    return at_places(find_points(block.body->mesh, points), elastic.displacement(load));
  }
};

double worst(std::span<const float> found, const Eigen::VectorXd& expected) {
  double most = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i)
    most = std::max(most, std::abs(static_cast<double>(found[i]) - expected(static_cast<Eigen::Index>(i))));
  return most;
}

// A needle that meets points of its line has no corridor of nodes: the picture takes those about the planned path.
TEST(BodyOfPicture, knows_the_free_nodes_about_the_path_of_a_body_without_a_corridor) {
  const SeenBlock block = seen_block();
  BodyDescription body = *block.body;
  body.corridor.clear();
  const ContactBody whole(std::make_shared<const BodyDescription>(body));
  const NeedlePath& path = *block.patient.description.procedure.path;
  const ElasticBody elastic = body_of_picture(body, &whole, path, {});
  ASSERT_GT(elastic.corridor().size(), 50U);
  for (const std::uint32_t node : elastic.corridor()) {
    const Vec3& at = body.mesh.nodes[node];
    EXPECT_LE((at - Vec3(0.0, std::clamp(at.y(), -45.0, 5.0), 0.0)).norm(), 25.0 + 1e-9);
    EXPECT_EQ(std::count(body.fixed.begin(), body.fixed.end(), node), 0);
  }
  const NeedlePath far_away{Vec3(0.0, 500.0, 0.0), Vec3(0.0, 470.0, 0.0)};
  EXPECT_EQ(body_of_picture(body, &whole, far_away, {}).corridor().size(), 1U) << "the nearest";
  body.corridor = {elastic.corridor()[0], elastic.corridor()[1]};
  EXPECT_EQ(body_of_picture(body, nullptr, path, {}).corridor(), body.corridor);
}

TEST(FollowedPoints, move_with_a_needle_24_mm_beside_the_path) {
  const Followed rig;
  ASSERT_GE(rig.forces.count, 1U);
  const NeedlePath& path = *rig.block.patient.description.procedure.path;
  const Eigen::VectorXd expected = rig.expected();
  ASSERT_GT(expected.cwiseAbs().maxCoeff(), 0.01);
  FollowedPoints followed(rig.elastic, rig.block.body->mesh, path, rig.points, {}, {}, rig.whole);
  followed.display()->set_forces(rig.forces);
  EXPECT_TRUE(holds_within_a_minute([&] {
    const std::span<const float> moved = followed.displacements();
    return moved.size() == 9 && worst(moved, expected) < 1e-5 * expected.cwiseAbs().maxCoeff();
  }));
  // In a body without contact points forces act only on nodes about the path.
  FollowedPoints nodes_alone(rig.elastic, rig.block.body->mesh, path, rig.points, {});
  nodes_alone.display()->set_forces(rig.forces);
  EXPECT_TRUE(holds_within_a_minute([&] { return nodes_alone.display()->snapshot().left_out > 0.0; }));
}

TEST(FollowedPoints, can_be_others_while_the_needle_is_in) {
  Followed rig;
  const NeedlePath& path = *rig.block.patient.description.procedure.path;
  const std::vector<std::uint32_t> held = nodes_beside(rig.block, 0.0);
  const std::vector<Vec3> first = {Vec3(0.0, -1.0, 0.0)};
  FollowedPoints followed(rig.elastic, rig.block.body->mesh, path, first, {}, {}, rig.whole, held);
  const auto shows = [&] {
    const Eigen::VectorXd expected = rig.expected();
    return [&followed, expected] {
      const std::span<const float> moved = followed.displacements();
      return moved.size() == 9 && worst(moved, expected) < 1e-5 * expected.cwiseAbs().maxCoeff();
    };
  };
  followed.display()->set_forces(rig.forces);
  followed.follow(rig.points, Vec3(24.0, 0.0, 0.0));
  ASSERT_EQ(followed.displacements().size(), 9U) << "at once";
  EXPECT_TRUE(holds_within_a_minute(shows()));
  // What a probe held before is held for these, too.
  const std::vector<float> still(3 * rig.block.body->mesh.nodes.size(), 0.0F);
  followed.update(still, held);
  rig.points.pop_back();
  rig.points.push_back(rig.block.body->mesh.nodes[held.front()]);
  followed.follow(rig.points, Vec3(24.0, 0.0, 0.0));
  const double free = rig.expected().tail<3>().norm();
  EXPECT_TRUE(holds_within_a_minute([&] {
    const std::span<const float> moved = followed.displacements();
    return std::hypot(moved[0], moved[1], moved[2]) > 0.1 * free &&
           std::hypot(moved[6], moved[7], moved[8]) < 1e-4 * free;
  }));
  followed.update(still, {});
  EXPECT_TRUE(holds_within_a_minute(shows()));
  // A body whose needle stays near its path keeps its original points.
  FollowedPoints nodes_alone(rig.elastic, rig.block.body->mesh, path, first, {});
  nodes_alone.follow(rig.points, Vec3(24.0, 0.0, 0.0));
  EXPECT_EQ(nodes_alone.displacements().size(), 3U);
}

TEST(FollowedPoints, do_not_move_where_a_probe_holds_the_tissue) {
  Followed rig;
  const std::vector<std::uint32_t> held = nodes_beside(rig.block, 0.0);
  ASSERT_GE(held.size(), 1U);
  rig.points.push_back(rig.block.body->mesh.nodes[held.front()]);
  const NeedlePath& path = *rig.block.patient.description.procedure.path;
  FollowedPoints followed(rig.elastic, rig.block.body->mesh, path, rig.points, {}, {}, rig.whole, held);
  followed.display()->set_forces(rig.forces);
  const Eigen::VectorXd free = rig.expected();
  const double at_held = free.tail<3>().norm();
  ASSERT_GT(at_held, 0.001);
  ASSERT_TRUE(holds_within_a_minute([&] { return worst(followed.displacements(), free) < 1e-4 * at_held; }));
  const std::vector<float> still(3 * rig.block.body->mesh.nodes.size(), 0.0F);
  followed.update(still, held);
  EXPECT_TRUE(holds_within_a_minute([&] {
    const std::span<const float> moved = followed.displacements();
    return std::hypot(moved[9], moved[10], moved[11]) < 1e-4 * at_held && worst(moved.first(9), free) > 0.1 * at_held;
  }));
  followed.update(still, {});
  EXPECT_TRUE(holds_within_a_minute([&] { return worst(followed.displacements(), free) < 1e-4 * at_held; }));
}

}  // namespace
}  // namespace bodkin
