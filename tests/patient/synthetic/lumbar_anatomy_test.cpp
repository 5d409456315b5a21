// The synthetic patient as checked by an anatomist: places, thicknesses, sizes.
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "patient/synthetic/lumbar.h"
#include "tests/sanitized.h"
#include <gtest/gtest.h>

#include "core/random.h"
#include "io/tissue_library_file.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
using namespace bodkin::patient;
namespace {

SyntheticPatient synthesize(LumbarParameters parameters) {
  return synthesize_lumbar(parameters, default_tissue_library());
}

const SyntheticPatient& default_patient() {
  static const SyntheticPatient patient = synthesize({});
  return patient;
}

struct Layer {
  TissueId tissue;
  double thickness;  // mm
};

// Tissues along a line, equal neighbours joined.
std::vector<Layer> layers(const TissueVolume& tissues, const Vec3& from, const Vec3& to) {
  std::vector<Layer> found;
  const double step = 0.1, length = (to - from).norm();
  for (double depth = 0.0; depth <= length; depth += step) {
    const TissueId id = nearest(tissues, Vec3(from + depth / length * (to - from)), tissue::air);
    if (found.empty() || found.back().tissue != id) found.push_back({id, 0.0});
    found.back().thickness += step;
  }
  return found;
}

double skin_to_epidural(const SyntheticPatient& patient) {
  double depth = 0.0;
  for (const Layer& layer : layers(patient.tissues, patient.path.entry, patient.path.target)) {
    if (layer.tissue == tissue::epidural_fat) return depth;
    if (layer.tissue != tissue::air) depth += layer.thickness;
  }
  return -1.0;
}

// Voxels of each label, and the mean of their centres.
struct Extent {
  std::size_t voxels = 0;
  Vec3 centre = Vec3::Zero(), low = Vec3::Constant(1e9), high = Vec3::Constant(-1e9);
};

std::map<int, Extent> extents(const LabelVolume& labels) {
  std::map<int, Extent> found;
  for (int k = 0; k < labels.grid.size[2]; ++k)
    for (int j = 0; j < labels.grid.size[1]; ++j)
      for (int i = 0; i < labels.grid.size[0]; ++i) {
        const int label = labels.at(i, j, k);
        if (label == 0) continue;
        Extent& extent = found[label];
        const Vec3 place = labels.grid.to_patient(Vec3(i, j, k));
        ++extent.voxels;
        extent.centre += place;
        extent.low = extent.low.cwiseMin(place);
        extent.high = extent.high.cwiseMax(place);
      }
  for (auto& [label, extent] : found) extent.centre /= static_cast<double>(extent.voxels);
  return found;
}

// Number of pieces (joined by faces) that a label falls into.
int pieces(const LabelVolume& labels, int label) {
  const Grid& grid = labels.grid;
  std::vector<char> seen(labels.voxels.size(), 0);
  int count = 0;
  std::vector<std::array<int, 3>> open;
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        if (labels.at(i, j, k) != label || seen[grid.offset(i, j, k)] != 0) continue;
        ++count;
        open.push_back({i, j, k});
        seen[grid.offset(i, j, k)] = 1;
        while (!open.empty()) {
          const std::array<int, 3> at = open.back();
          open.pop_back();
          for (int n = 0; n < 6; ++n) {
            std::array<int, 3> next = at;
            next[static_cast<std::size_t>(n / 2)] += n % 2 == 0 ? 1 : -1;
            if (!grid.contains(next[0], next[1], next[2]) || labels.at(next[0], next[1], next[2]) != label) continue;
            char& mark = seen[grid.offset(next[0], next[1], next[2])];
            if (mark == 0) open.push_back(next);
            mark = 1;
          }
        }
      }
  return count;
}

// Smallest vertical distance between two bones (upper, lower label) in the midline behind the canal.
double midline_gap(const SyntheticPatient& patient, int upper, int lower) {
  const Grid& grid = patient.structures.grid;
  const int i = static_cast<int>(grid.to_index(patient.path.target).x() + 0.5);
  const int behind = static_cast<int>(grid.to_index(patient.path.target).y() + 12.0 / grid.spacing.y());
  int least = grid.size[2];
  for (int j = behind; j < grid.size[1]; ++j) {
    int bottom = -1, top = -1;
    for (int k = 0; k < grid.size[2]; ++k) {
      const int label = patient.structures.at(i, j, k);
      if (label == lower) top = k;
      if (label == upper && bottom < 0) bottom = k;
    }
    if (bottom >= 0 && top >= 0) least = std::min(least, bottom - top);
  }
  return least * grid.spacing.z();
}

constexpr const char* several_patients =
    "sanitizers look at the memory of few synthetic patients, the plain build at the anatomy of several";

TEST(LumbarAnatomy, the_planned_path_meets_the_layers_of_a_lumbar_puncture_in_order) {
  const SyntheticPatient& patient = default_patient();
  std::vector<Layer> met = layers(patient.tissues, patient.path.entry, patient.path.target);
  if (met.front().tissue == tissue::air) met.erase(met.begin());  // half a voxel of air at the entry
  const std::vector<std::array<double, 3>> expected = {
      {tissue::skin, 1.0, 4.0},
      {tissue::fat, 6.0, 20.0},
      {tissue::supraspinous_ligament, 2.0, 6.0},
      {tissue::interspinous_ligament, 18.0, 32.0},
      {tissue::ligamentum_flavum, 2.5, 5.5},
      {tissue::epidural_fat, 2.5, 7.0},
      {tissue::dura, 0.8, 2.5},
      {tissue::cerebrospinal_fluid, 2.0, 12.0},
  };
  ASSERT_EQ(met.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(met[i].tissue, static_cast<TissueId>(expected[i][0])) << "layer " << i;
    EXPECT_GT(met[i].thickness, expected[i][1]) << "layer " << i;
    EXPECT_LT(met[i].thickness, expected[i][2]) << "layer " << i;
  }
  // Lawrence et al.: both ligaments together 25.5 to 33.4 mm along the needle (quartiles); one voxel of rounding.
  EXPECT_NEAR(met[2].thickness + met[3].thickness, 29.5, 5.0);
}

TEST(LumbarAnatomy, skin_to_epidural_distance_is_the_published_one_and_grows_with_weight) {
  if (sanitized) GTEST_SKIP() << several_patients;
  // Cha et al. 2011: 46 mm, standard deviation 6.9, at L3/L4.
  EXPECT_NEAR(skin_to_epidural(default_patient()), 46.0, 6.9);
  double before = 0.0;
  for (const double weight : {48.0, 72.0, 100.0, 140.0}) {
    LumbarParameters parameters;
    parameters.weight = weight;
    parameters.spacing = 2.0;
    const double depth = skin_to_epidural(synthesize(parameters));
    EXPECT_GT(depth, before + 3.0) << weight << " kg";
    before = depth;
  }
  EXPECT_GT(before, 65.0);
  EXPECT_LT(before, 100.0);
}

TEST(LumbarAnatomy, flexion_opens_the_space_between_the_spinous_processes) {
  if (sanitized) GTEST_SKIP() << several_patients;
  double before = 0.0;
  for (const double flexion : {0.0, 0.5, 1.0}) {
    LumbarParameters parameters;
    parameters.flexion = flexion;
    const double gap =
        flexion == 0.5 ? midline_gap(default_patient(), 29, 28) : midline_gap(synthesize(parameters), 29, 28);
    EXPECT_GT(gap, before + 2.0) << "flexion " << flexion;
    EXPECT_LT(gap, 26.0);
    before = gap;
  }
}

TEST(LumbarAnatomy, age_lowers_the_discs_and_thins_the_cancellous_bone) {
  if (sanitized) GTEST_SKIP() << several_patients;
  LumbarParameters young, old;
  young.age = 22.0;
  old.age = 85.0;
  young.spacing = old.spacing = 1.5;
  const SyntheticPatient a = synthesize(young), b = synthesize(old);
  const auto mean_hu = [](const SyntheticPatient& patient) {
    double sum = 0.0, count = 0.0;
    for (std::size_t n = 0; n < patient.ct.voxels.size(); ++n)
      if (patient.tissues.voxels[n] == tissue::cancellous_bone && patient.structures.voxels[n] == 29) {
        sum += patient.ct.voxels[n];
        count += 1.0;
      }
    return sum / count;
  };
  EXPECT_GT(mean_hu(a), mean_hu(b) + 60.0);
  const auto length = [](const SyntheticPatient& patient) {
    const auto found = extents(patient.structures);
    return found.at(31).centre.z() - found.at(27).centre.z();
  };
  EXPECT_GT(length(a), length(b) + 4.0);
}

TEST(LumbarAnatomy, the_spine_grows_with_body_height) {
  if (sanitized) GTEST_SKIP() << several_patients;
  std::vector<double> lengths;
  for (const double height : {1.5, 1.95}) {
    LumbarParameters parameters;
    parameters.height = height;
    parameters.weight = 24.0 * height * height;
    parameters.spacing = 2.5;
    const auto found = extents(synthesize(parameters).structures);
    lengths.push_back(found.at(31).centre.z() - found.at(27).centre.z());
  }
  EXPECT_NEAR(lengths[1] / lengths[0], 1.95 / 1.5, 0.06);
}

TEST(LumbarAnatomy, every_tissue_of_the_back_is_there) {
  const std::set<TissueId> present(default_patient().tissues.voxels.begin(), default_patient().tissues.voxels.end());
  for (const TissueId id : {tissue::air,
                            tissue::skin,
                            tissue::fat,
                            tissue::muscle,
                            tissue::soft,
                            tissue::cortical_bone,
                            tissue::cancellous_bone,
                            tissue::disc,
                            tissue::supraspinous_ligament,
                            tissue::interspinous_ligament,
                            tissue::ligamentum_flavum,
                            tissue::epidural_fat,
                            tissue::dura,
                            tissue::cerebrospinal_fluid,
                            tissue::nerve,
                            tissue::spinal_cord,
                            tissue::vessel,
                            tissue::organ,
                            tissue::gas,
                            tissue::cartilage})
    EXPECT_TRUE(present.contains(id)) << default_tissue_library().title(id);
}

TEST(LumbarAnatomy, the_cord_ends_at_the_conus_and_roots_hang_below_it) {
  const SyntheticPatient& patient = default_patient();
  const auto conus = std::find_if(patient.landmarks.begin(), patient.landmarks.end(),
                                  [](const Landmark& landmark) { return landmark.name == "conus"; });
  ASSERT_NE(conus, patient.landmarks.end());
  double lowest = 1e9;
  for (int k = 0; k < patient.tissues.grid.size[2]; ++k) {
    for (int j = 0; j < patient.tissues.grid.size[1]; ++j) {
      for (int i = 0; i < patient.tissues.grid.size[0]; ++i) {
        if (patient.tissues.at(i, j, k) == tissue::spinal_cord)
          lowest = std::min(lowest, patient.tissues.grid.to_patient(Vec3(i, j, k)).z());
      }
    }
  }
  EXPECT_NEAR(lowest, conus->position.z(), 3.0);
}

TEST(LumbarAnatomy, each_vertebra_is_one_piece_of_plausible_size) {
  const auto found = extents(default_patient().structures);
  for (int label = 27; label <= 31; ++label) {
    EXPECT_EQ(pieces(default_patient().structures, label), 1) << "label " << label;
    // A body of 44 x 35 x 27 mm with rounded corners holds some 30 cm3, arch and processes half as much again.
    const Extent& extent = found.at(label);
    EXPECT_GT(extent.voxels, 35000u);
    EXPECT_LT(extent.voxels, 80000u);
    EXPECT_NEAR(extent.high.x() - extent.low.x(), 82.0, 22.0) << "label " << label;
    EXPECT_NEAR(extent.high.y() - extent.low.y(), 80.0, 15.0) << "label " << label;
  }
  EXPECT_EQ(pieces(default_patient().structures, 26), 1);
}

TEST(LumbarAnatomy, levels_follow_each_other_and_sides_are_right) {
  const auto found = extents(default_patient().structures);
  for (int label = 26; label < 32; ++label)
    EXPECT_LT(found.at(label).centre.z() + 20.0, found.at(label + 1).centre.z()) << "label " << label;
  // LPS: the patient's left has positive x. Left and right: kidney, back muscle, psoas, hip.
  for (const auto& [left, right] : std::vector<std::pair<int, int>>{{3, 2}, {86, 87}, {88, 89}, {77, 78}}) {
    EXPECT_GT(found.at(left).centre.x(), 15.0);
    EXPECT_LT(found.at(right).centre.x(), -15.0);
  }
  EXPECT_GT(found.at(52).centre.x(), found.at(63).centre.x() + 10.0);  // aorta left of the vena cava
  EXPECT_LT(found.at(52).centre.y(), found.at(29).low.y());            // in front of the bodies
  EXPECT_GT(found.at(86).centre.y(), found.at(88).centre.y() + 30.0);  // back muscle behind psoas
  EXPECT_LT(found.at(2).centre.z(), found.at(3).centre.z());           // the right kidney lies lower
}

TEST(LumbarAnatomy, the_table_describes_every_label_and_marks_what_must_not_be_hit) {
  const SyntheticPatient& patient = default_patient();
  std::map<int, Structure> table;
  for (const Structure& structure : patient.structure_table) table[structure.label] = structure;
  for (const auto& [label, extent] : extents(patient.structures)) EXPECT_TRUE(table.contains(label)) << label;
  for (const int label : {2, 3, 52, 63}) EXPECT_TRUE(table.at(label).critical) << label;
  EXPECT_EQ(table.at(29).name, "vertebrae_L3");
  EXPECT_EQ(table.at(29).tissue, "bone");
  EXPECT_EQ(table.at(79).tissue, "spinal_canal");
}

TEST(LumbarAnatomy, no_line_reaches_the_fluid_without_crossing_the_dura) {
  for (const double spacing : {1.0, 2.5}) {
    LumbarParameters parameters;
    parameters.spacing = spacing;
    const SyntheticPatient coarse = spacing > 1.0 ? synthesize(parameters) : SyntheticPatient{};
    const SyntheticPatient& patient = spacing > 1.0 ? coarse : default_patient();
    const Grid& grid = patient.tissues.grid;
    Random random(7);
    int tried = 0;
    while (tried < 300) {
      const Vec3 inside =
          grid.to_patient(Vec3(random.uniform(0.0, grid.size[0] - 1.0), random.uniform(0.0, grid.size[1] - 1.0),
                               random.uniform(0.3 * grid.size[2], 0.7 * grid.size[2])));
      if (nearest(patient.tissues, inside, tissue::air) != tissue::cerebrospinal_fluid) continue;
      ++tried;
      // A direction more across than along the canal, which runs out of the volume above.
      const Vec3 direction =
          Vec3(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-0.5, 0.5)).normalized();
      TissueId last = tissue::cerebrospinal_fluid;
      for (double t = 0.0; t < 80.0; t += 0.05) {
        const TissueId id = nearest(patient.tissues, Vec3(inside + t * direction), tissue::air);
        if (id != last && last != tissue::nerve && last != tissue::spinal_cord && last != tissue::cerebrospinal_fluid)
          break;
        if (id == tissue::dura) break;
        ASSERT_TRUE(id == tissue::cerebrospinal_fluid || id == tissue::nerve || id == tissue::spinal_cord)
            << default_tissue_library().title(id) << " next to fluid at " << (inside + t * direction).transpose();
        last = id;
      }
    }
  }
}

TEST(LumbarAnatomy, landmarks_lie_in_the_canal_and_on_the_skin) {
  const SyntheticPatient& patient = default_patient();
  std::map<std::string, Vec3> landmark;
  for (const Landmark& found : patient.landmarks) landmark[found.name] = found.position;
  double before = 1e9;
  for (const std::string name : {"L1_L2", "L2_L3", "L3_L4", "L4_L5", "L5_S1"}) {
    ASSERT_TRUE(landmark.contains(name)) << name;
    EXPECT_EQ(nearest(patient.structures, landmark[name], std::uint16_t{0}), 79) << name;
    EXPECT_LT(landmark[name].z(), before - 20.0) << name;
    before = landmark[name].z();
    const Vec3 skin = landmark[name + "_skin"];
    EXPECT_EQ(nearest(patient.tissues, Vec3(skin - Vec3(0.0, 1.0, 0.0)), tissue::air), tissue::skin) << name;
    EXPECT_EQ(nearest(patient.tissues, Vec3(skin + Vec3(0.0, 1.0, 0.0)), tissue::air), tissue::air) << name;
  }
}

}  // namespace
}  // namespace bodkin
