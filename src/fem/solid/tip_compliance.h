#pragma once

#include <vector>

#include "core/geometry.h"
#include "fem/solid/elastic_material.h"
#include "fem/solid/mesh_patch.h"
#include "fem/solid/points_in_mesh.h"

namespace bodkin::fem {

// The disk over which a needle's tip pushes: across the needle, its force distributed evenly.
struct TipDisk {
  Vec3 centre = Vec3::Zero();   // mm, LPS
  Vec3 normal = Vec3::UnitZ();  // along the needle, unit vector
  double radius = 1.0;          // mm, above 0
};

// Points of a mesh, distributed evenly over the disk, which carry a force on it in equal shares. Points of the disk
// farther than `reach` mm outside the mesh do not move.
std::vector<PointInMesh> places_of(const TipDisk& disk, const PointFinder& finder, double reach = 5.0);

// mm/N, 3 x 3, symmetric, and positive semidefinite if displacements are linear: the compliance of the disk that its
// mesh lacks; near a force the mesh is too stiff by about the ratio of its elements' size to the disk's. The elements
// within two edges of the disk are cut into eight repeatedly, with the border of this patch held, until their edge is
// below one radius; each time the compliance gained is added. Then displacements in the patch become quadratic where
// they are not, and a quarter of the gain is added for a still finer mesh; where they were quadratic already, a third
// of the last gain is added. `finder`: of the mesh. Zero in a mesh that is already fine enough: edges below one
// radius where displacements are quadratic, below 0.35 elsewhere.
Mat3 refinement_gain(const MeshView& whole, const PointFinder& finder, const ElasticMaterials& materials,
                     const TipDisk& disk);

// mm^2/N, 3 x 3: a force distributed evenly over a ball in an infinite material moves the ball, on average, by this
// times 6 / (5 radius). Without fibres it is Kelvin's solution, (3 - 4 nu + 1/3) / (16 pi G (1 - nu)) in every
// direction; in general the mean of the inverse Christoffel tensors of all directions by 4 pi.
Mat3 ball_compliance(const ElasticMaterial& material) noexcept;

// mm/N, 3 x 3: the compliance of a point on a needle's shaft that a single barycentric point of an element with this
// edge (mm) lacks: that of a ball of `radius` mm, less that of a barycentric point, which is about that of a ball of
// 0.6 edges. At least a hundredth of the latter, so that any number of points may lie in one element and the
// equations stay regular.
Mat3 shaft_gain(const ElasticMaterial& material, double edge, double radius) noexcept;

}  // namespace bodkin::fem
