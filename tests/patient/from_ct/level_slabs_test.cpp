#include <cmath>
#include <cstdlib>
#include <map>

#include "patient/from_ct/path_planner.h"
#include "tests/patient/from_ct/patient_crossing.h"
#include <gtest/gtest.h>

#include "core/random.h"

// Axial slabs of every shared CT, as users crop them: no path above L2/L3, none in cord, every named level is
// correct. A dozen slabs chosen by a seed; all of them with BODKIN_ALL_SLABS=1 (scripts/level_slabs.sh).

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
using namespace bodkin::patient;
namespace {

struct SlabSource {
  const char* ct;
  const char* labels;  // "" = without
  const char* scheme;
  std::map<std::string, double> truth;  // LPS z of the interspaces, read by eye off a midline section
};

const std::map<std::string, double> abdomen_levels = {{"T11_T12", 417.0}, {"T12_L1", 384.0}, {"L1_L2", 352.0},
                                                      {"L2_L3", 321.0},   {"L3_L4", 292.0},  {"L4_L5", 269.0},
                                                      {"L5_S1", 247.0}};
const std::map<std::string, double> lumbosacral_levels = {{"L3_L4", -533.0}, {"L4_L5", -562.0}, {"L5_S1", -588.0}};
const std::map<std::string, double> crop_levels = {{"L2_L3", -58.0}, {"L3_L4", -86.0}};

const std::vector<SlabSource>& sources() {
  static const std::vector<SlabSource> all = {
      {"abdomen/abdomen_ct.nii.gz", "", "", abdomen_levels},
      {"abdomen/abdomen_ct.nii.gz", "abdomen/abdomen_labels.nii.gz", "totalsegmentator", abdomen_levels},
      {"abdomen/abdomen_ct.nii.gz", "abdomen/abdomen_vertebrae.nii.gz", "totalsegmentator", abdomen_levels},
      {"dicom_ct_lumbosacral/series", "", "", lumbosacral_levels},
      {"lumbar_l3/lumbar_l3_ct.nii.gz", "", "", crop_levels},
      {"lumbar_l3/lumbar_l3_ct.nii.gz", "lumbar_l3/lumbar_l3_vertebrae.nii.gz", "tptbox", crop_levels},
      {"lumbar_l3/lumbar_l3_ct.nii.gz", "lumbar_l3/lumbar_l3_subregions.nii.gz", "tptbox", crop_levels},
      {"dicom_ct_thoracolumbar_j2k/series", "", "", {{"T11_T12", -790.0}}},
      {"dicom_ct_thoracolumbar_j2k/series",
       "dicom_ct_thoracolumbar_j2k/labels.nii.gz",
       "totalsegmentator",
       {{"T11_T12", -790.0}}},
      {"lung_mha/lung_ct_small.mha", "", "", {}}};
  return all;
}

// The voxels whose LPS z lies in [low, high].
template <typename Voxel>
Volume<Voxel> slab_of(const Volume<Voxel>& volume, double low, double high) {
  Eigen::Index axis = 0;
  volume.grid.direction.row(2).cwiseAbs().maxCoeff(&axis);
  const auto a = static_cast<std::size_t>(axis);
  Vec3 index = Vec3::Zero();
  int first = -1, last = -1;
  for (int n = 0; n < volume.grid.size[a]; ++n) {
    index[axis] = n;
    const double z = volume.grid.to_patient(index).z();
    if (z < low || z > high) continue;
    if (first < 0) first = n;
    last = n;
  }
  Grid grid = volume.grid;
  grid.size[a] = last - first + 1;
  index[axis] = first;
  grid.origin = volume.grid.to_patient(index);
  Volume<Voxel> slab(grid);
  std::array<int, 3> shift = {0, 0, 0};
  shift[a] = first;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) slab.at(i, j, k) = volume.at(i + shift[0], j + shift[1], k + shift[2]);
    }
  }
  return slab;
}

struct Slab {
  std::size_t source;
  double low, thickness;
};

std::vector<Slab> all_slabs(const std::vector<test::RealPatient>& patients) {
  std::vector<Slab> slabs;
  for (std::size_t source = 0; source < patients.size(); ++source) {
    const PatientBox box = box_of_image(patients[source].ct.grid);
    for (const double thickness : {60.0, 90.0, 120.0}) {
      double low = box.low.z();
      do slabs.push_back({source, low, thickness});
      while ((low += 20.0) + thickness <= box.high.z() + 1.0);
    }
  }
  return slabs;
}

void check_slab(const SlabSource& source, const test::RealPatient& whole, const Slab& slab) {
  const CtVolume ct = slab_of(whole.ct, slab.low, slab.low + slab.thickness);
  LabelVolume labels;
  std::vector<Structure> table;
  if (!whole.labels.empty()) {
    labels = slab_of(whole.labels, slab.low, slab.low + slab.thickness);
    table = read_label_scheme(source.scheme);
  }
  BuiltPatient built;
  try {
    built = build_patient(ct, labels, table, {}, {});
  } catch (const InputError&) {
    return;  // refused with a sentence, as a slab without a body is
  }
  constexpr double right = 11.0;  // mm, a third of the distance between interspaces
  for (const Landmark& landmark : built.landmarks) {
    const auto truth = source.truth.find(landmark.name);
    if (landmark.name.find("skin") != std::string::npos || landmark.name == "conus" ||
        landmark.name.starts_with("interspace"))
      continue;
    ASSERT_NE(truth, source.truth.end()) << landmark.name << " is named at z = " << landmark.position.z();
    EXPECT_NEAR(landmark.position.z(), truth->second, right) << landmark.name;
  }
  if (!built.path) return;
  EXPECT_EQ(depth_of_cord(built.tissues, *built.path, 3.0), std::nullopt);
  ASSERT_TRUE(source.truth.contains("L2_L3") || source.truth.contains("L3_L4")) << "a path in a thoracic CT";
  const auto limit = source.truth.find("L2_L3");
  const double highest = limit != source.truth.end() ? limit->second : source.truth.at("L3_L4") + 30.0;
  EXPECT_LT(built.path->target.z(), highest + 12.0) << "a path above L2/L3";
}

TEST(LevelSlabs, have_no_path_above_l2_l3_none_in_cord_and_no_wrong_name) {
  BODKIN_REQUIRE_DATA(data);
  std::vector<test::RealPatient> patients;
  for (const SlabSource& source : sources()) {
    test::RealPatient patient;
    patient.ct = read_ct(data / source.ct).ct;
    if (*source.labels != '\0')
      patient.labels = place_labels(read_labels(data / source.labels), patient.ct.grid, false, source.labels).labels;
    patients.push_back(std::move(patient));
  }
  std::vector<Slab> slabs = all_slabs(patients);
  const std::size_t count = slabs.size();
  if (std::getenv("BODKIN_ALL_SLABS") == nullptr) {
    Random random(16);
    std::vector<Slab> some;
    for (int n = 0; n < 12; ++n) some.push_back(slabs[random.next() % count]);
    slabs = some;
  }
  for (const Slab& slab : slabs) {
    const SlabSource& source = sources()[slab.source];
    SCOPED_TRACE(std::string(source.ct) + " " + source.labels + ", " + std::to_string(slab.thickness) +
                 " mm from z = " + std::to_string(slab.low));
    check_slab(source, patients[slab.source], slab);
  }
  std::printf("%zu of %zu slabs\n", slabs.size(), count);
}

}  // namespace
}  // namespace bodkin
