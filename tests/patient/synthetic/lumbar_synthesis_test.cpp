// The synthetic patient as a generator: repeatable, bounded, punctured without touching bone.
#include <cmath>
#include <string>
#include <vector>

#include "patient/synthetic/approach.h"
#include "patient/synthetic/lumbar.h"
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

LumbarParameters coarse(std::uint64_t seed = 1) {
  LumbarParameters parameters;
  parameters.seed = seed;
  parameters.spacing = 2.5;
  return parameters;
}

LumbarParameters random_parameters(Random& random) {
  LumbarParameters parameters;
  parameters.seed = random.next();
  parameters.age = random.uniform(18.0, 95.0);
  parameters.height = random.uniform(1.4, 2.05);
  parameters.weight = std::clamp(random.uniform(17.0, 45.0) * parameters.height * parameters.height, 40.0, 160.0);
  parameters.flexion = random.uniform(0.3, 1.0);
  return parameters;
}

bool is_bone(TissueId id) {
  return id == tissue::cortical_bone || id == tissue::cancellous_bone;
}

TEST(LumbarSynthesis, the_same_seed_gives_the_same_voxels_and_another_seed_does_not) {
  const TissueLibrary library = default_tissue_library();
  const SyntheticPatient a = synthesize_lumbar(coarse(5), library), b = synthesize_lumbar(coarse(5), library),
                         c = synthesize_lumbar(coarse(6), library);
  EXPECT_EQ(a.ct.voxels, b.ct.voxels);
  EXPECT_EQ(a.tissues.voxels, b.tissues.voxels);
  EXPECT_EQ(a.structures.voxels, b.structures.voxels);
  EXPECT_EQ(a.path.entry, b.path.entry);
  EXPECT_NE(a.path.entry, c.path.entry);
  EXPECT_NE(a.ct.voxels, c.ct.voxels);
}

TEST(LumbarSynthesis, the_volumes_share_one_axial_lattice_with_air_around_the_body) {
  const SyntheticPatient patient = synthesize_lumbar(coarse(), default_tissue_library());
  EXPECT_TRUE(same_lattice(patient.ct.grid, patient.tissues.grid));
  EXPECT_TRUE(same_lattice(patient.ct.grid, patient.structures.grid));
  EXPECT_EQ(patient.ct.grid.axes(), "LPS");
  const auto& size = patient.ct.grid.size;
  for (int k = 0; k < size[2]; ++k) {
    for (int i = 0; i < size[0]; ++i) {
      ASSERT_EQ(patient.tissues.at(i, 0, k), tissue::air);
      ASSERT_EQ(patient.tissues.at(i, size[1] - 1, k), tissue::air);
    }
    for (int j = 0; j < size[1]; ++j) {
      ASSERT_EQ(patient.tissues.at(0, j, k), tissue::air);
      ASSERT_EQ(patient.tissues.at(size[0] - 1, j, k), tissue::air);
    }
  }
}

TEST(LumbarSynthesis, hounsfield_units_are_those_of_the_library_with_its_noise) {
  const TissueLibrary library = default_tissue_library();
  LumbarParameters parameters = coarse();
  parameters.age = 35.0;  // before muscles and bone change
  const SyntheticPatient patient = synthesize_lumbar(parameters, library);
  const Grid& grid = patient.tissues.grid;
  for (const TissueId id : {tissue::air, tissue::fat, tissue::muscle, tissue::organ}) {
    double sum = 0.0, squares = 0.0, count = 0.0;
    for (int k = 1; k + 1 < grid.size[2]; ++k)
      for (int j = 1; j + 1 < grid.size[1]; ++j)
        for (int i = 1; i + 1 < grid.size[0]; ++i) {
          bool inside = true;  // away from other tissues, which the point spread mixes in
          for (int n = 0; n < 27 && inside; ++n)
            inside = patient.tissues.at(i + n % 3 - 1, j + n / 3 % 3 - 1, k + n / 9 - 1) == id;
          if (!inside) continue;
          const double hu = patient.ct.at(i, j, k);
          sum += hu;
          squares += hu * hu;
          count += 1.0;
        }
    ASSERT_GT(count, 1000.0) << library.title(id);
    const double mean = sum / count, deviation = std::sqrt(squares / count - mean * mean);
    EXPECT_NEAR(mean, library.find(id)->hounsfield, 3.0) << library.title(id);
    EXPECT_NEAR(deviation, library.find(id)->hounsfield_noise, 0.25 * library.find(id)->hounsfield_noise + 0.5)
        << library.title(id);
  }
}

TEST(LumbarSynthesis, the_planned_path_keeps_clear_of_bone_for_every_flexed_patient) {
  Random random(20);
  for (int n = 0; n < 200; ++n) {
    const LumbarParameters parameters = random_parameters(random);
    const Approach approach = plan_approach(LumbarModel(lumbar_sizes(parameters), parameters.seed), level::l3);
    EXPECT_GE(approach.clearance, 2.0) << "age " << parameters.age << " height " << parameters.height << " flexion "
                                       << parameters.flexion << " seed " << parameters.seed;
    EXPECT_GT(approach.angle, -0.15);
    EXPECT_LT(approach.angle, 0.6);
  }
}

TEST(LumbarSynthesis, voxels_along_the_planned_path_hold_no_bone_and_end_in_the_fluid) {
  const TissueLibrary library = default_tissue_library();
  Random random(21);
  // The plain build checks the anatomy of many, a sanitizer the memory of a few.
  constexpr int coarse = sanitized ? 3 : 30, fine = sanitized ? 0 : 3;
  for (int n = 0; n < coarse + fine; ++n) {
    LumbarParameters parameters = random_parameters(random);
    parameters.spacing = n < coarse ? 2.5 : 1.0;
    const SyntheticPatient patient = synthesize_lumbar(parameters, library);
    const std::string who = "age " + std::to_string(parameters.age) + " height " + std::to_string(parameters.height) +
                            " weight " + std::to_string(parameters.weight) + " flexion " +
                            std::to_string(parameters.flexion) + " seed " + std::to_string(parameters.seed);
    for (double depth = 0.0; depth <= patient.path.length(); depth += 0.2) {
      const Vec3 tip = patient.path.entry + depth * patient.path.direction();
      const TissueId id = nearest(patient.tissues, tip, tissue::air);
      ASSERT_FALSE(is_bone(id)) << who << " at " << depth << " mm";
      // At 1 mm the midline holds ligaments from the fat to the canal, no muscle.
      if (parameters.spacing == 1.0) {
        ASSERT_NE(id, tissue::muscle) << who << " at " << depth << " mm";
      }
    }
    EXPECT_EQ(nearest(patient.tissues, patient.path.target, tissue::air), tissue::cerebrospinal_fluid) << who;
    EXPECT_GT(patient.path.length(), 32.0) << who;
    EXPECT_LT(patient.path.length(), 130.0) << who;
  }
}

TEST(LumbarSynthesis, parameters_out_of_range_are_refused_by_name_value_and_range) {
  const TissueLibrary library = default_tissue_library();
  struct Bad {
    const char *name, *value, *range;
    void (*spoil)(LumbarParameters&);
  };
  const std::vector<Bad> all = {
      {"age", "17", "18 to 95", [](LumbarParameters& p) { p.age = 17.0; }},
      {"height", "2.5", "1.4 to 2.05", [](LumbarParameters& p) { p.height = 2.5; }},
      {"weight", "300", "40 to 160", [](LumbarParameters& p) { p.weight = 300.0; }},
      {"flexion", "-0.1", "0 to 1", [](LumbarParameters& p) { p.flexion = -0.1; }},
      {"spacing", "0.1", "0.5 to 3", [](LumbarParameters& p) { p.spacing = 0.1; }},
      {"flexion", "nan", "0 to 1", [](LumbarParameters& p) { p.flexion = std::nan(""); }},
  };
  for (const Bad& bad : all) {
    LumbarParameters parameters;
    bad.spoil(parameters);
    try {
      synthesize_lumbar(parameters, library);
      ADD_FAILURE() << bad.name << " was accepted";
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find(bad.name), std::string::npos) << message;
      EXPECT_NE(message.find(bad.value), std::string::npos) << message;
      EXPECT_NE(message.find(bad.range), std::string::npos) << message;
    }
  }
}

TEST(LumbarSynthesis, a_library_without_a_tissue_of_the_patient_is_refused) {
  const TissueLibrary library = default_tissue_library();
  std::vector<TissueProperties> few;
  for (const TissueProperties& properties : library.tissues())
    if (properties.id != tissue::dura) few.push_back(properties);
  EXPECT_THROW(synthesize_lumbar(coarse(), TissueLibrary(few)), InputError);
}

TEST(LumbarSynthesis, progress_runs_from_zero_to_one_in_each_stage) {
  std::vector<std::pair<std::string, double>> reports;
  synthesize_lumbar(coarse(), default_tissue_library(),
                    [&](std::string_view stage, double fraction) { reports.emplace_back(stage, fraction); });
  ASSERT_GT(reports.size(), 4u);
  for (std::size_t i = 0; i < reports.size(); ++i) {
    EXPECT_GE(reports[i].second, 0.0);
    EXPECT_LE(reports[i].second, 1.0);
    const bool new_stage = i == 0 || reports[i].first != reports[i - 1].first;
    EXPECT_GE(reports[i].second, new_stage ? 0.0 : reports[i - 1].second);
  }
  EXPECT_EQ(reports.back().second, 1.0);
}

}  // namespace
}  // namespace bodkin
