#include "anatomy/grid.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {

using namespace bodkin::anatomy;
namespace {

Grid random_grid(Random& random) {
  Grid grid;
  for (int& n : grid.size) n = 2 + static_cast<int>(random.uniform(0.0, 60.0));
  for (int axis = 0; axis < 3; ++axis) {
    grid.spacing[axis] = random.uniform(0.2, 5.0);
    grid.origin[axis] = random.uniform(-500.0, 500.0);
  }
  grid.direction = Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), random.normal())
                       .normalized()
                       .toRotationMatrix();
  return grid;
}

TEST(Grid, index_to_patient_and_back_is_the_identity) {
  Random random(1);
  for (int trial = 0; trial < 1000; ++trial) {
    const Grid grid = random_grid(random);
    const Vec3 index(random.uniform(-10, 70), random.uniform(-10, 70), random.uniform(-10, 70));
    EXPECT_LT((grid.to_index(grid.to_patient(index)) - index).norm(), 1e-9);
  }
}

TEST(Grid, a_voxel_centre_is_where_its_header_says) {
  Grid grid;
  grid.size = {4, 5, 6};
  grid.spacing = {1.5, 2.0, 3.0};
  grid.origin = {-10.0, 20.0, 30.0};
  grid.direction.col(0) = Vec3(0, 1, 0);   // i runs to the back
  grid.direction.col(1) = Vec3(0, 0, -1);  // j runs to the feet
  grid.direction.col(2) = Vec3(-1, 0, 0);  // k runs to the right
  EXPECT_EQ(grid.to_patient(Vec3(1, 2, 3)), Vec3(-19.0, 21.5, 26.0));
  EXPECT_EQ(grid.axes(), "PIR");
  EXPECT_EQ(grid.voxel_count(), 120u);
  EXPECT_EQ(grid.offset(3, 4, 5), 119u);
}

TEST(Grid, an_axial_dicom_volume_runs_left_posterior_superior) {
  EXPECT_EQ(Grid{}.axes(), "LPS");
}

TEST(Grid, lattices_are_the_same_only_when_every_corner_agrees) {
  Random random(2);
  Grid a = random_grid(random);
  Grid b = a;
  EXPECT_TRUE(same_lattice(a, b));
  b.origin.x() += 0.01;
  EXPECT_FALSE(same_lattice(a, b));
  EXPECT_TRUE(same_lattice(a, b, 0.02));
  b = a;
  b.size[1] += 1;
  EXPECT_FALSE(same_lattice(a, b));
  b = a;
  b.direction = Eigen::AngleAxisd(0.01, Vec3::UnitZ()).toRotationMatrix() * b.direction;
  EXPECT_FALSE(same_lattice(a, b));
}

}  // namespace
}  // namespace bodkin
