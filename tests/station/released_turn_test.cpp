// A released needle in a moving body: it moves and turns with the tissue along it.
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "station/released_needle.h"
#include "tests/station/pressed_block.h"
#include <gtest/gtest.h>

#include "simulation/haptic_tick.h"

namespace bodkin {

using namespace bodkin::simulation;
using namespace bodkin::station;
namespace {

// mm, for every node of the block, which moves rigidly.
std::vector<float> moved_rigidly(const PressedBlock& block, const Pose& motion) {
  std::vector<float> moved;
  for (const Vec3& node : block.body->mesh.nodes) {
    const Vec3 by = motion * node - node;
    for (Eigen::Index axis = 0; axis < 3; ++axis) moved.push_back(static_cast<float>(by[axis]));
  }
  return moved;
}

Pose turned_about(const Vec3& place, const Vec3& turn, const Vec3& by) {
  Pose motion = Pose::Identity();
  motion.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  motion.translation() = place + by - motion.linear() * place;
  return motion;
}

// No force acts between needle and tissue, whether the needle lies on the line of its insertion or has been tilted
// since.
TEST(ReleasedTurn, a_needle_that_was_let_go_turns_with_the_tissue) {
  const PressedBlock block = pressed_block();
  for (const double lean : {0.0, 0.03}) {
    HapticTick tick(block.patient);
    const auto motion = std::make_shared<BodyMotion>();
    ASSERT_TRUE(tick.body()->move_with(motion));
    Pose needle = Pose::Identity();
    for (double depth = -2.0; depth < 22.0; depth += 0.05) tick.step({needle = straight_down(-30.0, depth)});
    for (int i = 1; i <= 200; ++i)
      tick.step({needle = needle_pose(Vec3(-30.0, -22.0, 0.0), Vec3(0.005 * lean * i, -1.0, 0.0).normalized())});
    const Pose held = needle;
    const Wrench before = tick.step({needle}).requested;
    const Pose rigid = turned_about(Vec3(-30.0, -10.0, 0.0), Vec3(0.06, 0.0, -0.08), Vec3(0.5, -3.0, 0.3));
    ReleasedNeedle released;
    released.step(true, needle, tick.body()->tissue_motion());
    Wrench last = before;
    double farthest = 0.0;
    // Slowly, as by a pressing probe.
    for (int i = 0; i < 2000; ++i) {
      const double share = std::min(1.0, i / 1200.0);
      if (i % 16 == 0)
        motion->write({static_cast<std::uint64_t>(i) / 16 + 1,
                       moved_rigidly(block, turned_about(Vec3(-30.0, -10.0, 0.0), share * Vec3(0.06, 0.0, -0.08),
                                                         share * Vec3(0.5, -3.0, 0.3)))});
      last = tick.step({needle}).requested;
      farthest = std::max(farthest, (last.force - before.force).norm());
      const ReleasedNeedle::Step step = released.step(true, needle, tick.body()->tissue_motion());
      needle.translation() += step.by;
      needle.linear() = step.turn * needle.linear();
    }
    const Pose expected = rigid * held;
    EXPECT_LT((needle.linear().col(2) - expected.linear().col(2)).norm(), 1e-3);
    EXPECT_LT((needle.translation() - expected.translation()).norm(), 0.05);
    EXPECT_LT((last.force - before.force).norm(), 0.02);
    EXPECT_LT(farthest, 0.03) << "on the way, too";
    EXPECT_GT((expected.linear().col(2) - held.linear().col(2)).norm(), 0.05);
  }
}

// Bent tissue takes it to the straight line nearest to the tissue.
TEST(ReleasedTurn, in_bent_tissue_it_is_nearest_to_the_tissue) {
  const PressedBlock block = pressed_block();
  HapticTick tick(block.patient);
  const auto motion = std::make_shared<BodyMotion>();
  ASSERT_TRUE(tick.body()->move_with(motion));
  for (double depth = -2.0; depth < 22.0; depth += 0.05) tick.step({straight_down(-30.0, depth)});
  // Sideways by the square of the depth at the nodes; points between them move with their element.
  std::vector<float> moved;
  for (const Vec3& node : block.body->mesh.nodes) {
    const auto depth = static_cast<float>(node.y());
    moved.insert(moved.end(), {0.004F * depth * depth, 0.0F, 0.0F});
  }
  motion->write({1, moved});
  for (int i = 0; i < 600; ++i) tick.step({straight_down(-30.0, 22.0)});
  const Pose found = tick.body()->tissue_motion();
  const CondensedBody& points = *block.patient.prepared.body;
  const auto sum_of = [&](const Pose& line) {
    double sum = 0.0;
    for (std::size_t i = 0; i < points.nodes.size() && points.nodes[i].y() > -22.0; ++i) {
      Vec3 place = points.nodes[i];
      for (std::size_t corner = 0; corner < 4; ++corner)
        place.x() += points.in_mesh[i].weights[corner] *
                     static_cast<double>(moved[3 * std::size_t{points.in_mesh[i].nodes[corner]}]);
      sum += (line * points.nodes[i] - place).squaredNorm();
    }
    return sum;
  };
  const double least = sum_of(found);
  EXPECT_GT(least, 1e-3) << "it is bent";
  EXPECT_LT(least, 0.5 * sum_of(Pose::Identity()));
  Random random(3);
  for (int other = 0; other < 300; ++other) {
    Pose line = turned_about(Vec3(-30.0, -11.0, 0.0), 0.01 * Vec3(random.normal(), random.normal(), random.normal()),
                             0.05 * Vec3(random.normal(), random.normal(), random.normal())) *
                found;
    EXPECT_GE(sum_of(line), least - 1e-9);
  }
}

}  // namespace
}  // namespace bodkin
