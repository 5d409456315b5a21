#include "fem/upper_triangular.h"

#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "core/random.h"

// A Cholesky factor that follows its matrix, against Eigen's factor of the new matrix.

namespace bodkin {
namespace {

using fem::upper_triangular::padded;

// U^T U = A, its rows padded as the kernels want them.
struct Factor {
  explicit Factor(const Eigen::MatrixXd& matrix)
      : rows(static_cast<std::size_t>(matrix.rows())), numbers(padded(rows) * padded(rows), 0.0) {
    const Eigen::MatrixXd upper = matrix.llt().matrixU();
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t j = i; j < rows; ++j)
        numbers[i * padded(rows) + j] = upper(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  }
  // The largest difference from the factor of this matrix.
  double difference(const Eigen::MatrixXd& matrix) const {
    const Factor expected(matrix);
    double worst = 0.0;
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t j = i; j < rows; ++j)
        worst = std::max(worst, std::abs(numbers[i * padded(rows) + j] - expected.numbers[i * padded(rows) + j]));
    return worst;
  }

  std::size_t rows;
  std::vector<double> numbers;
};

Eigen::MatrixXd any_matrix(Random& random, Eigen::Index rows, Eigen::Index columns) {
  Eigen::MatrixXd made(rows, columns);
  for (double& number : made.reshaped()) number = random.normal();
  return made;
}

TEST(UpperTriangular, a_factor_follows_what_is_added_to_its_matrix_and_subtracted_from_it) {
  Random random(1);
  for (const Eigen::Index size : {1, 2, 3, 7, 8, 9, 31, 64, 101}) {
    const Eigen::MatrixXd root = any_matrix(random, size, size);
    const Eigen::MatrixXd smaller = root * root.transpose() + Eigen::MatrixXd::Identity(size, size);
    const Eigen::MatrixXd both = any_matrix(random, size, 2);
    const Eigen::MatrixXd larger = smaller + both * both.transpose();
    const auto numbers_of = [&](Eigen::Index column) {
      return std::vector<double>(both.col(column).begin(), both.col(column).end());
    };
    const std::size_t rows = static_cast<std::size_t>(size), stride = padded(rows);
    const std::vector<double> least(rows, 0.0);

    Factor factor(smaller);
    std::vector<double> a = numbers_of(0), b = numbers_of(1);
    fem::upper_triangular::add_squares_to_factor(factor.numbers.data(), stride, rows, a.data(), b.data());
    EXPECT_LT(factor.difference(larger), 1e-12 * static_cast<double>(size * size)) << size;

    a = numbers_of(0), b = numbers_of(1);
    EXPECT_TRUE(fem::upper_triangular::subtract_squares_from_factor(factor.numbers.data(), stride, rows, a.data(),
                                                                    b.data(), least.data()));
    EXPECT_LT(factor.difference(smaller), 1e-11 * static_cast<double>(size * size)) << size;
  }
}

TEST(UpperTriangular, what_would_leave_no_positive_matrix_is_refused) {
  Random random(2);
  const Eigen::Index size = 20;
  const Eigen::MatrixXd root = any_matrix(random, size, size);
  const Eigen::MatrixXd matrix = root * root.transpose() + Eigen::MatrixXd::Identity(size, size);
  const std::vector<double> least(static_cast<std::size_t>(size), 0.0);
  // x^T A^-1 x = 1.02, of which each of the two vectors has half: A - a a^T - b b^T is indefinite.
  Eigen::VectorXd direction = any_matrix(random, size, 1);
  direction *= std::sqrt(1.02 / direction.dot(matrix.ldlt().solve(direction)) / 2.0);
  Factor factor(matrix);
  std::vector<double> a(direction.begin(), direction.end()), b = a;
  EXPECT_FALSE(fem::upper_triangular::subtract_squares_from_factor(factor.numbers.data(), padded(20), 20, a.data(),
                                                                   b.data(), least.data()));
}

}  // namespace
}  // namespace bodkin
