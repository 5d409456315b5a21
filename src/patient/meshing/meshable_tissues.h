#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "patient/meshing/mesh_plan.h"

#include "anatomy/volume.h"

namespace bodkin::patient {

// Tissues that can be meshed, and how finely.
struct MeshableTissues {
  anatomy::TissueVolume tissues;                   // on the plan's lattice
  std::vector<float> edges;                        // mm, one per voxel, scaled
  std::array<std::size_t, 256> before{}, after{};  // voxels by tissue, in the plan and here
  std::size_t dropped = 0;  // voxels that became air: in no thick part, or in no touch with the largest part
};

// The plan's tissues as they can be meshed with its edges times `scale`, and its held edges as they are. Parts of a
// tissue that are thinner than 0.8 border edges are merged, in two steps: families of tissues first (bone; ligaments;
// what is in the spinal canal; skin and fat; every other tissue is a family of its own), of which thin parts go to
// the adjacent family; then the tissues of a family, of which thin parts go to the nearest thick one of the same
// family. Where a part of a family has no thick tissue at all, it becomes what most of it is. Only the largest
// connected part of the body stays. Edges grow away from the borders that are left.
MeshableTissues meshable_tissues(const MeshPlan& plan, double scale);

// The layers of the planned path in whose middle is another tissue than in the volume.
std::vector<PathLayer> lost_layers(const MeshPlan& plan, const MeshableTissues& meshable);

// The number of nodes that a mesh of them is expected to have.
double expected_nodes(const MeshableTissues& meshable);

}  // namespace bodkin::patient
