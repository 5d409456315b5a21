#include "tracking/registration_picture.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bodkin::tracking {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::vector<Vec3> flat_points = {{0.0, 0.0, 0.0}, {100.0, 0.0, 0.0}, {0.0, 0.0, 80.0}, {60.0, 0.0, 30.0}};

TEST(RegistrationPicture, errors_are_magnified_by_round_numbers_and_never_made_smaller) {
  EXPECT_EQ(error_magnification(200.0, 0.5), 50.0);
  EXPECT_EQ(error_magnification(200.0, 1.0), 20.0);
  EXPECT_EQ(error_magnification(200.0, 2.4), 10.0);
  EXPECT_EQ(error_magnification(200.0, 60.0), 1.0);
  EXPECT_EQ(error_magnification(200.0, 0.0), 1000.0);
}

// Points of one plane have no extent along y: their panel is as high as the other one, not a line.
TEST(RegistrationPicture, shows_flat_and_exact_points) {
  const Registration exact = register_points(flat_points, flat_points, false);
  const imaging::Canvas picture = registration_picture(exact, flat_points, flat_points, {"a", "b", "c", "d"});
  EXPECT_LE(picture.height(), 800.0);
  EXPECT_GE(picture.height(), 300.0);
  const std::string drawing = picture.svg();
  EXPECT_THAT(drawing, HasSubstr(">d<"));
  EXPECT_THAT(drawing, Not(HasSubstr("target")));
  EXPECT_THAT(drawing, Not(HasSubstr("nan")));
}

TEST(RegistrationPicture, a_long_name_is_cut_between_characters) {
  const Registration exact = register_points(flat_points, flat_points, false);
  std::string longest;
  for (int n = 0; n < 40; ++n) longest += "ä";
  const std::string drawing = registration_picture(exact, flat_points, flat_points, {longest, "<b>", "c", "d"}).svg();
  EXPECT_THAT(drawing, HasSubstr("ää…<"));
  EXPECT_THAT(drawing, Not(HasSubstr(longest)));
  EXPECT_THAT(drawing, HasSubstr("&lt;b&gt;"));
}

}  // namespace
}  // namespace bodkin::tracking
