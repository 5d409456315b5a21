#include "imaging/slice.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::imaging;
namespace {

// A volume whose axes are stored as posterior, inferior, right, as some archives do.
Grid pir_grid() {
  Grid grid;
  grid.size = {20, 24, 16};
  grid.spacing = Vec3(1.5, 1.0, 2.0);
  grid.direction.col(0) = Vec3::UnitY();
  grid.direction.col(1) = -Vec3::UnitZ();
  grid.direction.col(2) = -Vec3::UnitX();
  grid.origin = Vec3(30.0, -10.0, 50.0);
  return grid;
}

CtVolume random_ct(const Grid& grid) {
  CtVolume ct(grid);
  Random random(3);
  for (auto& value : ct.voxels) value = static_cast<std::int16_t>(random.uniform(-500.0, 1500.0));
  return ct;
}

TissueVolume random_tissues(const Grid& grid) {
  TissueVolume tissues(grid);
  Random random(4);
  for (auto& id : tissues.voxels) id = static_cast<TissueId>(random.next() % tissue::count);
  return tissues;
}

TissueLibrary three_colours() {
  std::vector<TissueProperties> tissues(3);
  tissues[0].id = tissue::air;
  tissues[0].name = "air";
  tissues[1].id = tissue::fat;
  tissues[1].name = "fat";
  tissues[1].colour = 0xFF0000;
  tissues[2].id = tissue::muscle;
  tissues[2].name = "muscle";
  tissues[2].colour = 0x0000FF;
  return TissueLibrary(tissues);
}

TEST(Slice, holds_what_the_volumes_hold_at_each_pixels_place_whatever_the_order_of_their_axes) {
  const CtVolume ct = random_ct(pir_grid());
  const TissueVolume tissues = random_tissues(pir_grid());
  const Vec3 middle = ct.grid.to_patient(Vec3(9.7, 11.3, 7.1));
  const NeedlePath slanted{middle, middle + Vec3(1.0, -6.0, 3.0)};
  for (const SlicePlane& plane :
       {view_plane(View::axial, middle, 20, 14, 0.7), view_plane(View::coronal, middle, 20, 14, 0.7),
        view_plane(View::sagittal, middle, 20, 14, 0.7), sagittal_plane_along(slanted, middle, 20, 14, 0.7)}) {
    const Slice slice = cut(plane, ct, tissues);
    ASSERT_EQ(slice.hounsfield.size(), static_cast<std::size_t>(plane.width * plane.height));
    for (int row = 0; row < plane.height; ++row) {
      for (int column = 0; column < plane.width; ++column) {
        const Vec3 point = plane.point(column, row);
        const auto at = static_cast<std::size_t>(row * plane.width + column);
        EXPECT_FLOAT_EQ(slice.hounsfield[at], static_cast<float>(linear(ct, point, 0.0)));
        EXPECT_EQ(slice.tissues[at], nearest<TissueId>(tissues, point, 255));
      }
    }
  }
}

TEST(Slice, is_empty_outside_the_volumes) {
  const CtVolume ct = random_ct(pir_grid());
  const Slice slice = cut(view_plane(View::axial, Vec3(500, 500, 500), 4, 4, 1.0), ct, random_tissues(pir_grid()));
  for (const float value : slice.hounsfield) EXPECT_TRUE(std::isnan(value));
  for (const TissueId id : slice.tissues) EXPECT_EQ(id, Slice::outside);
  EXPECT_TRUE(tissues_present(slice).size() <= 1);
}

TEST(SlicePlane, looks_the_way_radiologists_do) {
  const Vec3 middle(10, 20, 30);
  const SlicePlane axial = view_plane(View::axial, middle, 100, 80, 1.0);
  const SlicePlane coronal = view_plane(View::coronal, middle, 100, 80, 1.0);
  const SlicePlane sagittal = view_plane(View::sagittal, middle, 100, 80, 1.0);
  EXPECT_EQ(direction_letters(axial.right), "L");
  EXPECT_EQ(direction_letters(axial.down), "P");
  EXPECT_EQ(direction_letters(coronal.right), "L");
  EXPECT_EQ(direction_letters(coronal.down), "I");
  EXPECT_EQ(direction_letters(sagittal.right), "P");
  EXPECT_EQ(direction_letters(sagittal.down), "I");
  // A point further to the left of the patient stands further right in the axial picture.
  EXPECT_GT(axial.place(middle + Vec3(5, 0, 0)).x(), axial.place(middle).x());
  EXPECT_GT(axial.place(middle + Vec3(0, 5, 0)).y(), axial.place(middle).y());
  EXPECT_LT(coronal.place(middle + Vec3(0, 0, 5)).y(), coronal.place(middle).y());
}

TEST(SlicePlane, places_and_points_are_inverse_and_the_middle_is_in_the_middle) {
  const Vec3 middle(1.5, -2.0, 7.25);
  const SlicePlane plane = view_plane(View::sagittal, middle, 60, 40, 0.5);
  EXPECT_EQ(plane.width, 120);
  EXPECT_EQ(plane.height, 80);
  EXPECT_TRUE(plane.place(middle).isApprox(Eigen::Vector2d(59.5, 39.5)));
  EXPECT_TRUE(plane.place(plane.point(13, 77)).isApprox(Eigen::Vector2d(13, 77)));
  EXPECT_NEAR(plane.distance(middle - 3.0 * Vec3::UnitX()), 3.0, 1e-12);  // the right side lies away from the eye
}

TEST(SlicePlane, the_sagittal_plane_along_a_path_holds_it_and_turns_as_little_as_it_can) {
  const NeedlePath path{Vec3(3, 90, 10), Vec3(-4, 30, 25)};
  const SlicePlane plane = sagittal_plane_along(path, Vec3(0, 60, 17), 80, 80, 0.5);
  EXPECT_NEAR(plane.distance(path.entry), 0.0, 1e-9);
  EXPECT_NEAR(plane.distance(path.target), 0.0, 1e-9);
  EXPECT_NEAR(plane.right.dot(plane.down), 0.0, 1e-12);
  // No plane through the path is closer to sagittal than the path's own angle with it.
  const double angle_of_path = std::asin(std::abs(path.direction().x()));
  EXPECT_NEAR(std::acos(std::abs(plane.normal().x())), angle_of_path, 1e-9);
  EXPECT_LT(plane.normal().x(), 0.0);
}

TEST(SlicePlane, a_path_from_the_side_gets_the_true_sagittal_plane_of_its_target) {
  const NeedlePath path{Vec3(90, 30, 10), Vec3(20, 25, 10)};
  const SlicePlane plane = sagittal_plane_along(path, Vec3(50, 28, 10), 80, 80, 0.5);
  EXPECT_TRUE(plane.right.isApprox(Vec3::UnitY()));
  EXPECT_NEAR(plane.distance(path.target), 0.0, 1e-9);
}

TEST(Slice, letters_of_a_slanted_direction_name_both_axes) {
  EXPECT_EQ(direction_letters(Vec3(0, -1, 0)), "A");
  EXPECT_EQ(direction_letters(Vec3(0, 0.6, -0.8)), "IP");
  EXPECT_EQ(direction_letters(Vec3(0.1, 0.0, 0.99)), "S");
}

TEST(Slice, the_body_box_is_that_of_the_tissues) {
  TissueVolume tissues(pir_grid(), tissue::air);
  tissues.at(3, 4, 5) = tissue::fat;
  tissues.at(6, 4, 5) = tissue::muscle;
  const PatientBox box = body_box(tissues);
  // i runs to the back in steps of 1.5 mm: four voxels along y; one voxel of 2 mm along x and of 1 mm along z.
  EXPECT_TRUE((box.high - box.low).isApprox(Vec3(2.0, 6.0, 1.0))) << (box.high - box.low).transpose();
  EXPECT_TRUE((0.5 * (box.high + box.low)).isApprox(tissues.grid.to_patient(Vec3(4.5, 4, 5))));
}

TEST(Slice, paint_shows_grey_by_window_and_level_tints_tissues_and_outlines_them) {
  Slice slice;
  slice.plane = view_plane(View::axial, Vec3::Zero(), 6, 1, 1.0);
  slice.hounsfield = {-500, 60, 900, 60, 60, std::nanf("")};
  slice.tissues = {tissue::air, tissue::air, tissue::air, tissue::fat, tissue::fat, tissue::muscle};
  const SliceLook look{500.0, 60.0, 0.25, 0.75};
  const ImageRgb image = paint(slice, three_colours(), look);
  EXPECT_EQ(image.at(0, 0), rgb(0x000000));         // below the window
  EXPECT_EQ(image.at(1, 0), (Rgb{128, 128, 128}));  // the level
  EXPECT_EQ(image.at(2, 0), rgb(0xFFFFFF));         // above the window
  EXPECT_EQ(image.at(3, 0), (Rgb{159, 96, 96}));    // 3/4 grey 127.5 + 1/4 red
  EXPECT_EQ(image.at(4, 0), (Rgb{223, 32, 32}));    // the outline towards muscle: 1/4 grey + 3/4 red
  EXPECT_EQ(image.at(5, 0), (Rgb{0, 0, 64}));       // no CT there: the tint alone
}

TEST(Slice, tissues_present_come_with_the_most_frequent_first_and_without_air) {
  Slice slice;
  slice.tissues = {tissue::air, tissue::fat, tissue::muscle, tissue::muscle, Slice::outside};
  EXPECT_EQ(tissues_present(slice), (std::vector<TissueId>{tissue::muscle, tissue::fat}));
}

}  // namespace
}  // namespace bodkin
