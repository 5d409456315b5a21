// Difficult patients: curved spines, calcified ligaments, and random patients by seed.
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "patient/synthetic/calcification.h"
#include "patient/synthetic/lumbar.h"
#include "patient/synthetic/sizes.h"
#include "patient/synthetic/variant.h"
#include "tests/sanitized.h"
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "io/tissue_library_file.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
using namespace bodkin::patient;
namespace {

constexpr const char* several_backs =
    "sanitizers look at the memory of few synthetic patients, the plain build at the anatomy of several";

SyntheticPatient back_with(double scoliosis, double calcification, double spacing = 2.0) {
  LumbarParameters parameters;
  parameters.scoliosis = scoliosis;
  parameters.calcification = calcification;
  parameters.spacing = spacing;
  return synthesize_lumbar(parameters, with_calcified_ligament(default_tissue_library()));
}

// The pose of a vertebra, only from its voxels, as measured in a frontal image.
struct Stance {
  double inclination = 0.0;  // degrees of the upper endplate: above 0 its left side is lower
  double body_x = 0.0;       // mm, of the middle of the body
  double process_x = 0.0;    // mm, of the hindmost part of the spinous process
};

Stance stance_of(const LabelVolume& labels, int label) {
  const Grid& grid = labels.grid;
  double front = 1e9, hindmost = -1e9;
  const auto for_voxels = [&](const auto& visit) {
    for (int k = 0; k < grid.size[2]; ++k)
      for (int j = 0; j < grid.size[1]; ++j)
        for (int i = 0; i < grid.size[0]; ++i)
          if (labels.at(i, j, k) == label) visit(i, j, grid.to_patient(Vec3(i, j, k)));
  };
  for_voxels([&](int, int, const Vec3& p) {
    front = std::min(front, p.y());
    hindmost = std::max(hindmost, p.y());
  });
  double sum = 0.0, count = 0.0, tip = 0.0, tips = 0.0;
  std::map<std::pair<int, int>, double> highest;
  for_voxels([&](int i, int j, const Vec3& p) {
    if (p.y() > hindmost - 5.0) tip += p.x(), tips += 1.0;
    if (std::abs(p.y() - front - 17.0) > 8.0) return;  // the middle of the body, 35 mm deep
    sum += p.x();
    count += 1.0;
    double& top = highest.try_emplace({i, j}, -1e9).first->second;
    top = std::max(top, p.z());
  });
  Stance found;
  found.body_x = sum / count;
  found.process_x = tip / tips;
  double xx = 0.0, xz = 0.0, mean_z = 0.0, mean_x = 0.0, columns = 0.0;
  const auto for_tops = [&](const auto& visit) {
    for (const auto& [column, z] : highest) {
      const double x = grid.to_patient(Vec3(column.first, column.second, 0)).x() - found.body_x;
      if (std::abs(x) < 15.0) visit(x, z);
    }
  };
  for_tops([&](double x, double z) { mean_x += x, mean_z += z, columns += 1.0; });
  mean_x /= columns;
  mean_z /= columns;
  for_tops([&](double x, double z) {
    xx += (x - mean_x) * (x - mean_x);
    xz += (x - mean_x) * (z - mean_z);
  });
  found.inclination = -std::atan(xz / xx) * 180.0 / 3.14159265358979;
  return found;
}

TEST(LumbarVariant, a_scoliosis_has_the_angle_of_Cobb_that_was_asked_for) {
  if (sanitized) GTEST_SKIP() << several_backs;
  const SyntheticPatient straight = back_with(0.0, 0.0), left = back_with(30.0, 0.0), right = back_with(-20.0, 0.0);
  const auto cobb = [&](const SyntheticPatient& curved) {
    double least = 1e9, most = -1e9;
    for (int label = 27; label <= 31; ++label) {  // L5 to L1
      const double bent =
          stance_of(curved.structures, label).inclination - stance_of(straight.structures, label).inclination;
      least = std::min(least, bent);
      most = std::max(most, bent);
    }
    return most - least;
  };
  EXPECT_NEAR(cobb(left), 30.0, 3.0);
  EXPECT_NEAR(cobb(right), 20.0, 3.0);
  // The apex moves to the side, by about L / 6.2 times the angle; pelvis and thorax stay.
  const Stance apex = stance_of(left.structures, 29), before = stance_of(straight.structures, 29);
  EXPECT_GT(apex.body_x - before.body_x, 10.0);
  EXPECT_LT(apex.body_x - before.body_x, 20.0);
  EXPECT_LT(stance_of(right.structures, 29).body_x - before.body_x, -6.0);
  EXPECT_NEAR(stance_of(left.structures, 26).body_x, stance_of(straight.structures, 26).body_x, 1.5);
  // The spinous processes turn to the concave side.
  EXPECT_LT(apex.process_x - apex.body_x, before.process_x - before.body_x - 5.0);
}

// Tissues on the way along the planned path, as shares of the way through the ligaments behind the canal.
std::map<TissueId, double> shares_of_way(const SyntheticPatient& patient) {
  std::map<TissueId, double> found;
  double all = 0.0;
  const Vec3 along = patient.path.direction();
  for (double depth = 0.0; depth < patient.path.length(); depth += 0.1) {
    const TissueId id = nearest(patient.tissues, Vec3(patient.path.entry + depth * along), tissue::air);
    if (id != tissue::supraspinous_ligament && id != tissue::interspinous_ligament && id != calcified_ligament)
      continue;
    found[id] += 1.0;
    all += 1.0;
  }
  for (auto& [id, share] : found) share /= all;
  return found;
}

TEST(LumbarVariant, a_curved_spine_has_its_ligaments_and_its_canal_where_the_needle_goes) {
  if (sanitized) GTEST_SKIP() << several_backs;
  for (const double angle : {-35.0, 35.0}) {
    const SyntheticPatient patient = back_with(angle, 0.0, 1.5);
    const Vec3 along = patient.path.direction();
    std::vector<TissueId> met;
    for (double depth = 0.5; depth <= patient.path.length(); depth += 0.1) {
      const TissueId id = nearest(patient.tissues, Vec3(patient.path.entry + depth * along), tissue::air);
      if (met.empty() || met.back() != id) met.push_back(id);
    }
    const std::vector<TissueId> expected = {tissue::skin,
                                            tissue::fat,
                                            tissue::supraspinous_ligament,
                                            tissue::interspinous_ligament,
                                            tissue::ligamentum_flavum,
                                            tissue::epidural_fat,
                                            tissue::dura,
                                            tissue::cerebrospinal_fluid};
    EXPECT_EQ(met, expected) << angle << " degrees";
    EXPECT_GT(std::abs(along.x()), 0.05) << "the needle follows the plane of the turned processes";
  }
}

TEST(LumbarVariant, calcification_begins_behind_and_reaches_as_far_as_it_was_asked_to) {
  if (sanitized) GTEST_SKIP() << several_backs;
  for (const double wanted : {0.0, 0.3, 0.6, 1.0}) {
    const SyntheticPatient patient = back_with(0.0, wanted);
    auto shares = shares_of_way(patient);
    EXPECT_NEAR(shares[calcified_ligament], wanted, 0.13) << wanted;
    if (wanted > 0.2) {
      EXPECT_LT(shares[tissue::supraspinous_ligament], 0.05) << wanted;
    }
    const bool is_anywhere = std::find(patient.tissues.voxels.begin(), patient.tissues.voxels.end(),
                                       calcified_ligament) != patient.tissues.voxels.end();
    EXPECT_EQ(is_anywhere, wanted > 0.0);
  }
}

TEST(LumbarVariant, beside_the_midline_a_way_leads_past_calcified_ligaments) {
  if (sanitized) GTEST_SKIP() << several_backs;
  const SyntheticPatient patient = back_with(0.0, 1.0);
  const auto is_free = [&](const Vec3& entry, const Vec3& target) {
    const double length = (target - entry).norm();
    for (double depth = 0.0; depth < length; depth += 0.5) {
      const TissueId id = nearest(patient.tissues, Vec3(entry + depth / length * (target - entry)), tissue::air);
      if (id == calcified_ligament || id == tissue::cortical_bone || id == tissue::cancellous_bone) return false;
    }
    return true;
  };
  EXPECT_FALSE(is_free(patient.path.entry, patient.path.target));
  // The paramedian approach: 10 to 20 mm beside the midline, towards the head and the middle.
  int free_ways = 0;
  for (const double beside : {10.0, 12.5, 15.0, 17.5, 20.0})
    for (double lower = -20.0; lower <= 10.0; lower += 2.5)
      if (is_free(patient.path.entry + Vec3(beside, 0.0, lower), patient.path.target)) ++free_ways;
  EXPECT_GT(free_ways, 0);
}

TEST(LumbarVariant, a_library_without_the_calcified_ligament_is_refused) {
  LumbarParameters parameters;
  parameters.calcification = 0.5;
  parameters.spacing = 3.0;
  EXPECT_THROW(synthesize_lumbar(parameters, default_tissue_library()), InputError);
  const TissueLibrary library = with_calcified_ligament(default_tissue_library());
  EXPECT_THROW(with_calcified_ligament(library), InputError);  // the id is taken
  // A file of the library gives the same tissue back.
  const TissueProperties& hard = *library.find(calcified_ligament);
  EXPECT_GT(hard.layered.break_force, library.find(tissue::ligamentum_flavum)->layered.break_force);
  EXPECT_GT(hard.hounsfield, library.find(tissue::interspinous_ligament)->hounsfield + 100.0);
}

TEST(LumbarVariant, a_seed_draws_a_whole_patient_and_each_parameter_by_itself) {
  int curved = 0, calcified_old = 0, old = 0;
  std::map<int, int> gauges;
  double sum = 0.0;
  constexpr int patients = 1000;
  for (int seed = 0; seed < patients; ++seed) {
    const LumbarVariant drawn = draw_variant(static_cast<std::uint64_t>(seed));
    const LumbarParameters& patient = drawn.parameters;
    ASSERT_NO_THROW(check_parameters(patient)) << "seed " << seed;
    EXPECT_EQ(patient.seed, static_cast<std::uint64_t>(seed));
    EXPECT_EQ(draw_variant(patient.seed).parameters.weight, patient.weight);
    sum += patient.age;
    ++gauges[drawn.gauge];
    if (patient.scoliosis != 0.0) {
      ++curved;
      EXPECT_GE(std::abs(patient.scoliosis), 10.0);
    }
    if (patient.age < 50.0) {
      EXPECT_EQ(patient.calcification, 0.0);
    }
    if (patient.age > 75.0) ++old;
    if (patient.age > 75.0 && patient.calcification > 0.0) ++calcified_old;
  }
  // Four standard deviations of a binomial distribution.
  EXPECT_NEAR(curved, 250, 55);
  EXPECT_NEAR(sum / patients, 55.0, 3.0);
  EXPECT_GT(calcified_old, old / 2);
  ASSERT_EQ(gauges.size(), 3U);
  for (const int gauge : {20, 22, 25}) EXPECT_NEAR(gauges[gauge], 333, 60) << gauge;
}

TEST(LumbarVariant, a_lesion_is_a_ball_in_muscle_and_fat_beside_the_left_psoas) {
  LumbarParameters parameters;
  parameters.spacing = 2.0;
  const SyntheticPatient healthy = synthesize_lumbar(parameters, default_tissue_library());
  parameters.lesion = 20.0;
  const SyntheticPatient ill = synthesize_lumbar(parameters, default_tissue_library());
  int voxels = 0, in_muscle = 0, in_fat = 0;
  Vec3 middle = Vec3::Zero();
  const Grid& grid = ill.tissues.grid;
  std::size_t at = 0;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i, ++at) {
        if (ill.tissues.voxels[at] != tissue::mass) {
          ASSERT_EQ(ill.tissues.voxels[at], healthy.tissues.voxels[at]);
          continue;
        }
        middle += grid.to_patient(Vec3(i, j, k));
        ++voxels;
        in_muscle += healthy.tissues.voxels[at] == tissue::muscle;
        in_fat += healthy.tissues.voxels[at] == tissue::fat;
      }
    }
  }
  middle /= std::max(voxels, 1);
  EXPECT_NEAR(voxels * 8.0, 4188.8, 0.1 * 4188.8);  // mm^3 of a ball of 20 mm
  EXPECT_GT(in_muscle, voxels / 4);
  EXPECT_GT(in_fat, voxels / 4);
  EXPECT_GT(middle.x(), 30.0);  // to the left
  EXPECT_LT(std::abs(middle.z()), 3.0);
  const auto named = std::find_if(ill.structure_table.begin(), ill.structure_table.end(),
                                  [](const Structure& structure) { return structure.name == "lesion"; });
  ASSERT_NE(named, ill.structure_table.end());
  EXPECT_EQ(named->tissue, "mass");
  parameters.lesion = 5.0;
  EXPECT_THROW(static_cast<void>(synthesize_lumbar(parameters, default_tissue_library())), InputError);
}

}  // namespace
}  // namespace bodkin
