#include "fem/needle_beam.h"

#include <cmath>
#include <limits>
#include <vector>

#include "tests/fem/hermite_beam.h"
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

NeedleBeam needle_24g(NeedleHold hold = NeedleHold::clamped) {
  return NeedleBeam({.rigidity = 877.94, .length = 90.0, .hold = hold});
}

TEST(NeedleBeam, cantilever_bends_by_the_cube_of_its_length_over_3EI) {
  for (const double length : {10.0, 50.0, 90.0}) {
    EXPECT_NEAR(needle_24g().flexibility(length, length), std::pow(length, 3) / (3.0 * 877.94), 1e-12 * length);
  }
  // design/force-models.md 4.3: 5 mm at 90 mm take 0.018065 N
  EXPECT_NEAR(5.0 / needle_24g().flexibility(90.0, 90.0), 0.018065, 1e-6);
}

TEST(NeedleBeam, is_what_any_chain_of_hermite_elements_gives) {
  Random random(1);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<double> places{0.0};
    for (int i = 0; i < 12; ++i) places.push_back(places.back() + random.uniform(0.2, 12.0));
    const checks::LongMatrix stiffness = checks::hermite_stiffness(300.0, places);
    const Eigen::Index size = stiffness.rows() - 2;
    const Eigen::MatrixXd flexible = stiffness.bottomRightCorner(size, size).inverse().cast<double>();
    const NeedleBeam beam({.rigidity = 300.0, .length = places.back()});
    const double largest = flexible(size - 2, size - 2);
    for (std::size_t i = 1; i < places.size(); ++i) {
      for (std::size_t j = 1; j < places.size(); ++j) {
        const auto a = static_cast<Eigen::Index>(2 * i - 2), b = static_cast<Eigen::Index>(2 * j - 2);
        EXPECT_NEAR(beam.flexibility(places[i], places[j]), flexible(a, b), 1e-9 * largest);
      }
    }
  }
}

TEST(NeedleBeam, ever_more_point_loads_become_a_distributed_one) {
  const NeedleBeam beam = needle_24g();
  const double load = 1e-4, length = 90.0;  // N/mm
  const double exact = load * std::pow(length, 4) / (8.0 * 877.94);
  double last = 0.0;
  for (const int count : {10, 20, 40, 80}) {
    double tip = 0.0;
    for (int i = 0; i < count; ++i)
      tip += load * length / count * beam.flexibility(length, length * (i + 0.5) / count);
    const double error = std::abs(tip - exact);
    if (last > 0.0) {
      EXPECT_NEAR(last / error, 4.0, 0.05) << count;
    }
    last = error;
  }
  EXPECT_LT(last, 1e-4 * exact);
}

TEST(NeedleBeam, the_piece_outside_and_the_piece_inside_make_the_whole) {
  Random random(2);
  const NeedleBeam beam = needle_24g();
  for (int trial = 0; trial < 100; ++trial) {
    const double depth = random.uniform(0.0, 90.0);
    const ShaftRoot root = beam.root(depth);
    EXPECT_NEAR(root.outside, 90.0 - depth, 1e-12);
    const Eigen::Matrix2d outside = root.root * root.root.transpose();
    const double a = random.uniform(0.0, depth), b = random.uniform(0.0, depth);
    const double whole = beam.flexibility(root.outside + a, root.outside + b);
    const double both = beam.flexibility(a, b) + Eigen::RowVector2d(1.0, a) * outside * Eigen::Vector2d(1.0, b);
    EXPECT_NEAR(both, whole, 1e-12 * beam.flexibility(90.0, 90.0));
  }
}

TEST(NeedleBeam, a_hub_in_the_body_is_at_its_surface) {
  EXPECT_EQ(needle_24g().root(95.0).outside, 0.0);
  EXPECT_EQ(needle_24g().root(95.0).root.norm(), 0.0);
  EXPECT_EQ(needle_24g().root(-5.0).outside, 90.0);
}

TEST(NeedleBeam, a_pinned_hub_turns_without_moment) {
  const NeedleBeam beam = needle_24g(NeedleHold::pinned);
  const ShaftRoot root = beam.root(30.0);
  // 1e-9 N mm turn it by far: what it moves at the surface is that angle times the way from the hub.
  const Eigen::Vector2d moved = root.root * root.root.transpose() * Eigen::Vector2d(0.0, 1e-9);
  EXPECT_NEAR(moved(1), 100.0, 1e-3);
  EXPECT_NEAR(moved(0), 60.0 * 100.0, 1e-1);
}

TEST(NeedleBeam, one_that_does_not_bend_has_no_flexibility) {
  const NeedleBeam beam({.rigidity = std::numeric_limits<double>::infinity()});
  EXPECT_EQ(beam.flexibility(50.0, 80.0), 0.0);
  EXPECT_EQ(beam.root(20.0).root.norm(), 0.0);
}

TEST(NeedleBeam, refuses_what_is_no_needle) {
  EXPECT_THROW(NeedleBeam({.rigidity = 0.0}), InputError);
  EXPECT_THROW(NeedleBeam({.rigidity = std::nan("")}), InputError);
  EXPECT_THROW(NeedleBeam({.rigidity = -std::numeric_limits<double>::infinity()}), InputError);
  EXPECT_THROW(NeedleBeam({.length = 4.0}), InputError);
  EXPECT_THROW(NeedleBeam({.length = 501.0}), InputError);
  EXPECT_THROW(NeedleBeam({.cut_offset = -0.1}), InputError);
  EXPECT_THROW(NeedleBeam({.cut_offset = std::nan("")}), InputError);
}

}  // namespace
}  // namespace bodkin
