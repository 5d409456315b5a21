#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "patient/meshing/mesh_plan.h"

#include "anatomy/volume.h"

namespace bodkin::patient {

// Tissues that can be meshed, and the desired edges.
struct MeshableTissues {
  anatomy::TissueVolume tissues;                   // on the plan's lattice
  std::vector<float> edges;                        // mm, one per voxel, scaled
  std::array<std::size_t, 256> before{}, after{};  // voxels by tissue, in the plan and here
  std::size_t dropped = 0;  // voxels that became air: in no thick part, or not connected to the largest part
};

// The plan's tissues in a form that can be meshed with its edges times `scale`, and its held edges unscaled. Parts of
// a tissue thinner than 0.8 border edges are merged, in two steps: families of tissues first (bone; ligaments;
// contents of the spinal canal; skin and fat; every other tissue is a family of its own), of which thin parts become
// the adjacent family; then the tissues of a family, of which thin parts become the nearest thick one of the same
// family. A part of a family without any thick tissue becomes its most frequent tissue. Only the largest connected
// part of the body stays. Edges grow away from the remaining borders.
MeshableTissues meshable_tissues(const MeshPlan& plan, double scale);

// The layers of the planned path whose middle has another tissue than in the volume.
std::vector<PathLayer> lost_layers(const MeshPlan& plan, const MeshableTissues& meshable);

// The expected number of nodes of a mesh of these tissues.
double expected_nodes(const MeshableTissues& meshable);

}  // namespace bodkin::patient
