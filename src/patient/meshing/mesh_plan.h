#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "anatomy/case.h"

namespace bodkin::patient {

// Settings for meshing a body. Lengths are mean edge lengths in mm before they are scaled to the number of nodes.
struct MeshSettings {
  std::int64_t nodes = 20000;     // desired number; 500 to 400000
  double fine = 2.0;              // mm, in the corridor and at tissue borders near it; 0.2 to 20
  double coarse = 10.0;           // mm, far from both; fine to 100
  double corridor_radius = 25.0;  // mm around the planned path; 1 to 200

  bool preserve_layers = true;  // finer where the planned path crosses a thin layer, whatever the scale for `nodes`
  bool stiff_skin = false;      // if layers are held: hold the skin as far around as it bends (has_stiff_skin)

  // [D] our choices, not offered on the command line.
  double corridor_beyond = 15.0;  // mm by which the corridor extends beyond the target
  double reach = 60.0;            // mm of body around the corridor that is meshed
};

// A layer of one tissue that the planned path crosses.
struct PathLayer {
  anatomy::TissueId tissue = anatomy::tissue::air;
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  // mm, on the path
  double depth = 0.0;                           // mm, of `from` below the entry
  Vec3 widest = Vec3::Zero();                   // on the path, at the largest width of the surrounding tissue
  double width = 0.0;                           // mm, of that tissue there; at most the thickness

  double thickness() const { return (to - from).norm(); }  // mm, along the path
  Vec3 middle() const { return 0.5 * (from + to); }
};

// The layers that a path crosses from its entry to `beyond` (mm) behind its target, in order; without air, without
// corners of voxels and without the last layer.
std::vector<PathLayer> layers_on(const anatomy::NeedlePath& path, double beyond,
                                 const anatomy::TissueVolume& tissues);

// The region and the resolution: the part of the tissue lattice that is meshed, with a layer of air around it, and
// the desired edges at each of its voxels for a scale of 1.
struct MeshPlan {
  anatomy::TissueVolume tissues;    // tissue ids; air and the outermost layer are 0, which is not meshed
  std::vector<float> border_edges;  // mm, at a border between tissues, if there is one at the voxel
  std::vector<float> inner_edges;   // mm, far from any border
  // mm, edges at each voxel that are not scaled up; empty: none (MeshSettings::preserve_layers).
  std::vector<float> preserving_edges;
  std::vector<PathLayer> layers;  // of the planned path
  bool boxed = false;             // the volume was larger than the meshed region
};

// Whether the skin is at least twice as stiff as fat, so that the mesh must contain it as far as it bends.
bool has_stiff_skin(const anatomy::TissueLibrary& library);

// The plan for a case's tissues. Throws InputError when there is no tissue within reach of the path.
MeshPlan plan_mesh(const anatomy::TissueVolume& tissues, const std::optional<anatomy::NeedlePath>& path,
                   const MeshSettings& settings);

// The part of a plan within 25 mm of the layers of its path, [D]: the voxels farther away do not decide how coarse a
// mesh may be that has elements of each layer, unless they cut the layer's tissue off from the body.
MeshPlan around_layers(const MeshPlan& plan);

// mm from `point` to the corridor: the cylinder around the path, from `corridor_radius` before the entry to
// `corridor_beyond` behind the target; 0 inside.
double distance_to_corridor(const Vec3& point, const anatomy::NeedlePath& path, const MeshSettings& settings);

}  // namespace bodkin::patient
