#include "views/depth_segments.h"

#include <array>

#include "tests/views/made_up.h"
#include <gtest/gtest.h>

namespace bodkin::views {
namespace {

namespace t = anatomy::tissue;

TEST(DepthSegments, straight_in_the_layers_have_their_thickness) {
  const auto patient = bodkin_test::layered_patient();
  const auto segments = depth_segments(patient->patient.tissues, Vec3(0, 30, 0), Vec3(0, -1, 0), 60.0);
  const std::array<std::pair<anatomy::TissueId, double>, 5> expected = {
      {{t::skin, bodkin_test::skin_to},
       {t::fat, bodkin_test::fat_to},
       {t::muscle, bodkin_test::muscle_to},
       {t::ligamentum_flavum, bodkin_test::flavum_to},
       {t::cerebrospinal_fluid, 60.0}}};
  ASSERT_EQ(segments.size(), expected.size());
  double from = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(segments[i].tissue, expected[i].first);
    EXPECT_NEAR(segments[i].from, from, 0.11);
    EXPECT_NEAR(segments[i].to, expected[i].second, 0.11);
    from = expected[i].second;
  }
}

TEST(DepthSegments, at_60_degrees_they_are_twice_as_long) {
  const auto patient = bodkin_test::layered_patient();
  const Vec3 direction(std::sqrt(0.75), -0.5, 0.0);
  const auto segments = depth_segments(patient->patient.tissues, Vec3(-20, 30, 0), direction, 30.0);
  ASSERT_GE(segments.size(), 3U);
  EXPECT_NEAR(segments[1].to, 2.0 * bodkin_test::fat_to, 0.25);
}

TEST(DepthSegments, end_where_the_line_leaves_the_body) {
  const auto patient = bodkin_test::layered_patient();
  const auto segments = depth_segments(patient->patient.tissues, Vec3(0, 30, 0), Vec3(0, -1, 0), 200.0);
  EXPECT_NEAR(segments.back().to, 80.0, 0.3) << "the image ends at y = -50";
  EXPECT_TRUE(depth_segments(patient->patient.tissues, Vec3(0, 45, 0), Vec3(0, 1, 0), 50.0).empty()) << "only air";
}

TEST(DepthSegments, the_one_at_a_depth_is_found) {
  const std::array<DepthSegment, 2> segments = {{{0.0, 2.0, t::skin}, {2.0, 9.0, t::fat}}};
  EXPECT_EQ(segment_at(segments, 1.0), &segments[0]);
  EXPECT_EQ(segment_at(segments, 2.0), &segments[1]);
  EXPECT_EQ(segment_at(segments, -0.1), nullptr);
  EXPECT_EQ(segment_at(segments, 9.0), nullptr);
}

TEST(SpreadLabels, with_room_for_all_nothing_moves) {
  const std::array<double, 3> desired = {10.0, 40.0, 90.0};
  EXPECT_EQ(spread_labels(desired, 12.0, 0.0, 100.0), std::vector<double>(desired.begin(), desired.end()));
}

TEST(SpreadLabels, neighbours_part_evenly) {
  const std::array<double, 3> desired = {50.0, 50.0, 50.0};
  EXPECT_EQ(spread_labels(desired, 12.0, 0.0, 100.0), (std::vector<double>{38.0, 50.0, 62.0}));
}

TEST(SpreadLabels, all_stay_within_the_bar_whatever_they_wish) {
  const std::array<double, 6> desired = {-5.0, 2.0, 3.0, 97.0, 99.0, 140.0};
  const std::vector<double> places = spread_labels(desired, 12.0, 0.0, 100.0);
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_GE(places[i], -1e-9);
    EXPECT_LE(places[i], 100.0 + 1e-9);
    if (i > 0) {
      EXPECT_GE(places[i] - places[i - 1], 12.0 - 1e-9);
    }
  }
}

TEST(SpreadLabels, too_many_come_closer_evenly) {
  const std::vector<double> desired(11, 70.0);
  const std::vector<double> places = spread_labels(desired, 12.0, 0.0, 100.0);
  for (std::size_t i = 0; i < places.size(); ++i) EXPECT_NEAR(places[i], 10.0 * static_cast<double>(i), 1e-9);
}

}  // namespace
}  // namespace bodkin::views
