// Registration against its closed forms, by trials.
#include "tracking/registration.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

#include "tracking/bead_centres.h"
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

// Fitzpatrick, West and Maurer 1998; 4000 trials, whose noise is about 1 %.
TEST(Registration, fre_and_tre_are_those_of_fitzpatrick) {
  Random random(11);
  const Vec3 target(60.0, 40.0, 120.0);
  const double fle = 0.6;
  for (const bool scaled : {false, true}) {
    double fre = 0.0, tre = 0.0;
    int within = 0;
    constexpr int trials = 4000;
    const Similarity truth = some_place(1.0);
    for (int n = 0; n < trials; ++n) {
      std::vector<Vec3> fixed;
      for (const Vec3& point : fiducials) fixed.push_back(truth * point + normal_point(random, fle / std::sqrt(3.0)));
      const Registration found = register_points(fixed, fiducials, scaled);
      fre += found.fre_rms * found.fre_rms;
      tre += (found.fixed_from_moving * target - truth * target).squaredNorm();
      const ErrorInterval interval = tre_interval(found, fiducials, target);
      const double expected = predicted_tre(fiducials, target, fle, scaled);
      within += interval.low <= expected && expected <= interval.high ? 1 : 0;
    }
    const double expected_tre = predicted_tre(fiducials, target, fle, scaled);
    EXPECT_NEAR(fre / trials / std::pow(expected_fre(fle, fiducials.size(), scaled), 2), 1.0, 0.03) << scaled;
    EXPECT_NEAR(tre / trials / (expected_tre * expected_tre), 1.0, 0.06) << scaled;
    EXPECT_NEAR(within / static_cast<double>(trials), 0.90, 0.02) << scaled;
  }
}

TEST(Registration, unequal_errors_are_propagated) {
  Random random(12);
  const Vec3 target(60.0, 40.0, 120.0);
  const Mat3 covariance = Vec3(0.01, 0.01, 0.36).asDiagonal();
  const Similarity truth = some_place(1.0);
  const std::vector<Mat3> told(fiducials.size(), 4.0 * covariance);  // right but for a factor
  double sum = 0.0;
  constexpr int trials = 4000;
  std::vector<ErrorInterval> intervals;
  Registration last;
  for (int n = 0; n < trials; ++n) {
    std::vector<Vec3> fixed;
    for (const Vec3& point : fiducials)
      fixed.push_back(truth * point + Vec3(0.1, 0.1, 0.6).cwiseProduct(normal_point(random, 1.0)));
    last = register_points(fixed, fiducials, false);
    sum += (last.fixed_from_moving * target - truth * target).squaredNorm();
    intervals.push_back(tre_interval(last, fiducials, told, target));
  }
  const double found = std::sqrt(sum / trials);
  const auto within = std::count_if(intervals.begin(), intervals.end(), [&](const ErrorInterval& interval) {
    return interval.low <= found && found <= interval.high;
  });
  EXPECT_NEAR(static_cast<double>(within) / trials, 0.90, 0.03);
  const Mat3 predicted = target_covariance(last, fiducials, std::vector<Mat3>(fiducials.size(), covariance), target);
  EXPECT_NEAR(std::sqrt(sum / trials / predicted.trace()), 1.0, 0.05);
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

TEST(Registration, points_without_names_find_their_partners) {
  Random random(13);
  int right = 0, ambiguous = 0;
  constexpr int trials = 60;
  for (int n = 0; n < trials; ++n) {
    const int count = 4 + n % 5;
    std::vector<Vec3> moving;
    for (int i = 0; i < count; ++i) moving.push_back(normal_point(random, 60.0));
    const Similarity truth = some_place(1.0);
    std::vector<Vec3> fixed;
    for (const Vec3& point : moving) fixed.push_back(truth * point + normal_point(random, 0.35));
    // One is missing where there are enough, and one of another thing is seen.
    std::vector<std::size_t> partner;
    for (std::size_t i = 0; i < fixed.size(); ++i) partner.push_back(i);
    if (count > 5) {
      fixed.erase(fixed.begin());
      partner.erase(partner.begin());
    }
    std::reverse(fixed.begin(), fixed.end());
    std::reverse(partner.begin(), partner.end());
    const PointMatch match = match_points(fixed, moving);
    if (match.ambiguous) {
      ++ambiguous;
      continue;
    }
    bool good = true;
    for (std::size_t i = 0; i < fixed.size(); ++i) good = good && match.moving_of_fixed[i] == partner[i];
    right += good ? 1 : 0;
  }
  EXPECT_EQ(right + ambiguous, trials);
  EXPECT_LT(ambiguous, trials / 4);
}

TEST(Registration, a_symmetric_layout_is_called_ambiguous) {
  const std::vector<Vec3> square = {{0, 0, 0}, {50, 0, 0}, {50, 50, 0}, {0, 50, 0}};
  EXPECT_TRUE(match_points(square, square).ambiguous);
}

TEST(Registration, exchanged_names_are_noticed) {
  std::vector<Vec3> exchanged = fiducials;
  std::swap(exchanged[1], exchanged[4]);
  const auto found = swapped_pair(fiducials, exchanged, false);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(*found, (std::pair<std::size_t, std::size_t>(1, 4)));
  EXPECT_FALSE(swapped_pair(fiducials, fiducials, false).has_value());
}

// Balls of 2 mm radius in foam, with voxels that they fill in part.
// Noise alone pretends a scale about once in a thousand registrations; a print that is 1 % too large is noticed.
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

TEST(BeadCentres, are_found_within_a_tenth_of_a_millimetre) {
  anatomy::Grid grid;
  grid.size = {70, 60, 40};
  grid.spacing = Vec3(0.98, 0.98, 1.25);
  grid.origin = Vec3(-30.0, 12.0, 5.0);
  anatomy::CtVolume ct(grid, -900);
  const std::vector<Vec3> centres = {{-12.3, 30.2, 20.4}, {8.71, 44.9, 33.33}, {20.0, 25.5, 40.1}};
  Random random(4);
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        int inside = 0;
        for (int s = 0; s < 216; ++s) {
          const Vec3 at = grid.to_patient(
              Vec3(i + (s % 6 + 0.5) / 6.0 - 0.5, j + (s / 6 % 6 + 0.5) / 6.0 - 0.5, k + (s / 36 + 0.5) / 6.0 - 0.5));
          for (const Vec3& centre : centres) inside += (at - centre).norm() < 2.0 ? 1 : 0;
        }
        const double value = -900.0 + 3400.0 * inside / 216.0 + 15.0 * random.normal();
        ct.at(i, j, k) = static_cast<std::int16_t>(std::lround(std::clamp(value, -1024.0, 3071.0)));
      }
    }
  }
  const std::vector<Bead> beads = find_beads(ct);
  ASSERT_EQ(beads.size(), centres.size());
  for (const Vec3& centre : centres) {
    double least = 1e9;
    for (const Bead& bead : beads) least = std::min(least, (bead.centre - centre).norm());
    EXPECT_LT(least, 0.1);
  }
}

}  // namespace
}  // namespace bodkin::tracking
