// Registration against its closed forms, by trials.
#include "tracking/registration.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"

namespace bodkin::tracking {
namespace {

Vec3 normal_point(Random& random, double deviation) {
  const double x = random.normal();
  const double y = random.normal();
  const double z = random.normal();
  return deviation * Vec3(x, y, z);
}

Similarity some_place(double scale) {
  Similarity place;
  place.turn = Eigen::AngleAxisd(1.1, Vec3(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  place.shift = Vec3(40.0, -12.0, 300.0);
  place.scale = scale;
  return place;
}

const std::vector<Vec3> fiducials = {{0.0, 0.0, 0.0},    {120.0, 5.0, 10.0}, {30.0, 90.0, -15.0},
                                     {80.0, 60.0, 40.0}, {10.0, 50.0, 55.0}, {100.0, -30.0, 25.0}};

TEST(Registration, exact_points_give_the_exact_place_with_and_without_scale) {
  for (const double scale : {1.0, 1.07}) {
    const Similarity truth = some_place(scale);
    std::vector<Vec3> fixed;
    for (const Vec3& point : fiducials) fixed.push_back(truth * point);
    const Registration found = register_points(fixed, fiducials, scale != 1.0);
    EXPECT_LT(found.fre_rms, 1e-9);
    EXPECT_NEAR(found.fixed_from_moving.scale, scale, 1e-12);
    EXPECT_TRUE(found.fixed_from_moving.turn.isApprox(truth.turn, 1e-10));
    const Vec3 back = found.fixed_from_moving.inverse() * (truth * Vec3(7.0, 8.0, 9.0));
    EXPECT_TRUE(back.isApprox(Vec3(7.0, 8.0, 9.0), 1e-9));
  }
}

TEST(Registration, equal_covariances_give_the_interval_of_equal_errors) {
  Random random(14);
  std::vector<Vec3> fixed;
  for (const Vec3& point : fiducials) fixed.push_back(some_place(1.0) * point + normal_point(random, 0.3));
  const Vec3 target(60.0, 40.0, 120.0);
  for (const bool scaled : {false, true}) {
    const Registration found = register_points(fixed, fiducials, scaled);
    const ErrorInterval equal = tre_interval(found, fiducials, target);
    const ErrorInterval same =
        tre_interval(found, fiducials, std::vector<Mat3>(fiducials.size(), 0.5 * Mat3::Identity()), target);
    EXPECT_NEAR(same.low / equal.low, 1.0, 0.02);
    EXPECT_NEAR(same.estimate / equal.estimate, 1.0, 0.02);
    EXPECT_NEAR(same.high / equal.high, 1.0, 0.02);
  }
}

TEST(Registration, too_few_points_and_points_on_a_line_are_refused) {
  const std::vector<Vec3> line = {{0, 0, 0}, {10, 0, 0}, {20, 0, 0}, {50, 0, 0}};
  EXPECT_THROW(register_points(line, line, false), InputError);
  const std::vector<Vec3> two = {{0, 0, 0}, {10, 0, 0}}, three = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}};
  EXPECT_THROW(register_points(two, two, false), InputError);
  EXPECT_THROW(register_points(three, three, true), InputError);
  EXPECT_NO_THROW(register_points(three, three, false));
  EXPECT_THROW(register_points(three, two, false), InputError);
}

TEST(Registration, a_symmetric_layout_is_called_ambiguous) {
  const std::vector<Vec3> square = {{0, 0, 0}, {50, 0, 0}, {50, 50, 0}, {0, 50, 0}};
  EXPECT_TRUE(match_points(square, square).ambiguous);
}

TEST(Registration, exchanged_names_are_noticed) {
  std::vector<Vec3> exchanged = fiducials;
  std::swap(exchanged[1], exchanged[4]);
  const std::vector<std::pair<std::size_t, std::size_t>> found = swapped_pairs(fiducials, exchanged, false);
  EXPECT_EQ(found, (std::vector<std::pair<std::size_t, std::size_t>>{{1, 4}}));
  EXPECT_TRUE(swapped_pairs(fiducials, fiducials, false).empty());
}

// Points located with 1 mm RMS: exchanged names are reported, correct ones are not.
TEST(Registration, exchanged_names_are_noticed_in_noise_and_none_are_made_up) {
  constexpr int trials = 2000;
  constexpr double deviation = 0.58;  // mm along each axis
  for (const std::size_t count : {std::size_t{4}, std::size_t{5}, std::size_t{6}, std::size_t{8}}) {
    for (const bool scaled : {false, true}) {
      Random random(500U + 10U * count + (scaled ? 1U : 0U));
      int made_up = 0, named = 0;
      for (int trial = 0; trial < trials; ++trial) {
        std::vector<Vec3> fixed, moving;
        for (std::size_t i = 0; i < count; ++i) {
          moving.push_back(normal_point(random, 60.0));
          fixed.push_back(some_place(1.0) * moving.back() + normal_point(random, deviation));
        }
        made_up += swapped_pairs(fixed, moving, scaled).empty() ? 0 : 1;
        const std::size_t one = static_cast<std::size_t>(trial) % (count - 1);
        std::swap(moving[one], moving[count - 1]);
        const auto found = swapped_pairs(fixed, moving, scaled);
        const std::pair<std::size_t, std::size_t> truth(one, count - 1);
        named += std::find(found.begin(), found.end(), truth) != found.end() ? 1 : 0;
      }
      std::printf("%zu points%s: %d exchanges made up, %d named of %d\n", count, scaled ? ", scale" : "", made_up,
                  named, trials);
      EXPECT_EQ(made_up, 0);
      EXPECT_GE(named, trials - 2);
    }
  }
}

// Noise alone suggests a scale about once in a thousand registrations; a print that is 1 % too large is noticed.
TEST(Registration, a_print_that_is_not_to_scale_is_noticed) {
  Random random(17);
  const auto noise = [&](double size) {
    const double x = random.normal(), y = random.normal(), z = random.normal();
    return Vec3(size * Vec3(x, y, z));
  };
  for (const std::size_t count : {std::size_t{4}, std::size_t{6}, std::size_t{8}}) {
    int pretended = 0, found = 0;
    constexpr int trials = 4000;
    for (int trial = 0; trial < trials; ++trial) {
      std::vector<Vec3> moving, same, larger;
      for (std::size_t i = 0; i < count; ++i) {
        moving.push_back(noise(60.0));
        same.push_back(moving.back() + noise(0.5));
        larger.push_back(1.01 * moving.back() + noise(0.05));
      }
      pretended += hidden_scale(same, moving) ? 1 : 0;
      const std::optional<double> scale = hidden_scale(larger, moving);
      found += scale && std::abs(*scale - 1.01) < 0.002 ? 1 : 0;
    }
    std::printf("%zu points: pretended %d, found %d of %d\n", count, pretended, found, trials);
    EXPECT_LE(pretended, 16);  // four in a thousand, far beyond chance for one in a thousand
    EXPECT_GT(found, 0.97 * trials);
  }
  const std::vector<Vec3> three = {Vec3(0, 0, 0), Vec3(90, 0, 0), Vec3(0, 70, 0)};
  std::vector<Vec3> scaled = three;
  for (Vec3& point : scaled) point *= 1.02;
  EXPECT_FALSE(hidden_scale(scaled, three).has_value());
}

}  // namespace
}  // namespace bodkin::tracking
