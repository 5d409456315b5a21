// Rays through volumes with known results.
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "imaging/volume_rendering/ray_caster.h"

namespace bodkin::imaging {
namespace {

constexpr double everywhere = 1e9;

anatomy::CtVolume block_of(std::int16_t hounsfield, double spacing = 1.0, int size = 40) {
  anatomy::Grid grid;
  grid.size = {size, size, size};
  grid.spacing = Vec3::Constant(spacing);
  grid.origin = Vec3::Constant(-0.5 * (size - 1) * spacing);
  return anatomy::CtVolume(grid, hounsfield);
}

std::shared_ptr<const PreparedVolume> prepared(const anatomy::CtVolume& ct) {
  return std::make_shared<const PreparedVolume>(prepare_volume(ct, {}, {}));
}

// Balls of many HU in air, with noise.
anatomy::CtVolume balls() {
  anatomy::CtVolume ct = block_of(-1000, 1.5, 61);
  Random random(7);
  for (int k = 0; k < 61; ++k) {
    for (int j = 0; j < 61; ++j) {
      for (int i = 0; i < 61; ++i) {
        const Vec3 at(i, j, k);
        double value = -1000.0;
        if ((at - Vec3(30, 30, 30)).norm() < 22.0) value = 40.0;
        if ((at - Vec3(36, 28, 30)).norm() < 8.0) value = 700.0;
        if ((at - Vec3(18, 30, 36)).norm() < 5.0) value = -100.0;
        ct.at(i, j, k) = static_cast<std::int16_t>(value + 20.0 * (random.uniform() - 0.5));
      }
    }
  }
  return ct;
}

VolumeCamera camera_from(const Vec3& eye, int size) {
  VolumeCamera camera;
  camera.eye = eye;
  const Vec3 ahead = -eye.normalized(), right = ahead.cross(Vec3::UnitZ()).normalized(), down = ahead.cross(right);
  const double pixel = 0.6 / size;
  camera.right = pixel * right;
  camera.down = pixel * down;
  camera.first = ahead - 0.5 * (size - 1) * (camera.right + camera.down);
  camera.width = camera.height = size;
  return camera;
}

VolumeLook look_of(VolumeMode mode) {
  VolumeLook look;
  look.mode = mode;
  return look;
}

TEST(RayCaster, a_homogeneous_slab_takes_the_same_light_at_any_step) {
  const auto volume = prepared(block_of(300));  // 40 mm with its outer half voxels
  VolumeLook look = look_of(VolumeMode::colour);
  const double opacity = 0.05;  // of 1 mm
  look.transfer.opacity = {{-1024.0, opacity}, {3071.0, opacity}};
  const double expected = 1.0 - std::pow(1.0 - opacity, 40.0);
  for (const double step : {0.2, 0.5, 1.0, 1.7, 3.0, 11.0, 100.0}) {
    const CastRay ray = RayCaster(volume, look, step).cast(Vec3(0.3, -200.0, 1.2), Vec3::UnitY(), everywhere);
    EXPECT_NEAR(ray.opacity, expected, 2e-4) << step;
  }
}

TEST(RayCaster, a_slab_before_a_place_takes_what_it_is_thick) {
  const auto volume = prepared(block_of(300));
  VolumeLook look = look_of(VolumeMode::colour);
  look.transfer.opacity = {{-1024.0, 0.05}, {3071.0, 0.05}};
  const RayCaster caster(volume, look, 0.7);
  for (const double depth : {0.0, 3.3, 10.0, 40.0, 60.0}) {
    const CastRay ray = caster.cast(Vec3(0.0, -220.0, 0.0), Vec3::UnitY(), 200.0 + depth);
    EXPECT_NEAR(ray.opacity, 1.0 - std::pow(0.95, std::min(depth, 40.0)), 2e-4) << depth;
  }
}

TEST(RayCaster, the_maximum_of_a_block_in_air_is_its_value) {
  anatomy::CtVolume ct = block_of(-1000);
  for (int k = 10; k < 20; ++k) {
    for (int j = 10; j < 20; ++j) {
      for (int i = 10; i < 20; ++i) ct.at(i, j, k) = 850;
    }
  }
  const RayCaster caster(prepared(ct), look_of(VolumeMode::maximum), 0.5);
  EXPECT_FLOAT_EQ(caster.cast(Vec3(-5.0, -200.0, -5.0), Vec3::UnitY(), everywhere).most, 850.0F);
  EXPECT_FLOAT_EQ(caster.cast(Vec3(10.0, -200.0, 10.0), Vec3::UnitY(), everywhere).most, -1000.0F);
}

TEST(RayCaster, the_sum_along_an_axis_is_the_integral) {
  // Twice water in 40 mm, then a ramp of 10 HU/mm across the ray's way.
  const RayCaster flat(prepared(block_of(1000)), look_of(VolumeMode::sum), 0.9);
  EXPECT_NEAR(flat.cast(Vec3(0.0, -200.0, 0.0), Vec3::UnitY(), everywhere).sum, 80.0, 1e-3);
  anatomy::CtVolume ct = block_of(0);
  for (int k = 0; k < 40; ++k) {
    for (int j = 0; j < 40; ++j) {
      for (int i = 0; i < 40; ++i) ct.at(i, j, k) = static_cast<std::int16_t>(10 * j);
    }
  }
  // Linear over 39 mm between the outer centres, and constant in the outer half voxels: 40 mm + 0.01 * 195 * 40 mm.
  for (const double step : {0.1, 0.5}) {
    const CastRay ray = RayCaster(prepared(ct), look_of(VolumeMode::sum), step)
                            .cast(Vec3(0.2, -200.0, 3.1), Vec3::UnitY(), everywhere);
    EXPECT_NEAR(ray.sum, 40.0 * (1.0 + 0.001 * 195.0), 0.03) << step;
  }
}

TEST(RayCaster, anisotropic_turned_voxels_sum_to_the_same_length) {
  anatomy::Grid grid;
  grid.size = {20, 30, 10};
  grid.spacing = Vec3(1.0, 0.5, 4.0);
  grid.direction = Eigen::AngleAxisd(0.5 * 3.14159265358979, Vec3::UnitX()).toRotationMatrix();  // k runs towards -y
  grid.origin = grid.direction * Vec3(-9.5, -7.25, -18.0);
  const RayCaster caster(prepared(anatomy::CtVolume(grid, 0)), look_of(VolumeMode::sum), 0.4);
  EXPECT_NEAR(caster.cast(Vec3(0.0, -200.0, 0.0), Vec3::UnitY(), everywhere).sum, 40.0, 1e-3);
  EXPECT_NEAR(caster.cast(Vec3(0.0, 0.0, -200.0), Vec3::UnitZ(), everywhere).sum, 15.0, 1e-3);
}

TEST(RayCaster, a_ray_that_misses_is_background) {
  for (const VolumeMode mode : {VolumeMode::colour, VolumeMode::grey, VolumeMode::maximum, VolumeMode::sum}) {
    VolumeLook look = look_of(mode);
    look.background = 0x123456;
    const RayCaster caster(prepared(block_of(800)), look, 1.0);
    const bool lit = mode == VolumeMode::colour || mode == VolumeMode::grey;
    EXPECT_EQ(caster.colour(caster.cast(Vec3(0.0, -200.0, 50.0), Vec3::UnitY(), everywhere)),
              lit ? 0xFF123456U : 0xFF000000U);
    EXPECT_NE(caster.colour(caster.cast(Vec3(0.0, -200.0, 0.0), Vec3::UnitY(), everywhere)),
              lit ? 0xFF123456U : 0xFF000000U);
  }
}

TEST(RayCaster, neither_threads_nor_skipped_blocks_change_a_bit) {
  const auto volume = prepared(balls());
  const VolumeCamera camera = camera_from(Vec3(90.0, -260.0, 70.0), 96);
  ThreadPool alone(1), many(4);
  for (const VolumeMode mode : {VolumeMode::colour, VolumeMode::grey, VolumeMode::maximum, VolumeMode::sum}) {
    RayCaster caster(volume, look_of(mode), 0.8);
    std::vector<std::uint32_t> one, four, walked;
    ASSERT_TRUE(caster.draw(camera, alone, one));
    ASSERT_TRUE(caster.draw(camera, many, four));
    EXPECT_EQ(one, four);
    caster.skip_nothing();
    ASSERT_TRUE(caster.draw(camera, many, walked));
    EXPECT_EQ(one, walked) << static_cast<int>(mode);
  }
}

// Steps are longer when little of a ray's light is left; with a step of a quarter of a voxel there are four times as
// many.
TEST(RayCaster, long_steps_far_behind_are_not_seen) {
  const auto volume = prepared(balls());
  const VolumeCamera camera = camera_from(Vec3(90.0, -260.0, 70.0), 96);
  ThreadPool pool(2);
  VolumeLook look = look_of(VolumeMode::colour);
  look.transfer = preset_function(TransferPreset::soft_tissue);
  for (OpacityPoint& point : look.transfer.opacity) point.opacity *= 2.0;  // all light is gone within the ball
  std::vector<std::uint32_t> usual, fine;
  ASSERT_TRUE(RayCaster(volume, look, 1.5).draw(camera, pool, usual));
  ASSERT_TRUE(RayCaster(volume, look, 0.375).draw(camera, pool, fine));
  double sum = 0.0;
  int most = 0;
  for (std::size_t i = 0; i < usual.size(); ++i) {
    for (const unsigned shift : {0U, 8U, 16U}) {
      const int off =
          std::abs(static_cast<int>(usual[i] >> shift & 0xFFU) - static_cast<int>(fine[i] >> shift & 0xFFU));
      sum += off;
      most = std::max(most, off);
    }
  }
  std::printf("of 255: %.2f in the mean, %d at most\n", sum / (3.0 * static_cast<double>(usual.size())), most);
  EXPECT_LT(sum / (3.0 * static_cast<double>(usual.size())), 1.5);
  EXPECT_LT(most, 64);  // at outlines, where rays of both meet the edge between different samples
}

// Light along a ray by the plain sum in double precision: every sample in turn, no block skipped, equal steps, to the
// end.
CastRay plain_ray(const anatomy::CtVolume& ct, const TransferFunction& transfer, double step, const Vec3& eye,
                  const Vec3& direction) {
  const Vec3 half = 0.5 * ct.grid.spacing, low = ct.grid.origin - half;
  const Vec3 high = ct.grid.to_patient(Vec3::Constant(ct.grid.size[0] - 1)) + half;
  double enters = 0.0, leaves = 1e9;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (low[axis] - eye[axis]) / direction[axis], b = (high[axis] - eye[axis]) / direction[axis];
    enters = std::max(enters, std::min(a, b));
    leaves = std::min(leaves, std::max(a, b));
  }
  double left = 1.0;
  std::array<double, 3> light{};
  for (double at = enters; at < leaves; at += step) {
    const double length = std::min(step, leaves - at);
    Vec3 index = ct.grid.to_index(eye + (at + 0.5 * length) * direction);
    index = index.cwiseMax(0.0).cwiseMin(ct.grid.size[0] - 1.0);
    const double hounsfield = anatomy::linear(ct, ct.grid.to_patient(index), -1000.0);
    const double opacity = 1.0 - std::pow(1.0 - transfer.opacity_at(hounsfield), length);
    const std::array<double, 3> colour = transfer.colour_at(hounsfield);
    for (std::size_t c = 0; c < 3; ++c) light[c] += left * opacity * colour[c];
    left *= 1.0 - opacity;
  }
  const auto part = [&](std::size_t c) { return static_cast<float>(light[c]); };
  return {part(0), part(1), part(2), static_cast<float>(1.0 - left)};
}

struct Off {
  double mean = 0.0, most = 0.0;  // of 255
};
Off off_from_plain(const anatomy::CtVolume& ct, const TransferFunction& transfer) {
  constexpr double step = 1.5;
  VolumeLook look = look_of(VolumeMode::colour);
  look.shaded = false;
  look.transfer = transfer;
  const RayCaster caster(prepared(ct), look, step);
  Off off;
  int parts = 0;
  for (double x = -31.0; x < 32.0; x += 3.1) {
    for (double z = -31.0; z < 32.0; z += 3.1) {
      const Vec3 eye(90.0, -260.0, 70.0), direction = (Vec3(x, 0.001, z) - eye).normalized();
      const CastRay ray = caster.cast(eye, direction, everywhere);
      const CastRay plain = plain_ray(ct, transfer, step, eye, direction);
      for (const float difference :
           {ray.red - plain.red, ray.green - plain.green, ray.blue - plain.blue, ray.opacity - plain.opacity}) {
        const double here = 255.0 * static_cast<double>(std::abs(difference));
        off.mean += here;
        off.most = std::max(off.most, here);
        ++parts;
      }
    }
  }
  off.mean /= parts;
  return off;
}

TEST(RayCaster, rays_meet_what_a_plain_sum_does) {
  const anatomy::CtVolume ct = balls();
  for (const TransferPreset preset : transfer_presets) {
    // So faint that more than a quarter of the light is left everywhere: the same samples. What is left are the rows
    // of the tables, of one HU each.
    TransferFunction transfer = preset_function(preset);
    for (OpacityPoint& point : transfer.opacity) point.opacity *= 0.02;
    const Off faint = off_from_plain(ct, transfer);
    // As displayed, with longer steps behind that, and an end where nothing is visible.
    const Off usual = off_from_plain(ct, preset_function(preset));
    std::printf("%s: of 255, %.4f in the mean, %.3f at most; with longer steps %.3f, %.1f\n",
                std::string(name_of(preset)).c_str(), faint.mean, faint.most, usual.mean, usual.most);
    EXPECT_LT(faint.mean, 0.01);
    EXPECT_LT(faint.most, 0.1);
    EXPECT_LT(usual.mean, 0.5);
    EXPECT_LT(usual.most, 16.0);  // a quarter of the light, at an edge that a step meets late
  }
}

// How tissue has moved, on a lattice that is wider than block_of() by 20 mm on every side.
RestOffsets offsets_of(const std::function<Vec3(const Vec3&)>& law) {
  RestOffsets made{{Vec3::Constant(-70.0), 5.0, {29, 29, 29}}, {}};
  for (int k = 0; k < 29; ++k) {
    for (int j = 0; j < 29; ++j) {
      for (int i = 0; i < 29; ++i) {
        for (const double part : law(made.lattice.corner + made.lattice.spacing * Vec3(i, j, k)))
          made.offsets.push_back(static_cast<float>(part));
      }
    }
  }
  return made;
}

// Water from y = -20 to 20 mm in air. Its front is pressed in by 10 mm and its back rests, so 30 mm of it are left:
// what now is at y lay at (y - 5) / 0.75. From all sides the ray meets as much as the law says.
TEST(RayCaster, pressed_tissue_is_met_where_it_is_now) {
  anatomy::CtVolume ct = block_of(-1000, 1.0, 80);
  for (int k = 0; k < 80; ++k)
    for (int j = 20; j < 60; ++j)
      for (int i = 0; i < 80; ++i) ct.at(i, j, k) = 0;
  const RestOffsets pressed = offsets_of(
      [](const Vec3& now) { return Vec3(0.0, std::clamp((now.y() - 5.0) / 0.75, -60.0, 60.0) - now.y(), 0.0); });
  for (const double step : {0.3, 1.0, 4.0}) {
    RayCaster caster(prepared(ct), look_of(VolumeMode::sum), step);
    const Vec3 eye(0.3, -200.0, 1.2), slanted = Vec3(0.1, 1.0, -0.05).normalized();
    EXPECT_NEAR(caster.cast(eye, Vec3::UnitY(), everywhere).sum, 40.0, 0.3 + 0.3 * step);
    caster.set_moved(&pressed);
    EXPECT_NEAR(caster.cast(eye, Vec3::UnitY(), everywhere).sum, 30.0, 0.3 + 0.3 * step);
    EXPECT_NEAR(caster.cast(eye, slanted, everywhere).sum, 30.0 / slanted.y(), 0.3 + 0.3 * step);
    EXPECT_NEAR(caster.cast(eye, Vec3::UnitY(), 195.0).sum, 5.0, 0.3 + 0.3 * step);  // until y = -5
    caster.set_moved(nullptr);
    EXPECT_NEAR(caster.cast(eye, Vec3::UnitY(), everywhere).sum, 40.0, 0.3 + 0.3 * step);
  }
}

// A shift of the whole tissue looks like the opposite shift of the eye; the samples lie elsewhere along the rays, so
// they are taken close together.
TEST(RayCaster, tissue_that_has_moved_looks_as_from_an_eye_that_has_moved_the_other_way) {
  const Vec3 motion(6.0, -5.0, 9.0);
  const RestOffsets moved = offsets_of([&](const Vec3& /*now*/) { return Vec3(-motion); });
  for (const VolumeMode mode : {VolumeMode::colour, VolumeMode::maximum}) {
    const RayCaster still(prepared(balls()), look_of(mode), 0.1);
    RayCaster caster(prepared(balls()), look_of(mode), 0.1), walked(prepared(balls()), look_of(mode), 0.1);
    caster.set_moved(&moved);
    walked.set_moved(&moved);
    walked.skip_nothing();
    const Vec3 eye(90.0, -260.0, 70.0);
    double off = 0.0;
    int rays = 0;
    for (double x = -25.0; x < 25.0; x += 3.1) {
      for (double z = -25.0; z < 25.0; z += 3.7, ++rays) {
        const Vec3 direction = (Vec3(x, 0.0, z) + motion - eye).normalized();
        const CastRay there = still.cast(eye - motion, direction, everywhere),
                      here = caster.cast(eye, direction, everywhere);
        off += static_cast<double>(std::abs(here.red - there.red) + std::abs(here.opacity - there.opacity));
        EXPECT_NEAR(here.most, there.most, 12.0);
        EXPECT_NEAR(here.red, walked.cast(eye, direction, everywhere).red, 1e-4);  // but for other packets' rounding
      }
    }
    EXPECT_LT(off / rays, 0.004) << static_cast<int>(mode);
  }
}

TEST(RayCaster, asking_the_memory_ahead_changes_no_bit) {
  const RayCaster caster(prepared(balls()), look_of(VolumeMode::colour), 0.8);
  const Vec3 eye(90.0, -260.0, 70.0);
  for (double x = -31.0; x < 32.0; x += 4.3) {
    const Vec3 direction = (Vec3(x, 0.0, 0.5 * x) - eye).normalized();
    const CastRay usual = caster.cast(eye, direction, everywhere);
    const CastRay ahead = caster.cast(eye, direction, everywhere, true);
    EXPECT_EQ(usual.red, ahead.red);
    EXPECT_EQ(usual.opacity, ahead.opacity);
  }
}

TEST(RayCaster, a_drawing_that_is_cancelled_says_so) {
  const RayCaster caster(prepared(balls()), look_of(VolumeMode::colour), 0.8);
  ThreadPool pool(2);
  std::vector<std::uint32_t> pixels;
  EXPECT_FALSE(caster.draw(camera_from(Vec3(0.0, -260.0, 0.0), 64), pool, pixels, [] { return true; }));
}

TEST(RayCaster, an_edge_that_faces_the_light_is_brighter_than_one_seen_aslant) {
  VolumeLook look = look_of(VolumeMode::colour);
  look.transfer = {{{-1024.0, 0.0}, {-600.0, 0.0}, {-300.0, 0.9}, {3071.0, 0.9}}, {{0.0, 0xFFFFFF}}};
  const RayCaster caster(prepared(balls()), look, 0.4);
  const CastRay middle = caster.cast(Vec3(0.0, -200.0, 0.0), Vec3::UnitY(), everywhere);
  const CastRay rim = caster.cast(Vec3(31.0, -200.0, 0.0), Vec3::UnitY(), everywhere);  // of 33 mm
  ASSERT_GT(middle.opacity, 0.9F);
  ASSERT_GT(rim.opacity, 0.9F);
  EXPECT_GT(middle.red, 1.3F * rim.red);
}

TEST(RayCaster, tissues_can_have_their_own_colours) {
  const anatomy::CtVolume ct = block_of(300);
  anatomy::TissueVolume tissues(ct.grid, 3);
  const auto volume = std::make_shared<const PreparedVolume>(prepare_volume(ct, tissues, {}));
  VolumeLook look = look_of(VolumeMode::colour);
  look.shaded = false;
  look.tissue_colours = true;
  look.tissues[3] = 0x00FF00;
  const CastRay ray = RayCaster(volume, look, 1.0).cast(Vec3(0.0, -200.0, 0.0), Vec3::UnitY(), everywhere);
  EXPECT_GT(ray.green, 0.9F);
  EXPECT_EQ(ray.red, 0.0F);
}

TEST(PreparedVolume, a_large_ct_becomes_coarser_and_stays_where_it_is) {
  anatomy::CtVolume ct = block_of(-1000, 1.0, 64);
  for (int k = 0; k < 64; ++k) {
    for (int j = 0; j < 64; ++j) {
      for (int i = 32; i < 64; ++i) ct.at(i, j, k) = 1000;
    }
  }
  const PreparedVolume made = prepare_volume(ct, {}, {}, 40000);
  EXPECT_LE(made.grid.voxel_count(), 40000U);
  EXPECT_EQ(made.grid.size, (std::array<int, 3>{32, 32, 32}));
  EXPECT_NEAR((made.grid.to_patient(Vec3::Constant(15.5)) - ct.grid.to_patient(Vec3::Constant(31.5))).norm(), 0.0,
              1e-9);
  EXPECT_EQ(made.hounsfield[made.offset(16, 5, 5)], -1000);
  EXPECT_EQ(made.hounsfield[made.offset(17, 5, 5)], 1000);
}

// Every voxel and its neighbours behind it, also where a brick ends; the border repeats the outermost voxels.
TEST(PreparedVolume, a_brick_has_each_voxel_and_its_neighbours_next_to_it) {
  anatomy::Grid grid;
  grid.size = {19, 14, 23};  // no multiples of a block
  anatomy::CtVolume ct(grid);
  for (std::size_t v = 0; v < ct.voxels.size(); ++v) ct.voxels[v] = static_cast<std::int16_t>(v % 4000 - 1000);
  const PreparedVolume made = prepare_volume(ct, {}, {});
  const auto expected = [&](int i, int j, int k) {
    return ct.at(std::clamp(i - 1, 0, 18), std::clamp(j - 1, 0, 13), std::clamp(k - 1, 0, 22));
  };
  constexpr std::size_t row = PreparedVolume::brick_side, slice = row * row;
  ASSERT_EQ(made.size, (std::array<int, 3>{21, 16, 25}));
  for (int k = 0; k < 24; ++k) {
    for (int j = 0; j < 15; ++j) {
      for (int i = 0; i < 20; ++i) {
        const std::int16_t* const voxel = &made.hounsfield[made.offset(i, j, k)];
        ASSERT_EQ(voxel[0], expected(i, j, k)) << i << " " << j << " " << k;
        ASSERT_EQ(voxel[1], expected(i + 1, j, k)) << i << " " << j << " " << k;
        ASSERT_EQ(voxel[row], expected(i, j + 1, k)) << i << " " << j << " " << k;
        ASSERT_EQ(voxel[slice], expected(i, j, k + 1)) << i << " " << j << " " << k;
        ASSERT_EQ(voxel[slice + row + 1], expected(i + 1, j + 1, k + 1)) << i << " " << j << " " << k;
      }
    }
  }
}

TEST(PreparedVolume, needs_a_ct_or_tissues) {
  EXPECT_THROW(prepare_volume({}, {}, {}), InputError);
}

TEST(TransferFunction, is_linear_between_its_points) {
  const TransferFunction made{{{0.0, 0.0}, {100.0, 1.0}}, {{0.0, 0x000000}, {100.0, 0xFF8000}}};
  EXPECT_DOUBLE_EQ(made.opacity_at(25.0), 0.25);
  EXPECT_DOUBLE_EQ(made.opacity_at(-500.0), 0.0);
  EXPECT_DOUBLE_EQ(made.opacity_at(500.0), 1.0);
  EXPECT_DOUBLE_EQ(made.colour_at(50.0)[0], 0.5);
}

TEST(TransferFunction, points_stay_in_order_however_they_are_drawn) {
  TransferFunction made{{{0.0, 0.0}, {100.0, 1.0}}, {}};
  const std::size_t added = made.add_point(50.0, 0.2);
  EXPECT_EQ(added, 1U);
  made.move_point(added, 5000.0, 7.0);
  EXPECT_EQ(made.opacity[1], (OpacityPoint{99.0, 1.0}));
  made.move_point(0, 5000.0, -1.0);
  EXPECT_EQ(made.opacity[0], (OpacityPoint{98.0, 0.0}));
  made.remove_point(added);
  made.remove_point(0);  // two stay
  EXPECT_EQ(made.opacity.size(), 2U);
}

TEST(TransferFunction, twice_the_density_takes_the_light_of_twice_the_way) {
  const TransferFunction made = adjusted({{{0.0, 0.3}}, {}}, 50.0, 2.0);
  EXPECT_DOUBLE_EQ(made.opacity[0].opacity, 1.0 - 0.7 * 0.7);
  EXPECT_DOUBLE_EQ(made.opacity[0].hounsfield, 50.0);
}

}  // namespace
}  // namespace bodkin::imaging
