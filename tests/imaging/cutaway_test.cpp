// The oval of Sutherland et al. (2013), eq. 6, and its contents.
#include "imaging/volume_rendering/cutaway.h"

#include <algorithm>
#include <cstdlib>
#include <memory>

#include <gtest/gtest.h>

namespace bodkin::imaging {
namespace {

TEST(Cutaway, eq_6_is_opaque_to_the_threshold_and_falls_to_the_rim) {
  const CutawayOval oval{{100.0, 50.0}, {80.0, 40.0}, 0.6};
  EXPECT_EQ(oval.opacity_at({100.0, 50.0}), 1.0);
  EXPECT_EQ(oval.opacity_at({100.0 + 0.59 * 80.0, 50.0}), 1.0);
  EXPECT_NEAR(oval.opacity_at({100.0 + 0.8 * 80.0, 50.0}), (1.0 - 0.8) / (1.0 - 0.6), 1e-12);
  EXPECT_NEAR(oval.opacity_at({100.0, 50.0 - 0.9 * 40.0}), (1.0 - 0.9) / (1.0 - 0.6), 1e-12);
  EXPECT_EQ(oval.opacity_at({100.0, 90.5}), 0.0);
}

// A bright ball stands where the camera projects its centre, through a lens that is no pinhole, at both resolutions.
TEST(Cutaway, a_ball_is_drawn_where_the_camera_sees_it) {
  anatomy::Grid grid;
  grid.size = {60, 60, 60};
  grid.spacing = Vec3::Constant(1.0);
  grid.origin = Vec3(-30.0, -30.0, -30.0);
  anatomy::CtVolume ct(grid, -1000);
  const Vec3 ball(8.0, -6.0, 4.0);
  for (int k = 0; k < 60; ++k) {
    for (int j = 0; j < 60; ++j) {
      for (int i = 0; i < 60; ++i) {
        if ((grid.to_patient(Vec3(i, j, k)) - ball).norm() < 4.0) ct.at(i, j, k) = 1500;
      }
    }
  }
  const auto volume = std::make_shared<const PreparedVolume>(prepare_volume(ct, {}, {}));
  const RayCaster caster(volume, {}, 0.5);
  PictureCamera camera;
  camera.patient_from_camera.translation() = Vec3(0.0, 0.0, -300.0);
  const auto bend = [](double x, double y) { return 1.0 + 0.4 * (x * x + y * y); };
  camera.ray = [&](const Eigen::Vector2d& pixel) {
    const double x = (pixel.x() - 100.0) / 600.0, y = (pixel.y() - 80.0) / 600.0;
    return Vec3(x * bend(x, y), y * bend(x, y), 1.0);
  };
  ThreadPool pool(2);
  for (const bool moving : {false, true}) {
    ImageRgb picture(200, 160);
    const Cutaway cast = cast_cutaway(caster, camera, {{110.0, 70.0}, {60.0, 60.0}, 0.9}, 200, 160, pool, moving);
    EXPECT_EQ(cast.coarser(), moving);
    EXPECT_NEAR(blend_cutaway(cast, pool, picture), 3.14159 * 60.0 * 60.0, 60.0);
    // Of its outline, because light from one side moves the centre of brightness.
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    int seen = 0;
    for (int y = 0; y < 160; ++y) {
      for (int x = 0; x < 200; ++x) {
        if (picture.at(x, y).green < 20) continue;
        sum += Eigen::Vector2d(x, y);
        ++seen;
      }
    }
    ASSERT_GT(seen, 100);
    const double depth = 304.0;
    EXPECT_NEAR(sum.x() / seen, 100.0 + 600.0 * 8.0 / depth, 0.6);
    EXPECT_NEAR(sum.y() / seen, 80.0 - 600.0 * 6.0 / depth, 0.6);
  }
}

// A slope of HU, on it a ball with a sharp edge and a rod as thin as the voxels.
anatomy::CtVolume slope_with_ball_and_rod() {
  anatomy::Grid grid;
  grid.size = {60, 60, 60};
  grid.origin = Vec3(-30.0, -30.0, -30.0);
  anatomy::CtVolume ct(grid, -1000);
  for (int k = 10; k < 50; ++k) {
    for (int j = 0; j < 60; ++j) {
      for (int i = 0; i < 60; ++i) {
        const bool in_ball = (grid.to_patient(Vec3(i, j, k)) - Vec3(-12.0, 8.0, 0.0)).norm() < 9.0;
        const bool in_rod = k == 20 && i == 45;
        ct.at(i, j, k) = static_cast<std::int16_t>(in_ball || in_rod ? 1200 : 2 * i);
      }
    }
  }
  return ct;
}

TEST(Cutaway, rays_are_left_out_only_where_their_neighbours_say_what_they_would_meet) {
  const auto volume = std::make_shared<const PreparedVolume>(prepare_volume(slope_with_ball_and_rod(), {}, {}));
  VolumeLook look;
  look.transfer = preset_function(TransferPreset::soft_tissue);
  const RayCaster caster(volume, look, 1.0);
  PictureCamera camera;
  camera.patient_from_camera.translation() = Vec3(0.0, 0.0, -300.0);
  camera.ray = [](const Eigen::Vector2d& pixel) {  // two and a half pixels for a voxel
    return Vec3((pixel.x() - 100.0) / 750.0, (pixel.y() - 80.0) / 750.0, 1.0);
  };
  ThreadPool pool(2);
  const CutawayOval oval{{100.0, 80.0}, {70.0, 60.0}, 0.9};
  for (const bool moving : {false, true}) {
    const auto cast = [&](float most_bend) {
      return cast_cutaway(caster, camera, oval, 200, 160, pool, moving, 160000, most_bend);
    };
    const Cutaway all = cast(-1.0F), most = cast(little_bend);
    ImageRgb exact(200, 160), drawn(200, 160);
    blend_cutaway(all, pool, exact);
    blend_cutaway(most, pool, drawn);
    EXPECT_LT(most.rays, 0.75 * all.rays);
    int bright = 0, off = 0, largest = 0;
    for (int y = 0; y < 160; ++y) {
      for (int x = 0; x < 200; ++x) {
        const int difference = std::abs(exact.at(x, y).green - drawn.at(x, y).green);
        bright += exact.at(x, y).green > 20 ? 1 : 0;
        off += difference > 4 ? 1 : 0;
        largest = std::max(largest, difference);
      }
    }
    EXPECT_GT(bright, 3000);
    EXPECT_LT(off, bright / 100);
    EXPECT_LT(largest, 20);
  }
}

TEST(Cutaway, a_large_oval_is_cast_at_half_the_resolution_and_an_oval_beside_the_picture_not_at_all) {
  anatomy::Grid grid;
  grid.size = {8, 8, 8};
  const auto volume = std::make_shared<const PreparedVolume>(prepare_volume(anatomy::CtVolume(grid, -1000), {}, {}));
  const RayCaster caster(volume, {}, 0.5);
  PictureCamera camera;
  camera.ray = [](const Eigen::Vector2d& pixel) { return Vec3(0.001 * pixel.x(), 0.001 * pixel.y(), 1.0); };
  ThreadPool pool(1);
  const auto cast = [&](const CutawayOval& oval) {
    return cast_cutaway(caster, camera, oval, 400, 300, pool, false, 20000);
  };
  EXPECT_TRUE(cast({{200.0, 150.0}, {150.0, 120.0}, 0.7}).coarser());
  EXPECT_TRUE(cast({{200.0, 150.0}, {150.0, 120.0}, 0.7}).large);
  EXPECT_FALSE(cast({{200.0, 150.0}, {50.0, 50.0}, 0.7}).coarser());
  EXPECT_FALSE(cast({{200.0, 150.0}, {50.0, 50.0}, 0.7}).large);
  const Cutaway beside = cast({{900.0, 150.0}, {50.0, 50.0}, 0.7});
  EXPECT_EQ(beside.rays, 0);
  ImageRgb picture(400, 300);
  EXPECT_EQ(blend_cutaway(beside, pool, picture), 0);
}

}  // namespace
}  // namespace bodkin::imaging
