#pragma once

#include <span>
#include <string>

#include "io/mesh/foreign_mesh.h"

namespace bodkin::io {

// Assembles a foreign mesh from a reader's findings, and rejects invalid ones. `where` is the prefix of every
// message: "mesh.msh, line 12".
class MeshBuilder {
 public:
  void add_node(const Vec3& point, const std::string& where);
  // Corners are positions among the nodes added; `name` is the element's name in the file.
  void add_element(const std::array<std::uint32_t, 4>& corners, std::int64_t region, const std::string& name,
                   const std::string& where);
  std::size_t node_count() const { return mesh_.nodes.size(); }
  ForeignMesh& mesh() { return mesh_; }
  // Drops unused nodes, with a note. Throws InputError when there are no elements.
  ForeignMesh finish(const std::string& origin);

 private:
  ForeignMesh mesh_;
};

}  // namespace bodkin::io
