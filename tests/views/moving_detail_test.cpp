#include "views/moving_detail.h"

#include <cmath>

#include <gtest/gtest.h>

namespace bodkin::views {
namespace {

// An image takes time in proportion to its rays and to the steps along each.
double time_of(const MovingDetail& detail, double finest) {
  return finest * detail.rays() / MovingDetail::most_rays * MovingDetail::finest_step / detail.step();
}

TEST(MovingDetail, quick_pictures_are_as_fine_as_they_get) {
  MovingDetail detail;
  for (int i = 0; i < 20; ++i) detail.took(time_of(detail, 0.015));
  EXPECT_EQ(detail.step(), 2.0);
  EXPECT_EQ(detail.rays(), 256.0 * 256.0);
}

TEST(MovingDetail, slow_pictures_come_in_time_after_a_few_and_then_stay_as_they_are) {
  for (const double finest : {0.04, 0.072, 0.15}) {
    MovingDetail detail;
    for (int i = 0; i < 6; ++i) detail.took(time_of(detail, finest));
    EXPECT_LE(time_of(detail, finest), MovingDetail::in_time) << finest;
    EXPECT_GT(time_of(detail, finest), 0.5 * MovingDetail::in_time) << "no coarser than it must be: " << finest;
    const double step = detail.step(), rays = detail.rays();
    for (int i = 0; i < 10; ++i) detail.took(time_of(detail, finest));
    EXPECT_EQ(detail.step(), step);
    EXPECT_EQ(detail.rays(), rays);
  }
}

TEST(MovingDetail, there_is_an_end_to_coarseness_and_a_way_back) {
  MovingDetail detail;
  for (int i = 0; i < 20; ++i) detail.took(2.0);
  EXPECT_EQ(detail.step(), 4.0);
  EXPECT_NEAR(std::sqrt(detail.rays()), 148.0, 1.0);
  for (int i = 0; i < 20; ++i) detail.took(time_of(detail, 0.015));
  EXPECT_EQ(detail.step(), 2.0);
  EXPECT_EQ(detail.rays(), 256.0 * 256.0);
}

}  // namespace
}  // namespace bodkin::views
