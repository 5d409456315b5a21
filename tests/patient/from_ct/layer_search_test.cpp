#include "patient/from_ct/layer_search.h"

#include "patient/synthetic/lumbar.h"
#include "tests/patient/from_ct/patient_crossing.h"
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/random.h"
#include "io/tissue_library_file.h"

// The layers behind the dural sac as the CT shows them: on canals made by hand, and on synthetic patients with thick
// slices and noise against their true tissues.

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
using namespace bodkin::patient;
namespace {

// A straight canal along z with its back at y = 20, and HU that depend on y alone; noise in HU.
struct HandMadeCanal {
  SpineView view;
  SpinalCanal canal;
};

template <typename HounsfieldAt>
HandMadeCanal canal_of(HounsfieldAt hounsfield_at, double noise = 0.0) {
  Grid grid;
  grid.size = {21, 60, 12};
  grid.spacing = Vec3::Ones();
  grid.origin = Vec3(-10.0, 0.0, 0.0);
  HandMadeCanal made;
  made.view.hounsfield = Volume<std::int16_t>(grid);
  made.view.bone = MaskVolume(grid);
  made.view.role = Volume<std::uint8_t>(grid);
  Random random(7);
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i)
        made.view.hounsfield.at(i, j, k) =
            static_cast<std::int16_t>(std::lround(hounsfield_at(j) + noise * random.uniform(-1.7, 1.7)));
    }
  }
  for (int k = 0; k < grid.size[2]; ++k) made.canal.sections.push_back({0.0, 4.0, 20.0, 11.0});
  return made;
}

double interspace_with_fat(double y) {
  return y < 17.0 ? 10.0 : y < 22.0 ? -95.0 : y < 26.0 ? 70.0 : 40.0;  // sac, epidural fat, flavum, ligament
}

LayersSeen seen_in(const HandMadeCanal& made) {
  return see_layers(made.view, made.canal, 2.0, 9.0, 1.0);
}

TEST(LayerSearch, finds_the_front_of_the_flavum_and_the_depth_of_the_fat) {
  for (const double noise : {0.0, 20.0}) {
    const LayersSeen seen = seen_in(canal_of(interspace_with_fat, noise));
    ASSERT_TRUE(seen.wall.has_value()) << noise;
    EXPECT_NEAR(seen.wall->value, 1.5, 0.5) << "between the voxels at y = 21 and 22";
    ASSERT_TRUE(seen.epidural.has_value()) << noise;
    EXPECT_NEAR(seen.epidural->value, 5.0, 0.7);
    EXPECT_GE(seen.wall->uncertainty, 0.5) << "half a voxel";
    EXPECT_LE(seen.wall->uncertainty, 1.5);
  }
}

TEST(LayerSearch, fat_behind_the_flavum_is_not_the_epidural_fat) {
  const LayersSeen seen = seen_in(canal_of([](double y) {
    return y < 20.0   ? 10.0
           : y < 24.0 ? 70.0
           : y < 30.0 ? -95.0
                      : 40.0;  // no epidural fat, a gap between the ligaments
  }));
  ASSERT_TRUE(seen.wall.has_value());
  EXPECT_NEAR(seen.wall->value, -0.5, 0.5);
  EXPECT_FALSE(seen.epidural.has_value());
}

TEST(LayerSearch, finds_nothing_where_there_is_no_step_but_noise) {
  EXPECT_FALSE(seen_in(canal_of([](double) { return 20.0; }, 25.0)).wall.has_value());
}

TEST(LayerSearch, leaves_out_heights_at_which_a_lamina_follows) {
  HandMadeCanal made = canal_of(interspace_with_fat);
  for (int k = 0; k < 12; ++k) {
    for (int j = 18; j < 30; ++j) {
      for (int i = 0; i < 21; ++i) made.view.bone.at(i, j, k) = k < 11 ? 1 : 0;
    }
  }
  EXPECT_FALSE(seen_in(made).wall.has_value());
}

// The CT with slices of `thickness` mm, each the mean of the thin ones in it, and Gaussian-like noise.
CtVolume degraded(const CtVolume& ct, int thickness, double noise) {
  Grid grid = ct.grid;
  grid.size[2] = ct.grid.size[2] / thickness;
  grid.spacing.z() = ct.grid.spacing.z() * thickness;
  grid.origin = ct.grid.to_patient(Vec3(0.0, 0.0, 0.5 * (thickness - 1)));
  CtVolume out(grid);
  Random random(5);
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        double sum = 0.0;
        for (int n = 0; n < thickness; ++n) sum += ct.at(i, j, k * thickness + n);
        out.at(i, j, k) = static_cast<std::int16_t>(std::lround(sum / thickness + noise * random.uniform(-1.7, 1.7)));
      }
    }
  }
  return out;
}

// A patient made from the CT of `truth`, with slices of `thickness` of its own and noise of 12 HU, without labels,
// has the layers of the truth at every level.
void expect_layers_of(const SyntheticPatient& truth, int thickness) {
  const BuiltPatient built = build_patient(degraded(truth.ct, thickness, 12.0), {}, {}, {}, {});
  const std::string slices = fmt::format(", slices of {:.1f} mm", thickness * truth.ct.grid.spacing.z());
  std::vector<double> errors;
  for (const char* level : {"L1_L2", "L2_L3", "L3_L4", "L4_L5", "L5_S1"}) {
    const NeedlePath path{test::landmark(truth.landmarks, std::string(level) + "_skin"),
                          test::landmark(truth.landmarks, level)};
    const auto real = test::crossings(truth.tissues, path), found = test::crossings(built.tissues, path);
    const double flavum = test::last_of(found, tissue::ligamentum_flavum);
    const double dura = test::first_of(found, tissue::dura);
    EXPECT_NEAR(flavum, test::last_of(real, tissue::ligamentum_flavum), 4.0) << level << slices;
    EXPECT_NEAR(dura, test::first_of(real, tissue::dura), 4.0) << level << slices;
    errors.push_back(std::abs(flavum - test::last_of(real, tissue::ligamentum_flavum)));
  }
  std::sort(errors.begin(), errors.end());
  EXPECT_LE(errors[2], 2.0) << "median" << slices;
}

TEST(LayerSearch, thick_slices_and_noise_move_the_layers_of_a_synthetic_patient_little) {
  const SyntheticPatient truth = synthesize_lumbar({}, default_tissue_library());
  for (const int thickness : {1, 2, 5}) expect_layers_of(truth, thickness);
}

TEST(LayerSearch, fine_slices_with_noise_show_the_layers_of_a_synthetic_patient) {
  LumbarParameters parameters;
  parameters.spacing = 0.7;
  expect_layers_of(synthesize_lumbar(parameters, default_tissue_library()), 1);
}

}  // namespace
}  // namespace bodkin
