#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry.h"
#include "core/mapped_file.h"
#include "fem/solid/factor_layout.h"
#include "fem/solid/multifrontal_cholesky.h"
#include "fem/zero_pages.h"

namespace bodkin::fem {

// A point that moves with a body: the free nodes (and quadratic edges) that carry it, as numbered in the equations,
// and the share of each. A force on the point is distributed over these nodes by the same shares. Without shares it
// is held.
struct CarriedPoint {
  struct Share {
    std::uint32_t node = 0;
    double weight = 0.0;
  };
  std::vector<Share> shares;  // each node once
};

// L^-1 B of one point, B its three columns of unit forces, where it is not zero: on the path of the elimination tree
// from the point's nodes to the root.
struct PointResponse {
  struct Piece {
    std::uint32_t supernode = 0;
    std::size_t at = 0;      // position of its numbers: three columns, one after another
    std::size_t length = 0;  // of a column, a multiple of 4; what exceeds the supernode is zero
  };
  std::vector<Piece> path;  // supernodes ascending
  std::vector<double> numbers;
};

// The Cholesky factor of a body's stiffness, kept so that the compliance of a few points can be computed at any time:
// the columns L^-1 B of a point are zero except on its path to the root of the elimination tree, and with them the
// displacement of point i by a force on point j is (L^-1 B_i)^T (L^-1 B_j), exact for the whole body.
//
// Every number is computed by one chain of additions and multiplications in a fixed order, without fused
// multiply-add: the same bits for a single point or several, and with every instruction set. Thread-safe.
class PackedFactor {
 public:
  // Room for a factor of this structure, whose panels are passed to take().
  explicit PackedFactor(const SymbolicFactor& symbolic);
  // A factor whose numbers are in a file, from byte `at`, a multiple of 8. The file must contain all of them.
  PackedFactor(FactorLayout layout, MappedFile file, std::size_t at);
  // Copies a whole factor, on this thread; the original may be destroyed afterwards.
  explicit PackedFactor(const MultifrontalCholesky& factor);

  // Stores the panel of a supernode, once each (FactorOptions::finished); `pool` shares the work.
  void take(std::size_t supernode, const double* panel, ThreadPool& pool);

  std::uint32_t nodes() const noexcept { return static_cast<std::uint32_t>(layout_.position.size()); }
  const FactorLayout& layout() const noexcept { return layout_; }
  std::size_t bytes() const noexcept;
  // The factor's numbers in the order of their storage.
  std::span<const double> numbers() const noexcept { return {numbers_, layout_.numbers}; }

  enum class Kernel {
    widest,  // the widest registers that the processor has
    plain    // those of every processor of its kind
  };
  // One response per point. Points of one call share one pass through the factor, so they should lie close together.
  std::vector<PointResponse> respond(std::span<const CarriedPoint> points, Kernel kernel = Kernel::widest) const;

  // mm/N: displacements of the nodes `wanted` by unit forces on the points with these responses: 3 rows per node and
  // 3 columns per point. Reads the part of the factor on the paths of these nodes to the root, once.
  Eigen::MatrixXd displacements(std::span<const PointResponse> points, std::span<const std::uint32_t> wanted) const;

 private:
  using Part = FactorLayout::Part;
  void pack_own(const Part& part, const double* panel, std::size_t strip_number);
  void pack_below(const Part& part, const double* panel, std::size_t strip_number);

  FactorLayout layout_;
  ZeroPages pages_;  // holds the numbers ...
  MappedFile file_;  // ... or this does
  const double* numbers_ = nullptr;
};

// mm/N: the displacement of point `a` (rows x y z) by unit forces on point `b` (columns x y z), from their responses
// to one factor. compliance_between(b, a) is its transpose to the last bit.
Mat3 compliance_between(const PointResponse& a, const PointResponse& b,
                        PackedFactor::Kernel kernel = PackedFactor::Kernel::widest);

}  // namespace bodkin::fem
