#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "anatomy/tetrahedral_mesh.h"
#include "fem/moving/corotational_elements.h"

namespace bodkin::fem {

// As NodeVectors, in single precision.
using SingleVectors = Eigen::Matrix4Xf;

// A symmetric matrix with a 3 x 3 block for every pair of nodes that share an element of a mesh, with both triangles
// stored, in single precision; vectors are in double precision. Refilled at every step of a moving body; the
// positions of its blocks are determined once.
class NodeMatrix {
 public:
  explicit NodeMatrix(const anatomy::TetrahedralMesh& mesh);

  // factor K + diagonal: K from the elements, one number per node in `diagonal` (N/mm), for all three of its
  // directions. The diagonal blocks of K follow from the others of their rows: a translation stores no energy.
  void assemble(const std::vector<TurnedElement>& elements, double factor, std::span<const double> diagonal) noexcept;

  // product = matrix vector
  void multiply(const NodeVectors& vector, NodeVectors& product) const noexcept;

  // To be called before the two functions below: inverts the diagonal block of every node whose `held` is zero. A
  // node whose block is not positive definite, because nothing resists it, counts as held.
  void invert_diagonal(std::span<const std::uint8_t> held) noexcept;
  // For the free nodes, with D the diagonal blocks and L those below it in the matrix's own order:
  //   solve_lower   (D + L) x = right,     scaled = D x
  //   solve_upper   (D + L)^T x = right,   above = L^T x
  // Held entries are not read, provided that they are zero in x, and not written.
  void solve_lower(const SingleVectors& right, SingleVectors& x, SingleVectors& scaled) const noexcept;
  void solve_upper(const SingleVectors& right, SingleVectors& x, SingleVectors& above) const noexcept;

  std::size_t nodes() const noexcept { return order_.size(); }
  std::size_t blocks() const noexcept { return blocks_.size(); }

  // Three columns; the fourth number of each is 0.
  struct alignas(16) Block {
    std::array<std::array<float, 4>, 3> column;
  };

 private:
  // An edge of the mesh: the positions of its block and of the transposed one, and the elements that contain it.
  struct Edge {
    std::uint32_t upper, lower;
    std::uint32_t first_share;
  };
  // 16 element + 4 a + b, a and b the corners that the edge joins.
  using Share = std::uint32_t;

  static void assemble_edges(std::span<const Edge> edges, const Share* shares, const TurnedElement* elements,
                             float factor, Block* blocks) noexcept;
  static void multiply_rows(const NodeMatrix& matrix, const double* vector, double* product) noexcept;
  static void sweep_down(const NodeMatrix& matrix, const float* right, float* x, float* scaled) noexcept;
  static void sweep_up(const NodeMatrix& matrix, const float* right, float* x, float* above) noexcept;

  // In blocks_, by place in order_.
  struct Range {
    std::uint32_t first, last;
  };
  Range below(std::uint32_t place) const noexcept { return {below_[place], below_[place + 1]}; }
  std::uint32_t own_block(std::uint32_t place) const noexcept { return below_.back() + place; }
  Range above(std::uint32_t place) const noexcept {
    const std::size_t from_last = nodes() - 1 - place;
    return {above_[from_last], above_[from_last + 1]};
  }

  // The blocks in the order of the sweeps: those below the diagonal, row by row; the diagonal; those above it, from
  // the last row to the first.
  std::vector<std::uint32_t> order_;   // of the nodes in a sweep
  std::vector<std::uint32_t> below_;   // nodes + 1, of each row in blocks_
  std::vector<std::uint32_t> above_;   // nodes + 1, of each row in blocks_, from the last row to the first
  std::vector<std::uint32_t> column_;  // of each block, its node
  std::vector<Block> blocks_;
  std::vector<Block> inverse_;       // of the diagonal
  std::vector<std::uint32_t> free_;  // places in order_ of the nodes that are free
  std::size_t free_count_ = 0;       // their number
  std::vector<Edge> edges_;          // one more than exist, so that each ends where the next begins
  std::vector<Share> shares_;
};

}  // namespace bodkin::fem
