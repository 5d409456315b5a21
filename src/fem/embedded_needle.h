#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "anatomy/condensed_body.h"
#include "anatomy/force_settings.h"
#include "core/geometry.h"
#include "fem/contact_tissues.h"
#include "fem/insertion_stations.h"
#include "fem/node_forces.h"
#include "fem/shaft_constraints.h"

namespace bodkin {

// A tissue that gave way.
struct TissuePuncture {
  TissueId tissue = tissue::air;
  double depth = 0.0;  // mm, tip beyond the entry, along the line
  double force = 0.0;  // N along the needle
};

// What a needle and a deformable body did to each other in one tick.
struct EmbeddedNeedleForce {
  Wrench on_hand;                      // about the tip
  double resistance = 0.0;             // N, along the line, positive pushes the hand out
  double tip_force = 0.0;              // N of the resistance, by the tissue in front of the tip
  Vec3 tip_deflection = Vec3::Zero();  // mm, LPS: of a needle that bends, its tip from where the pose has it
  std::uint32_t nodes = 0;             // that the shaft holds
  std::uint32_t sticking = 0;          // of them, those that do not slide
  std::optional<TissuePuncture> puncture;
  bool full = false;    // a node was not taken for want of room: the shaft beyond holds no tissue
  bool beyond = false;  // the tip is further in than the corridor reaches: its force is that of the nodes before
  bool fault = false;   // the pose is not one of a needle in a hand: zero force, state unchanged
};

// How far a needle is on its way into another corridor.
enum class FollowState : std::uint8_t { under_way, done, impossible };

// A straight needle in a deformable body (CondensedBody), its shaft as many constrained nodes. It is rigid, or bends
// as a beam (NeedleBeam).
//
//   S f = u                             all nodes at once, exactly (ShaftConstraints)
//   across the needle   u_i = offset of the needle's axis from the line at depth_i - what it was when i was taken
//                             + w_i, what bends the needle there: by -f and nothing else; 0 of a rigid one
//   along, sticking     u_i = s - z_i                      while |f_i| <= mu_t l_i
//   along, sliding      f_i = +-mu_t l_i                   while z_i moves in the sense of the force
//   before the tip      u_i = s - depth_i, f_i >= 0        until f_i = F_p: puncture
//
// A bevelled needle cuts its hole `cut_offset` beside its axis, towards its point, which is the side of -y of its
// pose (as BevelTip's; it cuts straight when y is no unit vector), and so bends there. The energy of it comes from
// the friction of the shaft: never more than that has taken. A hand that pushes a bent needle deeper bends it more
// sharply, and is pushed back for it.
//
//   s depth of the tip along the frozen line, mm; z_i slip, where on the needle node i sits, mm; l_i the length of
//   shaft in node i's part of the line; mu_t, F_p ContactTissue.
//
// Forces are continuous but for punctures, and even there: F_p becomes a friction that goes to zero within
// puncture_time. A node that the tip has just reached is held softly across the needle, the more firmly the further
// the tip is beyond it, and let go likewise. Nothing gives energy: every law is elastic, a friction, or a softness
// that grows at constant displacement and shrinks at constant force. Small displacements: depths and lengths are
// those at rest. Scheme, readings and proofs: docs/fem-contact.md, docs/flexible-needle.md.
//
// The state is reset by begin(); punctured nodes are remembered until reset(). Each call does the same for the same
// calls before it, to the bit. Memory is taken at construction; nothing else throws, allocates, locks or reads a
// clock.
class EmbeddedNeedle {
 public:
  // `body` is kept by reference and must outlive this. Throws InputError for settings or tissues out of range, or a
  // body whose arrays do not fit together. `dt`: s, 1e-6 to 0.1. `beam`: none for a rigid needle; the settings' own
  // `bending` says how a case's needle becomes one, and is not read here, nor is their `body`.
  EmbeddedNeedle(const CondensedBody& body, const ContactTissues& tissues, const EmbeddedNeedleSettings& settings,
                 double dt, const std::optional<NeedleBeam>& beam = {});

  // The needle touches the body at `entry` and goes along the unit vector `direction` (LPS).
  void begin(const Vec3& entry, const Vec3& direction) noexcept;
  // One tick. Before the first begin() nothing touches. `pressed`: mm, >= 0, along the line, by which the hub is
  // nearer to the body than the needle's length allows, its tip standing on what does not give way; of a needle that
  // bends there is so much less outside.
  const EmbeddedNeedleForce& step(const Pose& needle, double pressed = 0.0) noexcept;
  // As constructed: no contact, nothing punctured.
  void reset() noexcept;
  // Adds the punctures of a needle in another corridor of the same mesh: a mesh node is punctured in both corridors.
  void take_punctures(const EmbeddedNeedle& other) noexcept;

  // Transfers an inserted needle from `other`, which has the same settings and is in another corridor of the same
  // mesh, to this corridor without a force jump (docs/corotational.md).
  // Call begin_to_follow() once. It returns false if `other` holds no node, or a node that this corridor lacks.
  // Then call follow() after every step() of `other` until it returns done or impossible (`other` has left the
  // tissue, or has reached a node that this corridor lacks). Each call adds one node, and the last call copies the
  // state, so a tick's cost is bounded. Until then this needle touches nothing; afterwards it holds the same nodes
  // with the same forces, and these change with its motion by this corridor's compliance. Nodes ahead of the tip lie
  // where this corridor has them.
  bool begin_to_follow(const EmbeddedNeedle& other) noexcept;
  FollowState follow(const EmbeddedNeedle& other) noexcept;

  // Forces of the last tick, by node.
  const NodeForces& node_forces() const noexcept { return published_; }
  // Whether it holds a node, or its tip is beyond the entry of an insertion that has begun, as of the last tick.
  bool touches() const noexcept { return begun_ && (held_ > 0 || tip_ > 0.0); }
  // Whether it holds a node.
  bool holds() const noexcept { return begun_ && held_ > 0; }
  // Elastic energy by these forces, N mm, in the body, the needle and what is soft. Goes through all pairs of nodes.
  double stored_energy() const noexcept;
  // mm, LPS: how far the shaft of a needle that bends is from the straight needle of the pose, at a point `from_tip`
  // mm before its tip, 0 to its length. As of the last tick.
  Vec3 shaft_deflection(double from_tip) const noexcept;

 private:
  struct Hold {
    double slip = 0.0;                                 // z, mm; before the tip: where the tip meets it
    double sense = 1.0;                                // of sliding, -1 or 1
    double tear = 0.0;                                 // N, what a puncture has left
    double limit = 0.0;                                // N, this tick
    double moved = 0.0;                                // mm, u along the needle
    Eigen::Vector2d anchor = Eigen::Vector2d::Zero();  // mm, across
    double softness = -1.0;                            // mm/N, across; negative: not held
    double compliance = 0.0;                           // mm/N across, by its own force
    double whole = 1.0;                                // mm from its depth on, to where it is held firmly
    double cut = 0.0;                                  // part of cut_offset by which its hole is aside
    Eigen::Vector2d aside = Eigen::Vector2d::Zero();   // mm, what was added to that in this tick
  };

  std::span<const InsertionStation> line() const noexcept { return stations_.along(); }
  Eigen::Vector2d axis_offset(double depth) const noexcept { return offset_ + slope_ * (depth - tip_); }
  Eigen::Vector2d bent(double from_hub) const noexcept;
  Eigen::Vector2d shaft_offset(double depth) const noexcept {
    return axis_offset(depth) + bent(root_.outside + depth);
  }
  bool blocked() const noexcept;
  void let_go() noexcept;
  void capture() noexcept;
  void face_next(double moved) noexcept;
  void face_ahead() noexcept;
  bool take(std::size_t index) noexcept;
  void grip() noexcept;
  void soften(double softness) noexcept;
  void cut_aside(double advance) noexcept;
  void settle() noexcept;
  void place() noexcept;
  void solve() noexcept;
  bool stick_where_slip_turned(bool last_round) noexcept;
  bool slip_where_friction_ends(std::size_t& budget) noexcept;
  bool meet_tip() noexcept;
  void puncture() noexcept;
  void report() noexcept;
  bool take_line_of(const EmbeddedNeedle& other) noexcept;
  void take_sticking_of(const EmbeddedNeedle& other) noexcept;
  bool take_state_of(const EmbeddedNeedle& other) noexcept;
  Vec3 displacement(std::size_t index) const noexcept {
    return constraints_.compliance().displacement(index, forces_);
  }

  const CondensedBody& body_;
  ContactTissues tissues_;
  EmbeddedNeedleSettings settings_;
  double dt_;
  std::optional<NeedleBeam> beam_;
  InsertionStations stations_;
  ShaftConstraints constraints_;
  std::vector<Hold> holds_;              // most_nodes + 1: the shaft's nodes and the one before the tip
  std::vector<double> displacements_;    // 3 x (most_nodes + 1), mm: along, across, across
  std::vector<double> forces_;           // likewise, N on the tissue
  std::vector<std::uint8_t> punctured_;  // by node of the corridor
  std::vector<std::pair<std::uint32_t, std::uint32_t>> names_;  // of the nodes in the mesh, ascending, and the nodes
  std::size_t held_ = 0;
  bool begun_ = false, fresh_ = true;
  Vec3 entry_ = Vec3::Zero();
  Mat3 frame_ = Mat3::Identity();  // columns: along the line, across, across
  double tip_ = 0.0;               // s, mm
  Eigen::Vector2d offset_ = Eigen::Vector2d::Zero(), slope_ = Eigen::Vector2d::Zero();
  ShaftRoot root_;
  Eigen::Vector2d turn_ = Eigen::Vector2d::Zero();  // rad, of a pinned hub from the pose
  Eigen::Vector2d side_ = Eigen::Vector2d::Zero();  // where the point of a bevel is, across
  double spare_ = 0.0;                              // N mm that friction took and the bevel has not used
  EmbeddedNeedleForce force_;
  NodeForces published_;
};

}  // namespace bodkin
