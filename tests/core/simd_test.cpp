#include "core/simd.h"

#include <array>
#include <limits>

#include <gtest/gtest.h>

#include "core/geometry.h"

namespace bodkin {
namespace {

// A function compiled for several processors, as in the finite elements.
BODKIN_PROCESSOR_CLONES
void scale_and_sum(const double* numbers, double factor, double* scaled, double& sum) {
  const Lanes product = *lanes_at(numbers) * factor;
  *lanes_at(scaled) = product;
  sum = sum_of_lanes(product);
}

TEST(Simd, reads_and_writes_four_numbers_anywhere_in_an_array) {
  const std::array<double, 6> numbers = {9.0, 0.1, 0.2, 0.3, 0.7, 9.0};
  std::array<double, 6> scaled = {9.0, 9.0, 9.0, 9.0, 9.0, 9.0};
  double sum = 0.0;
  scale_and_sum(numbers.data() + 1, 3.0, scaled.data() + 1, sum);
  EXPECT_EQ(scaled, (std::array<double, 6>{9.0, 0.1 * 3.0, 0.2 * 3.0, 0.3 * 3.0, 0.7 * 3.0, 9.0}));
  EXPECT_EQ(sum, (0.1 * 3.0 + 0.2 * 3.0) + (0.3 * 3.0 + 0.7 * 3.0));
}

Vec3 vector_of(const LaneVector& vectors, std::size_t lane) {
  return {vectors.x[lane], vectors.y[lane], vectors.z[lane]};
}

Mat3 matrix_of(const LaneMatrix& matrices, std::size_t lane) {
  Mat3 matrix;
  for (int j = 0; j < 3; ++j) matrix.col(j) = vector_of(matrices.column[j], lane);
  return matrix;
}

LaneVector four_vectors(double seed) {
  const Lanes lane = {1.0, -2.0, 0.5, 3.0};
  return {lane + seed, seed * lane - 1.0, 2.0 - seed * lane * lane};
}

TEST(Simd, vectors_and_matrices_agree_with_eigen_in_each_lane) {
  const LaneVector a = four_vectors(0.3), b = four_vectors(-1.7);
  const LaneMatrix m = {{four_vectors(0.4), four_vectors(1.1), four_vectors(-0.6)}};
  const LaneMatrix n = {{four_vectors(2.0), four_vectors(-0.9), four_vectors(0.2)}};
  LaneVector cross, product, sum = a;
  LaneMatrix transposed;
  Lanes dot;
  cross_lanes(a, b, cross);
  dot_lanes(a, b, dot);
  add_lanes(b, Lanes{2.0, 3.0, 4.0, 5.0}, sum);
  multiply_lanes(m, a, product);
  multiply_transposed_lanes(m, n, transposed);
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    const Vec3 u = vector_of(a, lane), v = vector_of(b, lane);
    const Mat3 left = matrix_of(m, lane), right = matrix_of(n, lane);
    EXPECT_LT((vector_of(cross, lane) - u.cross(v)).norm(), 1e-12);
    EXPECT_NEAR(dot[lane], u.dot(v), 1e-12);
    EXPECT_LT((vector_of(sum, lane) - (u + (2.0 + static_cast<double>(lane)) * v)).norm(), 1e-12);
    EXPECT_LT((vector_of(product, lane) - left * u).norm(), 1e-12);
    EXPECT_LT((matrix_of(transposed, lane) - left.transpose() * right).norm(), 1e-12);
  }
}

TEST(Simd, bounds_a_number) {
  EXPECT_EQ(bounded(0.5F, 0.0F, 1.0F), 0.5F);
  EXPECT_EQ(bounded(-3.0F, 0.0F, 1.0F), 0.0F);
  EXPECT_EQ(bounded(std::numeric_limits<float>::infinity(), 0.0F, 1.0F), 1.0F);
  EXPECT_EQ(float_from_bits(0x3F800000U), 1.0F);
}

}  // namespace
}  // namespace bodkin
