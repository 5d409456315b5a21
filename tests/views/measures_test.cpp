#include "views/measures.h"

#include <gtest/gtest.h>

namespace bodkin::views {
namespace {

TEST(Measures, a_distance_of_50_mm_reads_50_mm) {
  const Measure distance{Measure::Kind::distance, {Vec3(10, 0, 0), Vec3(40, 40, 0), Vec3::Zero()}};
  EXPECT_DOUBLE_EQ(value_of(distance), 50.0);
  EXPECT_EQ(text_of(distance), "50.0 mm");
}

TEST(Measures, angles_are_at_the_second_place) {
  const Vec3 corner(5, 6, 7);
  const auto angle = [&](const Vec3& one, const Vec3& other) {
    return Measure{Measure::Kind::angle, {corner + one, corner, corner + other}};
  };
  EXPECT_NEAR(value_of(angle(Vec3(3, 0, 0), Vec3(0, 0, 8))), 90.0, 1e-9);
  EXPECT_NEAR(value_of(angle(Vec3(1, 0, 0), Vec3(1, 1, 0))), 45.0, 1e-9);
  EXPECT_NEAR(value_of(angle(Vec3(2, 0, 0), Vec3(-1, 0, 0))), 180.0, 1e-9);
  EXPECT_EQ(value_of(angle(Vec3::Zero(), Vec3(1, 0, 0))), 0.0);
  EXPECT_EQ(text_of(angle(Vec3(3, 0, 0), Vec3(0, 0, 8))), "90.0°");
}

TEST(Measures, two_clicks_make_a_distance_and_three_an_angle) {
  Measures measures;
  measures.add(Vec3::Zero());
  EXPECT_TRUE(measures.all().empty()) << "none was begun";
  measures.begin(Measure::Kind::distance);
  measures.add(Vec3(0, 0, 0));
  EXPECT_TRUE(measures.waiting());
  ASSERT_TRUE(measures.with_next(Vec3(0, 3, 4)));
  EXPECT_DOUBLE_EQ(value_of(*measures.with_next(Vec3(0, 3, 4))), 5.0);
  measures.add(Vec3(0, 3, 4));
  EXPECT_FALSE(measures.waiting());
  measures.begin(Measure::Kind::angle);
  measures.add(Vec3(1, 0, 0));
  EXPECT_FALSE(measures.with_next(Vec3(1, 0, 0))) << "two places are missing";
  measures.add(Vec3(0, 0, 0));
  measures.add(Vec3(0, 1, 0));
  ASSERT_EQ(measures.all().size(), 2U);
  EXPECT_NEAR(value_of(measures.all()[1]), 90.0, 1e-9);
}

TEST(Measures, a_measure_is_found_by_its_line_and_deleted) {
  Measures measures;
  for (const double y : {0.0, 10.0}) {
    measures.begin(Measure::Kind::distance);
    measures.add(Vec3(0, y, 0));
    measures.add(Vec3(50, y, 0));
  }
  EXPECT_EQ(measures.at(Vec3(25, 8.5, 0), 2.0), 1U);
  EXPECT_EQ(measures.at(Vec3(25, 5.0, 0), 2.0), std::nullopt);
  EXPECT_EQ(measures.at(Vec3(53, 0.0, 0), 2.0), std::nullopt) << "beyond its end";
  measures.remove(1);
  ASSERT_EQ(measures.all().size(), 1U);
  EXPECT_EQ(measures.all()[0].places[0].y(), 0.0);
}

}  // namespace
}  // namespace bodkin::views
