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

// The free nodes about a path, at least one, on which a display of the body can represent forces: the corridor of its
// description.
std::vector<std::uint32_t> nodes_of_picture(const fem::BodyDescription& body, const anatomy::NeedlePath& path);

// The body of the needle, for its display: with its whole factor, and with the corridor of `body` or, for a needle
// with contact points (`whole`, else null), nodes_of_picture(). Throws InputError as ElasticBody does.
fem::ElasticBody body_of_picture(const fem::BodyDescription& body, const fem::ContactBody* whole,
                                 const anatomy::NeedlePath& path, const Progress& progress);

// The nodes of the corridor that a needle within `around` mm of `path` can hold, by their index in the mesh: at least
// one, the nearest first, at most `most`.
std::vector<std::uint32_t> nodes_of_shaft(const fem::ElasticBody& elastic, const anatomy::TetrahedralMesh& mesh,
                                          const anatomy::NeedlePath& path, double around = 4.0,
                                          std::size_t most = 600);

// A node of a mesh as a point in it.
fem::PointInMesh place_of_node(std::uint32_t node);

// A field at `points` that computes the columns of other nodes in its spare places; `whole` null: of no others. The
// last of the points are the nodes `node_points`, which can be held.
std::unique_ptr<fem::GrowingField> growing_field(fem::DisplayField field,
                                                 std::shared_ptr<const fem::ContactBody> whole,
                                                 std::vector<fem::PointInMesh> points,
                                                 const fem::LeftNeedleForces& left,
                                                 std::span<const std::uint32_t> node_points);

// The displacements of a mesh's nodes by the forces of a needle, for displays of changing regions: between nodes they
// are linear (SliceField).
class NodeField {
 public:
  // Precomputes the columns of the visible nodes, those within 90 mm of the path, nearest first and as many as fit
  // into 512 MB, under forces within 15 mm of it; the others do not move. `elastic`: the body's, with its whole
  // factor; `left`: needles in the body, which hold the tissue. `whole`, for a needle that may enter anywhere: its
  // effect farther from the path is computed on demand (fem::GrowingField). Throws InputError when the columns do not
  // fit into memory.
  NodeField(const fem::ElasticBody& elastic, const fem::BodyDescription& body, const anatomy::NeedlePath& path,
            const Progress& progress = {}, const fem::LeftNeedleForces& left = {},
            const std::shared_ptr<const fem::ContactBody>& whole = {});

  std::size_t mesh_nodes() const noexcept { return mesh_nodes_; }
  // Sets the nodes that a probe holds from now on.
  void hold(std::span<const std::uint32_t> nodes) { field_->hold(nodes); }
  // mm, of every node of the mesh, 3 x mesh_nodes() values, which the next call overwrites.
  std::span<const float> evaluate(const fem::NodeForces& forces);
  // N of these forces that the field omits.
  double left_out(const fem::NodeForces& forces) const noexcept { return field_->left_out(forces); }

 private:
  NodeField(const fem::ElasticBody& elastic, const fem::BodyDescription& body, const anatomy::NeedlePath& path,
            const std::vector<std::uint32_t>& pushed, const Progress& progress, const fem::LeftNeedleForces& left,
            std::shared_ptr<const fem::ContactBody> whole);

  std::size_t mesh_nodes_;
  std::vector<std::uint32_t> seen_;           // by their index in the mesh
  std::unique_ptr<fem::GrowingField> field_;  // at these nodes
  std::vector<float> moved_, of_mesh_;
};

}  // namespace bodkin::station
