#include "core/random.h"

#include <gtest/gtest.h>

namespace bodkin {
namespace {

TEST(Random, hash_noise_stays_within_its_range_and_has_no_mean) {
  double sum = 0.0;
  constexpr int cells = 100000;
  for (int cell = -cells / 2; cell < cells / 2; ++cell) {
    const double value = hash_noise(7, cell);
    ASSERT_GE(value, -1.0);
    ASSERT_LT(value, 1.0);
    sum += value;
  }
  EXPECT_NEAR(sum / cells, 0.0, 0.01);  // standard error of the mean is 0.0018
}

TEST(Random, normal_has_mean_zero_and_variance_one) {
  Random random(42);
  double sum = 0.0, squares = 0.0;
  constexpr int draws = 200000;
  for (int draw = 0; draw < draws; ++draw) {
    const double value = random.normal();
    sum += value;
    squares += value * value;
  }
  EXPECT_NEAR(sum / draws, 0.0, 0.01);
  EXPECT_NEAR(squares / draws, 1.0, 0.02);
}

TEST(Random, equal_seeds_give_equal_sequences_and_neighbouring_seeds_do_not) {
  Random a(1), b(1), c(2);
  const auto first = a.next();
  EXPECT_EQ(first, b.next());
  EXPECT_NE(first, c.next());
}

}  // namespace
}  // namespace bodkin
