#pragma once

#include <span>
#include <string>

#include "io/mesh/foreign_mesh.h"

namespace bodkin::io {

// Puts a foreign mesh together from what a reader finds, and refuses what no mesh can be. `where` begins every
// message: "mesh.msh, line 12".
class MeshBuilder {
 public:
  void add_node(const Vec3& point, const std::string& where);
  // Corners are positions among the nodes added; `name` is what the file calls the element.
  void add_element(const std::array<std::uint32_t, 4>& corners, std::int64_t region, const std::string& name,
                   const std::string& where);
  std::size_t node_count() const { return mesh_.nodes.size(); }
  ForeignMesh& mesh() { return mesh_; }
  // Drops nodes that no element uses, with a note. Throws InputError when there are no elements.
  ForeignMesh finish(const std::string& origin);

 private:
  ForeignMesh mesh_;
};

}  // namespace bodkin::io
