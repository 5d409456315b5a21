#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry.h"
#include "fem/needle_beam.h"

namespace bodkin {

// The directions in which a node is held: 1 to 3 orthonormal columns.
using HeldDirections = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;

// The constraints of a needle on a condensed body, and the upper triangle U that solves for their forces:
//
//   U^T U = B^T S B + F + diag(softness);   f = U^-1 U^-T d
//
// S compliance of the corridor, mm/N, 3 rows and columns a node; B a column for every direction in which a node is
// held, a row of U each, in the order in which they were added; d how far each is held away from where it would be
// without these forces, mm; f its force, N. A node held in all directions sticks to the needle, one held across the
// needle alone slides along it. Softness, mm/N, lets a constraint give way in proportion to its force. F, of needles
// that bend: flexibility of a beam clamped at depth 0 between the depths of two constraints, times the cosine between
// their directions; nothing for those along the needle.
//
// Constraints come and go one by one without factorising again: a new one borders U, the last is cut off for nothing,
// any other leaves by Givens rotations (Golub and Van Loan, Matrix Computations, 6.5). All work is on U itself, none
// on its inverse, which is why rounding does not pile up (docs/fem-contact.md). Memory is taken at construction; the
// rest never throws, allocates or locks. Not for two threads at once.
class ContactFactor {
 public:
  // `compliance`: square, symmetric, positive definite; it is kept by reference and must outlive this. `most_nodes`:
  // room for 3 times as many rows, at least 1. `beam`: none for a rigid needle. Throws InputError when
  // the compliance is not square in whole nodes.
  ContactFactor(const Eigen::MatrixXd& compliance, std::size_t most_nodes,
                const std::optional<NeedleBeam>& beam = {});

  // Adds a constraint. False, and nothing changed, when there is no room, when the node is not one of the corridor,
  // or when the constraint says what others say already (U would be numerically singular: the same node twice).
  // `depth`: mm, >= 0, of a constraint across a needle that bends; negative: one along it.
  bool append(std::uint32_t node, const HeldDirections& directions, double softness = 0.0,
              double depth = -1.0) noexcept;
  // The same when U^-T times its columns of B^T S B + F are known already: stride() apart, room for stride() in each.
  bool append_solved(std::uint32_t node, const HeldDirections& directions, const double* columns, double softness,
                     double depth) noexcept;
  // Takes away the last constraint, if there is one.
  void remove_last() noexcept;
  // Takes away any constraint; those after it move up by one.
  void remove(std::size_t constraint) noexcept;
  void clear() noexcept;
  // Gives the last constraint another softness, >= 0 mm/N. False, and nothing changed, when U would be singular.
  bool soften_last(double softness) noexcept;
  // The constraints of `other`, which must be of the same compliance and capacity.
  void copy(const ContactFactor& other) noexcept;

  // d, mm, becomes f, N, in place; rows() values.
  void solve(std::span<double> values) noexcept;
  // Its two halves for vectors with room for stride() numbers each: U^-T times each of `count` columns, which follow
  // each other, and U^-1 times one. What stands beyond rows() is changed too.
  void forward(double* columns, std::size_t count) noexcept;
  void backward(double* values) noexcept;
  std::size_t stride() const noexcept { return stride_; }

  std::size_t constraints() const noexcept { return held_; }
  std::size_t rows() const noexcept { return rows_; }
  std::size_t most_rows() const noexcept { return most_rows_; }
  // A number of U, column >= row.
  double entry(std::size_t at, std::size_t column) const noexcept { return row(at)[column]; }
  // How many numbers of U lie behind a constraint: what its removal costs.
  std::size_t removal_cost(std::size_t constraint) const noexcept;

 private:
  struct Row {
    std::uint32_t node = 0;
    Vec3 direction = Vec3::Zero();
    double depth = -1.0;  // mm; negative: it does not bend
    bool firm = true;     // without softness
  };

  double* row(std::size_t index) noexcept { return factor_.data() + index * stride_; }
  const double* row(std::size_t index) const noexcept { return factor_.data() + index * stride_; }
  bool fits(std::uint32_t node, std::size_t count, double softness) const noexcept;
  bool border(std::uint32_t node, const HeldDirections& directions, double softness, double depth) noexcept;
  bool finish(std::size_t first, std::size_t count, double softness) noexcept;
  void find_corner(std::size_t first, std::size_t count) noexcept;

  const Eigen::MatrixXd& compliance_;
  std::optional<NeedleBeam> beam_;
  std::size_t most_rows_;
  std::size_t stride_;                   // of U, a multiple of 8
  std::vector<double> storage_;          // most_rows_ x stride_, row-major, and what aligns it
  std::span<double> factor_;             // U; below its diagonal and beyond rows() anything finite
  std::vector<double> scratch_;          // 3 x stride_
  std::vector<Row> row_of_;              // most_rows_
  std::vector<std::size_t> first_rows_;  // most_rows_ + 1, by constraint
  std::size_t held_ = 0, rows_ = 0;
  Mat3 corner_ = Mat3::Zero();  // U^T U of the last constraint alone, without softness
  Vec3 whole_ = Vec3::Zero();   // diagonal of S there
  bool corner_known_ = false;
};

}  // namespace bodkin
