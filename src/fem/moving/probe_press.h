#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry.h"
#include "fem/moving/corotational_body.h"

namespace bodkin::fem {

// The face of an ultrasound probe, rigid, in the probe's own frame: its middle is the origin, the third axis points
// out of the probe into the body, the first runs along the array. A linear array is flat; a convex one is a piece of
// a cylinder about the second axis, bent away from the body at its ends.
struct ProbeFace {
  double width = 40.0;      // mm, along the array; 1 to 200, and at most 1.9 times the radius
  double thickness = 12.0;  // mm, across it; 1 to 100
  double radius = 0.0;      // mm, 0: flat; else 5 to 500
  // mm; a node further behind the face than this is not pressed: it is on the other side of the body, or the probe
  // jumped there. 1 to 100.
  double reach = 20.0;
};

// Selects the nodes of a body's surface that a probe presses. A node that the face meets sticks to it where it was
// met, as on dry skin; gel, on which skin slides, is not modelled. The face pushes and cannot pull: a node under
// tension is released, and may be met again. Only nodes are met: a mesh coarser than the face is pressed at few nodes
// or none. Memory is allocated by the constructor; no other function throws or allocates.
class ProbePress {
 public:
  // `mesh` and `fixed` as of the body to be pressed. Throws InputError for a face out of range.
  ProbePress(const anatomy::TetrahedralMesh& mesh, std::span<const std::uint32_t> fixed, const ProbeFace& face);

  // Before a step of the body: captures the nodes that the face meets and moves those it holds. A pose that is not
  // finite or not rigid counts as none.
  void press(const Pose& probe, CorotationalBody& body) noexcept;
  // Without a probe: releases all nodes.
  void lift(CorotationalBody& body) noexcept;
  // After a step: releases the nodes that the probe would have to pull.
  void release_pulled_nodes(CorotationalBody& body) noexcept;

  // The number of nodes held, and the force on the probe, N, and its torque about the probe's origin, N mm, after a
  // step.
  std::size_t held() const noexcept { return held_; }
  Wrench on_probe(const CorotationalBody& body) const noexcept;
  // As above, for a wrench about the present middle of the held nodes; zero if there are none.
  Wrench from_middle(const Wrench& wrench, const CorotationalBody& body) const noexcept;
  // The held nodes, ascending; only the first held() are written; `nodes` has room for surface().
  void held_nodes(std::span<std::uint32_t> nodes) const noexcept;
  // Whether exactly these nodes are held.
  bool holds(std::span<const std::uint32_t> nodes) const noexcept;
  // Nodes of the mesh's surface that are not fixed, ascending.
  std::span<const std::uint32_t> surface() const noexcept { return surface_; }

 private:
  double height_of_face(double along) const noexcept;
  Vec3 outward(double along) const noexcept;

  ProbeFace face_;
  std::vector<std::uint32_t> surface_;
  std::vector<Vec3> held_at_;          // by place in surface_, in the frame of the probe
  std::vector<std::uint8_t> is_held_;  // by place in surface_: held by the probe
  std::size_t held_ = 0;
  Pose probe_ = Pose::Identity();
};

}  // namespace bodkin::fem
