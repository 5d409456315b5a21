// Tissue displacement between the points of a lattice, by laws that a lattice represents exactly.
#include "imaging/tissue_displacement.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::imaging;
namespace {

const PatientBox box = {Vec3(-10.0, 0.0, 5.0), Vec3(50.0, 44.0, 39.0)};

TissueDisplacement moved_by(const PointLattice& lattice, const std::function<Vec3(const Vec3&)>& law) {
  std::vector<float> displacements;
  for (const Vec3& point : lattice.points()) {
    const Vec3 moved = law(point);
    for (Eigen::Index axis = 0; axis < 3; ++axis) displacements.push_back(static_cast<float>(moved[axis]));
  }
  return {lattice, displacements};
}

// Linear in each coordinate.
Vec3 law(const Vec3& rest) {
  return {2.0 + 0.1 * rest.y(), -1.0 - 0.2 * (rest.y() - 20.0), 0.05 * rest.x() - 0.1 * rest.z()};
}

TEST(TissueDisplacement, its_lattice_covers_the_box_with_as_many_points_as_are_allowed) {
  for (const double spacing : {1.0, 4.0, 100.0}) {
    for (const int most : {8, 500, 100'000}) {
      const PointLattice lattice = lattice_around(box, spacing, most);
      EXPECT_GE(lattice.spacing, spacing);
      const auto points = lattice.points();
      EXPECT_LE(points.size(), static_cast<std::size_t>(most));
      EXPECT_TRUE((points.front().array() <= box.low.array() + 1e-9).all());
      EXPECT_TRUE((points.back().array() >= box.high.array() - 1e-9).all());
    }
  }
  EXPECT_EQ(lattice_around(box, 4.0, 100'000).spacing, 4.0);
}

TEST(TissueDisplacement, is_linear_between_the_points_and_beyond_them_as_at_the_border) {
  const TissueDisplacement moved = moved_by(lattice_around(box, 4.0, 100'000), law);
  for (const Vec3& rest : {Vec3(0.0, 10.0, 20.0), Vec3(33.3, 41.7, 7.9), Vec3(-9.9, 0.1, 38.0)})
    EXPECT_LT((moved.of(rest) - law(rest)).norm(), 1e-5) << rest.transpose();
  EXPECT_LT((moved.of(Vec3(20.0, 500.0, 20.0)) - law(Vec3(20.0, 44.0, 20.0))).norm(), 1e-5);
}

TEST(TissueDisplacement, the_way_back_to_rest_is_its_inverse) {
  const TissueDisplacement moved = moved_by(lattice_around(box, 4.0, 100'000), law);
  for (const Vec3& rest : {Vec3(0.0, 10.0, 20.0), Vec3(33.3, 30.0, 12.0)})
    EXPECT_LT((moved.at_rest(rest + law(rest)) - rest).norm(), 0.02 * law(rest).norm()) << rest.transpose();
}

TEST(TissueDisplacement, the_way_back_at_the_points_of_its_lattice_is_that_of_any_place) {
  const TissueDisplacement moved = moved_by(lattice_around(box, 4.0, 100'000), law);
  const RestOffsets offsets = moved.rest_offsets();
  const std::vector<Vec3> points = offsets.lattice.points();
  ASSERT_EQ(offsets.offsets.size(), 3 * points.size());
  for (std::size_t i = 0; i < points.size(); i += 37) {
    const Vec3 offset = Eigen::Map<const Eigen::Vector3f>(offsets.offsets.data() + 3 * i).cast<double>();
    EXPECT_LT((points[i] + offset - moved.at_rest(points[i])).norm(), 1e-5);
  }
}

TEST(TissueDisplacement, two_motions_add_up_from_different_lattices) {
  const auto other = [](const Vec3& rest) { return Vec3(0.1 * rest.x(), 2.0, -0.05 * rest.y()); };
  const TissueDisplacement sum =
      moved_by(lattice_around(box, 4.0, 100'000), law).plus(moved_by(lattice_around(box, 7.0, 100'000), other));
  for (const Vec3& rest : {Vec3(0.0, 10.0, 20.0), Vec3(33.3, 30.0, 12.0)})
    EXPECT_LT((sum.of(rest) - law(rest) - other(rest)).norm(), 1e-4) << rest.transpose();
}

TEST(TissueDisplacement, knows_how_differently_two_tissues_have_moved) {
  const PointLattice lattice = lattice_around(box, 4.0, 100'000);
  const TissueDisplacement moved = moved_by(lattice, law);
  EXPECT_EQ(moved.most_difference(moved), 0.0);
  const TissueDisplacement farther =
      moved_by(lattice, [](const Vec3& rest) { return Vec3(law(rest) + Vec3(0.0, 0.3, -0.7)); });
  EXPECT_NEAR(moved.most_difference(farther), 0.7, 1e-5);
  EXPECT_TRUE(std::isinf(moved.most_difference(moved_by(lattice_around(box, 5.0, 100'000), law))));
}

// HU rise by 10 a mm along y; bone for y > 25.
TEST(TissueDisplacement, a_slice_shows_at_each_pixel_what_has_moved_there) {
  Grid grid;
  grid.size = {41, 45, 41};
  CtVolume ct(grid);
  TissueVolume tissues(grid);
  for (int k = 0; k < 41; ++k) {
    for (int j = 0; j < 45; ++j) {
      for (int i = 0; i < 41; ++i) {
        ct.at(i, j, k) = static_cast<std::int16_t>(10 * j);
        tissues.at(i, j, k) = j > 25 ? tissue::cortical_bone : tissue::muscle;
      }
    }
  }
  const TissueDisplacement moved = moved_by(lattice_around(box, 4.0, 100'000), law);
  // An oblique plane, in which tissue also moves through it.
  const SlicePlane plane = {Vec3(8.0, 8.0, 12.0), Vec3(1.0, 0.0, 1.0).normalized(), Vec3::UnitY(), 0.5, 30, 50};
  const Slice slice = cut_moved(plane, ct, tissues, moved);
  for (int row = 0; row < plane.height; row += 7) {
    for (int column = 0; column < plane.width; column += 7) {
      const double y = (plane.point(column, row).y() + 1.0 - 4.0) / 0.8;  // y + law(y) is the pixel's
      const auto at = static_cast<std::size_t>(row * plane.width + column);
      EXPECT_NEAR(static_cast<double>(slice.hounsfield[at]), 10.0 * y, 1.0);
      if (std::abs(y - 25.5) < 0.05) continue;  // at the border
      EXPECT_EQ(slice.tissues[at], y > 25.5 ? tissue::cortical_bone : tissue::muscle);
    }
  }
}

}  // namespace
}  // namespace bodkin
