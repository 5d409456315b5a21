// Two registrations in sequence, tested by trials.
#include "tracking/registration_chain.h"

#include <cmath>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin::tracking {
namespace {

const std::vector<Vec3> of_patient = {
    {0.0, 0.0, 0.0}, {90.0, 10.0, 0.0}, {20.0, 70.0, 15.0}, {50.0, 30.0, 60.0}, {-30.0, 40.0, 30.0}};
const std::vector<Vec3> of_mannequin = {{-80.0, -40.0, 200.0}, {90.0, -50.0, 210.0}, {70.0, 60.0, 190.0},
                                        {-60.0, 70.0, 250.0},  {10.0, 20.0, 280.0},  {0.0, -60.0, 240.0}};
const Vec3 aim(30.0, 20.0, 110.0);  // mm, patient

Similarity turned_about(double angle, const Vec3& axis, const Vec3& shift, double scale) {
  Similarity place;
  place.turn = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
  place.shift = shift;
  place.scale = scale;
  return place;
}

// `points` registered to their true places with an error of `deviation` mm along each axis.
Registration registered(const Similarity& truth, const std::vector<Vec3>& points, double deviation, bool with_scale,
                        Random& random) {
  std::vector<Vec3> seen;
  for (const Vec3& point : points) {
    const double x = random.normal(), y = random.normal(), z = random.normal();
    seen.push_back(truth * point + deviation * Vec3(x, y, z));
  }
  Registration made = register_points(seen, points, with_scale);
  made.errors = placement_errors(made, points, std::vector<Mat3>(points.size(), Mat3::Identity()));
  return made;
}

TEST(RegistrationChain, the_error_at_the_target_is_that_of_both) {
  constexpr int trials = 10000;
  const Similarity inner = turned_about(0.7, Vec3(1.0, -2.0, 0.5), Vec3(-10.0, 5.0, 180.0), 1.0);
  for (const double scale : {1.0, 1.3}) {
    const Similarity outer = turned_about(-1.4, Vec3(0.2, 1.0, 0.4), Vec3(30.0, -8.0, 500.0), scale);
    const bool scaled = scale != 1.0;
    Random random(scaled ? 62 : 61);
    double squares = 0.0, predicted = 0.0;
    std::vector<ErrorInterval> intervals;
    for (int n = 0; n < trials; ++n) {
      Registration first = registered(inner, of_patient, 0.35, false, random);
      first.at_target = TargetError{aim, {}};
      const Registration whole = followed_by(first, registered(outer, of_mannequin, 0.25, scaled, random));
      squares += (whole.fixed_from_moving * aim - outer * (inner * aim)).squaredNorm();
      predicted += whole.at_target->tre.estimate * whole.at_target->tre.estimate;
      intervals.push_back(whole.at_target->tre);
    }
    const double found = std::sqrt(squares / trials), expected = std::sqrt(predicted / trials);
    int within = 0;
    for (const ErrorInterval& interval : intervals) within += interval.low <= found && found <= interval.high ? 1 : 0;
    std::printf("chain, scale %.1f: TRE %.3f mm, predicted %.3f (%+.2f %%), interval holds the RMS in %.1f %%\n",
                scale, found, expected, 100.0 * (expected / found - 1.0), 100.0 * within / trials);
    EXPECT_NEAR(expected / found, 1.0, 0.02);
    EXPECT_NEAR(static_cast<double>(within) / trials, 0.90, 0.02);
  }
}

// Three placements, composed from either end.
TEST(RegistrationChain, is_the_same_from_either_end) {
  Random random(63);
  Registration first = registered(turned_about(0.7, Vec3(1.0, -2.0, 0.5), Vec3(-10.0, 5.0, 180.0), 1.0), of_patient,
                                  0.35, false, random);
  const Registration second = registered(turned_about(-1.4, Vec3(0.2, 1.0, 0.4), Vec3(30.0, -8.0, 500.0), 1.2),
                                         of_mannequin, 0.25, true, random),
                     third = registered(turned_about(2.0, Vec3(0.0, 0.3, 1.0), Vec3(1.0, 2.0, 3.0), 0.8),
                                        of_mannequin, 0.5, true, random);
  first.at_target = TargetError{aim, {}};
  const Registration left = followed_by(followed_by(first, second), third),
                     right = followed_by(first, followed_by(second, third));
  EXPECT_TRUE((left.fixed_from_moving * aim).isApprox(right.fixed_from_moving * aim, 1e-12));
  EXPECT_TRUE(
      (left.fixed_from_moving * aim)
          .isApprox(third.fixed_from_moving * (second.fixed_from_moving * (first.fixed_from_moving * aim)), 1e-12));
  EXPECT_NEAR(left.at_target->tre.estimate / right.at_target->tre.estimate, 1.0, 1e-9);
  EXPECT_TRUE(left.errors->covariance.isApprox(right.errors->covariance, 1e-9));
}

TEST(RegistrationChain, without_the_errors_of_one_nothing_is_predicted) {
  Random random(64);
  Registration first = registered(Similarity{}, of_patient, 0.35, false, random);
  first.at_target = TargetError{aim, {}};
  Registration second;
  second.fixed_from_moving.shift = Vec3(1.0, 2.0, 3.0);
  const Registration whole = followed_by(first, second);
  EXPECT_FALSE(whole.at_target.has_value());
  EXPECT_FALSE(whole.errors.has_value());
  EXPECT_TRUE((whole.fixed_from_moving * aim).isApprox(first.fixed_from_moving * aim + Vec3(1.0, 2.0, 3.0), 1e-12));
}

}  // namespace
}  // namespace bodkin::tracking
