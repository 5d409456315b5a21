#include "patient/meshing/mesh_plan.h"

#include <algorithm>

#include "patient/meshing/meshable_tissues.h"
#include "patient/synthetic/lumbar.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::patient;
namespace {

constexpr double voxel = 1.0;  // mm

// Muscle below y = 0, of 100 x 60 x 100 mm, with a skin of 2 mm towards positive y; a specimen of bone 20 mm deep.
TissueVolume layered_block() {
  Grid grid;
  grid.size = {100, 80, 100};
  grid.spacing = Vec3::Constant(voxel);
  grid.origin = Vec3(-49.5, -59.5, -49.5);
  TissueVolume tissues(grid, tissue::air);
  for (int k = 0; k < 100; ++k) {
    for (int j = 0; j < 60; ++j) {
      for (int i = 0; i < 100; ++i) {
        const Vec3 at = grid.to_patient(Vec3(i, j, k));
        TissueId id = at.y() > -2.0 ? tissue::skin : tissue::muscle;
        if (at.y() < -20.0 && at.y() > -24.0) id = tissue::cortical_bone;
        tissues.at(i, j, k) = id;
      }
    }
  }
  return tissues;
}

const NeedlePath straight_in{Vec3::Zero(), Vec3(0.0, -40.0, 0.0)};

TEST(MeshPlan, edges_are_fine_in_the_corridor_and_grow_steadily_away_from_it) {
  const TissueVolume tissues = layered_block();
  MeshSettings settings;
  settings.corridor_radius = 15.0;
  settings.preserve_layers = false;
  const MeshPlan plan = plan_mesh(tissues, straight_in, settings);
  const Grid& grid = plan.tissues.grid;
  const std::vector<float> edges = meshable_tissues(plan, 1.0).edges;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const float edge = edges[grid.offset(i, j, k)];
        ASSERT_GE(edge, 2.0F);
        ASSERT_LE(edge, 10.0F);
        const double away = distance_to_corridor(grid.to_patient(Vec3(i, j, k)), straight_in, settings);
        if (away <= 0.0) {
          ASSERT_FLOAT_EQ(edge, 2.0F);
        }
        if (i > 0) {
          ASSERT_LE(std::abs(edge - edges[grid.offset(i - 1, j, k)]), 0.83F);
        }
      }
    }
  }
}

TEST(MeshPlan, without_a_path_edges_are_fine_at_borders_only) {
  const MeshableTissues meshable = meshable_tissues(plan_mesh(layered_block(), std::nullopt, {}), 1.0);
  const Grid& grid = meshable.tissues.grid;
  const auto edge_at = [&](double y) {
    const Vec3 index = grid.to_index({0.5, y, 0.5}).array().round();
    return meshable
        .edges[grid.offset(static_cast<int>(index.x()), static_cast<int>(index.y()), static_cast<int>(index.z()))];
  };
  EXPECT_NEAR(edge_at(-19.5), 2.6F, 1e-5F);  // muscle beside the bone
  EXPECT_NEAR(edge_at(-20.5), 2.6F, 1e-5F);  // the bone beside the muscle
  EXPECT_NEAR(edge_at(-38.5), 10.0F, 1e-5F);
}

TEST(MeshPlan, the_box_ends_where_it_is_far_from_the_path) {
  MeshSettings settings;
  settings.corridor_radius = 5.0;
  settings.reach = 20.0;
  const TissueVolume tissues = layered_block();
  const MeshPlan plan = plan_mesh(tissues, straight_in, settings);
  EXPECT_TRUE(plan.boxed);
  const Grid& grid = plan.tissues.grid;
  EXPECT_LE(grid.size[0], 54);
  EXPECT_GE(grid.size[0], 50);
  // The tissues are unmoved.
  for (const Vec3& at : {Vec3(3, -1, 2), Vec3(-20, -22, 10), Vec3(0, -40, 0)}) {
    EXPECT_EQ(nearest(plan.tissues, at, tissue::air), nearest(tissues, at, tissue::air));
  }
  settings.reach = 500.0;
  EXPECT_FALSE(plan_mesh(tissues, straight_in, settings).boxed);
  EXPECT_FALSE(plan_mesh(tissues, std::nullopt, settings).boxed);
  // The outermost layer is air.
  for (int j = 0; j < grid.size[1]; ++j) EXPECT_EQ(plan.tissues.at(0, j, grid.size[2] / 2), tissue::air);
}

TEST(MeshPlan, thin_skin_becomes_what_is_below_it_and_thick_bone_stays) {
  MeshSettings settings;
  settings.preserve_layers = false;
  settings.corridor_radius = 15.0;
  const MeshPlan plan = plan_mesh(layered_block(), straight_in, settings);
  const MeshableTissues merged = meshable_tissues(plan, 1.5);
  const TissueVolume& coarse = merged.tissues;
  EXPECT_EQ(merged.after[tissue::skin], 0U);
  EXPECT_EQ(nearest(coarse, Vec3(0, -1, 0), tissue::air), tissue::muscle);          // there is no fat
  EXPECT_EQ(nearest(coarse, Vec3(0, -22, 0), tissue::air), tissue::cortical_bone);  // 4 mm, edges of 3 mm
  EXPECT_EQ(merged.dropped, 0U);
  EXPECT_EQ(nearest(meshable_tissues(plan, 0.5).tissues, Vec3(0, -1, 0), tissue::air), tissue::skin);
  std::size_t before = 0, after = 0;
  for (std::size_t id = 1; id < 256; ++id) {
    before += merged.before[id];
    after += merged.after[id];
  }
  EXPECT_EQ(before, after + merged.dropped);
}

// Skin of 2 mm, a dura of one voxel at 10 mm, bone of 4 mm.
TissueVolume block_with_dura() {
  TissueVolume tissues = layered_block();
  for (int k = 0; k < 100; ++k) {
    for (int i = 0; i < 100; ++i) tissues.at(i, 49, k) = tissue::dura;
  }
  return tissues;
}

TEST(MeshPlan, layers_of_the_path_are_those_of_the_voxels) {
  const std::vector<PathLayer> layers = layers_on(straight_in, 15.0, block_with_dura());
  ASSERT_EQ(layers.size(), 5U);  // the muscle behind the bone goes on
  const TissueId ids[] = {tissue::skin, tissue::muscle, tissue::dura, tissue::muscle, tissue::cortical_bone};
  const double thickness[] = {2.0, 8.0, 1.0, 9.0, 4.0};
  for (std::size_t i = 0; i < layers.size(); ++i) {
    EXPECT_EQ(layers[i].tissue, ids[i]);
    EXPECT_NEAR(layers[i].thickness(), thickness[i], 0.11);
  }
  EXPECT_NEAR(layers[2].depth, 10.0, 0.06);
}

TEST(MeshPlan, held_layers_stay_where_the_path_crosses_them_however_coarse_the_rest) {
  MeshSettings settings;
  settings.corridor_radius = 15.0;
  settings.preserve_layers = false;
  const TissueVolume tissues = block_with_dura();
  const MeshPlan lax = plan_mesh(tissues, straight_in, settings);
  const MeshableTissues coarse = meshable_tissues(lax, 1.5);
  const std::vector<PathLayer> lost = lost_layers(lax, coarse);
  ASSERT_EQ(lost.size(), 2U);
  EXPECT_EQ(lost[0].tissue, tissue::skin);
  EXPECT_EQ(lost[1].tissue, tissue::dura);
  settings.preserve_layers = true;
  const MeshPlan plan = plan_mesh(tissues, straight_in, settings);
  for (const double scale : {1.0, 1.5, 4.0}) {
    const MeshableTissues held = meshable_tissues(plan, scale);
    EXPECT_TRUE(lost_layers(plan, held).empty()) << scale;
    EXPECT_EQ(nearest(held.tissues, Vec3(30, -10.5, 0), tissue::air), tissue::muscle) << "far from the path";
    const Vec3 index = plan.tissues.grid.to_index(Vec3(0.5, -10.5, 0.5)).array().round();
    const float edge = held.edges[plan.tissues.grid.offset(static_cast<int>(index.x()), static_cast<int>(index.y()),
                                                           static_cast<int>(index.z()))];
    EXPECT_NEAR(edge, 1.0F, 0.11F) << scale;
  }
  EXPECT_GT(expected_nodes(meshable_tissues(plan, 4.0)), 2.0 * expected_nodes(meshable_tissues(lax, 4.0)));
}

TEST(MeshPlan, the_surroundings_of_the_layers_tell_how_coarse_the_whole_may_be) {
  const TissueLibrary library = default_tissue_library();
  const auto depths = [](const std::vector<PathLayer>& layers) {
    std::vector<double> found;
    for (const PathLayer& layer : layers) found.push_back(layer.depth);
    return found;
  };
  int lost_layers_found = 0;
  for (const std::uint64_t seed : {1, 2, 3, 11}) {
    SCOPED_TRACE(seed);
    LumbarParameters parameters;
    parameters.seed = seed;
    parameters.spacing = 2.5;
    const SyntheticPatient torso = synthesize_lumbar(parameters, library);
    const MeshPlan plan = plan_mesh(torso.tissues, torso.path, {});
    const MeshPlan part = around_layers(plan);
    EXPECT_LT(5 * part.border_edges.size(), plan.border_edges.size());
    for (const double scale : {0.5, 1.0, 2.0, 8.0}) {
      const std::vector<double> lost = depths(lost_layers(plan, meshable_tissues(plan, scale)));
      EXPECT_EQ(depths(lost_layers(part, meshable_tissues(part, scale))), lost) << scale;
      lost_layers_found += static_cast<int>(lost.size());
    }
  }
  EXPECT_GT(lost_layers_found, 0);
}

TEST(MeshPlan, the_surroundings_of_the_layers_have_the_edges_of_the_whole) {
  const MeshPlan plan = plan_mesh(block_with_dura(), straight_in, {});
  const MeshPlan part = around_layers(plan);
  const Grid &whole = plan.tissues.grid, &grid = part.tissues.grid;
  for (const Vec3& place : {Vec3(0.5, -0.5, 0.5), Vec3(-10.5, -10.5, 7.5), Vec3(20.5, -22.5, -20.5)}) {
    const auto at = [&place](const Grid& in) {
      const Vec3 index = in.to_index(place).array().round();
      return in.offset(static_cast<int>(index.x()), static_cast<int>(index.y()), static_cast<int>(index.z()));
    };
    EXPECT_EQ(part.tissues.voxels[at(grid)], plan.tissues.voxels[at(whole)]);
    EXPECT_EQ(part.border_edges[at(grid)], plan.border_edges[at(whole)]);
    EXPECT_EQ(part.inner_edges[at(grid)], plan.inner_edges[at(whole)]);
    EXPECT_EQ(part.preserving_edges[at(grid)], plan.preserving_edges[at(whole)]);
  }
}

TEST(MeshPlan, a_stiff_skin_is_held_as_far_around_the_path_as_it_bends) {
  const TissueVolume tissues = layered_block();
  MeshSettings settings;
  settings.corridor_radius = 15.0;
  const auto skin_at = [&](double aside) {
    const MeshableTissues held = meshable_tissues(plan_mesh(tissues, straight_in, settings), 3.0);
    return nearest(held.tissues, Vec3(aside + 0.5, -0.5, 0.5), tissue::air);
  };
  EXPECT_EQ(skin_at(2.0), tissue::skin);
  EXPECT_EQ(skin_at(11.0), tissue::muscle);
  settings.stiff_skin = true;
  EXPECT_EQ(skin_at(11.0), tissue::skin);
  EXPECT_EQ(skin_at(25.0), tissue::muscle);
}

TEST(MeshPlan, a_ligament_that_the_path_follows_lengthwise_is_held_by_its_width) {
  TissueVolume tissues = layered_block();
  for (int k = 0; k < 100; ++k) {
    for (int j = 0; j < 60; ++j) {
      for (int i = 0; i < 100; ++i) {  // 4 mm wide, from 3 to 18 mm deep
        const Vec3 place = tissues.grid.to_patient(Vec3(i, j, k));
        if (std::abs(place.x()) < 2.0 && place.y() < -3.0 && place.y() > -18.0)
          tissues.at(i, j, k) = tissue::interspinous_ligament;
      }
    }
  }
  MeshSettings settings;
  settings.corridor_radius = 15.0;
  const MeshPlan plan = plan_mesh(tissues, straight_in, settings);
  const auto ligament = std::find_if(plan.layers.begin(), plan.layers.end(), [](const PathLayer& layer) {
    return layer.tissue == tissue::interspinous_ligament;
  });
  ASSERT_NE(ligament, plan.layers.end());
  EXPECT_NEAR(ligament->thickness(), 15.0, 0.2);
  EXPECT_NEAR(ligament->width, 4.0, 1.1);
  EXPECT_TRUE(lost_layers(plan, meshable_tissues(plan, 4.0)).empty());
}

TEST(MeshPlan, a_thin_shell_of_bone_joins_the_bone_in_it_and_not_the_muscle_around) {
  TissueVolume tissues = layered_block();
  // Bone 4 mm deep becomes 1 mm of cortical, 2 mm of cancellous, 1 mm of cortical bone: one family, thick as a whole.
  for (int k = 0; k < 100; ++k) {
    for (int j = 0; j < 60; ++j) {
      for (int i = 0; i < 100; ++i) {
        const double y = tissues.grid.to_patient(Vec3(i, j, k)).y();
        if (y < -21.0 && y > -23.0) tissues.at(i, j, k) = tissue::cancellous_bone;
      }
    }
  }
  MeshSettings settings;
  settings.preserve_layers = false;
  settings.corridor_radius = 15.0;
  const MeshableTissues merged = meshable_tissues(plan_mesh(tissues, straight_in, settings), 1.5);
  for (const double y : {-20.5, -21.5, -22.5, -23.5}) {
    const TissueId found = nearest(merged.tissues, Vec3(0, y, 0), tissue::air);
    EXPECT_TRUE(found == tissue::cortical_bone || found == tissue::cancellous_bone) << y;
    EXPECT_EQ(found, nearest(merged.tissues, Vec3(0, -20.5, 0), tissue::air));
  }
  EXPECT_EQ(nearest(merged.tissues, Vec3(0, -19.5, 0), tissue::air), tissue::muscle);
  EXPECT_EQ(nearest(merged.tissues, Vec3(0, -24.5, 0), tissue::air), tissue::muscle);
}

TEST(MeshPlan, what_hangs_apart_from_the_body_is_dropped) {
  TissueVolume tissues = layered_block();
  for (int k = 40; k < 60; ++k) {
    for (int j = 66; j < 78; ++j) {
      for (int i = 40; i < 60; ++i) tissues.at(i, j, k) = tissue::muscle;  // a hand above the skin
    }
  }
  MeshSettings settings;
  const MeshableTissues left = meshable_tissues(plan_mesh(tissues, straight_in, settings), 1.0);
  EXPECT_EQ(left.dropped, 20U * 12U * 20U);
  EXPECT_EQ(nearest(left.tissues, Vec3(0, 12, 0), tissue::air), tissue::air);
}

TEST(MeshPlan, half_the_edges_mean_eight_times_the_nodes) {
  const MeshPlan plan = plan_mesh(layered_block(), straight_in, {});
  MeshableTissues meshable = meshable_tissues(plan, 1.0);
  const double nodes = expected_nodes(meshable);
  for (float& edge : meshable.edges) edge *= 0.5F;
  EXPECT_NEAR(expected_nodes(meshable) / nodes, 8.0, 1e-9);
}

TEST(MeshPlan, a_path_far_from_the_body_is_refused) {
  const NeedlePath astray{Vec3(900, 0, 0), Vec3(900, -40, 0)};
  try {
    plan_mesh(layered_block(), astray, {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("no tissue within 85 mm of the planned path"));
  }
}

}  // namespace
}  // namespace bodkin
