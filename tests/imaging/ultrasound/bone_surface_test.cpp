#include "imaging/ultrasound/bone_surface.h"

#include <cmath>

#include "tests/imaging/ultrasound/hand_made_patient.h"
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::imaging;
namespace {

const double soft_impedance = 1.6, bone_impedance = 7.8;

// Bone where `inside(index)`, muscle elsewhere.
template <typename Inside>
AcousticVolume bone_and_muscle(const Vec3& spacing, Inside&& inside) {
  AcousticVolume volume;
  volume.grid.size = {24, 26, 20};
  volume.grid.spacing = spacing;
  for (int k = 0; k < volume.grid.size[2]; ++k) {
    for (int j = 0; j < volume.grid.size[1]; ++j) {
      for (int i = 0; i < volume.grid.size[0]; ++i) {
        const bool bone = inside(Vec3(i, j, k));
        volume.voxels.push_back(AcousticVolume::voxel(checks::impedance_steps(bone ? bone_impedance : soft_impedance),
                                                      bone ? tissue::cortical_bone : tissue::muscle));
      }
    }
  }
  return volume;
}

// Voxels from `height` on, column by column along j, to where the impedance is half way to bone's.
double surface_of(const AcousticVolume& volume, int i, int k) {
  const double half = 0.5 * (soft_impedance + bone_impedance) / AcousticVolume::unit;
  for (int j = 0; j + 1 < volume.grid.size[1]; ++j) {
    const double here = volume.impedance(volume.grid.offset(i, j, k)),
                 next = volume.impedance(volume.grid.offset(i, j + 1, k));
    if (here < half && next >= half) return j + (half - here) / (next - here);
  }
  return -1.0;
}

// Root mean square distance of the surface from the plane j = middle + slope_i i + slope_k k, but for a constant.
double roughness(const AcousticVolume& volume, double slope_i, double slope_k) {
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (int k = 2; k < volume.grid.size[2] - 2; ++k) {
    for (int i = 2; i < volume.grid.size[0] - 2; ++i) {
      const double off = surface_of(volume, i, k) - slope_i * i - slope_k * k;
      sum += off;
      squares += off * off;
      count += 1.0;
    }
  }
  return std::sqrt(squares / count - sum / count * sum / count);
}

TEST(BoneSurface, planes_along_the_lattice_stay_as_they_are) {
  for (int axis = 0; axis < 3; ++axis) {
    AcousticVolume volume = bone_and_muscle(Vec3::Ones(), [&](const Vec3& at) { return at[axis] >= 9.0; });
    const auto before = volume.voxels;
    smooth_bone_surface(volume);
    EXPECT_EQ(volume.voxels, before) << "axis " << axis;
  }
}

TEST(BoneSurface, steps_of_slanted_planes_are_worn_by_a_third_and_more) {
  for (const auto& [slope_i, slope_k] : {std::pair{0.3, 0.0}, {0.2, 0.15}, {0.45, -0.2}, {-0.35, 0.3}}) {
    AcousticVolume volume = bone_and_muscle(Vec3::Ones(), [&, i = slope_i, k = slope_k](const Vec3& at) {
      return at.y() >= 10.0 + i * (at.x() - 12.0) + k * (at.z() - 10.0);
    });
    const double before = roughness(volume, slope_i, slope_k);
    smooth_bone_surface(volume);
    EXPECT_LT(roughness(volume, slope_i, slope_k), 0.667 * before) << slope_i << " " << slope_k;
  }
}

TEST(BoneSurface, ids_stay_gas_takes_no_part_and_nothing_leaves_what_is_around_it) {
  AcousticVolume volume = bone_and_muscle(Vec3::Ones(), [](const Vec3& at) {
    return std::sin(0.7 * at.x()) + std::cos(0.6 * at.y()) + std::sin(0.8 * at.z()) > 0.6;
  });
  for (std::size_t at = 0; at < volume.voxels.size(); at += 7)
    volume.voxels[at] = AcousticVolume::voxel(2, tissue::gas);
  const auto before = volume.voxels;
  smooth_bone_surface(volume);
  const std::int16_t soft = checks::impedance_steps(soft_impedance), bone = checks::impedance_steps(bone_impedance);
  bool any = false;
  for (std::size_t at = 0; at < volume.voxels.size(); ++at) {
    ASSERT_EQ(volume.tissue(at), static_cast<TissueId>(before[at] >> 16));
    if (volume.tissue(at) == tissue::gas) {
      ASSERT_EQ(volume.voxels[at], before[at]);
    } else {
      ASSERT_GE(volume.impedance(at), soft);
      ASSERT_LE(volume.impedance(at), bone);
    }
    any = any || volume.voxels[at] != before[at];
  }
  EXPECT_TRUE(any);
}

TEST(BoneSurface, long_voxels_are_not_mixed_along_their_length) {
  const auto ball = [](const Vec3& at) { return (at - Vec3(11.3, 12.2, 9.0)).norm() < 6.4; };
  AcousticVolume volume = bone_and_muscle(Vec3(1.0, 1.0, 3.0), ball);
  AcousticVolume slice =
      bone_and_muscle(Vec3(1.0, 1.0, 3.0), [&](const Vec3& at) { return ball(Vec3(at.x(), at.y(), 7.0)); });
  smooth_bone_surface(volume);
  smooth_bone_surface(slice);
  const auto layer = static_cast<std::ptrdiff_t>(volume.grid.offset(0, 0, 7)), size = std::ptrdiff_t{24 * 26};
  EXPECT_TRUE(
      std::equal(volume.voxels.begin() + layer, volume.voxels.begin() + layer + size, slice.voxels.begin() + layer));
}

}  // namespace
}  // namespace bodkin
