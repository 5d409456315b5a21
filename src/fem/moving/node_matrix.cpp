#include "fem/moving/node_matrix.h"

#include <algorithm>
#include <tuple>

#include "fem/moving/lanes.h"
#include "fem/processor_clones.h"

namespace bodkin {

namespace {

using SingleLanes = float __attribute__((vector_size(16), may_alias));
using LooseLanes = double __attribute__((vector_size(32), aligned(8), may_alias));

BODKIN_LANES_INLINE void widen(const std::array<float, 4>& column, Lanes& wide) {
  wide = __builtin_convertvector(*reinterpret_cast<const SingleLanes*>(column.data()), Lanes);
}

}  // namespace

NodeMatrix::NodeMatrix(const TetrahedralMesh& mesh) {
  const std::size_t count = mesh.nodes.size();
  std::vector<std::tuple<std::uint32_t, std::uint32_t, Share>> found;  // ascending pairs
  for (std::uint32_t element = 0; element < mesh.elements.size(); ++element) {
    for (std::uint32_t a = 0; a < 4; ++a) {
      for (std::uint32_t b = 0; b < 4; ++b) {
        const std::uint32_t i = mesh.elements[element][a], j = mesh.elements[element][b];
        if (i < j) found.emplace_back(i, j, 16 * element + 4 * a + b);
      }
    }
  }
  std::sort(found.begin(), found.end());
  std::vector<std::vector<std::uint32_t>> neighbours(count);
  for (std::uint32_t node = 0; node < count; ++node) neighbours[node].push_back(node);
  for (std::size_t k = 0; k < found.size(); ++k) {
    const auto [i, j, share] = found[k];
    shares_.push_back(share);
    if (k > 0 && std::get<0>(found[k - 1]) == i && std::get<1>(found[k - 1]) == j) continue;
    edges_.push_back({i, j, static_cast<std::uint32_t>(k)});
    neighbours[i].push_back(j);
    neighbours[j].push_back(i);
  }
  start_.push_back(0);
  for (std::uint32_t node = 0; node < count; ++node) {
    std::sort(neighbours[node].begin(), neighbours[node].end());
    for (const std::uint32_t other : neighbours[node]) {
      if (other == node) diagonal_.push_back(static_cast<std::uint32_t>(column_.size()));
      column_.push_back(other);
    }
    start_.push_back(static_cast<std::uint32_t>(column_.size()));
  }
  const auto place_of_block = [this](std::uint32_t row, std::uint32_t column) {
    const auto first = column_.begin() + start_[row], last = column_.begin() + start_[row + 1];
    return static_cast<std::uint32_t>(std::lower_bound(first, last, column) - column_.begin());
  };
  for (Edge& edge : edges_) {
    const std::uint32_t i = edge.upper, j = edge.lower;
    edge.upper = place_of_block(i, j);
    edge.lower = place_of_block(j, i);
  }
  edges_.push_back({0, 0, static_cast<std::uint32_t>(shares_.size())});
  blocks_.resize(column_.size(), Block{});
  inverse_.resize(count, std::array<double, 12>{});
}

BODKIN_PROCESSOR_CLONES
void NodeMatrix::assemble_edges(std::span<const Edge> edges, const Share* shares, const TurnedElement* elements,
                                float factor, Block* blocks) noexcept {
  for (std::size_t edge = 0; edge + 1 < edges.size(); ++edge) {
    SingleLanes column[3] = {};
    for (std::uint32_t share = edges[edge].first_share; share < edges[edge + 1].first_share; ++share) {
      const TurnedElement& element = elements[shares[share] / 16];
      const std::array<float, 3>&a = element.gradient[shares[share] / 4 % 4],
                              &b = element.gradient[shares[share] % 4];
      const SingleLanes ga = {a[0], a[1], a[2], 0.0F}, gb = {b[0], b[1], b[2], 0.0F};
      const float turned = element.both * ((a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]);
      const SingleLanes across = element.across * ga, along = element.along * gb;
      column[0] += across * b[0] + along * a[0] + SingleLanes{turned, 0.0F, 0.0F, 0.0F};
      column[1] += across * b[1] + along * a[1] + SingleLanes{0.0F, turned, 0.0F, 0.0F};
      column[2] += across * b[2] + along * a[2] + SingleLanes{0.0F, 0.0F, turned, 0.0F};
    }
    Block &upper = blocks[edges[edge].upper], &lower = blocks[edges[edge].lower];
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t i = 0; i < 3; ++i) lower.column[i][j] = upper.column[j][i] = factor * column[j][i];
    }
  }
}

void NodeMatrix::assemble(const std::vector<TurnedElement>& elements, double factor,
                          std::span<const double> diagonal) noexcept {
  assemble_edges(edges_, shares_.data(), elements.data(), static_cast<float>(factor), blocks_.data());
  for (std::size_t node = 0; node < nodes(); ++node) {
    std::array<std::array<double, 3>, 3> sum{};
    for (std::uint32_t k = start_[node]; k < start_[node + 1]; ++k) {
      if (k == diagonal_[node]) continue;
      for (std::size_t j = 0; j < 3; ++j) {
        for (std::size_t i = 0; i < 3; ++i) sum[j][i] -= static_cast<double>(blocks_[k].column[j][i]);
      }
    }
    Block& own = blocks_[diagonal_[node]];
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t i = 0; i < 3; ++i) {
        const double here = 0.5 * (sum[j][i] + sum[i][j]) + (i == j ? diagonal[node] : 0.0);
        own.column[j][i] = static_cast<float>(here);
      }
    }
  }
}

BODKIN_PROCESSOR_CLONES
void NodeMatrix::multiply_rows(const std::uint32_t* start, const std::uint32_t* column, const Block* blocks,
                               std::size_t rows, const double* vector, double* product) noexcept {
  for (std::size_t row = 0; row < rows; ++row) {
    Lanes x = {}, y = {}, z = {};
    for (std::uint32_t k = start[row]; k < start[row + 1]; ++k) {
      const double* from = vector + 4 * std::size_t{column[k]};
      Lanes a, b, c;
      widen(blocks[k].column[0], a);
      widen(blocks[k].column[1], b);
      widen(blocks[k].column[2], c);
      x += a * from[0];
      y += b * from[1];
      z += c * from[2];
    }
    *reinterpret_cast<LooseLanes*>(product + 4 * row) = (x + y) + z;
  }
}

void NodeMatrix::multiply(const NodeVectors& vector, NodeVectors& product) const noexcept {
  multiply_rows(start_.data(), column_.data(), blocks_.data(), nodes(), vector.data(), product.data());
}

void NodeMatrix::invert_diagonal(std::span<const std::uint8_t> held) noexcept {
  for (std::size_t node = 0; node < nodes(); ++node) {
    std::array<double, 12>& inverse = inverse_[node];
    inverse.fill(0.0);
    if (held[node] != 0) continue;
    const auto& m = blocks_[diagonal_[node]].column;
    const double xx = m[0][0], yy = m[1][1], zz = m[2][2], xy = m[0][1], xz = m[0][2], yz = m[1][2];
    const double a = yy * zz - yz * yz, b = xz * yz - xy * zz, c = xy * yz - xz * yy;
    const double determinant = xx * a + xy * b + xz * c;
    const double size = xx + yy + zz;
    if (!(xx > 0.0 && xx * yy - xy * xy > 0.0 && determinant > 1e-9 * size * size * size)) continue;
    const double by = 1.0 / determinant;
    inverse = {a * by,
               b * by,
               c * by,
               0.0,
               b * by,
               (xx * zz - xz * xz) * by,
               (xy * xz - xx * yz) * by,
               0.0,
               c * by,
               (xy * xz - xx * yz) * by,
               (xx * yy - xy * xy) * by,
               0.0};
  }
}

void NodeMatrix::multiply_by_inverse_diagonal(const NodeVectors& vector, NodeVectors& product) const noexcept {
  for (std::size_t node = 0; node < nodes(); ++node) {
    const std::array<double, 12>& inverse = inverse_[node];
    const double* from = vector.data() + 4 * node;
    double* to = product.data() + 4 * node;
    for (std::size_t i = 0; i < 4; ++i)
      to[i] = inverse[i] * from[0] + inverse[4 + i] * from[1] + inverse[8 + i] * from[2];
  }
}

}  // namespace bodkin
