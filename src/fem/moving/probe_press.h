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
  // mm; a node that is further behind the face than this is not pressed: it is on the other side of the body, or the
  // probe was moved there at once. 1 to 100.
  double reach = 20.0;
};

// Which nodes of a body's surface a probe presses on. A node that the face meets is taken along with it, where it was
// met, as on dry skin; gel, on which skin slides, is not modelled. The face pushes and cannot pull: what would be
// pulled is let go, and may be met again. Only nodes are met: a mesh that is coarser than the face is pressed by few
// nodes or none. Memory is taken at construction; nothing else throws or allocates.
class ProbePress {
 public:
  // `mesh` and `fixed` as of the body that will be pressed. Throws InputError for a face out of range.
  ProbePress(const anatomy::TetrahedralMesh& mesh, std::span<const std::uint32_t> fixed, const ProbeFace& face);

  // Before a step of the body: takes what the face meets and moves what it has. A pose that is not finite, or not
  // that of a rigid body, is as none.
  void press(const Pose& probe, CorotationalBody& body) noexcept;
  // Without a probe: lets everything go.
  void lift(CorotationalBody& body) noexcept;
  // After a step: lets go what the probe would have to pull.
  void let_go_what_is_pulled(CorotationalBody& body) noexcept;

  // How many nodes are held, and by what force on the probe, N, and torque about its origin, N mm, after a step.
  std::size_t held() const noexcept { return held_; }
  Wrench on_probe(const CorotationalBody& body) const noexcept;
  // The same of a wrench about the middle of the nodes held, where they are now; zero where none is.
  Wrench from_middle(const Wrench& wrench, const CorotationalBody& body) const noexcept;
  // The nodes held, ascending, of which the first held() are written; `nodes` has room for surface().
  void held_nodes(std::span<std::uint32_t> nodes) const noexcept;
  // Whether exactly these are held.
  bool holds(std::span<const std::uint32_t> nodes) const noexcept;
  // Nodes of the mesh's surface that are not fixed, ascending.
  std::span<const std::uint32_t> surface() const noexcept { return surface_; }

 private:
  double height_of_face(double along) const noexcept;
  Vec3 outward(double along) const noexcept;

  ProbeFace face_;
  std::vector<std::uint32_t> surface_;
  std::vector<Vec3> held_at_;        // by place in surface_, in the frame of the probe
  std::vector<std::uint8_t> taken_;  // by place in surface_: held by the probe
  std::size_t held_ = 0;
  Pose probe_ = Pose::Identity();
};

}  // namespace bodkin::fem
