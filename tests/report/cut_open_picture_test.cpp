#include "report/cut_open_picture.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace bodkin::report {
namespace {

// Soft tissue of 120 x 120 x 120 mm with a ball of bone; the path goes from behind to the middle.
anatomy::Case with_ball(const Vec3& ball) {
  anatomy::Case patient;
  anatomy::Grid grid;
  grid.size = {60, 60, 60};
  grid.spacing = Vec3::Constant(2.0);
  grid.origin = Vec3::Constant(-59.0);
  patient.ct = anatomy::CtVolume(grid, 40);
  patient.tissues = anatomy::TissueVolume(grid, anatomy::tissue::muscle);
  for (int k = 0; k < 60; ++k) {
    for (int j = 0; j < 60; ++j) {
      for (int i = 0; i < 60; ++i) {
        if ((grid.to_patient(Vec3(i, j, k)) - ball).norm() < 12.0) patient.ct.at(i, j, k) = 1200;
      }
    }
  }
  return patient;
}

const anatomy::NeedlePath path = [] {
  anatomy::NeedlePath from_behind;
  from_behind.entry = Vec3(0.0, 50.0, 0.0);
  from_behind.target = Vec3::Zero();
  return from_behind;
}();

// Number of pixels for which `is` holds.
template <typename Is>
int count(const imaging::ImageRgb& image, const Is& is) {
  return static_cast<int>(std::count_if(image.pixels.begin(), image.pixels.end(), is));
}
bool is_bone(const imaging::Rgb& pixel) {
  return pixel.red > 120 && pixel.red >= pixel.blue;
}
bool is_blue(const imaging::Rgb& pixel) {
  return pixel.blue > 200 && pixel.red < 130;
}

TEST(CutOpenPicture, bone_behind_the_cut_is_seen_and_bone_before_it_is_taken_away) {
  // To the patient's right, LPS: the left is taken away.
  const auto right = cut_open_picture(with_ball(Vec3(-25.0, 0.0, 0.0)), path, {}, 320.0, 240.0).pixels(1.0);
  const auto left = cut_open_picture(with_ball(Vec3(25.0, 0.0, 0.0)), path, {}, 320.0, 240.0).pixels(1.0);
  EXPECT_GT(count(right, is_bone), 2000);
  EXPECT_LT(count(left, is_bone), 500);  // letters
  EXPECT_EQ(right.width, 320);
  EXPECT_EQ(right.height, 240);
}

TEST(CutOpenPicture, the_way_of_the_tip_is_drawn_where_it_went) {
  const anatomy::Case patient = with_ball(Vec3(-25.0, 0.0, 0.0));
  const auto without = cut_open_picture(patient, path, {}, 320.0, 240.0).pixels(1.0);
  const auto half = cut_open_picture(patient, path, {path.entry, Vec3(0.0, 25.0, 0.0)}, 320.0, 240.0).pixels(1.0);
  const auto whole = cut_open_picture(patient, path, {path.entry, path.target}, 320.0, 240.0).pixels(1.0);
  const int letters = count(without, is_blue);
  EXPECT_GT(count(half, is_blue), letters + 50);
  EXPECT_NEAR(count(whole, is_blue) - letters, 2 * (count(half, is_blue) - letters), 120);
}

TEST(CutOpenPicture, the_probe_is_drawn_where_it_went_with_its_slice) {
  const anatomy::Case patient = with_ball(Vec3(-25.0, 0.0, 0.0));
  const auto is_orange = [](const imaging::Rgb& pixel) {
    return pixel.red > 230 && pixel.green > 150 && pixel.green < 210 && pixel.blue < 110;
  };
  const auto drawn = [&](const ProbePath& probe) {
    return count(cut_open_picture(patient, path, {}, 320.0, 240.0, probe).pixels(1.0), is_orange);
  };
  const int none = drawn({});
  const Vec3 from(-10.0, 50.0, -30.0), to(-10.0, 50.0, 30.0);
  const int way = drawn({{from, to}, {}});
  EXPECT_GT(way, none + 100);
  EXPECT_GT(drawn({{from, to}, {from, to, to - 40.0 * Vec3::UnitY(), from - 40.0 * Vec3::UnitY()}}), way + 100);
}

TEST(CutOpenPicture, a_path_that_leaves_the_ct_is_still_drawn) {
  anatomy::NeedlePath beside = path;
  beside.entry = Vec3(0.0, 300.0, 200.0);
  EXPECT_NO_THROW(cut_open_picture(with_ball(Vec3::Zero()), beside, {beside.entry}, 320.0, 240.0).pixels(1.0));
}

}  // namespace
}  // namespace bodkin::report
