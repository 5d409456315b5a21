#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry.h"

namespace bodkin {

// How the nodes along a needle move by loads along it, and how far they are moved along it by any forces: the part of
// the compliance that friction needs in every tick, kept together because in the whole matrix it is scattered.
// Vectors are in the frame of the insertion: along the needle and two directions across it, 3 numbers a node.
class AxialCoupling {
 public:
  // `compliance` is kept by reference and must outlive this.
  AxialCoupling(const Eigen::MatrixXd& compliance, std::size_t most_nodes);

  // Forgets all nodes. `frame`: columns along the needle and across it.
  void begin(const Mat3& frame) noexcept;
  // Adds a node; the caller sees to it that there is room. Takes away the last.
  void push(std::uint32_t node) noexcept;
  void pop() noexcept { --count_; }
  std::size_t size() const noexcept { return count_; }

  // displacements += those by a force of `load` N along the needle at node `index`; 3 x size().
  void add(std::size_t index, double load, std::span<double> displacements) const noexcept;
  // mm along the needle that node `index` is moved by `forces`; 3 x size().
  double displacement(std::size_t index, std::span<const double> forces) const noexcept;

 private:
  const Eigen::MatrixXd& compliance_;
  std::size_t stride_;
  std::vector<double> matrix_;        // most_nodes x stride_: row i, 3 j + c: of node j along c by 1 N at i along 0
  std::vector<std::uint32_t> nodes_;  // most_nodes
  std::size_t count_ = 0;
  Mat3 frame_ = Mat3::Identity();
};

}  // namespace bodkin
