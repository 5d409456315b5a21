#include <cmath>

#include "patient/synthetic/lumbar.h"
#include "tests/patient/from_ct/patient_crossing.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.h"
#include "io/tissue_library_file.h"

// The constructed ligaments, epidural space and dura: where a lumbar puncture must meet them in real CT, with and
// without labels, and against the known tissues of the synthetic patient.

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
using namespace bodkin::patient;
namespace {

using test::Crossing;
using test::crossings;
using test::first_bone;
using test::first_of;
using test::last_of;
using test::total_of;

// Skin (when the image has it), fat, the ligaments, epidural space, dura and fluid, in this order.
void expect_puncture(const std::vector<Crossing>& way, bool from_skin) {
  std::vector<TissueId> order = {tissue::supraspinous_ligament,
                                 tissue::interspinous_ligament,
                                 tissue::ligamentum_flavum,
                                 tissue::epidural_fat,
                                 tissue::dura,
                                 tissue::cerebrospinal_fluid};
  if (from_skin) order.insert(order.begin(), {tissue::skin, tissue::fat});
  double last = -1.0;
  for (const TissueId id : order) {
    const double depth = first_of(way, id);
    EXPECT_GT(depth, last) << "tissue " << int{id} << " is missing or out of order";
    last = depth;
  }
  if (from_skin) {
    EXPECT_LE(first_of(way, tissue::skin), 3.0);
  }
  const double fluid = first_of(way, tissue::cerebrospinal_fluid), bone = first_bone(way);
  EXPECT_TRUE(bone < 0.0 || bone > fluid) << "bone at " << bone << " before fluid at " << fluid;
  // Thickness along the needle of the ligamentum flavum and, behind the dura, of the epidural space.
  EXPECT_GE(total_of(way, tissue::ligamentum_flavum), 2.5);
  EXPECT_LE(total_of(way, tissue::ligamentum_flavum), 6.0);
  const double epidural = first_of(way, tissue::dura) - first_of(way, tissue::epidural_fat);
  EXPECT_GE(epidural, 2.0);
  EXPECT_LE(epidural, 8.1);
  // Epidural space begins where the flavum ends, dura where the epidural space ends: no gap between them.
  EXPECT_DOUBLE_EQ(last_of(way, tissue::ligamentum_flavum), first_of(way, tissue::epidural_fat));
}

// LPS y of the front edge of the ligamentum flavum behind the canal, level with an interspace and in its midline.
double front_of_flavum(const BuiltPatient& built, const char* interspace) {
  const Vec3 centre = test::landmark(built.landmarks, interspace);
  for (double y = centre.y(); y < centre.y() + 40.0; y += 0.1) {
    if (nearest(built.tissues, Vec3(centre.x(), y, centre.z()), tissue::air) == tissue::ligamentum_flavum) return y;
  }
  return 1e9;
}

// Readings of the front edge of the flavum by eye, LPS y, by the protocol in docs/patients.md; the median must lie
// within 2 mm and the worst within 4.
void expect_flavum_at(const BuiltPatient& built, const std::vector<std::pair<const char*, double>>& readings) {
  std::vector<double> errors;
  for (const auto& [interspace, reading] : readings) {
    errors.push_back(std::abs(front_of_flavum(built, interspace) - reading));
    EXPECT_LT(errors.back(), 4.0) << interspace;
  }
  std::sort(errors.begin(), errors.end());
  EXPECT_LT(errors[errors.size() / 2], 2.0);
}

struct Abdomen : testing::Test {
  static const test::RealPatient& patient(const std::filesystem::path& data) {
    static const auto built = test::build_real(data, "abdomen/abdomen_ct.nii.gz", "abdomen/abdomen_labels.nii.gz",
                                               read_label_scheme("totalsegmentator"));
    return built;
  }
};

TEST_F(Abdomen, lumbar_punctures_cross_the_layers_in_order_where_the_canal_begins) {
  BODKIN_REQUIRE_DATA(data);
  const TissueVolume& tissues = patient(data).built.tissues;
  const std::vector<std::pair<const char*, double>> paths = {
      {"lp_l3_l4", 64.0}, {"lp_l2_l3_cephalad", 63.0}, {"lp_l4_l5", 66.0}};  // depth of the canal's label
  for (const auto& [name, canal] : paths) {
    SCOPED_TRACE(name);
    const auto way = crossings(tissues, test::trajectory(data, "abdomen", name), 5.0);
    expect_puncture(way, true);
    EXPECT_NEAR(last_of(way, tissue::ligamentum_flavum), canal, 4.0);
    // 25 mm of fat lie on this back (HU near -100 along the paths).
    EXPECT_NEAR(first_of(way, tissue::supraspinous_ligament), 30.0, 7.0);
  }
}

TEST_F(Abdomen, the_flavum_begins_where_a_reader_sees_it) {
  BODKIN_REQUIRE_DATA(data);
  expect_flavum_at(patient(data).built, {{"T12_L1", -83.3},
                                         {"L1_L2", -93.6},
                                         {"L2_L3", -102.0},
                                         {"L3_L4", -105.4},
                                         {"L4_L5", -105.2},
                                         {"L5_S1", -99.2}});
  const auto bare = test::build_real(data, "abdomen/abdomen_ct.nii.gz", "", {});
  expect_flavum_at(bare.built,
                   {{"T12_L1", -83.2}, {"L1_L2", -95.6}, {"L2_L3", -103.6}, {"L3_L4", -106.1}, {"L4_L5", -104.0}});
}

TEST_F(Abdomen, bone_stops_what_must_be_stopped) {
  BODKIN_REQUIRE_DATA(data);
  const TissueVolume& tissues = patient(data).built.tissues;
  const auto spinous = crossings(tissues, test::trajectory(data, "abdomen", "bone_strike_l4_spinous"));
  EXPECT_NEAR(first_bone(spinous), 35.5, 2.0);  // HU exceeds 250 at 36 mm
  EXPECT_GT(first_of(spinous, tissue::dura), first_bone(spinous));
  const auto pedicle = crossings(tissues, test::trajectory(data, "abdomen", "biopsy_l3_left_pedicle"));
  EXPECT_TRUE(test::bone(pedicle.back().tissue));
  EXPECT_LT(first_of(pedicle, tissue::cerebrospinal_fluid), 0.0) << "never the canal";
}

TEST_F(Abdomen, other_needles_end_in_what_they_aim_at) {
  BODKIN_REQUIRE_DATA(data);
  const TissueVolume& tissues = patient(data).built.tissues;
  EXPECT_EQ(crossings(tissues, test::trajectory(data, "abdomen", "biopsy_left_kidney")).back().tissue, tissue::organ);
  EXPECT_EQ(crossings(tissues, test::trajectory(data, "abdomen", "injection_left_paraspinal")).back().tissue,
            tissue::muscle);
}

TEST_F(Abdomen, interspaces_are_named_and_a_path_is_planned) {
  BODKIN_REQUIRE_DATA(data);
  const BuiltPatient& built = patient(data).built;
  // Heights between the laminae, read off a sagittal slice with the labels of the vertebrae.
  EXPECT_NEAR(test::landmark(built.landmarks, "L3_L4").z(), 293.0, 4.0);
  EXPECT_NEAR(test::landmark(built.landmarks, "L2_L3").z(), 322.0, 5.0);
  EXPECT_NEAR(test::landmark(built.landmarks, "L4_L5").z(), 269.0, 5.0);
  EXPECT_LT((test::landmark(built.landmarks, "L3_L4_skin") - Vec3(4.5, -45, 293)).norm(), 15.0);
  ASSERT_TRUE(built.path.has_value());
  // The midline of L3/L4 and L4/L5 leaves less than a voxel of the CT, as the trajectories of the data say.
  EXPECT_THAT(built.notes, testing::Contains(testing::ContainsRegex(
                               "through L2_L3, .*; L3_L4 [12]\\.[0-9] mm, L4_L5 [12]\\.[0-9] mm are narrower")));
  const auto way = crossings(built.tissues, *built.path);
  expect_puncture(way, true);
  EXPECT_EQ(way.front().tissue, tissue::skin);
  EXPECT_EQ(way.back().tissue, tissue::cerebrospinal_fluid);
  EXPECT_LT(first_bone(way), 0.0);
}

TEST(Lumbosacral, without_labels_the_layers_are_found_from_bone_and_midline) {
  BODKIN_REQUIRE_DATA(data);
  const auto patient = test::build_real(data, "dicom_ct_lumbosacral/series", "dicom_ct_lumbosacral/mass_mask.nii.gz",
                                        test::mass_table());
  const TissueVolume& tissues = patient.built.tissues;
  for (const char* name : {"lp_l3_l4", "lp_l4_l5"}) {
    SCOPED_TRACE(name);
    expect_puncture(crossings(tissues, test::trajectory(data, "dicom_ct_lumbosacral", name), 8.0), true);
  }
  const auto strike = crossings(tissues, test::trajectory(data, "dicom_ct_lumbosacral", "bone_strike_l4_spinous"));
  EXPECT_NEAR(first_bone(strike), 38.5, 2.0);  // HU exceeds 250 at 39 mm
  EXPECT_EQ(crossings(tissues, test::trajectory(data, "dicom_ct_lumbosacral", "biopsy_mass")).back().tissue,
            tissue::mass);
  expect_flavum_at(patient.built, {{"L3_L4", 69.3}, {"L4_L5", 71.5}, {"L5_S1", 79.7}});
  // Counted up from the sacrum.
  EXPECT_NEAR(test::landmark(patient.built.landmarks, "L3_L4").z(), -532.0, 5.0);
  EXPECT_NEAR(test::landmark(patient.built.landmarks, "L4_L5").z(), -562.0, 5.0);
  EXPECT_NEAR(test::landmark(patient.built.landmarks, "L3_L4").x(), 15.0, 3.0);
}

TEST(LumbarCrop, without_skin_and_canal_labels_the_layers_are_there) {
  BODKIN_REQUIRE_DATA(data);
  for (const char* labels : {"lumbar_l3/lumbar_l3_subregions.nii.gz", "lumbar_l3/lumbar_l3_vertebrae.nii.gz"}) {
    SCOPED_TRACE(labels);
    const auto patient = test::build_real(data, "lumbar_l3/lumbar_l3_ct.nii.gz", labels, read_label_scheme("tptbox"));
    const TissueVolume& tissues = patient.built.tissues;
    EXPECT_THAT(tissues.voxels, testing::Not(testing::Contains(tissue::skin)));
    expect_puncture(crossings(tissues, test::trajectory(data, "lumbar_l3", "lp_l3_l4"), 3.0), false);
    const auto strike = crossings(tissues, test::trajectory(data, "lumbar_l3", "bone_strike_l3_spinous"));
    EXPECT_NEAR(first_bone(strike), 9.0, 2.0);
    const bool levels = std::string(labels).find("vertebrae") != std::string::npos;
    EXPECT_NEAR(test::landmark(patient.built.landmarks, levels ? "L3_L4" : "interspace_1").z(), -86.0, 4.0);
  }
}

void expect_no_lumbar_spine(const BuiltPatient& built, const std::string& why) {
  EXPECT_FALSE(built.path.has_value());
  EXPECT_TRUE(built.landmarks.empty());
  for (const TissueId id : {tissue::ligamentum_flavum, tissue::dura, tissue::epidural_fat}) {
    EXPECT_EQ(std::count(built.tissues.voxels.begin(), built.tissues.voxels.end(), id), 0) << int{id};
  }
  EXPECT_THAT(built.notes,
              testing::Contains(testing::AllOf(testing::StartsWith("No path was planned"), testing::HasSubstr(why))));
}

TEST(Thorax, without_labels_has_no_lumbar_spine_and_no_path) {
  BODKIN_REQUIRE_DATA(data);
  expect_no_lumbar_spine(test::build_real(data, "lung_mha/lung_ct_small.mha", "", {}).built,
                         "the image border cuts it lengthwise");
}

// The upper lumbar spine of a synthetic patient, so low that the third interspace is cut off; with lung in front of
// its upper end, or without.
CtVolume upper_spine(bool lung) {
  LumbarParameters parameters;
  parameters.spacing = 3.0;
  const SyntheticPatient truth = synthesize_lumbar(parameters, default_tissue_library());
  const Vec3 gap = test::landmark(truth.landmarks, "L2_L3"), below = test::landmark(truth.landmarks, "L3_L4");
  Grid grid = truth.ct.grid;
  const int low = static_cast<int>(std::lround(grid.to_index(Vec3(gap.x(), gap.y(), below.z() + 6.0)).z()));
  const int high = static_cast<int>(std::lround(grid.to_index(Vec3(gap.x(), gap.y(), gap.z() + 50.0)).z()));
  grid.size[2] = high - low;
  grid.origin = truth.ct.grid.to_patient(Vec3(0, 0, low));
  CtVolume ct(grid);
  Random random(3);
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const Vec3 p = grid.to_patient(Vec3(i, j, k));
        const bool here =
            lung && p.z() > gap.z() + 30.0 && std::abs(p.x()) < 60.0 && std::abs(p.y() - gap.y() + 75.0) < 20.0;
        ct.at(i, j, k) =
            here ? static_cast<std::int16_t>(random.uniform(-1000.0, -600.0)) : truth.ct.at(i, j, k + low);
      }
    }
  }
  return ct;
}

TEST(Thorax, a_spine_close_below_lung_is_not_lumbar) {
  expect_no_lumbar_spine(build_patient(upper_spine(true), {}, {}, {}, {}), "less than 60 mm below");
  const BuiltPatient lumbar = build_patient(upper_spine(false), {}, {}, {}, {});
  EXPECT_FALSE(lumbar.landmarks.empty()) << "the same spine without lung is taken for what it is";
  EXPECT_FALSE(lumbar.path.has_value()) << "but nothing in it tells the levels";
  PatientOptions word;
  word.lowest_vertebra = "L2";
  const BuiltPatient overruled = build_patient(upper_spine(true), {}, {}, word, {});
  EXPECT_LT(test::landmark(overruled.landmarks, "L2_L3").z(), 1e6) << "the user's word overrules the guard";
}

// Random needles about a planned path: any needle that avoids bone meets flavum before epidural space, and fluid only
// through dura.
void expect_no_leaks(const TissueVolume& tissues, const NeedlePath& path, std::uint64_t seed) {
  Random random(seed);
  int reached = 0;
  for (int n = 0; n < 400; ++n) {
    const auto shift = [&](double most) {
      return Vec3(random.uniform(-most, most), random.uniform(-most, most), random.uniform(-most, most));
    };
    const Vec3 entry = path.entry + shift(2.0);
    const Vec3 aim = path.target + shift(2.0) + path.length() * std::tan(3.0 * 3.14159 / 180.0) * shift(0.6);
    const auto way = crossings(tissues, {entry, aim}, 5.0);
    const double fluid = first_of(way, tissue::cerebrospinal_fluid), bone = first_bone(way);
    if (fluid < 0.0 || (bone >= 0.0 && bone < fluid)) continue;
    ++reached;
    const double flavum = first_of(way, tissue::ligamentum_flavum), dura = first_of(way, tissue::dura);
    const double epidural = first_of(way, tissue::epidural_fat);
    ASSERT_TRUE(flavum >= 0.0 && flavum < epidural) << "needle " << n << " slips past the flavum";
    ASSERT_TRUE(dura > flavum && dura < fluid) << "needle " << n << " slips past the dura";
  }
  EXPECT_GT(reached, 100);
}

TEST_F(Abdomen, no_needle_slips_through) {
  BODKIN_REQUIRE_DATA(data);
  const BuiltPatient& built = patient(data).built;
  ASSERT_TRUE(built.path.has_value());
  expect_no_leaks(built.tissues, *built.path, 1);
}

class Synthetic : public testing::TestWithParam<LumbarParameters> {};

TEST_P(Synthetic, the_construction_finds_the_layers_where_they_truly_are) {
  const SyntheticPatient truth = synthesize_lumbar(GetParam(), default_tissue_library());
  const BuiltPatient labelled = build_patient(truth.ct, truth.structures, truth.structure_table, {}, {});
  const auto real = crossings(truth.tissues, truth.path, 3.0);
  const double skin_to_epidural = first_of(real, tissue::epidural_fat);
  const auto way = crossings(labelled.tissues, truth.path, 3.0);
  expect_puncture(way, true);
  EXPECT_NEAR(last_of(way, tissue::ligamentum_flavum), skin_to_epidural, 2.0);
  EXPECT_NEAR(first_of(way, tissue::supraspinous_ligament), first_of(real, tissue::supraspinous_ligament), 3.0);
  EXPECT_NEAR(first_of(way, tissue::cerebrospinal_fluid), first_of(real, tissue::cerebrospinal_fluid), 3.0);
  for (const char* name : {"L2_L3", "L3_L4", "L4_L5"}) {
    EXPECT_LT((test::landmark(labelled.landmarks, name) - test::landmark(truth.landmarks, name)).norm(), 4.0) << name;
  }
  ASSERT_TRUE(labelled.path.has_value());
  // The planned path is a correct puncture in the true anatomy.
  const auto planned = crossings(truth.tissues, *labelled.path);
  EXPECT_LT(first_bone(planned), 0.0);
  EXPECT_EQ(planned.front().tissue, tissue::skin);
  EXPECT_TRUE(planned.back().tissue == tissue::cerebrospinal_fluid || planned.back().tissue == tissue::nerve);
  EXPECT_GT(total_of(planned, tissue::ligamentum_flavum), 2.0);
  expect_no_leaks(labelled.tissues, *labelled.path, 2);

  // The same CT without its labels.
  const BuiltPatient bare = build_patient(truth.ct, {}, {}, {}, {});
  EXPECT_NEAR(last_of(crossings(bare.tissues, truth.path, 3.0), tissue::ligamentum_flavum), skin_to_epidural, 3.0);
}

TEST(PatientOptions, a_given_path_is_kept_and_the_construction_can_be_left_out) {
  LumbarParameters parameters;
  parameters.spacing = 3.0;
  const SyntheticPatient truth = synthesize_lumbar(parameters, default_tissue_library());
  PatientOptions options;
  options.path = truth.path;
  options.construct_lumbar = false;
  options.tissue_spacing = 3.0;
  const BuiltPatient patient = build_patient(truth.ct, truth.structures, truth.structure_table, options, {});
  EXPECT_EQ(patient.path->entry, truth.path.entry);
  EXPECT_TRUE(patient.landmarks.empty());
  EXPECT_THAT(patient.tissues.voxels, testing::Not(testing::Contains(tissue::ligamentum_flavum)));
}

std::vector<LumbarParameters> patients() {
  LumbarParameters usual, heavy, curled;
  heavy.seed = 3, heavy.weight = 110.0, heavy.age = 75.0, heavy.spacing = 1.5;
  curled.seed = 5, curled.flexion = 1.0, curled.weight = 55.0;
  return {usual, heavy, curled};
}

INSTANTIATE_TEST_SUITE_P(Patients, Synthetic, testing::ValuesIn(patients()));

}  // namespace
}  // namespace bodkin
