#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "anatomy/case.h"
#include "core/progress.h"
#include "fem/display_field.h"
#include "fem/growing_field.h"
#include "fem/solid/contact_body.h"
#include "fem/solid/elastic_body.h"
#include "fem/solid/left_needle_forces.h"
#include "fem/solid/points_in_mesh.h"

namespace bodkin::station {

// The free nodes about a path, one at least, that a picture of the body can know the forces on: the corridor that its
// description needs.
std::vector<std::uint32_t> nodes_of_picture(const fem::BodyDescription& body, const anatomy::NeedlePath& path);

// The body that the needle feels, for its picture: with its whole factor, and with the corridor of `body` or, where
// the needle meets contact points (`whole`, else null), nodes_of_picture(). Throws InputError as ElasticBody does.
fem::ElasticBody body_of_picture(const fem::BodyDescription& body, const fem::ContactBody* whole,
                                 const anatomy::NeedlePath& path, const Progress& progress);

// The nodes of the corridor that a needle within `around` mm of `path` can hold, as the mesh calls them: one at
// least, the nearest first, `most` at most.
std::vector<std::uint32_t> nodes_of_shaft(const fem::ElasticBody& elastic, const anatomy::TetrahedralMesh& mesh,
                                          const anatomy::NeedlePath& path, double around = 4.0,
                                          std::size_t most = 600);

// A node of a mesh as a point in it.
fem::PointInMesh place_of_node(std::uint32_t node);

// A field at `points` that computes the columns of other nodes in its spare places: `whole`, null: no others. The
// last of the points are the nodes `node_points`, which can be held.
std::unique_ptr<fem::GrowingField> growing_field(fem::DisplayField field,
                                                 std::shared_ptr<const fem::ContactBody> whole,
                                                 std::vector<fem::PointInMesh> points,
                                                 const fem::LeftNeedleForces& left,
                                                 std::span<const std::uint32_t> node_points);

// How the nodes of a mesh move by the forces of a needle, for displays of changing regions: what moves
// between nodes is linear in them (SliceField).
class NodeField {
 public:
  // Precomputes the columns of the nodes that can be seen, those within 90 mm of the path, the nearest first and as
  // many as 512 MB hold, under forces within 15 mm of it; the rest stands still. `elastic`: the body's, with its
  // whole factor; `left`: needles in the body, which hold the tissue. `whole`, of a needle that goes anywhere: what
  // it does farther from the path is computed when it is there (fem::GrowingField). Throws InputError when the
  // columns do not fit into memory.
  NodeField(const fem::ElasticBody& elastic, const fem::BodyDescription& body, const anatomy::NeedlePath& path,
            const Progress& progress = {}, const fem::LeftNeedleForces& left = {},
            const std::shared_ptr<const fem::ContactBody>& whole = {});

  std::size_t mesh_nodes() const noexcept { return mesh_nodes_; }
  // Nodes that a probe holds from now on.
  void hold(std::span<const std::uint32_t> nodes) { field_->hold(nodes); }
  // mm, of every node of the mesh, 3 x mesh_nodes() values, which the next call overwrites.
  std::span<const float> evaluate(const fem::NodeForces& forces);
  // N of these forces that the field does not show.
  double left_out(const fem::NodeForces& forces) const noexcept { return field_->left_out(forces); }

 private:
  NodeField(const fem::ElasticBody& elastic, const fem::BodyDescription& body, const anatomy::NeedlePath& path,
            const std::vector<std::uint32_t>& pushed, const Progress& progress, const fem::LeftNeedleForces& left,
            std::shared_ptr<const fem::ContactBody> whole);

  std::size_t mesh_nodes_;
  std::vector<std::uint32_t> seen_;           // as the mesh calls them
  std::unique_ptr<fem::GrowingField> field_;  // at these
  std::vector<float> moved_, of_mesh_;
};

}  // namespace bodkin::station
