#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "anatomy/case.h"
#include "core/progress.h"
#include "fem/display_field.h"
#include "fem/solid/elastic_body.h"

namespace bodkin::station {

// The nodes of the corridor that a needle within `around` mm of `path` can hold, as the mesh calls them: one at
// least, the nearest first, `most` at most.
std::vector<std::uint32_t> nodes_of_shaft(const fem::ElasticBody& elastic, const anatomy::TetrahedralMesh& mesh,
                                          const anatomy::NeedlePath& path, double around = 4.0,
                                          std::size_t most = 600);

// How the nodes of a mesh move by the forces of a needle, for displays of changing regions: what moves
// between nodes is linear in them (SliceField).
class NodeField {
 public:
  // Precomputes the columns of the nodes that can be seen, those within 90 mm of the path, the nearest first and as
  // many as 512 MB hold, under forces within 15 mm of it; the rest stands still. `elastic`: the body's, with its
  // whole factor. Throws InputError when the columns do not fit into memory.
  NodeField(const fem::ElasticBody& elastic, const fem::BodyDescription& body, const anatomy::NeedlePath& path,
            const Progress& progress = {});

  std::size_t mesh_nodes() const noexcept { return mesh_nodes_; }
  // mm, of every node of the mesh, 3 x mesh_nodes() values, which the next call overwrites.
  std::span<const float> evaluate(const fem::NodeForces& forces) noexcept;
  // N of these forces that the field does not show.
  double left_out(const fem::NodeForces& forces) const noexcept { return field_.left_out(forces); }

 private:
  NodeField(const fem::ElasticBody& elastic, const fem::BodyDescription& body, const anatomy::NeedlePath& path,
            const std::vector<std::uint32_t>& held, const Progress& progress);

  std::size_t mesh_nodes_;
  std::vector<std::uint32_t> seen_;  // as the mesh calls them
  fem::DisplayField field_;          // at these
  std::vector<float> moved_, of_mesh_;
};

}  // namespace bodkin::station
