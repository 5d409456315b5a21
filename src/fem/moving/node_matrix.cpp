#include "fem/moving/node_matrix.h"

#include <algorithm>
#include <tuple>

#include "core/simd.h"

namespace bodkin::fem {

namespace {

BODKIN_LANES_INLINE void widen(const std::array<float, 4>& column, Lanes& wide) {
  wide = __builtin_convertvector(*reinterpret_cast<const FloatLanes*>(column.data()), Lanes);
}

// The order of the nodes in sweeps: that of the mesh, except that nodes whose neighbours were just processed come
// later, so that the processor need not wait for these.
std::vector<std::uint32_t> sweep_order(const std::vector<std::vector<std::uint32_t>>& neighbours) {
  constexpr std::size_t window = 64, apart = 4;
  const auto count = static_cast<std::uint32_t>(neighbours.size());
  std::vector<std::uint32_t> order, waiting;
  std::vector<std::size_t> blocked_until(count, 0);
  order.reserve(count);
  for (std::uint32_t next = 0; order.size() < count;) {
    while (waiting.size() < window && next < count) waiting.push_back(next++);
    auto chosen = std::find_if(waiting.begin(), waiting.end(),
                               [&](std::uint32_t node) { return blocked_until[node] <= order.size(); });
    if (chosen == waiting.end()) chosen = waiting.begin();
    const std::uint32_t node = *chosen;
    waiting.erase(chosen);
    order.push_back(node);
    for (const std::uint32_t other : neighbours[node]) blocked_until[other] = order.size() + apart;
  }
  return order;
}

}  // namespace

NodeMatrix::NodeMatrix(const anatomy::TetrahedralMesh& mesh) {
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
  for (std::size_t k = 0; k < found.size(); ++k) {
    const auto [i, j, share] = found[k];
    shares_.push_back(share);
    if (k > 0 && std::get<0>(found[k - 1]) == i && std::get<1>(found[k - 1]) == j) continue;
    edges_.push_back({i, j, static_cast<std::uint32_t>(k)});
    neighbours[i].push_back(j);
    neighbours[j].push_back(i);
  }
  order_ = sweep_order(neighbours);
  std::vector<std::uint32_t> place_of(count);
  for (std::uint32_t place = 0; place < count; ++place) place_of[order_[place]] = place;
  const auto place_row = [&](std::uint32_t row, bool below) {
    for (const std::uint32_t other : neighbours[row])
      if ((place_of[other] < place_of[row]) == below) column_.push_back(other);
  };
  for (const std::uint32_t row : order_) {
    std::sort(neighbours[row].begin(), neighbours[row].end());
    below_.push_back(static_cast<std::uint32_t>(column_.size()));
    place_row(row, true);
  }
  below_.push_back(static_cast<std::uint32_t>(column_.size()));
  column_.insert(column_.end(), order_.begin(), order_.end());
  for (std::size_t place = count; place-- > 0;) {
    above_.push_back(static_cast<std::uint32_t>(column_.size()));
    place_row(order_[place], false);
  }
  above_.push_back(static_cast<std::uint32_t>(column_.size()));
  const auto find_block = [&](std::uint32_t row, std::uint32_t column) {
    const std::uint32_t place = place_of[row];
    const Range range = place_of[column] < place ? below(place) : above(place);
    const auto first = column_.begin() + range.first, last = column_.begin() + range.last;
    return static_cast<std::uint32_t>(std::lower_bound(first, last, column) - column_.begin());
  };
  for (Edge& edge : edges_) {
    const std::uint32_t i = edge.upper, j = edge.lower;
    edge.upper = find_block(i, j);
    edge.lower = find_block(j, i);
  }
  edges_.push_back({0, 0, static_cast<std::uint32_t>(shares_.size())});
  blocks_.resize(column_.size(), Block{});
  inverse_.resize(count, Block{});
  free_.resize(count);
}

BODKIN_PROCESSOR_CLONES
void NodeMatrix::assemble_edges(std::span<const Edge> edges, const Share* shares, const TurnedElement* elements,
                                float factor, Block* blocks) noexcept {
  for (std::size_t edge = 0; edge + 1 < edges.size(); ++edge) {
    FloatLanes column[3] = {};
    for (std::uint32_t share = edges[edge].first_share; share < edges[edge + 1].first_share; ++share) {
      const TurnedElement& element = elements[shares[share] / 16];
      const std::array<float, 3>&a = element.gradient[shares[share] / 4 % 4],
                              &b = element.gradient[shares[share] % 4];
      const FloatLanes ga = {a[0], a[1], a[2], 0.0F}, gb = {b[0], b[1], b[2], 0.0F};
      const float turned = element.both * ((a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]);
      const FloatLanes across = element.across * ga, along = element.along * gb;
      column[0] += across * b[0] + along * a[0] + FloatLanes{turned, 0.0F, 0.0F, 0.0F};
      column[1] += across * b[1] + along * a[1] + FloatLanes{0.0F, turned, 0.0F, 0.0F};
      column[2] += across * b[2] + along * a[2] + FloatLanes{0.0F, 0.0F, turned, 0.0F};
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
  for (std::uint32_t place = 0; place < nodes(); ++place) {
    std::array<std::array<double, 3>, 3> sum{};
    for (const Range range : {below(place), above(place)}) {
      for (std::uint32_t k = range.first; k < range.last; ++k) {
        for (std::size_t j = 0; j < 3; ++j) {
          for (std::size_t i = 0; i < 3; ++i) sum[j][i] -= static_cast<double>(blocks_[k].column[j][i]);
        }
      }
    }
    Block& own = blocks_[own_block(place)];
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t i = 0; i < 3; ++i) {
        const double here = 0.5 * (sum[j][i] + sum[i][j]) + (i == j ? diagonal[order_[place]] : 0.0);
        own.column[j][i] = static_cast<float>(here);
      }
    }
  }
}

BODKIN_PROCESSOR_CLONES
void NodeMatrix::multiply_rows(const NodeMatrix& matrix, const double* vector, double* product) noexcept {
  for (std::uint32_t place = 0; place < matrix.nodes(); ++place) {
    Lanes x = {}, y = {}, z = {};
    const std::uint32_t own = matrix.own_block(place);
    for (const Range range : {matrix.below(place), Range{own, own + 1}, matrix.above(place)}) {
      for (std::uint32_t k = range.first; k < range.last; ++k) {
        const double* from = vector + 4 * std::size_t{matrix.column_[k]};
        Lanes a, b, c;
        widen(matrix.blocks_[k].column[0], a);
        widen(matrix.blocks_[k].column[1], b);
        widen(matrix.blocks_[k].column[2], c);
        x += a * from[0];
        y += b * from[1];
        z += c * from[2];
      }
    }
    *lanes_at(product + 4 * std::size_t{matrix.order_[place]}) = (x + y) + z;
  }
}

void NodeMatrix::multiply(const NodeVectors& vector, NodeVectors& product) const noexcept {
  multiply_rows(*this, vector.data(), product.data());
}

void NodeMatrix::invert_diagonal(std::span<const std::uint8_t> held) noexcept {
  free_count_ = 0;
  for (std::uint32_t place = 0; place < nodes(); ++place) {
    if (held[order_[place]] != 0) continue;
    const auto& m = blocks_[own_block(place)].column;
    const double xx = m[0][0], yy = m[1][1], zz = m[2][2], xy = m[0][1], xz = m[0][2], yz = m[1][2];
    const double a = yy * zz - yz * yz, b = xz * yz - xy * zz, c = xy * yz - xz * yy;
    const double determinant = xx * a + xy * b + xz * c;
    const double size = xx + yy + zz;
    if (!(xx > 0.0 && xx * yy - xy * xy > 0.0 && determinant > 1e-9 * size * size * size)) continue;
    free_[free_count_++] = place;
    const auto part = [determinant](double minor) { return static_cast<float>(minor / determinant); };
    const float d = part(xy * xz - xx * yz);
    inverse_[place].column = {{{part(a), part(b), part(c), 0.0F},
                               {part(b), part(xx * zz - xz * xz), d, 0.0F},
                               {part(c), d, part(xx * yy - xy * xy), 0.0F}}};
  }
}

// Sum of the blocks `first` to `last` times x.
BODKIN_LANES_INLINE void add_blocks(const std::uint32_t* column, const NodeMatrix::Block* blocks, std::uint32_t first,
                                    std::uint32_t last, const float* x, FloatLanes& sum) {
  FloatLanes a = {}, b = {}, c = {};
  for (std::uint32_t k = first; k < last; ++k) {
    const float* from = x + 4 * std::size_t{column[k]};
    const auto* columns = reinterpret_cast<const FloatLanes*>(&blocks[k]);
    a += columns[0] * from[0];
    b += columns[1] * from[1];
    c += columns[2] * from[2];
  }
  sum = (a + b) + c;
}

BODKIN_LANES_INLINE void multiply_block(const NodeMatrix::Block& block, const FloatLanes& x, FloatLanes& product) {
  const auto* columns = reinterpret_cast<const FloatLanes*>(&block);
  product = (columns[0] * x[0] + columns[1] * x[1]) + columns[2] * x[2];
}

BODKIN_LANES_INLINE FloatLanes& at_node(float* vector, std::size_t node) {
  return *reinterpret_cast<FloatLanes*>(vector + 4 * node);
}
BODKIN_LANES_INLINE const FloatLanes& at_node(const float* vector, std::size_t node) {
  return *reinterpret_cast<const FloatLanes*>(vector + 4 * node);
}

BODKIN_PROCESSOR_CLONES
void NodeMatrix::sweep_down(const NodeMatrix& matrix, const float* right, float* x, float* scaled) noexcept {
  for (std::size_t i = 0; i < matrix.free_count_; ++i) {
    const std::uint32_t place = matrix.free_[i], node = matrix.order_[place];
    const Range range = matrix.below(place);
    FloatLanes sum;
    add_blocks(matrix.column_.data(), matrix.blocks_.data(), range.first, range.last, x, sum);
    sum = at_node(right, node) - sum;
    at_node(scaled, node) = sum;
    multiply_block(matrix.inverse_[place], sum, at_node(x, node));
  }
}

BODKIN_PROCESSOR_CLONES
void NodeMatrix::sweep_up(const NodeMatrix& matrix, const float* right, float* x, float* above) noexcept {
  for (std::size_t i = matrix.free_count_; i-- > 0;) {
    const std::uint32_t place = matrix.free_[i], node = matrix.order_[place];
    const Range range = matrix.above(place);
    FloatLanes sum;
    add_blocks(matrix.column_.data(), matrix.blocks_.data(), range.first, range.last, x, sum);
    at_node(above, node) = sum;
    multiply_block(matrix.inverse_[place], at_node(right, node) - sum, at_node(x, node));
  }
}

void NodeMatrix::solve_lower(const SingleVectors& right, SingleVectors& x, SingleVectors& scaled) const noexcept {
  sweep_down(*this, right.data(), x.data(), scaled.data());
}

void NodeMatrix::solve_upper(const SingleVectors& right, SingleVectors& x, SingleVectors& above) const noexcept {
  sweep_up(*this, right.data(), x.data(), above.data());
}

}  // namespace bodkin::fem
