#include "anatomy/tissue_surface.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"

namespace bodkin {

using namespace bodkin::anatomy;
namespace {

// mm^3 inside a closed surface.
double enclosed(const Surface& surface) {
  double volume = 0.0;
  for (const auto& corners : surface.triangles()) {
    const auto at = [&](std::size_t i) { return surface.vertices()[static_cast<std::size_t>(corners[i])]; };
    volume += at(0).dot(at(1).cross(at(2))) / 6.0;
  }
  return volume;
}

Grid turned_grid(double spacing, int size) {
  Grid grid;
  grid.size = {size, size, size};
  grid.spacing = Vec3::Constant(spacing);
  grid.direction = Eigen::AngleAxisd(0.7, Vec3(1, -2, 3).normalized()).toRotationMatrix();
  grid.origin = Vec3(120.0, -40.0, 900.0);
  return grid;
}

TissueVolume ball(Grid grid, double radius) {
  TissueVolume tissues(grid);
  const Vec3 middle = 0.5 * (grid.size[0] - 1) * Vec3::Ones();
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const double distance = (Vec3(i, j, k) - middle).cwiseProduct(grid.spacing).norm();
        if (distance < radius) tissues.at(i, j, k) = distance < 0.8 * radius ? tissue::muscle : tissue::skin;
      }
    }
  }
  return tissues;
}

TEST(TissueSurface, a_ball_of_voxels_becomes_a_smooth_sphere) {
  for (const bool mirrored : {false, true}) {
    Grid grid = turned_grid(1.0, 70);
    if (mirrored) grid.direction.col(2) *= -1.0;
    const Surface surface = tissue_surface(ball(grid, 30.0), body_tissues(), {});
    EXPECT_TRUE(surface.closed());
    EXPECT_EQ(surface.left_out(), 0u);
    // Smoothing takes about 2^2 / 30 mm off the radius, and facets cut off a little more.
    EXPECT_NEAR(enclosed(surface), 4.0 / 3.0 * std::numbers::pi * std::pow(30.0 - 4.0 / 30.0, 3), 0.01 * 113097.0);
    const Vec3 centre = grid.to_patient(34.5 * Vec3::Ones());
    double lean = 0.0;
    for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
      Vec3 middle = Vec3::Zero();
      for (const int corner : surface.triangles()[t]) {
        const Vec3 vertex = surface.vertices()[static_cast<std::size_t>(corner)];
        ASSERT_NEAR((vertex - centre).norm(), 30.0 - 4.0 / 30.0, 0.2);
        middle += vertex / 3.0;
      }
      lean = std::max(lean, std::acos(surface.normal(t).dot((middle - centre).normalized())));
    }
    EXPECT_LT(lean, 4.0 * std::numbers::pi / 180.0);
  }
}

TEST(TissueSurface, without_smoothing_a_block_keeps_its_faces) {
  Grid grid;
  grid.size = {12, 12, 12};
  TissueVolume tissues(grid);
  for (int k = 3; k < 9; ++k) {
    for (int j = 2; j < 8; ++j) {
      for (int i = 4; i < 10; ++i) tissues.at(i, j, k) = tissue::cortical_bone;
    }
  }
  const Surface surface = tissue_surface(tissues, bone_tissues(), {.edge = 1.0, .smoothing = 0.0});
  Eigen::AlignedBox3d box;
  for (const Vec3& vertex : surface.vertices()) box.extend(vertex);
  EXPECT_NEAR((box.min() - Vec3(3.5, 1.5, 2.5)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((box.max() - Vec3(9.5, 7.5, 8.5)).norm(), 0.0, 1e-9);
}

TEST(TissueSurface, a_body_that_the_image_cuts_off_gets_a_lid) {
  Grid grid;
  grid.size = {20, 24, 10};
  const Surface surface =
      tissue_surface(TissueVolume(grid, tissue::fat), body_tissues(), {.edge = 1.0, .smoothing = 0.5});
  EXPECT_TRUE(surface.closed());
  EXPECT_NEAR(enclosed(surface), 20.0 * 24.0 * 10.0, 0.03 * 4800.0);
}

TEST(TissueSurface, any_voxels_make_a_closed_surface_of_one_fan_per_vertex) {
  Random random(2);
  for (int trial = 0; trial < 20; ++trial) {
    TissueVolume tissues(turned_grid(1.3, 14));
    const double share = random.uniform(0.02, 0.98);
    for (auto& voxel : tissues.voxels) voxel = random.uniform() < share ? tissue::muscle : tissue::air;
    const Surface surface = tissue_surface(tissues, body_tissues(), {.edge = 1.0, .smoothing = 0.0});
    EXPECT_TRUE(surface.closed());  // the constructor has refused more than two triangles at an edge
    // Going around a vertex from triangle to triangle passes all that touch it.
    std::vector<int> touching(surface.vertices().size(), 0), first(surface.vertices().size(), -1);
    for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
      for (const int corner : surface.triangles()[t]) {
        ++touching[static_cast<std::size_t>(corner)];
        first[static_cast<std::size_t>(corner)] = static_cast<int>(t);
      }
    }
    for (std::size_t v = 0; v < touching.size(); ++v) {
      int at = first[v], fan = 0;
      do {
        const auto& corners = surface.triangles()[static_cast<std::size_t>(at)];
        const auto corner = std::find(corners.begin(), corners.end(), static_cast<int>(v)) - corners.begin();
        at = surface.neighbours()[static_cast<std::size_t>(at)][static_cast<std::size_t>(corner)];
        ++fan;
      } while (at != first[v] && fan <= touching[v]);
      ASSERT_EQ(fan, touching[v]) << v;
    }
  }
}

TEST(TissueSurface, refuses_what_it_cannot_draw) {
  const TissueVolume tissues = ball(turned_grid(1.0, 20), 8.0);
  EXPECT_THROW(tissue_surface(tissues, bone_tissues(), {}), InputError);
  EXPECT_THROW(tissue_surface(TissueVolume{}, body_tissues(), {}), InputError);
  EXPECT_THROW(tissue_surface(tissues, body_tissues(), {.edge = 0.0}), InputError);
  EXPECT_THROW(tissue_surface(tissues, body_tissues(), {.smoothing = std::nan("")}), InputError);
}

}  // namespace
}  // namespace bodkin
