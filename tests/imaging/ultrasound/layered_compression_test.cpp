#include "imaging/ultrasound/layered_compression.h"

#include <cmath>
#include <limits>

#include "tests/io/scratch_folder.h"
#include <gtest/gtest.h>

#include "anatomy/tissue.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::imaging;
namespace {

constexpr double soft_young = 0.01, firm_young = 0.04;  // MPa

// `first` cells of one modulus, then `second` of another.
std::vector<double> two_layers(std::size_t first, double first_young, std::size_t second, double second_young) {
  std::vector<double> moduli(first, first_young);
  moduli.insert(moduli.end(), second, second_young);
  return moduli;
}

// Every sample increases, and the displacement falls from the press to the excess.
void expect_monotone(const LayeredCompression& tissue) {
  const auto depths = tissue.rest_depths();
  EXPECT_EQ(depths.front(), 0.0F);
  for (std::size_t i = 1; i < depths.size(); ++i) {
    const double stretched = static_cast<double>(depths[i] - depths[i - 1]) / tissue.spacing();
    ASSERT_GE(stretched, 1.0 - 1e-4) << i;
    ASSERT_LE(stretched, 1.0 / (1.0 - LayeredCompression::most_strain) + 1e-4) << i;
  }
  EXPECT_NEAR(tissue.moved(0.0), tissue.press(), 1e-6);
  const double end = tissue.far_end() - tissue.press() + tissue.excess();  // mm below the face, now
  EXPECT_NEAR(tissue.moved(end + tissue.spacing()), tissue.excess(), 1e-4);
  EXPECT_NEAR(tissue.moved(1000.0), tissue.excess(), 1e-6);
}

TEST(LayeredCompression, two_layers_share_the_way_as_springs_in_series) {
  LayeredCompression tissue(40.0, 0.5);
  const double press = 6.0, thick = 10.0, deep = 30.0;  // mm
  tissue.settle(two_layers(20, soft_young, 60, firm_young), press);
  const double stress = press / (thick / soft_young + deep / firm_young);  // MPa
  const double soft = stress / soft_young, firm = stress / firm_young;     // strains
  ASSERT_LT(soft, LayeredCompression::most_strain);
  for (double depth = 0.0; depth <= 34.0; depth += 0.13) {
    const double border = thick * (1.0 - soft);  // mm below the face, where the layers meet now
    const double rest = depth < border ? depth / (1.0 - soft) : thick + (depth - border) / (1.0 - firm);
    // Between two samples the line is straight, also where the border lies between them.
    EXPECT_NEAR(tissue.rest_depth(depth), rest, std::abs(depth - border) < 0.5 ? 0.15 : 1e-4) << depth;
  }
  EXPECT_NEAR(tissue.moved(thick * (1.0 - soft)), press - soft * thick, 0.1);
  EXPECT_EQ(tissue.far_end(), 40.0);
  EXPECT_EQ(tissue.excess(), 0.0);
  EXPECT_NEAR(tissue.moved(35.0), 0.0, 1e-4) << "below the far end nothing moves";
  expect_monotone(tissue);
}

TEST(LayeredCompression, a_layer_gives_no_more_than_its_most_and_the_rest_goes_deeper) {
  LayeredCompression tissue(30.0, 0.25);
  const double press = 8.0, thick = 5.0, deep = 25.0;  // mm; alone, the soft layer would take 7.7 of its 5 mm
  tissue.settle(two_layers(20, 0.001, 100, 0.1), press);
  const double taken = LayeredCompression::most_strain * thick;
  const double firm = (press - taken) / deep;
  EXPECT_NEAR(tissue.rest_depth(1.0), 1.0 / (1.0 - LayeredCompression::most_strain), 1e-4);
  EXPECT_NEAR(tissue.moved(thick - taken), press - taken, 0.01);
  EXPECT_NEAR(tissue.rest_depth(12.0), thick + (12.0 - (thick - taken)) / (1.0 - firm), 1e-4);
  EXPECT_EQ(tissue.excess(), 0.0);
  expect_monotone(tissue);
}

TEST(LayeredCompression, one_layer_after_another_comes_to_its_most) {
  LayeredCompression tissue(30.0, 0.5);
  std::vector<double> moduli;
  for (int cell = 0; cell < 60; ++cell) moduli.push_back(0.001 * std::pow(1.3, cell / 3));
  for (const double press : {0.1, 1.0, 3.0, 6.0, 9.0, 12.0, 15.0, 17.9, 18.0}) {
    tissue.settle(moduli, press);
    EXPECT_NEAR(tissue.excess(), 0.0, 1e-9) << press;
    expect_monotone(tissue);
  }
}

TEST(LayeredCompression, bone_stays_where_it_is) {
  LayeredCompression tissue(80.0, 0.5);
  std::vector<double> moduli(160, soft_young);
  moduli[40] = 12000.0;
  tissue.settle(moduli, 5.0);
  EXPECT_EQ(tissue.far_end(), 20.0);
  EXPECT_NEAR(tissue.moved(15.0), 0.0, 1e-4);
  EXPECT_NEAR(tissue.rest_depth(30.0), 35.0, 1e-4);
  EXPECT_NEAR(tissue.moved(7.5), 2.5, 1e-4) << "half way";
  expect_monotone(tissue);
  tissue.settle(std::vector<double>(40, soft_young), 5.0);
  EXPECT_EQ(tissue.far_end(), 20.0) << "what nobody gives is rigid";
}

TEST(LayeredCompression, what_cannot_be_pressed_so_far_takes_the_far_end_along) {
  LayeredCompression tissue(80.0, 0.5);
  std::vector<double> moduli(160, soft_young);
  moduli[8] = 12000.0;  // 4 mm below the skin
  tissue.settle(moduli, 5.0);
  EXPECT_NEAR(tissue.excess(), 5.0 - 0.6 * 4.0, 1e-12);
  expect_monotone(tissue);
  moduli[0] = 12000.0;
  tissue.settle(moduli, 5.0);
  EXPECT_EQ(tissue.excess(), 5.0);
  EXPECT_EQ(tissue.far_end(), 0.0);
  EXPECT_EQ(tissue.rest_depth(3.0), 3.0);
}

TEST(LayeredCompression, without_a_press_nothing_moves) {
  LayeredCompression tissue;
  for (const double press :
       {0.0, -3.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    tissue.settle(std::vector<double>(160, soft_young), press);
    EXPECT_EQ(tissue.press(), 0.0);
    for (const double depth : {-2.0, 0.0, 0.2, 33.3, 79.9, 500.0}) {
      EXPECT_NEAR(tissue.rest_depth(depth), depth, 1e-4);
      EXPECT_NEAR(tissue.moved(depth), 0.0, 1e-4);
    }
  }
}

// Skin at x = 10 mm, 2 mm voxels: fat to 30 mm, then muscle to 50 mm, then bone whose modulus nobody gave.
AcousticVolume layered_patient() {
  AcousticVolume volume;
  volume.grid.size = {40, 5, 5};
  volume.grid.spacing = {2.0, 2.0, 2.0};
  volume.grid.origin = {1.0, -4.0, -4.0};
  volume.young[tissue::fat] = soft_young;
  volume.young[tissue::muscle] = firm_young;
  volume.voxels.resize(volume.grid.voxel_count());
  for (std::size_t voxel = 0; voxel < volume.voxels.size(); ++voxel) {
    const double x = 2.0 * static_cast<double>(voxel % 40) + 1.0;
    const TissueId id = x < 10.0   ? tissue::air
                        : x < 30.0 ? tissue::fat
                        : x < 50.0 ? tissue::muscle
                                   : tissue::cortical_bone;
    volume.voxels[voxel] = AcousticVolume::voxel(0, id);
  }
  return volume;
}

TEST(LayeredCompression, the_tissues_of_a_patient_settle_along_the_line_of_sight) {
  const AcousticVolume patient = layered_patient();
  LayeredCompression from_patient(80.0, 0.5), from_layers(80.0, 0.5);
  const double press = 4.0;
  Pose pose = Pose::Identity();
  pose.translation() = Vec3(10.0 + press, 0.0, 0.0);
  pose.linear() << 0, 1, 0, -1, 0, 0, 0, 0, 1;  // looks along +x of the patient
  ASSERT_TRUE(pose.linear().col(1).isApprox(Vec3::UnitX()));
  from_patient.settle(patient, pose, press);
  from_layers.settle(two_layers(40, soft_young, 40, firm_young), press);
  EXPECT_EQ(from_patient.far_end(), 40.0);
  EXPECT_TRUE(std::equal(from_patient.rest_depths().begin(), from_patient.rest_depths().end(),
                         from_layers.rest_depths().begin()));
  EXPECT_NEAR(from_patient.moved(36.0), 0.0, 1e-4) << "the bone stays";
  expect_monotone(from_patient);
}

TEST(LayeredCompression, a_line_beside_the_patient_or_a_broken_pose_does_no_harm) {
  const AcousticVolume patient = layered_patient();
  LayeredCompression tissue;
  tissue.settle(patient, Vec3(10.0, 900.0, 0.0), Vec3::UnitX(), 4.0);
  EXPECT_EQ(tissue.far_end(), 80.0);
  expect_monotone(tissue);
  const double no_press = std::numeric_limits<double>::quiet_NaN();
  tissue.settle(patient, Vec3(10.0, no_press, 0.0), Vec3::UnitX(), 4.0);
  EXPECT_EQ(tissue.press(), 0.0);
  tissue.settle(patient, Vec3(10.0, 0.0, 0.0), Vec3::UnitX(), no_press);
  EXPECT_EQ(tissue.press(), 0.0);
  tissue.settle(patient, Vec3(1e300, 0.0, 0.0), 1e300 * Vec3::UnitX(), 4.0);
  expect_monotone(tissue);
}

TEST(LayeredCompression, its_lattice_is_checked) {
  EXPECT_EQ(refusal([] { LayeredCompression(5.0); }), "layered compression: reach is 5 mm, expected 10 to 400 mm");
  EXPECT_EQ(refusal([] { LayeredCompression(80.0, std::numeric_limits<double>::quiet_NaN()); }),
            "layered compression: spacing is nan mm, expected 0.05 to 5 mm");
}

}  // namespace
}  // namespace bodkin
