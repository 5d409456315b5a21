#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry.h"

namespace bodkin::fem {

// The compliance between the nodes along a needle, in the frame of the insertion: along the needle and two directions
// across it, 3 numbers for each node. It is copied from the body's compliance, where it is scattered over much
// memory; each pair of nodes is fetched once.
class ShaftCompliance {
 public:
  // `compliance` is kept by reference and must outlive this.
  ShaftCompliance(const Eigen::MatrixXd& compliance, std::size_t most_nodes);

  // Removes all nodes. `frame`: columns along the needle and across it.
  void begin(const Mat3& frame) noexcept;
  // Adds a node; returns false, and changes nothing, at full capacity and if the body does not have the node.
  // pop() removes the last one.
  bool push(std::uint32_t node) noexcept;
  void pop() noexcept { --count_; }
  std::size_t size() const noexcept { return count_; }

  // mm/N: displacement of node `index` along direction c by 1 N on each node up to itself; the force on node j along
  // direction d is at 3 j + d. Since the compliance is symmetric, these are also the displacements of those nodes by
  // a force on this one.
  const double* row(std::size_t index, std::size_t c) const noexcept {
    return rows_.data() + (3 * index + c) * stride_;
  }
  // mm, displacement of node `index` by `forces`, N, 3 x size().
  Vec3 displacement(std::size_t index, std::span<const double> forces) const noexcept;
  // mm, displacements of all nodes by `forces`; room for upper_triangular::padded(3 x size()).
  void displace(std::span<const double> forces, std::span<double> displacements) const noexcept;

 private:
  const Eigen::MatrixXd* compliance_;
  std::size_t most_nodes_, stride_;
  std::vector<double> rows_;          // 3 most_nodes x stride_
  std::vector<std::uint32_t> nodes_;  // most_nodes
  std::size_t count_ = 0;
  Mat3 frame_ = Mat3::Identity();
};

}  // namespace bodkin::fem
