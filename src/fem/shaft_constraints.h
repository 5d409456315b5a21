#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fem/contact_factor.h"
#include "fem/shaft_compliance.h"
#include "fem/shaft_schur_complement.h"

namespace bodkin {

// Which of the nodes along a needle are held along it, and which across it, and the forces that this takes. Nodes
// come and go at the tip; along the needle any of them may be held or let slide at any time. Vectors have 3 numbers a
// node: along, across, across.
//
// The equations are solved in three steps, of which the first costs most and is done once for a needle's place:
//   1. all nodes but the last, firmly across: they come and go at the end alone (ContactFactor)
//   2. those that stick, along: what is left of them by 1 (ShaftSchurComplement)
//   3. the last node across, which is soft, and how a needle that bends goes through the surface: 6 numbers at most
//
// A shaft that bends adds its flexibility to what holds it across. Of that, the part between the nodes is that of a
// beam clamped at the surface of the body, which does not change while the needle slides through the nodes and so
// can be kept in the factor; where and how steeply the needle really goes through the surface follows from what is
// outside, for two numbers in each plane and anew in every solution: exact at any depth (docs/flexible-needle.md).
class ShaftConstraints {
 public:
  // As of ContactFactor. There is room for one node more than `most_nodes`: the one before the tip.
  // `beam`: none for a rigid needle.
  ShaftConstraints(const Eigen::MatrixXd& compliance, std::size_t most_nodes,
                   const std::optional<NeedleBeam>& beam = {});

  // Forgets everything. `frame`: columns along the needle and across it.
  void begin(const Mat3& frame) noexcept;
  // The node before the tip, which push() makes one of the needle's: from now on known() has it. False, and nothing
  // changed, when there is one already, when there is no room, or no such node.
  bool face(std::uint32_t node) noexcept;
  // A further node, held in no direction yet unless hold_before_tip() held it. The node before it is from now on held
  // across the needle without softness. `depth`, mm, counts for a needle that bends. False, and nothing changed, when
  // there is no room, or another node is before the tip.
  bool push(std::uint32_t node, double depth) noexcept;
  // Takes the last node away with all that held it, and the one before the tip; it is before the tip again.
  void pop() noexcept;

  // Holds a node along the needle; false when it is held already, or cannot be.
  bool hold_along(std::size_t index) noexcept { return index < known() && along_.stick(index); }
  bool hold_before_tip() noexcept { return hold_along(count_); }
  void let_slide(std::size_t index) noexcept { along_.release(index); }  // index size(): the node before the tip
  // Holds every node along the needle, and the one before the tip if it was held.
  void hold_all_along() noexcept;
  // Holds the last node across the needle with this softness, mm/N.
  bool hold_last_across(double softness) noexcept;
  void release_last_across() noexcept { last_softness_ = -1.0; }

  // Where everything is to be, mm, for the solutions that follow: of each node known what it is held away from where
  // it would be without these forces. `root`, of a needle that bends: the piece outside.
  void place(std::span<const double> displacements, const ShaftRoot& root = {}) noexcept;
  // The forces along the needle, N: what is not held is a load in `forces`, what is held is written there, and so is
  // what holds the last node across (0 when nothing does). The other forces across are not changed.
  void solve_along(std::span<double> forces) noexcept;
  // mm, of a known node that slides, along the needle by all forces of the last solution.
  double moved(std::size_t index) const noexcept { return moved_[always() + index]; }
  // The forces across of the last solution, once for a place(). Returns by how much the hub turns in the hand, rad,
  // in the two planes across; 0 unless it is pinned.
  Eigen::Vector2d solve_across(std::span<double> forces) noexcept;
  // All of it at once.
  Eigen::Vector2d solve(std::span<const double> displacements, std::span<double> forces,
                        const ShaftRoot& root = {}) noexcept;

  // Nodes of the needle; those and the one before the tip.
  std::size_t size() const noexcept { return count_; }
  std::size_t known() const noexcept { return compliance_.size(); }
  bool held_along(std::size_t index) const noexcept { return along_.sticks(index); }
  std::size_t release_cost(std::size_t index) const noexcept { return along_.release_cost(index); }
  const ShaftCompliance& compliance() const noexcept { return compliance_; }

 private:
  // The last node across, as of when it came: what stands above it in the factor, and what is left of it.
  struct Last {
    Eigen::Matrix2d corner = Eigen::Matrix2d::Zero();  // mm/N, without softness
    Eigen::Vector2d whole = Eigen::Vector2d::Zero();   // mm/N, its own compliance
  };

  std::size_t always() const noexcept { return bends_ ? 4 : 0; }
  std::size_t firm() const noexcept { return count_ > 0 ? count_ - 1 : 0; }
  bool last_held() const noexcept { return count_ > 0 && last_softness_ >= 0.0; }
  double* above(std::size_t index, std::size_t c) noexcept {
    return above_.data() + (2 * index + c) * across_.stride();
  }
  double* left(std::size_t index, std::size_t c) noexcept { return left_.data() + (2 * index + c) * along_.stride(); }
  bool make_firm(std::size_t index) noexcept;
  void begin_last(std::size_t index) noexcept;
  void find_border() noexcept;
  Eigen::Vector4d bend_outside(const Eigen::Vector4d& pulled) noexcept;
  void finish_along(std::span<double> forces, const Eigen::Vector4d& bent) noexcept;

  bool bends_;
  std::optional<NeedleBeam> beam_;
  ShaftCompliance compliance_;
  ContactFactor across_;
  ShaftSchurComplement along_;
  std::vector<std::uint32_t> nodes_;  // most_nodes + 1; of the corridor
  std::vector<double> depths_;        // most_nodes + 1; mm
  std::vector<Last> lasts_;           // by node
  std::vector<double> above_;         // by node and direction: U^-T times its columns
  std::vector<double> left_;          // by node and direction: what it has to do with the columns of along_
  std::size_t count_ = 0;
  double last_softness_ = -1.0;  // mm/N; negative: not held across
  HeldDirections across_directions_;

  // Of the present solutions.
  ShaftRoot root_;
  std::vector<double> across_values_;  // U^-T times the displacements across
  std::vector<double> products_;       // by row across
  std::vector<double> given_;          // by node, mm along the needle
  std::vector<double> carried_;        // by column of along_: moved by the forces firmly across alone
  std::vector<double> moved_, loads_;  // by column: by all forces; the forces
  std::vector<double> found_;          // by column: the forces of what is held
  std::vector<double> held_values_;    // by place in T
  std::vector<double> border_;         // 6 vectors by place in T: the last node's two, and those of bending
  Eigen::Vector2d last_wanted_ = Eigen::Vector2d::Zero(), last_force_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d turn_ = Eigen::Vector2d::Zero();
  Eigen::Matrix2d last_factor_ = Eigen::Matrix2d::Zero();                         // lower triangle
  Eigen::Matrix<double, 2, 4> last_bends_ = Eigen::Matrix<double, 2, 4>::Zero();  // what it has to do with bending
  Eigen::Matrix4d stiffness_ = Eigen::Matrix4d::Zero();                           // of all nodes against bending
  bool border_known_ = false, last_sound_ = false;
};

}  // namespace bodkin
