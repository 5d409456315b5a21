// The accuracy of registration, by the number of trials stated in docs/augmented-reality.md; each row is printed.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <optional>
#include <vector>

#include "tracking/bead_centres.h"
#include "tracking/registration.h"
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"

namespace bodkin::tracking {
namespace {

constexpr int trials = 10000;
constexpr double fle = 0.6;  // mm, RMS length

Vec3 noise(Random& random, const Vec3& deviation) {
  const double x = random.normal();
  const double y = random.normal();
  const double z = random.normal();
  return deviation.cwiseProduct(Vec3(x, y, z));
}

Similarity place_in_room() {
  Similarity place;
  place.turn = Eigen::AngleAxisd(-0.8, Vec3(0.3, 1.0, -0.6).normalized()).toRotationMatrix();
  place.shift = Vec3(-25.0, 60.0, 410.0);
  return place;
}

// Points that do not lie on a line.
std::vector<Vec3> layout(std::size_t count) {
  const std::vector<Vec3> all = {{0.0, 0.0, 0.0},    {120.0, 5.0, 10.0}, {30.0, 90.0, -15.0},  {80.0, 60.0, 40.0},
                                 {10.0, 50.0, 55.0}, {100., -30.0, 25.}, {-40.0, -20.0, 30.0}, {60.0, 20.0, -50.0}};
  return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)};
}

// Mean and standard error of the mean.
struct Mean {
  double sum = 0.0, squares = 0.0;
  void add(double value) {
    sum += value;
    squares += value * value;
  }
  double mean() const { return sum / trials; }
  double error() const { return std::sqrt((squares / trials - mean() * mean()) / trials); }
};

struct Row {
  Mean fre, tre;        // squares, mm^2
  double within = 0.0;  // share of the trials whose interval contains the RMS of TRE
  double below = 0.0;   // share of the trials whose own TRE is below the upper end of their interval
};

Row row_of(const std::vector<Vec3>& points, const Vec3& target, bool scaled, std::uint64_t seed) {
  Random random(seed);
  const Similarity truth = place_in_room();
  const double expected = predicted_tre(points, target, fle, scaled);
  Row row;
  int within = 0, below = 0;
  for (int n = 0; n < trials; ++n) {
    std::vector<Vec3> fixed;
    for (const Vec3& point : points)
      fixed.push_back(truth * point + noise(random, Vec3::Constant(fle / std::sqrt(3.0))));
    const Registration found = register_points(fixed, points, scaled);
    row.fre.add(found.fre_rms * found.fre_rms);
    row.tre.add((found.fixed_from_moving * target - truth * target).squaredNorm());
    const ErrorInterval interval = tre_interval(found, points, target);
    within += interval.low <= expected && expected <= interval.high ? 1 : 0;
    below += (found.fixed_from_moving * target - truth * target).norm() <= interval.high ? 1 : 0;
  }
  row.within = static_cast<double>(within) / trials;
  row.below = static_cast<double>(below) / trials;
  return row;
}

// FRE^2 = FLE^2 (1 - 6/(3k)), with scale 7 for 6; TRE by Fitzpatrick, West and Maurer 1998, with the term of scale.
TEST(RegistrationAccuracy, fre_and_tre_of_four_to_eight_points_are_the_closed_forms) {
  const Vec3 target(60.0, 40.0, 120.0);
  for (std::size_t count = 4; count <= 8; ++count) {
    for (const bool scaled : {false, true}) {
      const std::vector<Vec3> points = layout(count);
      const Row row = row_of(points, target, scaled, 100U + 10U * count + (scaled ? 1U : 0U));
      const double left = 1.0 - (scaled ? 7.0 : 6.0) / (3.0 * static_cast<double>(count));
      const double fre = fle * fle * left, tre = std::pow(predicted_tre(points, target, fle, scaled), 2);
      std::printf(
          "%zu points%s: FRE^2 %.4f of %.4f (%+.2f %%), TRE^2 %.4f of %.4f (%+.2f %%), interval holds the RMS in "
          "%.1f %%, "
          "own TRE below its upper end in %.1f %%\n",
          count, scaled ? ", scale" : "", row.fre.mean(), fre, 100.0 * (row.fre.mean() / fre - 1.0), row.tre.mean(),
          tre, 100.0 * (row.tre.mean() / tre - 1.0), 100.0 * row.within, 100.0 * row.below);
      EXPECT_NEAR(row.fre.mean(), fre, std::min(3.0 * row.fre.error(), 0.02 * fre));
      EXPECT_NEAR(row.tre.mean(), tre, std::min(3.0 * row.tre.error(), 0.02 * tre));
      EXPECT_NEAR(row.within, 0.90, 0.01);
    }
  }
}

TEST(RegistrationAccuracy, points_nearly_on_a_line_keep_within_5_percent_with_and_without_scale) {
  const Vec3 target(30.0, 20.0, 60.0);
  for (std::size_t count = 4; count <= 8; ++count) {
    std::vector<Vec3> points;
    for (const Vec3& point : layout(count))  // into a box of 4 x 4 x 140 mm
      points.push_back((point + Vec3(40.0, 30.0, 50.0)).cwiseProduct(Vec3(4.0 / 160.0, 4.0 / 120.0, 140.0 / 105.0)));
    for (const bool scaled : {false, true}) {
      const Row row = row_of(points, target, scaled, (scaled ? 250U : 200U) + count);
      const double left = 1.0 - (scaled ? 7.0 : 6.0) / (3.0 * static_cast<double>(count));
      const double fre = fle * fle * left, tre = std::pow(predicted_tre(points, target, fle, scaled), 2);
      std::printf("%zu points nearly on a line%s: FRE^2 %.4f of %.4f (%+.2f %%), TRE^2 %.3f of %.3f (%+.2f %%)\n",
                  count, scaled ? ", scale" : "", row.fre.mean(), fre, 100.0 * (row.fre.mean() / fre - 1.0),
                  row.tre.mean(), tre, 100.0 * (row.tre.mean() / tre - 1.0));
      EXPECT_NEAR(row.fre.mean() / fre, 1.0, 0.05);
      EXPECT_NEAR(row.tre.mean() / tre, 1.0, 0.05);
    }
  }
}

// One camera measures depth six times worse than the other coordinates.
TEST(RegistrationAccuracy, unequal_errors_are_propagated_within_5_percent) {
  const Vec3 target(60.0, 40.0, 120.0), deviation(0.1, 0.1, 0.6);
  const Mat3 covariance = deviation.cwiseAbs2().asDiagonal();
  for (std::size_t count = 4; count <= 8; ++count) {
    const std::vector<Vec3> points = layout(count);
    Random random(300U + count);
    const Similarity truth = place_in_room();
    const std::vector<Mat3> told(count, 4.0 * covariance);  // right up to a factor
    Mean tre;
    std::vector<ErrorInterval> intervals;
    Registration last;
    for (int n = 0; n < trials; ++n) {
      std::vector<Vec3> fixed;
      for (const Vec3& point : points) fixed.push_back(truth * point + noise(random, deviation));
      last = register_points(fixed, points, false);
      tre.add((last.fixed_from_moving * target - truth * target).squaredNorm());
      intervals.push_back(tre_interval(last, points, told, target));
    }
    Registration exact;
    exact.fixed_from_moving = truth;
    const double predicted = target_covariance(exact, points, std::vector<Mat3>(count, covariance), target).trace();
    const double found = std::sqrt(tre.mean());
    const auto within = std::count_if(intervals.begin(), intervals.end(), [&](const ErrorInterval& interval) {
      return interval.low <= found && found <= interval.high;
    });
    std::printf(
        "%zu points, depth six times worse: TRE %.3f of %.3f mm (%+.2f %%), interval holds the RMS in %.1f %%\n",
        count, found, std::sqrt(predicted), 100.0 * (found / std::sqrt(predicted) - 1.0),
        100.0 * static_cast<double>(within) / trials);
    EXPECT_NEAR(found / std::sqrt(predicted), 1.0, 0.05);
    EXPECT_NEAR(static_cast<double>(within) / trials, 0.90, 0.03);
  }
}

// 4 to 8 points without names, up to two of them missing as long as three are left, and one point of another object.
TEST(RegistrationAccuracy, unlabelled_points_are_paired_rightly_or_called_ambiguous) {
  constexpr int layouts = 1000;
  Random random(400);
  int right = 0, ambiguous = 0;
  std::vector<double> times;  // ms of processor time
  for (int n = 0; n < layouts; ++n) {
    const std::size_t count = 4U + static_cast<std::size_t>(n) % 5U;
    const std::size_t missing = std::min<std::size_t>(static_cast<std::size_t>(n) / 5U % 3U, count - 3U);
    std::vector<Vec3> moving, fixed;
    for (std::size_t i = 0; i < count; ++i) moving.push_back(noise(random, Vec3::Constant(60.0)));
    std::vector<std::optional<std::size_t>> partner;
    for (std::size_t i = missing; i < count; ++i) {
      fixed.push_back(place_in_room() * moving[i] + noise(random, Vec3::Constant(fle / std::sqrt(3.0))));
      partner.emplace_back(i);
    }
    fixed.push_back(place_in_room() * noise(random, Vec3::Constant(60.0)));
    partner.emplace_back(std::nullopt);
    std::reverse(fixed.begin(), fixed.end());
    std::reverse(partner.begin(), partner.end());
    const std::clock_t begin = std::clock();
    const PointMatch match = match_points(fixed, moving);
    times.push_back(1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    if (match.ambiguous)
      ++ambiguous;
    else if (match.moving_of_fixed == partner)
      ++right;
    else
      std::printf("wrong: layout %d, %zu points, %zu missing, FRE %.2f mm\n", n, count, missing, match.fre_rms);
  }
  std::sort(times.begin(), times.end());
  std::printf("unlabelled points: %d right, %d ambiguous of %d; %.2f ms in the median, %.2f ms at most\n", right,
              ambiguous, layouts, times[layouts / 2], times.back());
  EXPECT_EQ(right + ambiguous, layouts);
  EXPECT_GT(right, layouts * 3 / 4);
  EXPECT_LT(times.back(), 10.0);
}

// Balls of 2 mm radius in foam, with partly filled voxels.
TEST(BeadCentres, are_found_within_a_tenth_of_a_millimetre) {
  for (const Vec3& spacing : {Vec3(0.6, 0.6, 0.6), Vec3(0.98, 0.98, 1.25), Vec3(1.25, 1.25, 1.25)}) {
    constexpr int across = 4;  // beads along each side
    constexpr double apart = 12.0;
    anatomy::Grid grid;
    grid.spacing = spacing;
    grid.origin = Vec3(-30.0, 12.0, 5.0);
    for (int axis = 0; axis < 3; ++axis)
      grid.size[static_cast<std::size_t>(axis)] = static_cast<int>(across * apart / spacing[axis]) + 1;
    anatomy::CtVolume ct(grid, -900);
    Random random(4);
    for (auto& voxel : ct.voxels) voxel = static_cast<std::int16_t>(std::lround(-900.0 + 15.0 * random.normal()));
    std::vector<Vec3> centres;
    for (int n = 0; n < across * across * across; ++n) {
      const double x = n % across + 0.5, y = n / across % across + 0.5, z = n / (across * across) + 0.5;
      const double dx = random.uniform(-2.0, 2.0), dy = random.uniform(-2.0, 2.0), dz = random.uniform(-2.0, 2.0);
      const Vec3 centre = grid.origin + apart * Vec3(x, y, z) + Vec3(dx, dy, dz);
      centres.push_back(centre);
      const Vec3 reach = Vec3::Constant(2.0) + spacing;
      const Vec3 low = (centre - reach - grid.origin).cwiseQuotient(spacing);
      const Vec3 high = (centre + reach - grid.origin).cwiseQuotient(spacing);
      for (int k = static_cast<int>(low.z()); k <= static_cast<int>(high.z()); ++k) {
        for (int j = static_cast<int>(low.y()); j <= static_cast<int>(high.y()); ++j) {
          for (int i = static_cast<int>(low.x()); i <= static_cast<int>(high.x()); ++i) {
            int inside = 0;
            for (int s = 0; s < 512; ++s) {
              const Vec3 part(s % 8, s / 8 % 8, s / 64);
              const Vec3 at =
                  grid.to_patient(Vec3(i, j, k) + (part + Vec3::Constant(0.5)) / 8.0 - Vec3::Constant(0.5));
              inside += (at - centre).norm() < 2.0 ? 1 : 0;
            }
            const double value = ct.at(i, j, k) + 3400.0 * inside / 512.0;
            ct.at(i, j, k) = static_cast<std::int16_t>(std::lround(std::clamp(value, -1024.0, 3071.0)));
          }
        }
      }
    }
    const std::vector<Bead> beads = find_beads(ct);
    ASSERT_EQ(beads.size(), centres.size());
    double squares = 0.0, most = 0.0;
    for (const Vec3& centre : centres) {
      double least = 1e9;
      for (const Bead& bead : beads) least = std::min(least, (bead.centre - centre).norm());
      squares += least * least;
      most = std::max(most, least);
    }
    std::printf("%zu beads, voxels of %.2f x %.2f x %.2f mm: off by %.3f mm RMS, %.3f at most\n", centres.size(),
                spacing.x(), spacing.y(), spacing.z(), std::sqrt(squares / static_cast<double>(centres.size())),
                most);
    EXPECT_LT(most, 0.1);
  }
}

}  // namespace
}  // namespace bodkin::tracking
