#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry.h"
#include "fem/needle_beam.h"

namespace bodkin::fem {

// The directions in which a node is constrained: 1 to 3 orthonormal columns.
using ConstraintDirections = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;

// The constraints between a needle and a condensed body, and the upper triangular factor U for their forces:
//
//   U^T U = B^T S B + F + diag(c);   f = U^-1 U^-T d
//
// S: compliance of the body's points, mm/N, 3 rows and columns for each node. B: one column for each direction in
// which a node is constrained, in the order in which the constraints were added. d: displacement that each constraint
// imposes, relative to the position without these forces, mm. f: its force, N. c: compliance of the constraint
// itself, mm/N, 0 if it is rigid. F: for needles that bend, the flexibility between two lateral constraints of a beam
// clamped at depth 0, times the cosine between their directions; 0 for constraints along the needle. A node
// constrained in all directions sticks to the needle; one constrained only across the needle slides along it.
//
// Constraints are added and removed one at a time without a new factorisation: a new one adds columns to U, the last
// one is removed without any work, any other one by Givens rotations (Golub and Van Loan, Matrix Computations, 6.5).
// All operations act on U itself, never on its inverse, so rounding errors do not accumulate (docs/fem-contact.md).
// Memory is allocated by the constructor; no other function throws, allocates or locks. Not thread-safe.
class ContactFactor {
 public:
  // `compliance`: S, square, symmetric, positive definite; kept by reference, must outlive this. `most_nodes`: at
  // least 1; the capacity is 3 times as many rows. `beam`: none for a rigid needle. Throws InputError if S is not
  // square or does not have 3 rows for each node.
  ContactFactor(const Eigen::MatrixXd& compliance, std::size_t most_nodes,
                const std::optional<NeedleBeam>& beam = {});

  // Adds a constraint. Returns false, and changes nothing, at full capacity, for a node that the body does not
  // have, and if U would be numerically singular, as by the same node twice. `compliance`: mm/N, >= 0. `depth`: mm,
  // >= 0, of a lateral constraint of a bending needle; negative for one along the needle.
  bool append(std::uint32_t node, const ConstraintDirections& directions, double compliance = 0.0,
              double depth = -1.0) noexcept;
  // As above, with given columns U^-T B^T S B + F, stride() apart, with room for stride() numbers each.
  bool append_solved(std::uint32_t node, const ConstraintDirections& directions, const double* columns,
                     double compliance, double depth) noexcept;
  // Removes the last constraint, if there is one.
  void remove_last() noexcept;
  // Removes a constraint; the index of those after it decreases by one.
  void remove(std::size_t constraint) noexcept;
  void clear() noexcept;
  // Changes the compliance of the last constraint, mm/N, >= 0. Returns false, and changes nothing, if U would be
  // singular.
  bool set_last_compliance(double compliance) noexcept;
  // Copies the constraints of `other`, which must have the same compliance and capacity.
  void copy(const ContactFactor& other) noexcept;

  // Replaces d, mm, by f, N; rows() numbers.
  void solve(std::span<double> values) noexcept;
  // The two halves of solve(): x := U^-T x for each of `count` consecutive vectors with room for stride() numbers
  // each, and x := U^-1 x for one. The numbers from rows() on are overwritten.
  void forward(double* columns, std::size_t count) noexcept;
  void backward(double* values) noexcept;
  std::size_t stride() const noexcept { return stride_; }

  std::size_t constraints() const noexcept { return constraints_; }
  std::size_t rows() const noexcept { return rows_; }
  std::size_t most_rows() const noexcept { return most_rows_; }
  // An element of U, column >= row.
  double entry(std::size_t at, std::size_t column) const noexcept { return row(at)[column]; }

 private:
  struct Row {
    std::uint32_t node = 0;
    Vec3 direction = Vec3::Zero();
    double depth = -1.0;  // mm; negative: along the needle
    bool rigid = true;    // without compliance
  };

  double* row(std::size_t index) noexcept { return factor_.data() + index * stride_; }
  const double* row(std::size_t index) const noexcept { return factor_.data() + index * stride_; }
  bool fits(std::uint32_t node, std::size_t count, double compliance) const noexcept;
  bool add_columns(std::uint32_t node, const ConstraintDirections& directions, double compliance,
                   double depth) noexcept;
  bool finish(std::size_t first, std::size_t count, double compliance) noexcept;
  void find_corner(std::size_t first, std::size_t count) noexcept;

  const Eigen::MatrixXd* compliance_;
  std::optional<NeedleBeam> beam_;
  std::size_t most_rows_;
  std::size_t stride_;                   // of U, a multiple of 8
  std::vector<double> storage_;          // most_rows_ x stride_, by rows, and room to align it
  std::span<double> factor_;             // U; finite numbers below its diagonal and from rows() on
  std::vector<double> scratch_;          // 3 x stride_
  std::vector<Row> row_of_;              // most_rows_
  std::vector<std::size_t> first_rows_;  // most_rows_ + 1, by constraint
  std::size_t constraints_ = 0, rows_ = 0;
  Mat3 corner_ = Mat3::Zero();  // U^T U of the last constraint, without its compliance
  Vec3 own_ = Vec3::Zero();     // diagonal of S there
  bool corner_known_ = false;
};

}  // namespace bodkin::fem
