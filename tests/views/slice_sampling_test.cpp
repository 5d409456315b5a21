#include "views/slice_sampling.h"

#include <cmath>

#include "tests/views/made_up.h"
#include <gtest/gtest.h>

#include "imaging/slice.h"

namespace bodkin::views {
namespace {

imaging::SlicePlane oblique_plane() {
  const Vec3 right = Vec3(0.8, 0.6, 0.0), down = Vec3(0.0, 0.0, -1.0);
  return {Vec3(-40, -30, 30), right, down, 0.7, 90, 70};
}

TEST(SliceSampling, equals_the_slices_of_imaging_in_any_plane) {
  const auto patient = bodkin_test::layered_patient();
  const imaging::SlicePlane plane = oblique_plane();
  const imaging::Slice expected = imaging::cut(plane, patient->patient.ct, patient->patient.tissues);
  std::vector<float> hounsfield;
  sample_hounsfield(plane, patient->patient.ct, {}, hounsfield);
  ASSERT_EQ(hounsfield.size(), expected.hounsfield.size());
  for (std::size_t i = 0; i < hounsfield.size(); ++i) {
    if (std::isnan(expected.hounsfield[i])) {
      EXPECT_TRUE(std::isnan(hounsfield[i]));
    } else {
      EXPECT_NEAR(hounsfield[i], expected.hounsfield[i], 1e-3);
    }
  }
}

TEST(SliceSampling, a_slab_has_the_mean_or_the_greatest_of_its_thickness) {
  const auto patient = bodkin_test::layered_patient();
  imaging::SlicePlane plane = imaging::view_plane(imaging::View::axial, Vec3(0, 0, 10), 20.0, 20.0, 1.0);
  std::vector<float> thin, mean, most;
  sample_hounsfield(plane, patient->patient.ct, {}, thin);
  sample_hounsfield(plane, patient->patient.ct, {8.0, SlabKind::mean}, mean);
  sample_hounsfield(plane, patient->patient.ct, {8.0, SlabKind::maximum}, most);
  // The HU rise by 5 per millimetre along the normal.
  EXPECT_NEAR(mean[150], thin[150], 1e-3);
  EXPECT_NEAR(most[150], thin[150] + 5.0 * 4.0, 1e-3);
}

TEST(SliceSampling, places_outside_of_the_ct_do_not_count_in_a_slab) {
  const auto patient = bodkin_test::layered_patient();
  const imaging::SlicePlane plane = imaging::view_plane(imaging::View::axial, Vec3(0, 0, 50), 20.0, 20.0, 1.0);
  std::vector<float> most;
  sample_hounsfield(plane, patient->patient.ct, {8.0, SlabKind::maximum}, most);
  EXPECT_NEAR(most[0], bodkin_test::layered_hounsfield(plane.point(0, 0)), 2.6);
}

TEST(SliceSampling, tints_leave_to_the_ct_what_it_shows_well) {
  std::array<std::uint32_t, 256> colours{};
  colours.fill(0xFF8000);
  const auto tints = tissue_tints(colours, 0.5);
  EXPECT_EQ(tints[anatomy::tissue::air], 0U);
  EXPECT_EQ(tints[anatomy::tissue::cortical_bone], 0U);
  EXPECT_EQ(tints[anatomy::tissue::muscle], 0U);
  EXPECT_EQ(tints[imaging::Slice::outside], 0U);
  EXPECT_EQ(tints[anatomy::tissue::ligamentum_flavum], 0x80804000U) << "half of it, premultiplied";
}

TEST(SliceSampling, a_border_within_a_pixel_has_the_mean_of_both) {
  const auto patient = bodkin_test::layered_patient();
  std::array<Tint, 256> tints{};
  tints[anatomy::tissue::ligamentum_flavum] = 0x80000000U;
  // Pixels of 1 mm across the border of muscle and flavum, y = 0 at depth 30.
  const imaging::SlicePlane plane{Vec3(0, -4, 0), Vec3::UnitY(), Vec3::UnitX(), 1.0, 9, 1};
  std::vector<Tint> pixels;
  sample_tints(plane, patient->patient.tissues, tints, pixels);
  EXPECT_EQ(pixels[2] >> 24, 0x80U);
  EXPECT_EQ(pixels[7] >> 24, 0U);
  bool between = false;
  for (const Tint pixel : pixels) between = between || (pixel >> 24 == 0x40U);
  EXPECT_TRUE(between);
}

TEST(SliceSampling, greys_follow_the_window) {
  EXPECT_EQ(grey_of(-200.0, 400.0, 40.0), 0);
  EXPECT_EQ(grey_of(40.0, 400.0, 40.0), 128);
  EXPECT_EQ(grey_of(240.0, 400.0, 40.0), 255);
  EXPECT_EQ(grey_of(3000.0, 400.0, 40.0), 255);
  EXPECT_EQ(grey_of(std::nan(""), 400.0, 40.0), 0);
}

TEST(ForbiddenPlaces, are_vessels_nerves_and_critical_structures) {
  auto open = *bodkin_test::layered_patient();
  open.patient.structures = anatomy::LabelVolume(open.patient.tissues.grid);
  const Vec3 organ(20, 10.25, -20);  // the centre of a voxel
  const Vec3 index = open.patient.structures.grid.to_index(organ);
  open.patient.structures.at(static_cast<int>(index.x()), static_cast<int>(index.y()), static_cast<int>(index.z())) =
      7;
  EXPECT_FALSE(ForbiddenPlaces(open.patient).holds(organ));
  open.patient.description.structures.push_back({7, "kidney_left", "organ", true});
  const ForbiddenPlaces places(open.patient);
  EXPECT_TRUE(places.holds(organ));
  EXPECT_TRUE(places.holds(Vec3(0, -25, 20))) << "the vessel";
  EXPECT_FALSE(places.holds(Vec3(0, 10, 0)));
  EXPECT_FALSE(places.holds(Vec3(500, 0, 0)));
}

}  // namespace
}  // namespace bodkin::views
