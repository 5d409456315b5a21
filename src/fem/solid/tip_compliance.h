#pragma once

#include <vector>

#include "core/geometry.h"
#include "fem/solid/elastic_material.h"
#include "fem/solid/mesh_patch.h"
#include "fem/solid/points_in_mesh.h"

namespace bodkin::fem {

// The disk over which a needle's tip pushes: across the needle, its force spread evenly.
struct TipDisk {
  Vec3 centre = Vec3::Zero();   // mm, LPS
  Vec3 normal = Vec3::UnitZ();  // along the needle, unit vector
  double radius = 1.0;          // mm, above 0
};

// Places of a mesh, spread evenly over the disk, which carry a force on it in equal shares. Where the disk is farther
// than `reach` mm outside the mesh they do not move.
std::vector<PointInMesh> places_of(const TipDisk& disk, const PointFinder& finder, double reach = 5.0);

// mm/N, 3 x 3, symmetric, and positive semidefinite where displacements are linear: by how much more the disk moves
// by a force on it than its mesh says, which near a force is too stiff by about as much as its elements are larger
// than the disk. The elements within two edges of the disk are cut into eight again and again, with the border of
// this patch held, until their edge is below one radius; each time the compliance gained is added. Then displacements
// in the patch become quadratic where they are not, and a quarter of what that gains is added for what a still finer
// mesh would; where they were quadratic already, a third of the last gain is. `finder`: of the mesh. Zero in a mesh
// that is as fine already: edges below one radius where displacements are quadratic, below 0.35 elsewhere.
Mat3 refinement_gain(const MeshView& whole, const PointFinder& finder, const ElasticMaterials& materials,
                     const TipDisk& disk);

// mm^2/N, 3 x 3: a force that is spread evenly over a ball in a material as far as the eye can see moves the ball, on
// average, by this times 6 / (5 radius). Without fibres it is Kelvin's solution, (3 - 4 nu + 1/3) / (16 pi G (1 -
// nu)) in every direction; in general the mean of the inverse Christoffel tensors of all directions by 4 pi.
Mat3 ball_compliance(const ElasticMaterial& material) noexcept;

// mm/N, 3 x 3: by how much more a point on a needle's shaft moves than a single barycentric point of an element with
// this edge (mm) says: a ball of `radius` mm, less what a barycentric point is about as soft as, a ball of 0.6 edges.
// At least a hundredth of the latter, so that any number of points may lie in one element and the equations stay
// regular.
Mat3 shaft_gain(const ElasticMaterial& material, double edge, double radius) noexcept;

}  // namespace bodkin::fem
