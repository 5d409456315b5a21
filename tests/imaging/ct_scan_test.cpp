#include "imaging/ct_scan.h"

#include <cmath>

#include <gtest/gtest.h>

namespace bodkin::imaging {
namespace {

// A block of 40 x 30 x 60 voxels with HU from a function.
template <typename Hounsfield>
anatomy::CtVolume block(const Hounsfield& hounsfield) {
  anatomy::Grid grid;
  grid.size = {40, 30, 60};
  grid.origin = Vec3(-20.0, -15.0, 100.0);
  anatomy::CtVolume ct(grid);
  for (int k = 0; k < 60; ++k) {
    for (int j = 0; j < 30; ++j) {
      for (int i = 0; i < 40; ++i)
        ct.at(i, j, k) = static_cast<std::int16_t>(hounsfield(grid.to_patient(Vec3(i, j, k))));
    }
  }
  return ct;
}

CtScan scan_of(const anatomy::CtVolume& ct, const ScanProtocol& protocol, std::optional<ScannedNeedle> needle = {}) {
  CtScan scan{protocol, scan_plane(ct.grid), needle, {}};
  for (const double z : slice_positions(protocol))
    scan.slices.push_back(take_slice(ct, scan.plane, protocol, z, needle));
  return scan;
}

std::int16_t pixel(const CtScan& scan, const ScanSlice& slice, const Vec3& point) {
  const Eigen::Vector2d at = scan.plane.place(point);
  return slice.hounsfield[static_cast<std::size_t>(std::lround(at.y()) * scan.plane.width + std::lround(at.x()))];
}

TEST(CtScan, slices_lie_where_the_protocol_says) {
  EXPECT_EQ(slice_positions({110.0, 130.0, 5.0, 5.0}), (std::vector<double>{110.0, 115.0, 120.0, 125.0, 130.0}));
  EXPECT_EQ(slice_positions({130.0, 117.0, 5.0, 5.0}), (std::vector<double>{130.0, 125.0, 120.0}));
  EXPECT_EQ(slice_positions({130.0, 130.0, 5.0, 5.0}).size(), 1U);
  const CtScan scan = scan_of(block([](const Vec3&) { return 0; }), {110.0, 130.0, 2.0, 10.0});
  ASSERT_EQ(scan.slices.size(), 3U);
  EXPECT_EQ(scan.slices[1].z, 120.0);
}

TEST(CtScan, a_protocol_beyond_the_scanner_is_refused_in_a_sentence) {
  EXPECT_EQ(trouble_with({}), "");
  EXPECT_NE(trouble_with({0.0, 10.0, 12.0, 5.0}).find("12 mm"), std::string::npos);
  EXPECT_NE(trouble_with({0.0, 10.0, 5.0, 0.1}).find("0.1 mm"), std::string::npos);
  EXPECT_TRUE(slice_positions({0.0, 10.0, 12.0, 5.0}).empty());
}

TEST(CtScan, a_slice_is_the_mean_over_its_thickness) {
  const anatomy::CtVolume ramp =
      block([](const Vec3& point) { return 10.0 * (point.z() - 100.0) + 2.0 * point.x(); });
  for (const double thickness : {0.5, 1.0, 4.0, 10.0}) {
    const CtScan scan = scan_of(ramp, {120.0, 130.0, thickness, 10.0});
    EXPECT_NEAR(pixel(scan, scan.slices[0], Vec3(5.0, 0.0, 120.0)), 210.0, 1.0) << thickness;
  }
  // A sheet of 2 mm at 1000 HU in a slice of 8 mm of water is a quarter of it.
  const anatomy::CtVolume sheet =
      block([](const Vec3& point) { return std::abs(point.z() - 130.5) < 1.0 ? 1000.0 : 0.0; });
  const CtScan scan = scan_of(sheet, {130.5, 130.5, 8.0, 8.0});
  EXPECT_NEAR(pixel(scan, scan.slices[0], Vec3::Zero()), 250.0, 2.0);
}

TEST(CtScan, gaps_are_gaps) {
  const CtScan scan = scan_of(block([](const Vec3&) { return 50; }), {110.0, 150.0, 2.0, 10.0});
  EXPECT_EQ(scan.slice_at(115.0), nullptr);
  EXPECT_EQ(scan.slice_at(160.0), nullptr);
  ASSERT_NE(scan.slice_at(120.9), nullptr);
  EXPECT_EQ(scan.slice_at(120.9)->z, 120.0);
  const ReformattedSlice side = reformatted(scan, Reformat::sagittal, 20);
  const auto at = [&](double z) {
    return side.hounsfield[static_cast<std::size_t>(std::floor((side.top - z) / side.pixel)) *
                               static_cast<std::size_t>(side.width) +
                           15U];
  };
  EXPECT_EQ(at(120.5), 50);
  EXPECT_EQ(at(115.0), nothing_scanned);
}

TEST(CtScan, the_needle_is_metal_on_its_line_and_nowhere_else) {
  const anatomy::CtVolume ct = block([](const Vec3&) { return 40; });
  ScannedNeedle needle;
  const Vec3 tip(-4.0, 2.0, 122.0), axis = Vec3(-0.6, 0.2, -0.4).normalized();
  needle.pose = needle_pose(tip, axis);
  needle.length = 60.0;
  const CtScan scan = scan_of(ct, {105.0, 155.0, 1.0, 1.0}, needle);
  int metal = 0;
  for (const ScanSlice& slice : scan.slices) {
    for (int row = 0; row < scan.plane.height; ++row) {
      for (int column = 0; column < scan.plane.width; ++column) {
        const Vec3 point = scan.point(slice, column, row);
        const double along = (point - tip).dot(axis), off = (point - tip - along * axis).norm();
        const std::int16_t value = slice.hounsfield[static_cast<std::size_t>(row * scan.plane.width + column)];
        if (value > 1000) {
          ++metal;
          EXPECT_LT(off, needle.radius + scan.plane.pixel + 0.5) << point.transpose();
          EXPECT_LT(along, scan.plane.pixel + 0.6);
        } else {
          EXPECT_FALSE(along < -1.0 && off < 0.2) << point.transpose();
        }
      }
    }
  }
  EXPECT_GT(metal, 30);
}

TEST(CtScan, beyond_the_ct_is_air) {
  const CtScan scan = scan_of(block([](const Vec3&) { return 40; }), {90.0, 90.0, 4.0, 4.0});
  EXPECT_EQ(pixel(scan, scan.slices[0], Vec3(0.0, 0.0, 90.0)), -1000);
}

TEST(CtScan, a_soft_kernel_blurs_an_edge_and_a_sharp_one_overshoots) {
  const anatomy::CtVolume edge = block([](const Vec3& point) { return point.x() < 0.0 ? 0 : 100; });
  const auto at = [&](ScanKernel kernel, double x) {
    const CtScan scan = scan_of(edge, {130.0, 130.0, 1.0, 1.0, kernel});
    return static_cast<int>(pixel(scan, scan.slices[0], Vec3(x, 0.0, 130.0)));
  };
  EXPECT_EQ(at(ScanKernel::standard, -1.0), 0);
  EXPECT_EQ(at(ScanKernel::soft, -1.0), 25);
  EXPECT_LT(at(ScanKernel::sharp, -1.0), -20);
  for (const ScanKernel kernel : {ScanKernel::soft, ScanKernel::sharp}) EXPECT_EQ(at(kernel, 10.0), 100);
}

TEST(CtScan, the_scout_shows_dense_columns_bright_with_the_head_above) {
  const anatomy::CtVolume ct =
      block([](const Vec3& point) { return point.x() > 0.0 && point.z() > 140.0 ? 800 : -1000; });
  const Scout front = make_scout(ct, ScoutView::frontal), side = make_scout(ct, ScoutView::lateral);
  EXPECT_EQ(front.width, 40);
  EXPECT_EQ(side.width, 30);
  EXPECT_EQ(front.height, 60);
  EXPECT_DOUBLE_EQ(front.top, 159.5);
  EXPECT_EQ(front.grey[static_cast<std::size_t>(10 * 40 + 30)], 255);
  EXPECT_EQ(front.grey[static_cast<std::size_t>(10 * 40 + 10)], 0);
  EXPECT_EQ(front.grey[static_cast<std::size_t>(50 * 40 + 30)], 0);
}

}  // namespace
}  // namespace bodkin::imaging
