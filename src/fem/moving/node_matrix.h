#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "anatomy/tetrahedral_mesh.h"
#include "fem/moving/corotational_elements.h"

namespace bodkin {

// A symmetric matrix with a 3 x 3 block for every pair of nodes that share an element of a mesh, both triangles kept,
// in single precision; vectors are in double precision. Filled anew at every step of a moving body, so that what goes
// where is found once.
class NodeMatrix {
 public:
  explicit NodeMatrix(const TetrahedralMesh& mesh);

  // factor K + diagonal: K from the elements, one number a node in `diagonal` (N/mm), for all three of its
  // directions. What a block of the diagonal of K is follows from the others of its row: a translation costs nothing.
  void assemble(const std::vector<TurnedElement>& elements, double factor, std::span<const double> diagonal) noexcept;

  // product = matrix vector
  void multiply(const NodeVectors& vector, NodeVectors& product) const noexcept;

  // The inverse of every node's own block; zero for those whose `held` is not zero. A block that is not positive
  // definite, of a node that nothing resists, gives zero too.
  void invert_diagonal(std::span<const std::uint8_t> held) noexcept;
  // product = that inverse, vector by vector
  void multiply_by_inverse_diagonal(const NodeVectors& vector, NodeVectors& product) const noexcept;

  std::size_t nodes() const noexcept { return start_.size() - 1; }
  std::size_t blocks() const noexcept { return blocks_.size(); }

 private:
  // Three columns; the fourth number of each is 0.
  struct alignas(16) Block {
    std::array<std::array<float, 4>, 3> column;
  };
  // An edge of the mesh: where its block and the transposed one are, and which elements have it.
  struct Edge {
    std::uint32_t upper, lower;
    std::uint32_t first_share;
  };
  // 16 element + 4 a + b, a and b the corners that the edge joins.
  using Share = std::uint32_t;

  static void assemble_edges(std::span<const Edge> edges, const Share* shares, const TurnedElement* elements,
                             float factor, Block* blocks) noexcept;
  static void multiply_rows(const std::uint32_t* start, const std::uint32_t* column, const Block* blocks,
                            std::size_t rows, const double* vector, double* product) noexcept;

  std::vector<std::uint32_t> start_;   // nodes + 1, of each row in blocks_
  std::vector<std::uint32_t> column_;  // of each block, ascending in a row, the diagonal among them
  std::vector<std::uint32_t> diagonal_;
  std::vector<Block> blocks_;
  std::vector<Edge> edges_;  // one more than there are, so that each ends where the next begins
  std::vector<Share> shares_;
  std::vector<std::array<double, 12>> inverse_;  // by node, three columns of four
};

}  // namespace bodkin
