#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fem/contact_factor.h"

namespace bodkin {

// Which of the nodes along a needle are held along it, and which across it. Nodes come and go at the tip; along the
// needle any of them may be held or let slide at any time. When all are to be held at once, as when the needle turns
// round, a second factor in which they always are is copied. Vectors have 3 numbers a node: along, across, across.
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
  // A further node, held in no direction yet unless hold_before_tip() held it. The node before it is from now on held
  // across the needle without softness. `depth`, mm, counts for a needle that bends. False, and nothing changed, when
  // there is no room.
  bool push(std::uint32_t node, double depth) noexcept;
  // Takes the last node away with all that held it.
  void pop() noexcept;

  // Holds a node along the needle; false when it is held already, or cannot be.
  bool hold_along(std::size_t index) noexcept;
  bool hold_before_tip(std::uint32_t node) noexcept;
  void let_slide(std::size_t index) noexcept;  // index size(): the node before the tip
  // Holds every node along the needle, and the one before the tip if it was held.
  void hold_all_along() noexcept;
  // Holds the last node across the needle with this softness, mm/N.
  bool hold_last_across(double softness) noexcept;
  void release_last_across() noexcept;

  // For what is held: how far, mm, becomes the force, N. What is not held is left as it is in `forces`.
  // `root`, of a needle that bends: the piece outside. Returns by how much the hub turns in the hand, rad, in the two
  // planes across; 0 unless it is pinned.
  Eigen::Vector2d solve(std::span<const double> displacements, std::span<double> forces,
                        const ShaftRoot& root = {}) noexcept;

  std::size_t size() const noexcept { return count_; }
  bool held_along(std::size_t index) const noexcept { return held_[along(index)] != 0; }
  std::size_t release_cost(std::size_t index) const noexcept;

 private:
  // A constraint by its node and its kind.
  using Name = std::uint32_t;
  static Name along(std::size_t index) noexcept { return static_cast<Name>(2 * index); }
  static Name across(std::size_t index) noexcept { return static_cast<Name>(2 * index + 1); }
  std::size_t place(Name name) const noexcept;
  bool append(Name name, std::uint32_t node, double softness) noexcept;
  void remove(Name name) noexcept;
  void find_rigid_modes() noexcept;
  Eigen::Vector2d bend_outside(const ShaftRoot& root) noexcept;

  bool bends_;
  ContactFactor factor_;
  ContactFactor all_held_;            // every node but the last, in all directions
  std::vector<Name> names_;           // of the constraints of factor_
  std::vector<std::uint8_t> held_;    // by name: whether factor_ has it
  std::vector<std::uint32_t> nodes_;  // most_nodes + 1; of the corridor; that before the tip is nodes_[count_]
  std::vector<double> depths_;        // most_nodes + 1; mm
  std::vector<double> values_;        // one a row
  std::vector<double> modes_;         // 4 x stride: U^-T times place and slope of the shaft in either plane
  bool modes_known_ = false;
  std::size_t count_ = 0;
  double last_softness_ = -1.0;  // mm/N; negative: not held across
  HeldDirections along_, across_;
};

}  // namespace bodkin
