#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fem/contact_factor.h"
#include "fem/shaft_compliance.h"
#include "fem/shaft_schur_complement.h"

namespace bodkin::fem {

// The constraints along and across the shaft of a needle at its contact nodes, and their forces. Nodes are added and
// removed at the tip; along the needle each can be constrained or released at any time. Vectors have 3 numbers for
// each node: along, across, across.
//
// The equations are solved in three steps. The first costs most and is done once for each position of the needle:
//   1. the lateral constraints of all nodes but the last, which are rigid (ContactFactor)
//   2. the constraints along the needle: the Schur complement of step 1 (ShaftSchurComplement)
//   3. the lateral constraint of the last node, which has a compliance, and the deflection and slope of a bending
//      needle at the surface of the body: 6 unknowns at most
//
// The flexibility of a bending shaft adds to the lateral equations. The part between the nodes is that of a beam
// clamped at the surface of the body; it does not change while the needle slides through the nodes and is part of the
// factor. Deflection and slope at the surface follow from the piece of the needle outside, two unknowns in each plane
// in each solution: exact at any depth (docs/flexible-needle.md).
class ShaftConstraints {
 public:
  // `compliance`, `most_nodes`, `beam`: as for ContactFactor. The node in front of the tip does not count towards
  // `most_nodes`.
  ShaftConstraints(const Eigen::MatrixXd& compliance, std::size_t most_nodes,
                   const std::optional<NeedleBeam>& beam = {});

  // Removes all nodes. `frame`: columns along the needle and across it.
  void begin(const Mat3& frame) noexcept;
  // Adds the node in front of the tip; known() counts it from now on. push() makes it a node of the shaft. Returns
  // false, and changes nothing, if there is one already, at full capacity, and if the body does not have the
  // node.
  bool add_before_tip(std::uint32_t node) noexcept;
  // Adds a node to the shaft, without constraints except that of constrain_before_tip(). The lateral constraint of
  // the node before it becomes rigid. `depth`, mm, is used for a bending needle. Returns false, and changes nothing,
  // at full capacity, and if another node is in front of the tip.
  bool push(std::uint32_t node, double depth) noexcept;
  // Removes the node in front of the tip, and the last node of the shaft with its constraints, which then is in front
  // of the tip.
  void pop() noexcept;

  // Constrains a node along the needle. Returns false if it is constrained already, or depends on those that are.
  bool constrain_along(std::size_t index) noexcept { return index < known() && along_.stick(index); }
  bool constrain_before_tip() noexcept { return constrain_along(count_); }
  // `index`: size() for the node in front of the tip.
  void release_along(std::size_t index) noexcept { along_.release(index); }
  // Constrains all nodes of the shaft along the needle, and keeps the constraint of the node in front of the tip.
  void constrain_all_along() noexcept;
  // Constrains the last node across the needle, with this compliance, mm/N. Returns false if it is not >= 0 or the
  // equations would be singular.
  bool constrain_last_across(double compliance) noexcept;
  void release_last_across() noexcept { last_compliance_ = -1.0; }

  // Sets the displacements, mm, that the constraints impose in the following solutions, for each known node and
  // relative to its position without these forces. `root`, of a bending needle: the piece outside.
  void place(std::span<const double> displacements, const ShaftRoot& root = {}) noexcept;
  // Computes the forces along the needle, N. Input: `forces` of nodes that are not constrained along it, as loads.
  // Output: those of the constrained nodes, and the lateral force of the last node (0 without a constraint). The
  // other lateral forces are not changed.
  void solve_along(std::span<double> forces) noexcept;
  // mm, displacement of a sliding node along the needle by all forces of the last solution.
  double moved(std::size_t index) const noexcept { return moved_[always() + index]; }
  // Computes the lateral forces of the last solution; once for each place(). Returns the rotation of the hub in the
  // hand, rad, in the two planes across the needle; 0 unless the hub is pinned.
  Eigen::Vector2d solve_across(std::span<double> forces) noexcept;
  // place(), solve_along() and solve_across().
  Eigen::Vector2d solve(std::span<const double> displacements, std::span<double> forces,
                        const ShaftRoot& root = {}) noexcept;

  // Nodes of the shaft.
  std::size_t size() const noexcept { return count_; }
  // Nodes of the shaft, and the one in front of the tip if there is one.
  std::size_t known() const noexcept { return compliance_.size(); }
  bool constrained_along(std::size_t index) const noexcept { return along_.sticks(index); }
  std::size_t release_cost(std::size_t index) const noexcept { return along_.release_cost(index); }
  const ShaftCompliance& compliance() const noexcept { return compliance_; }

 private:
  // The lateral equations of a node when it was the last: Schur complement of the nodes before it.
  struct Last {
    Eigen::Matrix2d corner = Eigen::Matrix2d::Zero();  // mm/N, without the constraint's compliance
    Eigen::Vector2d own = Eigen::Vector2d::Zero();     // mm/N, compliance of the tissue at the node
  };

  std::size_t always() const noexcept { return bends_ ? 4 : 0; }
  // Nodes with a rigid lateral constraint.
  std::size_t rigid_count() const noexcept { return count_ > 0 ? count_ - 1 : 0; }
  bool last_constrained() const noexcept { return count_ > 0 && last_compliance_ >= 0.0; }
  double* above(std::size_t index, std::size_t c) noexcept {
    return above_.data() + (2 * index + c) * across_.stride();
  }
  double* left(std::size_t index, std::size_t c) noexcept { return left_.data() + (2 * index + c) * along_.stride(); }
  bool make_rigid(std::size_t index) noexcept;
  void begin_last(std::size_t index) noexcept;
  void find_border() noexcept;
  Eigen::Vector4d bend_outside(const Eigen::Vector4d& mode_displacements) noexcept;
  void finish_along(std::span<double> forces, const Eigen::Vector4d& outside_modes) noexcept;

  bool bends_;
  std::optional<NeedleBeam> beam_;
  ShaftCompliance compliance_;
  ContactFactor across_;
  ShaftSchurComplement along_;
  std::vector<std::uint32_t> nodes_;  // most_nodes + 1; in the body
  std::vector<double> depths_;        // most_nodes + 1; mm
  std::vector<Last> lasts_;           // by node
  std::vector<double> above_;         // by node and direction: its columns of the factor U
  std::vector<double> left_;          // by node and direction: coupling with the columns of along_
  std::size_t count_ = 0;
  double last_compliance_ = -1.0;  // mm/N; negative: no lateral constraint
  ConstraintDirections across_directions_;

  // State of the current solution.
  ShaftRoot root_;
  std::vector<double> across_values_;  // U^-T times the imposed lateral displacements
  std::vector<double> products_;       // by lateral row
  std::vector<double> given_;          // by node: imposed displacement along the needle, mm
  std::vector<double> carried_;        // by column of along_: displacement by the rigid lateral forces only
  std::vector<double> moved_, loads_;  // by column: displacement by all forces; the forces
  std::vector<double> found_;          // by column: constraint forces
  std::vector<double> unknowns_;       // by row of T
  std::vector<double> border_;         // 6 vectors by row of T: two of the last node, four of bending
  Eigen::Vector2d last_wanted_ = Eigen::Vector2d::Zero(), last_force_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d turn_ = Eigen::Vector2d::Zero();
  Eigen::Matrix2d last_factor_ = Eigen::Matrix2d::Zero();                         // lower triangle
  Eigen::Matrix<double, 2, 4> last_bends_ = Eigen::Matrix<double, 2, 4>::Zero();  // its coupling with bending
  Eigen::Matrix4d stiffness_ = Eigen::Matrix4d::Zero();  // stiffness of all nodes against bending
  bool border_valid_ = false, last_valid_ = false;
};

}  // namespace bodkin::fem
