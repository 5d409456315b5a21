#include "imaging/ultrasound/acoustic_volume.h"

#include <cmath>
#include <limits>

#include "patient/synthetic/lumbar.h"
#include "tests/io/scratch_folder.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/tissue_library_file.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::imaging;
using namespace bodkin::io;
using namespace bodkin::patient;
namespace {

using ::testing::HasSubstr;

const TissueLibrary& acoustic_library() {
  static const TissueLibrary library = default_tissue_library();
  return library;
}

// A block of `id` with a layer of air above it (k = 0), 1 mm voxels, every voxel at the HU typical of its tissue.
Case acoustic_block(TissueId id, std::array<int, 3> size = {9, 8, 7}) {
  Case patient;
  patient.library = acoustic_library();
  Grid grid;
  grid.size = size;
  patient.tissues = TissueVolume(grid, id);
  patient.ct = CtVolume(grid, static_cast<std::int16_t>(patient.library.find(id)->hounsfield));
  for (int j = 0; j < size[1]; ++j) {
    for (int i = 0; i < size[0]; ++i) {
      patient.tissues.at(i, j, 0) = tissue::air;
      patient.ct.at(i, j, 0) = -1000;
    }
  }
  return patient;
}

double impedance_at(const AcousticVolume& volume, int i, int j, int k) {
  return volume.impedance(volume.grid.offset(i, j, k)) * AcousticVolume::unit;
}

double own_impedance(TissueId id) {
  return acoustic_library().find(id)->acoustic.impedance;
}

TEST(ImpedanceOfHounsfield, follows_the_published_map) {
  // HU and MRayl, as computed from Schneider 1996 and Mast 2000
  const std::array<std::array<double, 2>, 12> table = {{{-100, 1.301},
                                                        {-50, 1.424},
                                                        {0, 1.542},
                                                        {15, 1.578},
                                                        {40, 1.640},
                                                        {60, 1.690},
                                                        {100, 1.790},
                                                        {200, 1.939},
                                                        {300, 2.113},
                                                        {700, 3.013},
                                                        {1000, 3.792},
                                                        {2000, 7.026}}};
  for (const auto& [hounsfield, impedance] : table) {
    EXPECT_NEAR(impedance_of_hounsfield(hounsfield), impedance, 0.002) << hounsfield << " HU";
  }
}

TEST(ImpedanceOfHounsfield, stays_between_air_and_bone) {
  EXPECT_EQ(impedance_of_hounsfield(-1000.0), 0.0004);
  EXPECT_EQ(impedance_of_hounsfield(-3024.0), 0.0004);
  EXPECT_EQ(impedance_of_hounsfield(30000.0), 8.0);
  EXPECT_EQ(impedance_of_hounsfield(std::numeric_limits<double>::quiet_NaN()), 0.0004);
  for (double hounsfield = -1050.0; hounsfield < 3000.0; hounsfield += 0.5)
    ASSERT_LE(impedance_of_hounsfield(hounsfield), impedance_of_hounsfield(hounsfield + 0.5)) << hounsfield;
}

TEST(AcousticVolume, a_tissue_at_its_typical_hu_has_its_own_impedance) {
  for (const TissueProperties& entry : acoustic_library().tissues()) {
    if (entry.id == tissue::air) continue;
    const auto volume = acoustic_volume(acoustic_block(entry.id), {});
    EXPECT_NEAR(impedance_at(*volume, 4, 4, 4), std::min(entry.acoustic.impedance, 7.9998),
                0.51 * AcousticVolume::unit)
        << entry.name;
    EXPECT_NEAR(impedance_at(*volume, 4, 4, 0), 0.0004, AcousticVolume::unit) << "air above " << entry.name;
    EXPECT_GT(volume->impedance(0), 0) << "no impedance is zero";
    EXPECT_EQ(volume->media[entry.id].echo, entry.acoustic.echo);
    EXPECT_EQ(volume->young[entry.id], entry.deformable.young);
  }
}

TEST(AcousticVolume, hu_vary_soft_tissue_as_far_as_a_twelfth_and_bone_not_at_all) {
  Case patient = acoustic_block(tissue::muscle);
  for (std::size_t voxel = 72; voxel < patient.ct.voxels.size(); ++voxel) patient.ct.voxels[voxel] = 60;
  EXPECT_NEAR(impedance_at(*acoustic_volume(patient, {}), 4, 4, 4),
              own_impedance(tissue::muscle) + impedance_of_hounsfield(60) - impedance_of_hounsfield(45), 0.001);
  for (std::size_t voxel = 72; voxel < patient.ct.voxels.size(); ++voxel) patient.ct.voxels[voxel] = 300;
  EXPECT_NEAR(impedance_at(*acoustic_volume(patient, {}), 4, 4, 4), 1.08 * own_impedance(tissue::muscle), 0.001);
  for (std::size_t voxel = 72; voxel < patient.ct.voxels.size(); ++voxel) patient.ct.voxels[voxel] = -150;
  EXPECT_NEAR(impedance_at(*acoustic_volume(patient, {}), 4, 4, 4), 0.92 * own_impedance(tissue::muscle), 0.001);
  Case bone = acoustic_block(tissue::cancellous_bone);
  for (std::size_t voxel = 72; voxel < bone.ct.voxels.size(); ++voxel) bone.ct.voxels[voxel] = 900;
  EXPECT_NEAR(impedance_at(*acoustic_volume(bone, {}), 4, 4, 4), own_impedance(tissue::cancellous_bone), 0.001);
}

TEST(AcousticVolume, tissues_too_thin_for_a_ct_keep_their_own) {
  for (const TissueId id : {tissue::skin, tissue::ligamentum_flavum, tissue::dura, tissue::cerebrospinal_fluid}) {
    Case patient = acoustic_block(id);
    for (std::size_t voxel = 72; voxel < patient.ct.voxels.size(); ++voxel) patient.ct.voxels[voxel] = -60;
    EXPECT_NEAR(impedance_at(*acoustic_volume(patient, {}), 4, 4, 4), own_impedance(id), 0.001)
        << acoustic_library().title(id);
  }
}

TEST(AcousticVolume, a_tissue_without_impedance_has_that_of_its_hu) {
  Case patient = acoustic_block(tissue::muscle);
  std::vector<TissueProperties> tissues = patient.library.tissues();
  for (TissueProperties& entry : tissues) entry.acoustic = {};
  patient.library = TissueLibrary(tissues);
  EXPECT_NEAR(impedance_at(*acoustic_volume(patient, {}), 4, 4, 4), impedance_of_hounsfield(45), 0.001);
}

TEST(AcousticVolume, noise_is_smoothed_within_a_tissue_and_borders_stay_sharp) {
  Case patient = acoustic_block(tissue::muscle, {24, 24, 24});
  std::uint32_t state = 1;
  double noise = 0.0;
  for (std::size_t voxel = 0; voxel < patient.ct.voxels.size(); ++voxel) {
    state = state * 1664525U + 1013904223U;
    const int away = static_cast<int>(state >> 16) % 41 - 20;  // HU; standard deviation 11.8
    const bool fat = voxel % 24 >= 12;
    if (fat && patient.tissues.voxels[voxel] == tissue::muscle) patient.tissues.voxels[voxel] = tissue::fat;
    if (patient.tissues.voxels[voxel] == tissue::air) continue;
    patient.ct.voxels[voxel] = static_cast<std::int16_t>((fat ? -100 : 45) + away);
    if (!fat) noise += away * away;
  }
  noise = std::sqrt(noise / (12.0 * 24.0 * 23.0)) * (impedance_of_hounsfield(46) - impedance_of_hounsfield(45));
  const auto volume = acoustic_volume(patient, {});
  double left = 0.0, sum = 0.0;
  int inner = 0;
  for (int k = 3; k < 21; ++k) {
    for (int j = 3; j < 21; ++j) {
      for (int i = 3; i < 9; ++i, ++inner) {
        sum += impedance_at(*volume, i, j, k);
        left += std::pow(impedance_at(*volume, i, j, k) - own_impedance(tissue::muscle), 2);
      }
      EXPECT_NEAR(impedance_at(*volume, 11, j, k), own_impedance(tissue::muscle), 0.04) << "beside the fat";
      EXPECT_NEAR(impedance_at(*volume, 12, j, k), own_impedance(tissue::fat), 0.05) << "beside the muscle";
    }
  }
  // A Gaussian of 0.7 voxels leaves (sum of the squares of its weights)^(3/2) = 0.262 of white noise.
  EXPECT_NEAR(std::sqrt(left / inner) / noise, 0.262, 0.04);
  EXPECT_NEAR(sum / inner, own_impedance(tissue::muscle), 0.003);
}

TEST(AcousticVolume, the_ct_may_lie_on_another_lattice) {
  Case patient = acoustic_block(tissue::muscle, {16, 16, 16});
  Grid coarse;
  coarse.size = {10, 8, 12};
  coarse.spacing = {2.0, 2.5, 2.0};
  coarse.origin = {-2.0, 18.0, -3.0};
  coarse.direction.col(1) = -Vec3::UnitY();  // runs the other way
  patient.ct = CtVolume(coarse);
  const auto hounsfield = [](const Vec3& point) { return 45.0 + 2.0 * (point.x() - 7.0) - 1.0 * (point.y() - 7.0); };
  for (int k = 0; k < coarse.size[2]; ++k)
    for (int j = 0; j < coarse.size[1]; ++j)
      for (int i = 0; i < coarse.size[0]; ++i)
        patient.ct.at(i, j, k) =
            static_cast<std::int16_t>(k == 0 ? -1000 : std::lround(hounsfield(coarse.to_patient(Vec3(i, j, k)))));
  const auto volume = acoustic_volume(patient, {});
  EXPECT_TRUE(same_lattice(volume->grid, patient.tissues.grid));
  for (const auto& [i, j, k] : {std::array{7, 7, 7}, std::array{4, 9, 6}, std::array{10, 4, 12}}) {
    EXPECT_NEAR(impedance_at(*volume, i, j, k),
                own_impedance(tissue::muscle) + impedance_of_hounsfield(hounsfield(Vec3(i, j, k))) -
                    impedance_of_hounsfield(45.0),
                0.002);
  }
}

TEST(AcousticVolume, beyond_the_ct_tissue_is_as_usual) {
  Case patient = acoustic_block(tissue::muscle, {8, 8, 40});
  Grid shorter = patient.ct.grid;
  shorter.size[2] = 20;
  patient.ct = CtVolume(shorter, 60);
  patient.ct.voxels[0] = -1000;
  const auto volume = acoustic_volume(patient, {});
  EXPECT_GT(impedance_at(*volume, 4, 4, 10), own_impedance(tissue::muscle) + 0.01);
  EXPECT_NEAR(impedance_at(*volume, 4, 4, 30), own_impedance(tissue::muscle), 0.001);
}

TEST(AcousticVolume, a_volume_one_voxel_thick_is_no_trouble) {
  for (const std::array<int, 3> size : {std::array{1, 1, 2}, std::array{1, 5, 3}, std::array{5, 1, 9}}) {
    const auto volume = acoustic_volume(acoustic_block(tissue::organ, size), {});
    EXPECT_NEAR(impedance_at(*volume, 0, 0, 1), own_impedance(tissue::organ), 0.001);
  }
}

TEST(AcousticVolume, a_ct_that_is_not_in_hu_is_refused) {
  const auto refused = [](const auto& change) {
    Case patient = acoustic_block(tissue::muscle);
    for (std::int16_t& value : patient.ct.voxels) value = static_cast<std::int16_t>(change(value));
    return refusal([&patient] { acoustic_volume(patient, {}); });
  };
  EXPECT_EQ(refused([](int v) { return v < 0 ? 0 : 230; }),
            "the CT is not in Hounsfield units: its values go from 0 to 230, as a picture's do; import the patient "
            "from a CT with its rescale slope and intercept");
  EXPECT_EQ(refused([](int v) { return v + 1024; }),
            "the CT is not in Hounsfield units: no value is below 24, though there is air, expected about -1000; "
            "import the patient from a CT with its rescale slope and intercept");
  EXPECT_EQ(refused([](int v) { return v < 0 ? -1000 : v + 1024; }),
            "the CT is not in Hounsfield units: soft tissue misses its usual values by +1024 on average, expected "
            "less than 400; import the patient from a CT with its rescale slope and intercept");
}

TEST(AcousticVolume, what_is_no_patient_is_refused) {
  const auto refused = [](const auto& change) {
    Case patient = acoustic_block(tissue::muscle);
    change(patient);
    return refusal([&patient] { acoustic_volume(patient, {}); });
  };
  EXPECT_THAT(refused([](Case& patient) { patient.ct = {}; }), HasSubstr("the case has no CT"));
  EXPECT_THAT(refused([](Case& patient) { patient.tissues = {}; }), HasSubstr("the case has no tissues"));
  EXPECT_THAT(refused([](Case& patient) {
                std::fill(patient.tissues.voxels.begin(), patient.tissues.voxels.end(), tissue::air);
              }),
              HasSubstr("nothing but air"));
}

// Whether bone and something else are among the 27 voxels about one.
bool beside_border_of_bone(const AcousticVolume& volume, std::size_t voxel) {
  const Grid& grid = volume.grid;
  const auto row = static_cast<std::size_t>(grid.size[0]), slice = row * static_cast<std::size_t>(grid.size[1]);
  const auto i = static_cast<int>(voxel % row), j = static_cast<int>(voxel % slice / row),
             k = static_cast<int>(voxel / slice);
  bool bone = false, other = false;
  for (int n = 0; n < 27; ++n) {
    const int x = i + n % 3 - 1, y = j + n / 3 % 3 - 1, z = k + n / 9 - 1;
    if (!grid.contains(x, y, z)) continue;
    const TissueId id = volume.tissue(grid.offset(x, y, z));
    (id == tissue::cortical_bone || id == tissue::cancellous_bone ? bone : other) = true;
  }
  return bone && other;
}

TEST(AcousticVolume, a_synthetic_patient_sounds_like_its_tissues) {
  LumbarParameters parameters;
  parameters.spacing = 2.5;
  SyntheticPatient lumbar = synthesize_lumbar(parameters, acoustic_library());
  Case patient;
  patient.library = acoustic_library();
  patient.ct = std::move(lumbar.ct);
  patient.tissues = std::move(lumbar.tissues);
  const auto volume = acoustic_volume(patient, {});
  std::array<double, 256> sum{}, count{};
  for (std::size_t voxel = 0; voxel < volume->voxels.size(); ++voxel) {
    const std::size_t id = volume->tissue(voxel);
    const double own = own_impedance(static_cast<TissueId>(id)),
                 found = volume->impedance(voxel) * AcousticVolume::unit;
    ASSERT_GT(volume->impedance(voxel), 0);
    if (beside_border_of_bone(*volume, voxel)) continue;  // worn there (bone_surface.h)
    ASSERT_NEAR(found, own, 0.0801 * own + AcousticVolume::unit) << volume->tissue(voxel);
    sum[id] += found;
    count[id] += 1.0;
  }
  for (const TissueId id : {tissue::fat, tissue::muscle, tissue::cerebrospinal_fluid, tissue::cortical_bone})
    EXPECT_NEAR(sum[id] / count[id], own_impedance(id), 0.015 * own_impedance(id)) << acoustic_library().title(id);
}

TEST(AcousticVolume, reports_where_it_is) {
  std::vector<double> fractions;
  acoustic_volume(acoustic_block(tissue::organ, {4, 4, 100}), [&](std::string_view stage, double fraction) {
    EXPECT_EQ(stage, "preparing the ultrasound");
    fractions.push_back(fraction);
  });
  EXPECT_LE(fractions.size(), 40U);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(fractions.back(), 1.0);
}

}  // namespace
}  // namespace bodkin
