#include "fem/solid/dense_front.h"

#include <limits>
#include <vector>

#include "tests/fem/lattice_body.h"
#include "tests/sanitized.h"
#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::fem;
namespace {

Eigen::MatrixXd random_positive(Eigen::Index size, std::uint64_t seed) {
  Random random(seed);
  const Eigen::MatrixXd any = Eigen::MatrixXd::NullaryExpr(size, size, [&random] { return random.normal(); });
  return any * any.transpose() + 0.1 * static_cast<double>(size) * Eigen::MatrixXd::Identity(size, size);
}

// Widths and heights below, at and above the tiles.
TEST(DenseFront, agrees_with_the_factor_of_the_whole_matrix) {
  struct Size {
    Eigen::Index width, height;
  };
  for (const auto& [width, height] : {Size{3, 3}, Size{30, 90}, Size{192, 192}, Size{400, 400}, Size{250, 1300}}) {
    if (sanitized && height > 400) continue;
    const Eigen::MatrixXd whole = random_positive(height, 1);
    const Eigen::Index below = height - width;
    const Eigen::MatrixXd expected = whole.llt().matrixL();
    const Eigen::MatrixXd expected_rest =
        whole.bottomRightCorner(below, below) -
        expected.bottomLeftCorner(below, width) * expected.bottomLeftCorner(below, width).transpose();
    ThreadPool pool(3);
    Eigen::MatrixXd panel = whole.leftCols(width), update = whole.bottomRightCorner(below, below);
    ASSERT_EQ(factorise_front(pool, static_cast<std::size_t>(width), static_cast<std::size_t>(height), panel.data(),
                              update.data()),
              static_cast<std::size_t>(width));
    const Eigen::MatrixXd found = panel.triangularView<Eigen::Lower>();
    EXPECT_LT((found - expected.leftCols(width)).cwiseAbs().maxCoeff(), 1e-12 * expected.maxCoeff()) << height;
    const Eigen::MatrixXd rest = (update - expected_rest).triangularView<Eigen::Lower>();
    if (below > 0) {
      EXPECT_LT(rest.cwiseAbs().maxCoeff(), 1e-12 * whole.maxCoeff()) << height;
    }
  }
}

TEST(DenseFront, names_the_column_without_a_pivot) {
  for (const Eigen::Index size : {40, 500}) {
    Eigen::MatrixXd matrix = random_positive(size, 2);
    const Eigen::Index bad = size - 7;
    matrix(bad, bad) = -1.0;
    ThreadPool pool(2);
    EXPECT_EQ(
        factorise_front(pool, static_cast<std::size_t>(size), static_cast<std::size_t>(size), matrix.data(), nullptr),
        static_cast<std::size_t>(bad));
  }
}

TEST(DenseFront, inverts_from_the_lower_triangle_alone) {
  for (const Eigen::Index size : {1, 191, 192, 193, 600}) {
    if (sanitized && size > 200) continue;
    const Eigen::MatrixXd matrix = random_positive(size, 3);
    Eigen::MatrixXd lower = matrix.llt().matrixL();
    lower.triangularView<Eigen::StrictlyUpper>().setConstant(std::numeric_limits<double>::quiet_NaN());
    Eigen::MatrixXd inverse = Eigen::MatrixXd::Constant(size, size, std::numeric_limits<double>::quiet_NaN());
    ThreadPool pool(3);
    invert_from_lower(pool, static_cast<std::size_t>(size), lower.data(), inverse.data());
    EXPECT_EQ((inverse - inverse.transpose()).cwiseAbs().maxCoeff(), 0.0);
    const Eigen::MatrixXd identity = inverse * matrix - Eigen::MatrixXd::Identity(size, size);
    EXPECT_LT(identity.cwiseAbs().maxCoeff(), 1e-12) << size;
  }
}

// Widths and heights beside the sizes of all tiles.
TEST(DenseFront, has_the_same_bits_with_every_instruction_set) {
  if (dense_tiles().size() < 2) GTEST_SKIP() << "this processor has only the plain instructions";
  struct Size {
    Eigen::Index width, height;
  };
  for (const auto& [width, height] :
       {Size{1, 1}, Size{3, 4}, Size{12, 31}, Size{47, 120}, Size{49, 97}, Size{200, 330}}) {
    const Eigen::MatrixXd whole = random_positive(height, 4);
    const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
    ThreadPool pool(2);
    Eigen::MatrixXd first_panel, first_update, first_inverse;
    for (const DenseTiles& tiles : dense_tiles()) {
      Eigen::MatrixXd panel = whole.leftCols(width), update = whole.bottomRightCorner(height - width, height - width);
      ASSERT_EQ(factorise_front(pool, w, h, panel.data(), update.data(), tiles), w);
      Eigen::MatrixXd lower = whole.llt().matrixL(), inverse(height, height);
      invert_from_lower(pool, h, lower.data(), inverse.data(), tiles);
      if (first_panel.size() == 0) {
        first_panel = panel;
        first_update = update;
        first_inverse = inverse;
      }
      EXPECT_TRUE(panel == first_panel && update == first_update && inverse == first_inverse)
          << tiles.name << ", " << width << " columns of " << height;
    }
  }
}

// The corridor's front and those next to it are cut into several tiles.
TEST(DenseFront, a_body_has_the_same_bits_for_any_number_of_threads) {
  const BodyDescription body = lattice_body(sanitized ? 9 : 14, 80.0, 0.1, sanitized ? 150 : 300);
  FactorOptions options;
  options.threads = 1;
  const Eigen::MatrixXd alone = condense(body, options).compliance;
  for (const int threads : {0, 2, 3, 8}) {
    options.threads = threads;
    EXPECT_EQ(condense(body, options).compliance, alone) << threads;
  }
}

}  // namespace
}  // namespace bodkin
