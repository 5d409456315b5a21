#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/progress.h"
#include "fem/display_field.h"
#include "fem/solid/elastic_body.h"
#include "fem/solid/left_needle_forces.h"
#include "fem/solid/points_in_mesh.h"

namespace bodkin::fem {

// Bytes of display_columns() for these numbers of points and nodes; temporary memory is at most an eighth of that for
// bodies with no more nodes than points.
std::size_t display_bytes(std::size_t points, std::size_t nodes) noexcept;

// Displacements of visible points (of skin, of organs, of the grid by which CT and ultrasound are warped) by forces
// on nodes of the corridor: K^-1 of the whole body, as in the tick, evaluated at the points. `nodes`: indices in the
// mesh of the nodes whose columns are wanted (along the needle's path through the displayed region); forces on other
// nodes are ignored. The field uses the mesh's node indices. `left`: needles in the same body, which hold the tissue
// as they do in the tick. `spare`: number of further nodes that the field has room for. The body must have been
// factorised with keep_field. Throws InputError when there are no points or nodes, when a node is not in the
// corridor, or when the columns do not fit into the available memory.
DisplayField display_columns(const ElasticBody& body, std::span<const PointInMesh> points,
                             const std::vector<std::uint32_t>& nodes, const Progress& progress = {},
                             const LeftNeedleForces& left = {}, std::size_t spare = 0);

}  // namespace bodkin::fem
