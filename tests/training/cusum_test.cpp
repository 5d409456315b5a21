#include "training/cusum.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"

namespace bodkin {

using namespace bodkin::training;
namespace {

// For p0 = 0.1, p1 = 0.3 and both errors 0.1 the literature gives s = 0.186, h0 = h1 = 1.63.
TEST(Cusum, has_the_limits_that_the_formulas_give) {
  const Cusum cusum({});
  const double p = std::log(3.0), q = std::log(9.0 / 7.0);
  EXPECT_NEAR(cusum.step(), q / (p + q), 1e-12);
  EXPECT_NEAR(cusum.step(), 0.186, 0.001);
  EXPECT_NEAR(cusum.lower(), 1.63, 0.005);
  EXPECT_NEAR(cusum.upper(), 1.63, 0.005);
}

// The number of successes in a row that shows mastery: the least n with n s >= h0, here 9.
TEST(Cusum, crosses_where_theory_says) {
  const Cusum cusum({});
  const std::vector<char> successes(30, 0);
  const auto good = cusum.curve(successes);
  const auto needed = static_cast<std::size_t>(std::ceil(cusum.lower() / cusum.step()));
  EXPECT_EQ(needed, 9U);
  for (std::size_t i = 0; i + 1 < needed; ++i) EXPECT_FALSE(good[i].mastery);
  EXPECT_TRUE(good[needed - 1].mastery);
  EXPECT_TRUE(good[2 * needed - 1].mastery) << "the test begins anew";
  const auto bad = cusum.curve(std::vector<char>(5, 1));
  EXPECT_FALSE(bad[1].failing);
  EXPECT_TRUE(bad[2].failing);  // 3 (1 - s) = 2.44 is past 1.63, 2 (1 - s) = 1.627 is not
}

// A trainee at the acceptable rate is rejected first with a probability of about alpha, one at the unacceptable rate
// is accepted first with about beta (Wald: errors are at most alpha/(1 - beta), beta/(1 - alpha)).
TEST(Cusum, errs_no_more_often_than_it_promises) {
  const Cusum cusum({});
  for (const bool masters : {true, false}) {
    Random random(masters ? 1 : 2);
    int wrong = 0;
    constexpr int trainees = 2000;
    for (int trainee = 0; trainee < trainees; ++trainee) {
      std::vector<char> failed;
      for (int i = 0; i < 400; ++i) failed.push_back(random.uniform() < (masters ? 0.1 : 0.3) ? 1 : 0);
      for (const Cusum::Point& point : cusum.curve(failed)) {
        if (!point.mastery && !point.failing) continue;
        wrong += point.mastery != masters ? 1 : 0;
        break;
      }
    }
    EXPECT_LT(wrong, trainees * 0.1 / 0.9 + 3.0 * std::sqrt(trainees * 0.1)) << masters;
  }
}

TEST(Cusum, refuses_rates_that_are_none) {
  EXPECT_THROW(Cusum({.acceptable = 0.3, .unacceptable = 0.3}), InputError);
  EXPECT_THROW(Cusum({.acceptable = 0.0}), InputError);
  EXPECT_THROW(Cusum({.alpha = 0.5}), InputError);
}

}  // namespace
}  // namespace bodkin
