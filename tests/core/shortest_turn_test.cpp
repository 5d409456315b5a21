#include "core/shortest_turn.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace bodkin {
namespace {

TEST(ShortestTurn, takes_one_direction_to_the_other_by_the_angle_between_them) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 from(normal(random), normal(random), normal(random)),
        to(normal(random), normal(random), normal(random));
    const Eigen::Quaterniond turn = shortest_turn(from, to);
    EXPECT_NEAR(turn.norm(), 1.0, 1e-12);
    EXPECT_LT((turn * from.normalized() - to.normalized()).norm(), 1e-12);
    EXPECT_NEAR(2.0 * std::acos(std::abs(turn.w())), std::acos(from.normalized().dot(to.normalized())), 1e-6);
  }
}

TEST(ShortestTurn, of_opposite_directions_is_half_a_turn) {
  for (const Vec3& from : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitZ()), Vec3(1.0, -2.0, 0.5)}) {
    const Eigen::Quaterniond turn = shortest_turn(from, -3.0 * from);
    EXPECT_LT((turn * from + from).norm(), 1e-9 * from.norm());
    EXPECT_NEAR(turn.w(), 0.0, 1e-9);
  }
}

}  // namespace
}  // namespace bodkin
