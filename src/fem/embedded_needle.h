#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "anatomy/condensed_body.h"
#include "anatomy/force_settings.h"
#include "core/geometry.h"
#include "fem/body_motion.h"
#include "fem/contact_nodes.h"
#include "fem/contact_numbers.h"
#include "fem/contact_tissues.h"
#include "fem/node_forces.h"
#include "fem/relaxing_tissue.h"
#include "fem/shaft_constraints.h"

namespace bodkin::fem {

// The needle has punctured a tissue.
struct TissuePuncture {
  anatomy::TissueId tissue = anatomy::tissue::air;
  double depth = 0.0;         // mm, of the tip below the entry, along the line
  double force = 0.0;         // N, along the needle
  Vec3 place = Vec3::Zero();  // mm, LPS, of the contact point, at rest
};

// The surface that the tip pushes while the first contact point is still being computed.
struct ProvisionalSurface {
  double compliance = 0.0;  // mm/N, along the needle; 0: no surface
  double strength = 0.0;    // N, the largest force on it
  bool is_missing = false;  // there is no contact point at all
};

// Relaxation of the tissue at the needle (RelaxingTissue): none without terms.
struct NeedleRelaxation {
  std::span<const anatomy::PronyTerm> terms = {};
  double spring = 0.0;  // mm/N, that the body's compliance contains for each pair of points, and that does not relax
};

// Result of one tick: the forces between a needle and a deformable body.
struct EmbeddedNeedleForce {
  Wrench on_hand;               // about the tip
  double resistance = 0.0;      // N, along the line, positive pushes the hand out
  double tip_force = 0.0;       // N, part of the resistance from the tissue in front of the tip
  double material_depth = 0.0;  // mm, at rest, of the tissue that the tip touches; no border beyond it is punctured
  double opened_depth = -1.0;   // mm, of the deepest punctured border on the shaft; negative: none
  anatomy::TissueId inside = anatomy::tissue::air;  // at the tip; air: unknown
  anatomy::TissueId pushed = anatomy::tissue::air;  // to be punctured before the tip can advance; air: none
  Vec3 tip_deflection = Vec3::Zero();  // mm, LPS, of a bending needle: from the tip of the pose to the needle's tip
  std::uint32_t nodes = 0;             // contact points on the shaft
  std::uint32_t sticking = 0;          // number of sticking contact points
  std::optional<TissuePuncture> puncture;
  bool full = false;    // capacity reached: the shaft beyond the last contact point has no contact
  bool beyond = false;  // the tip is deeper than the last contact point; only the existing points exert forces
  bool fault = false;   // the pose is invalid for an inserted needle: zero force, state unchanged
};

// A straight needle in a deformable body (CondensedBody), whose shaft is represented by the contact points of its
// line, called nodes below. It is rigid, or bends as a beam (NeedleBeam).
//
//   S f = u                    for all nodes at once, exactly (ShaftConstraints)
//   across the needle          u_i = offset of the needle's axis from the line at depth_i, less its value when node i
//                                    was captured, + w_i; w_i: bending of the needle there by -f, 0 if it is rigid
//   along, sticking            u_i = s - z_i                      while |f_i| <= mu_t l_i
//   along, sliding             f_i = +-mu_t l_i                   while z_i moves in the direction of the force
//   node in front of the tip   u_i = s - depth_i, f_i >= 0        until f_i = F_p: puncture
//   cutting                    f_n <= mu_t l_n + F_c inwards at the last node, where the tip is at its deepest
//
// A bevelled needle cuts its hole `cut_offset` to one side of its axis, towards its point. This is the side of -y of
// its pose, as for BevelTip; without a unit vector y it cuts straight. The needle bends to follow the hole. The
// energy for bending is taken from the friction of the shaft, never more than friction has dissipated. Pushing a bent
// needle deeper bends it more sharply, and the hand feels the force of that.
//
//   s depth of the tip along the frozen line, mm; z_i slip, the position of node i on the needle, mm; l_i the length
//   of shaft in node i's part of the line; mu_t, F_p, F_c see ContactTissue. Where the body moves by itself
//   (move_with), u_i is S f and that motion.
//
// With `relaxation` the tissue relaxes as RelaxingTissue does: u_i is S f plus the motion from relaxation.
//
// Forces are continuous. At a puncture F_p becomes friction that decays to F_c within puncture_time, and F_c to zero
// when the tip has left the layer. Until then the layer's nodes, and the one behind it, are met at the present depth
// of the displaced tissue. A newly captured node has a soft lateral constraint, which stiffens as the tip moves on
// and softens again on withdrawal. No law generates energy: each is elastic, frictional, or a compliance that grows
// at constant displacement and shrinks at constant force. Displacements are small: depths and lengths are those at
// rest. Numerical method, choices and proofs: docs/fem-contact.md, docs/flexible-needle.md.
//
// begin() resets the state; punctured nodes are remembered until reset(). The same sequence of calls gives the same
// bits. Memory is allocated by the constructor; no other function throws, allocates, locks or reads a clock.
class EmbeddedNeedle {
 public:
  // `body` is kept by reference and must outlive this. Throws InputError for settings or tissues out of range, or if
  // the body's arrays differ in size. `dt`: s, 1e-6 to 0.1. `beam`: none for a rigid needle. The settings' `bending`
  // and `body` are not read here: they determine how a case sets up beam and body. `other`: for exchange(), of the
  // size of the body's compliance and also kept by reference; may be null.
  EmbeddedNeedle(const anatomy::CondensedBody& body, const ContactTissues& tissues,
                 const anatomy::EmbeddedNeedleSettings& settings, double dt,
                 const std::optional<NeedleBeam>& beam = {}, const Eigen::MatrixXd* other = nullptr,
                 const NeedleRelaxation& relaxation = {});

  // Starts an insertion: the needle touches the body at `entry` and advances along the unit vector `direction` (LPS).
  void begin(const Vec3& entry, const Vec3& direction) noexcept;
  // As begin(), with the contact points of exactly this line, which are still being computed (ContactLine): there is
  // none until extend(). Until then the tip pushes on `surface`, whose force the first point takes over. A tissue
  // whose border is computed after the tip has passed it is felt from there on.
  void begin_growing(const Vec3& entry, const Vec3& direction, const ProvisionalSurface& surface = {}) noexcept;
  // Before a tick: the first `points` of the body are complete; `complete`: no more will follow.
  void extend(std::size_t points, bool complete = false) noexcept;
  // For a needle that has turned: forgets the points behind the first `points`, at least as many as it has reached(),
  // so that extend() adds others.
  void keep_first(std::size_t points) noexcept;
  // Before a tick: the body's points have the other compliance now, because something holds other nodes of the mesh
  // (ContactLine::couple). The needle prepares the exchange, a few points per tick, and then makes it in one tick, in
  // which nothing moves and no force changes; the effect of the changed compliance on its present forces follows
  // within some hundredths of a second (move_with). The next exchange() restores the previous compliance.
  void exchange() noexcept;
  bool exchanges() const noexcept { return exchanging_; }
  // Whether the last exchange() is complete; false if the equations would have been singular.
  bool exchanged() const noexcept { return exchanged_; }
  // Number of points on the needle's shaft or in front of its tip.
  std::size_t reached() const noexcept { return constraints_.known(); }
  // Where the needle would continue, as of the last tick: the position at rest (mm, LPS) of the tissue that its tip
  // touches, or of the border that it pushes, and the direction of its tip, a unit vector.
  struct Continuation {
    Vec3 place = Vec3::Zero();
    Vec3 direction = Vec3::UnitZ();
  };
  Continuation continuation() const noexcept;
  // Before a tick: the body moves independently, for example under a probe, or as its patient breathes. `of_mesh`:
  // mm, 3 per node of its mesh; fewer: it stands still. The tissue at the needle follows within some hundredths of a
  // second, and carries the needle or slides along it. Returns whether any point moves at all.
  bool move_with(std::span<const float> of_mesh, const BodyBreath& breath = {}) noexcept;
  // The body's own motion along the shaft: the motion of a straight line that is nearest to that of its contact
  // points, by the sum of squared distances, without a turn about the line (LPS, mm). Identity without a point; no
  // turn with one.
  Pose carried_along_shaft() const noexcept;
  // Adds a puncture: the points within 1 mm of it in the same tissue become punctured.
  void open(const Vec3& place, anatomy::TissueId tissue) noexcept;
  // mm, of the points that extend() added, in their order; negative for one that does not exist.
  double point_depth(std::size_t point) const noexcept { return point < line().size() ? line()[point].depth : -1.0; }
  // Computes one tick. Before the first begin() there is no contact. `pressed`: mm, >= 0, along the line, by which
  // the hub is nearer to the body than the needle's length allows because its tip rests on something rigid; the free
  // length of a bending needle is shorter by that amount.
  const EmbeddedNeedleForce& step(const Pose& needle, double pressed = 0.0) noexcept;
  // Restores the state after construction: no contact, no punctures, a body that stands still.
  void reset() noexcept;
  // Capture radius, time of a puncture and tissues; the new ones apply from the next tick on. Ranges as for the
  // constructor. A tissue without a puncture force stays so until the next insertion.
  ContactNumbers numbers() const noexcept;
  void set_numbers(const ContactNumbers& numbers) noexcept;
  // Forces of the last tick, by node.
  const NodeForces& node_forces() const noexcept { return published_; }
  // The forces for the tissue's present displacement in an elastic body: with relaxation, more than node_forces().
  const NodeForces& elastic_forces() const noexcept { return relaxing_.relaxes() ? elastic_ : published_; }
  // Whether an insertion has begun and, as of the last tick, has contact nodes or its tip below the entry.
  bool touches() const noexcept { return begun_ && (captured_ > 0 || tip_ > 0.0); }
  // Whether there are contact nodes on the shaft.
  bool holds() const noexcept { return begun_ && captured_ > 0; }
  // Elastic energy, N mm, in body, needle and lateral constraints; with relaxation, without the energy still stored
  // at nodes from which the needle was withdrawn. The cost is quadratic in the number of nodes.
  double stored_energy() const noexcept;
  // mm, LPS: offset of a bending needle's shaft from the straight needle of the pose, `from_tip` mm before its tip,
  // 0 to its length. As of the last tick.
  Vec3 shaft_deflection(double from_tip) const noexcept;

 private:
  // State of the contact with one node.
  struct NodeContact {
    double slip = 0.0;                                 // z, mm; in front of the tip: where the tip touches the node
    double sense = 1.0;                                // direction of sliding, -1 or 1
    double puncture_residual = 0.0;                    // N, the remainder of the force of a puncture or a cut
    double fading = 0.0;                               // N, the part of it that decays in puncture_time
    double limit = 0.0;                                // N, friction limit of this tick
    double cutting = 0.0;                              // N, by which the limit is higher inwards, while the tip cuts
    double moved = 0.0;                                // mm, u along the needle
    Eigen::Vector2d anchor = Eigen::Vector2d::Zero();  // mm, across: position of its hole
    double lateral_compliance = -1.0;                  // mm/N, of the constraint; negative: not constrained
    double own_compliance = 0.0;                       // mm/N, across, of the tissue at the node
    double full_capture_length = 1.0;                  // mm past its depth, over which its constraint stiffens
    double cut = 0.0;                                  // fraction of cut_offset by which the bevel has moved its hole
    Eigen::Vector2d aside = Eigen::Vector2d::Zero();   // mm, by which the bevel moved it in this tick
    bool whole = true;                                 // its layer was unpunctured before this insertion

    double limit_towards(double direction) const noexcept { return limit + (direction > 0.0 ? cutting : 0.0); }
  };

  std::span<const ContactNode> line() const noexcept { return contact_nodes_.along(); }
  Eigen::Vector2d axis_offset(double depth) const noexcept { return offset_ + slope_ * (depth - tip_); }
  Eigen::Vector2d beam_deflection(double from_hub) const noexcept;
  // mm, across: offset of the shaft at the present position of a node of the line.
  Eigen::Vector2d shaft_offset(std::size_t index) const noexcept {
    return axis_offset(depth_now(index)) + beam_deflection(root_.outside + line()[index].depth);
  }
  void start(const Vec3& entry, const Vec3& direction) noexcept;
  void prepare_exchange() noexcept;
  void take_exchanged() noexcept;
  double provisional_force() noexcept;
  double material_depth() const noexcept;
  double opened_depth() const noexcept;
  anatomy::TissueId tissue_at(double depth) const noexcept;
  bool blocked() const noexcept;
  bool cuts() const noexcept;
  bool is_at_cut() const noexcept;
  bool comes_to_next() const noexcept;
  bool is_whole(std::size_t index) const noexcept;
  bool is_before_next() const noexcept { return blocked() || (is_at_cut() && captured_ < line().size()); }
  void release_withdrawn() noexcept;
  void capture() noexcept;
  void place_tip_contact(double moved) noexcept;
  void add_next_before_tip() noexcept;
  bool capture_node(std::size_t index) noexcept;
  void update_capture() noexcept;
  void update_cutting() noexcept;
  double cutting_force() const noexcept;
  void set_lateral_compliance(double lateral_compliance) noexcept;
  void cut_aside() noexcept;
  void solve_contacts() noexcept;
  void place() noexcept;
  void solve() noexcept;
  bool stick_where_slip_reverses(bool last_round) noexcept;
  bool slip_where_friction_ends(std::size_t& budget) noexcept;
  bool update_tip_contact() noexcept;
  void puncture() noexcept;
  void report() noexcept;
  void publish(NodeForces& all, std::size_t node, const Vec3& force) const noexcept;
  Vec3 displacement(std::size_t index) const noexcept {
    return constraints_.compliance().displacement(index, forces_) + moved_otherwise(index);
  }
  // mm, in the frame: displacement of a node by anything but the forces of this tick.
  Vec3 moved_otherwise(std::size_t index) const noexcept { return carried(index) + relaxing_.moved(index); }
  // mm, in the frame: displacement of a node of the line by the body's own motion.
  Vec3 carried(std::size_t index) const noexcept {
    return moves_ ? Vec3(frame_.transpose() * carried_[line()[index].index]) : Vec3(Vec3::Zero());
  }
  // mm along the line: present depth of a node without the needle's effect.
  double depth_now(std::size_t index) const noexcept { return line()[index].depth + carried(index)(0); }
  Vec3 goal(std::uint32_t point) const noexcept;
  void place_new_points() noexcept;

  const anatomy::CondensedBody& body_;
  ContactTissues tissues_;
  anatomy::EmbeddedNeedleSettings settings_;
  double dt_;
  std::optional<NeedleBeam> beam_;
  ContactNodes contact_nodes_;
  ShaftConstraints constraints_;
  RelaxingTissue relaxing_;
  std::unique_ptr<ShaftConstraints> other_;  // with the other compliance; may be null
  bool exchanging_ = false, exchanged_ = false;
  std::vector<NodeContact> contacts_;  // most_nodes + 1: the shaft's nodes and the one in front of the tip
  std::vector<double> displacements_;  // 3 x (most_nodes + 1), mm: along, across, across
  std::vector<double> forces_;         // 3 x (most_nodes + 1), N on the tissue: along, across, across
  // By point of the body: not punctured, punctured in this insertion, or before it.
  static constexpr std::uint8_t punctured_now = 1, punctured_before = 2;
  std::vector<std::uint8_t> punctured_;
  std::span<const float> field_;  // of the body's own motion, as passed to move_with()
  BodyBreath breath_;
  std::vector<Vec3> carried_;  // mm, LPS, by point of the body; the present motion of the tissue there
  std::size_t placed_ = 0;     // nodes of the line whose carried_ is known
  bool moves_ = false;         // some carried_ is not 0
  std::size_t captured_ = 0;   // contact nodes on the shaft
  bool begun_ = false, fresh_ = true;
  Vec3 entry_ = Vec3::Zero();
  Mat3 frame_ = Mat3::Identity();  // columns: along the line, across, across
  double tip_ = 0.0;               // s, mm
  double advance_ = 0.0;           // mm, in this tick
  double cut_ = 0.0;               // mm, where the last node touched the needle at the deepest cut
  Eigen::Vector2d offset_ = Eigen::Vector2d::Zero(), slope_ = Eigen::Vector2d::Zero();
  ShaftRoot root_;
  Eigen::Vector2d turn_ = Eigen::Vector2d::Zero();  // rad, rotation of a pinned hub from the pose
  Eigen::Vector2d side_ = Eigen::Vector2d::Zero();  // unit vector across, towards the point of the bevel
  double bevel_energy_ = 0.0;                       // N mm, dissipated by friction and not used by the bevel
  ProvisionalSurface surface_;
  double provisional_ = 0.0;  // N, of the last tick
  EmbeddedNeedleForce force_;
  NodeForces published_, elastic_;
};

}  // namespace bodkin::fem
