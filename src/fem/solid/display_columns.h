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

// Bytes that display_columns() takes for so many points and nodes; temporary memory is at most an eighth of it
// for bodies with no more nodes than points.
std::size_t display_bytes(std::size_t points, std::size_t nodes) noexcept;

// How visible points (of skin, of organs, of the grid by which CT and ultrasound are warped) move by forces on nodes
// of the corridor: K^-1 of the whole body, as in the tick, taken at the points. `nodes`: as the mesh calls them,
// those whose columns are wanted (along the needle's path through the displayed region); forces on others move
// nothing. The field knows nodes by their names in the mesh. `left`: needles in the same body, which hold the tissue
// as they do in the tick. `spare`: nodes for which the field has room besides. The body must have been factorised
// with keep_field. Throws InputError when there are no points or nodes, when a node is not of the corridor, or when
// the columns do not fit into the memory that is left.
DisplayField display_columns(const ElasticBody& body, std::span<const PointInMesh> points,
                             const std::vector<std::uint32_t>& nodes, const Progress& progress = {},
                             const LeftNeedleForces& left = {}, std::size_t spare = 0);

}  // namespace bodkin::fem
