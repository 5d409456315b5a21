#include "fem/moving/nearest_rotation.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {

using namespace bodkin::fem;
namespace {

Mat3 random_matrix(Random& random) {
  return Mat3::NullaryExpr([&random] { return random.normal(); });
}

// By the singular values, the smallest with the sign of the determinant.
Mat3 rotation_by_svd(const Mat3& f) {
  const Eigen::JacobiSVD<Mat3> svd(f, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() > 0.0 ? 1.0 : -1.0;
  return svd.matrixU() * Vec3(1.0, 1.0, sign).asDiagonal() * svd.matrixV().transpose();
}

TEST(NearestRotation, is_that_of_the_singular_values_whether_inverted_or_not) {
  Random random(1);
  int inverted = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const Mat3 f = random_matrix(random) * std::pow(10.0, random.uniform(-8.0, 8.0));
    inverted += f.determinant() < 0.0 ? 1 : 0;
    const Eigen::JacobiSVD<Mat3> svd(f);
    const Vec3 s = svd.singularValues();
    if (s(1) - s(2) < 1e-3 * s(0)) continue;  // nearly two nearest ones when inverted
    EXPECT_LT((nearest_rotation(f).toRotationMatrix() - rotation_by_svd(f)).norm(), 1e-11) << trial;
  }
  EXPECT_GT(inverted, 100);
}

TEST(NearestRotation, of_a_rotation_is_itself) {
  Random random(2);
  for (int trial = 0; trial < 100; ++trial) {
    const Mat3 rotation = rotation_by_svd(random_matrix(random));
    EXPECT_LT((nearest_rotation(rotation).toRotationMatrix() - rotation).norm(), 1e-13);
    EXPECT_LT((nearest_rotation(-rotation).toRotationMatrix().transpose() * rotation).trace(), -0.999999);
  }
}

TEST(NearestRotation, of_flat_empty_and_senseless_matrices_is_some_rotation) {
  Random random(3);
  const double huge = std::numeric_limits<double>::max(), tiny = std::numeric_limits<double>::denorm_min();
  std::vector<Mat3> matrices = {Mat3::Zero(),
                                Mat3::Constant(huge),
                                Mat3::Constant(tiny),
                                Mat3::Ones(),
                                Mat3::Constant(std::nan("")),
                                Mat3::Constant(std::numeric_limits<double>::infinity()),
                                Vec3(1.0, 0.0, 0.0).asDiagonal(),
                                Vec3(-1.0, -1.0, -1.0).asDiagonal(),
                                Vec3(1.0, 1.0, -1.0).asDiagonal(),
                                Vec3(1.0, 1.0, 0.0).asDiagonal()};
  for (int trial = 0; trial < 50; ++trial) {
    const Mat3 a = random_matrix(random), b = random_matrix(random);
    matrices.emplace_back(a.col(0) * b.row(0));
    matrices.emplace_back(a.col(0) * b.row(0) + a.col(1) * b.row(1));
  }
  for (const Mat3& f : matrices) {
    const Mat3 rotation = nearest_rotation(f).toRotationMatrix();
    EXPECT_LT((rotation.transpose() * rotation - Mat3::Identity()).norm(), 1e-12);
    EXPECT_NEAR(rotation.determinant(), 1.0, 1e-12);
  }
}

void put(const Mat3& matrix, std::size_t lane, LaneMatrix& into) {
  for (int j = 0; j < 3; ++j) {
    into.column[j].x[lane] = matrix(0, j);
    into.column[j].y[lane] = matrix(1, j);
    into.column[j].z[lane] = matrix(2, j);
  }
}

Mat3 taken(const LaneMatrix& from, std::size_t lane) {
  Mat3 matrix;
  for (int j = 0; j < 3; ++j)
    matrix.col(j) = Vec3(from.column[j].x[lane], from.column[j].y[lane], from.column[j].z[lane]);
  return matrix;
}

TEST(NearestRotation, four_at_once_are_the_same_wherever_they_say_that_they_have_settled) {
  Random random(4);
  int settled_lanes = 0, others = 0;
  for (int trial = 0; trial < 500; ++trial) {
    LaneMatrix f{}, rotation{};
    LaneQuaternion q{};
    LaneMask settled{};
    std::array<Mat3, lane_count> matrices;
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      matrices[lane] = random_matrix(random);
      if (trial == 7 && lane == 2) matrices[lane](1, 1) = std::nan("");
      put(matrices[lane], lane, f);
      q.w[lane] = random.normal();
      q.x[lane] = random.normal();
      q.y[lane] = random.normal();
      q.z[lane] = random.normal();
    }
    turn_to_nearest(f, q, rotation, settled);
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      EXPECT_TRUE(taken(rotation, lane).allFinite());
      (settled[lane] != 0 ? settled_lanes : others) += 1;
      if (settled[lane] == 0) continue;
      EXPECT_LT((taken(rotation, lane) - nearest_rotation(matrices[lane]).toRotationMatrix()).norm(), 1e-9) << trial;
    }
  }
  EXPECT_GT(settled_lanes, 100);
  EXPECT_GT(others, 100);
}

TEST(NearestRotation, four_at_once_settle_in_two_turns_from_nearby) {
  Random random(5);
  LaneMatrix f{}, rotation{};
  LaneQuaternion q{};
  LaneMask settled{};
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    const Mat3 turned =
        Eigen::AngleAxisd(0.05, Vec3(random.normal(), random.normal(), 1.0).normalized()).toRotationMatrix();
    put(turned * Vec3(1.2, 0.9, 0.8).asDiagonal(), lane, f);
    q.w[lane] = 1.0;
  }
  turn_to_nearest(f, q, rotation, settled);
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    EXPECT_NE(settled[lane], 0);
    EXPECT_LT((taken(rotation, lane) - nearest_rotation(taken(f, lane)).toRotationMatrix()).norm(), 1e-14);
  }
}

}  // namespace
}  // namespace bodkin
