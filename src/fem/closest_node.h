#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "anatomy/condensed_body.h"
#include "anatomy/force_settings.h"
#include "core/geometry.h"
#include "fem/contact_numbers.h"
#include "fem/contact_tissues.h"
#include "fem/embedded_needle.h"
#include "fem/node_forces.h"

namespace bodkin::fem {

struct ClosestNodeForce {
  double resistance = 0.0;            // R, N, positive pushes the hand out
  double tip_force = 0.0;             // N of it, at the tip
  double friction = 0.0;              // N of it, along the shaft
  std::optional<std::uint32_t> node;  // i*, of the corridor
  std::optional<TissuePuncture> puncture;
  bool fault = false;  // the tip's position is invalid: zero force, state unchanged
};

// The deformable body of Sutherland et al. 2013, as in the paper: the tip pushes one node, the closest.
//
//   u = (P - X_i) - o;   f = c_i inverse(S_ii) u;   f_tip = max(0, f . d)
//   f_tip >= F_p: node i is punctured and the tip looks for the next;   R = f_tip + friction
//   c_i = k_target / (d . inverse(S_ii) d), or 1 for a tissue without a k_target
//
// P tip, X_i node at rest, d the frozen line, S compliance of the corridor. A node that is closer (by 10 %) takes
// over at the present force, by means of its offset o. Friction: a spring that slides at the sum of length times
// mu_t.
//
// Tissue behind a firmer one is not touched before the firmer one is punctured: a node of a softer tissue deeper
// along the line does not take over, and a layer without nodes is punctured with the first node behind it, at the
// layer's own F_p.
//
// c_i compensates for the size of the elements: a point load on a finer mesh meets less stiffness. A force that is
// carried from a stiff node to a soft one stores more energy than before (**active**, see docs/fem-contact.md). For
// the exact answer with all nodes of the shaft: EmbeddedNeedle. Memory is allocated by the constructor; no other
// function throws, allocates or locks.
class ClosestNodeContact {
 public:
  // `body` is kept by reference. Throws InputError for settings or tissues out of range. `dt`: s, 1e-6 to 0.1.
  ClosestNodeContact(const anatomy::CondensedBody& body, const ContactTissues& tissues,
                     const anatomy::ClosestNodeSettings& settings, double dt);

  static constexpr double layer_step = 0.25;  // mm between the tissues passed to begin()
  // The needle touches at `entry` and advances along the unit vector `direction`. Punctured nodes are remembered.
  // `line`: the tissues along the line from the entry, one every layer_step; a layer between two nodes is felt with
  // the second node. Empty: only the tissues of the nodes. Tissues beyond `longest` are not read.
  void begin(const Vec3& entry, const Vec3& direction, std::span<const anatomy::TissueId> line = {}) noexcept;
  ClosestNodeForce step(const Vec3& tip) noexcept;
  void reset() noexcept;
  // Capture radius, relaxation, presliding and tissues; the new ones apply from the next tick on. Ranges as for the
  // constructor.
  ContactNumbers numbers() const noexcept;
  void set_numbers(const ContactNumbers& numbers) noexcept;

  // The forces on the tissue, including a punctured node that returns to rest: at most 2 nodes, with forces on the
  // body of the mesh (that is, divided by c_i).
  NodeForces node_forces() const noexcept;
  // c_i of a node for the line of the last begin().
  double stiffness_scale(std::uint32_t node) const noexcept;

 private:
  static constexpr std::uint32_t none = 0xffffffff;

  std::uint32_t closest(const Vec3& place, double within, bool unpunctured) const noexcept;
  Mat3 own_compliance(std::uint32_t node) const noexcept;
  Vec3 push(const Vec3& tip) const noexcept;
  void follow(const Vec3& tip) noexcept;
  double shaft_limit(double depth) noexcept;
  void pass(double depth, anatomy::TissueId tissue) noexcept;
  anatomy::TissueId firmest_before(double depth) const noexcept;
  // Whether a deeper node has been punctured.
  bool is_passed(std::uint32_t node) const noexcept { return tissues_along_ > 0 && depth_of(node) < deepest_; }
  double depth_of(std::uint32_t node) const noexcept { return (body_.nodes[node] - entry_).dot(direction_); }

  const anatomy::CondensedBody& body_;
  ContactTissues tissues_;
  anatomy::ClosestNodeSettings settings_;
  double dt_;
  std::vector<std::uint8_t> punctured_;  // by node
  std::vector<anatomy::TissueId> line_;  // along the line, every layer_step; tissues_along_ of them
  std::size_t tissues_along_ = 0;
  double passed_ = 0.0;         // mm along the line, to which its layers are open
  double deepest_ = 0.0;        // mm, of the punctured nodes
  std::vector<double> limits_;  // N of friction from the entry to each layer's end
  std::size_t known_ = 0;       // layers
  bool begun_ = false, fresh_ = true;
  Vec3 entry_ = Vec3::Zero(), direction_ = Vec3::UnitZ();
  std::uint32_t node_ = none;   // i*
  Vec3 offset_ = Vec3::Zero();  // o, mm
  Vec3 force_ = Vec3::Zero();   // f, N
  double friction_ = 0.0, last_depth_ = 0.0;
  std::uint32_t relaxing_ = none;
  Vec3 relaxing_force_ = Vec3::Zero();  // N on the body of the mesh, at the puncture
  double relaxed_ = 0.0;                // 0 to 1
};

}  // namespace bodkin::fem
