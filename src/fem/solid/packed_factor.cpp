#include "fem/solid/packed_factor.h"

#include <algorithm>
#include <array>

#include "core/simd.h"
#include "core/thread_pool.h"

namespace bodkin::fem {

namespace {

// The factor is packed in strips of this many rows: for each column of the supernode, the strip's numbers in it.
constexpr std::size_t strip = 8;
constexpr std::size_t numbers_at_once = std::size_t{1} << 16U;  // that one thread packs

constexpr std::size_t strips_of(std::size_t rows) {
  return (rows + strip - 1) / strip;
}

// Numbers in the packed triangle: strip i has 8 (i + 1) columns.
constexpr std::size_t triangle_size(std::size_t width) {
  const std::size_t strips = strips_of(width);
  return strip * strip * strips * (strips + 1) / 2;
}

using StripSums = std::array<std::array<double, strip>, 3>;

// sums[c][i] = sum over k < columns of numbers[8 k + i] x[c lead + k].
BODKIN_LANES_INLINE void strip_products(const double* numbers, std::size_t columns, const double* x, std::size_t lead,
                                        StripSums& sums) noexcept {
  Lanes low0 = {}, high0 = {}, low1 = {}, high1 = {}, low2 = {}, high2 = {};
  const double *const x0 = x, *const x1 = x + lead, *const x2 = x + 2 * lead;
  for (std::size_t k = 0; k < columns; ++k) {
    const Lanes low = *lanes_at(numbers + strip * k), high = *lanes_at(numbers + strip * k + lane_count);
    low0 += low * x0[k];
    high0 += high * x0[k];
    low1 += low * x1[k];
    high1 += high * x1[k];
    low2 += low * x2[k];
    high2 += high * x2[k];
  }
  *lanes_at(sums[0].data()) = low0;
  *lanes_at(sums[0].data() + lane_count) = high0;
  *lanes_at(sums[1].data()) = low1;
  *lanes_at(sums[1].data() + lane_count) = high1;
  *lanes_at(sums[2].data()) = low2;
  *lanes_at(sums[2].data() + lane_count) = high2;
}

// One supernode of a forward substitution, for several points.
struct SweepStep {
  const double* own;          // packed triangle, with the inverse of its diagonal in the place of that
  const double* below;        // packed strips
  std::size_t width, height;  // numbers: own columns; rows below
  std::size_t first;          // the supernode's first equation
  const std::uint32_t* rows;  // below, in nodes
  std::size_t lead;           // between the columns of a point
  double* const* points;      // three columns each, over the equations that are met
  std::size_t count;
};

// x of the supernode := L^-1 x, and taken from the rows below what follows.
BODKIN_LANES_INLINE void sweep_inline(const SweepStep& step) noexcept {
  StripSums sums;
  const double* numbers = step.own;
  for (std::size_t first = 0; first < step.width; first += strip) {
    const std::size_t here = step.width - first < strip ? step.width - first : strip;
    const double* const triangle = numbers + strip * first;
    for (std::size_t p = 0; p < step.count; ++p) {
      double* const own = step.points[p] + step.first;
      strip_products(numbers, first, own, step.lead, sums);
      for (std::size_t c = 0; c < 3; ++c) {
        double* const x = own + c * step.lead + first;
        for (std::size_t i = 0; i < here; ++i) {
          double value = x[i] - sums[c][i];
          for (std::size_t j = 0; j < i; ++j) value -= triangle[strip * j + i] * x[j];
          x[i] = value * triangle[strip * i + i];
        }
      }
    }
    numbers = triangle + strip * strip;
  }
  numbers = step.below;
  for (std::size_t first = 0; first < step.height; first += strip) {
    const std::size_t here = step.height - first < strip ? step.height - first : strip;
    for (std::size_t p = 0; p < step.count; ++p) {
      double* const x = step.points[p];
      strip_products(numbers, step.width, x + step.first, step.lead, sums);
      for (std::size_t i = 0; i < here; ++i) {
        const std::size_t row = first + i;
        double* const target = x + 3 * std::size_t{step.rows[row / 3]} + row % 3;
        for (std::size_t c = 0; c < 3; ++c) target[c * step.lead] -= sums[c][i];
      }
    }
    numbers += strip * step.width;
  }
}

BODKIN_PROCESSOR_CLONES
void sweep_widest(const SweepStep& step) noexcept {
  sweep_inline(step);
}

void sweep_plain(const SweepStep& step) noexcept {
  sweep_inline(step);
}

// sums[3 i + j] += a_i * b_j lane by lane, for three columns of `length` numbers each.
BODKIN_LANES_INLINE void products_inline(const double* a, const double* b, std::size_t length, Lanes* sums) noexcept {
  Lanes sum[9];
  for (std::size_t i = 0; i < 9; ++i) sum[i] = sums[i];
  for (std::size_t k = 0; k < length; k += lane_count) {
    const Lanes b0 = *lanes_at(b + k), b1 = *lanes_at(b + length + k), b2 = *lanes_at(b + 2 * length + k);
    for (std::size_t i = 0; i < 3; ++i) {
      const Lanes left = *lanes_at(a + i * length + k);
      sum[3 * i] += left * b0;
      sum[3 * i + 1] += left * b1;
      sum[3 * i + 2] += left * b2;
    }
  }
  for (std::size_t i = 0; i < 9; ++i) sums[i] = sum[i];
}

BODKIN_PROCESSOR_CLONES
void products_widest(const double* a, const double* b, std::size_t length, Lanes* sums) noexcept {
  products_inline(a, b, length, sums);
}

void products_plain(const double* a, const double* b, std::size_t length, Lanes* sums) noexcept {
  products_inline(a, b, length, sums);
}

}  // namespace

PackedFactor::PackedFactor(const MultifrontalCholesky& factor) : PackedFactor(factor.symbolic()) {
  ThreadPool alone(1);
  for (std::size_t s = 0; s < parts_.size(); ++s) take(s, factor.kept_panel(s), alone);
}

PackedFactor::PackedFactor(const SymbolicFactor& symbolic) {
  position_ = symbolic.position;
  rows_ = symbolic.rows;
  part_of_.resize(position_.size());
  for (std::uint32_t s = 0; s < symbolic.supernodes.size(); ++s) {
    const Supernode& supernode = symbolic.supernodes[s];
    for (std::uint32_t k = 0; k < supernode.columns; ++k) part_of_[supernode.first + k] = s;
  }
  for (std::uint32_t s = 0; s < symbolic.supernodes.size(); ++s) {
    const Supernode& supernode = symbolic.supernodes[s];
    Part part;
    part.first = supernode.first;
    part.columns = supernode.columns;
    part.rows = supernode.rows;
    part.rows_at = supernode.rows_at;
    part.own_at = numbers_size_;
    part.below_at = part.own_at + triangle_size(supernode.width());
    part.parent = supernode.rows > 0 ? part_of_[rows_[supernode.rows_at]] : s;
    numbers_size_ = part.below_at + strip * strips_of(3 * std::size_t{supernode.rows}) * supernode.width();
    parts_.push_back(part);
  }
}

std::size_t PackedFactor::bytes() const noexcept {
  return sizeof(double) * numbers_size_ + sizeof(Part) * parts_.size() +
         sizeof(std::uint32_t) * (position_.size() + part_of_.size() + rows_.size());
}

void PackedFactor::take(std::size_t supernode, const double* panel, ThreadPool& pool) {
  if (numbers_.data() == nullptr) numbers_ = ZeroPages(numbers_size_);  // not before the memory was found to suffice
  const Part& part = parts_[supernode];
  const std::size_t width = 3 * std::size_t{part.columns};
  const std::size_t own = strips_of(width), all = own + strips_of(3 * std::size_t{part.rows});
  const std::size_t in_piece = std::max<std::size_t>(1, numbers_at_once / (strip * width));
  pool.run((all + in_piece - 1) / in_piece, [&](std::size_t piece) {
    for (std::size_t i = piece * in_piece; i < std::min(all, (piece + 1) * in_piece); ++i) {
      if (i < own)
        pack_own(part, panel, i);
      else
        pack_below(part, panel, i - own);
    }
  });
}

void PackedFactor::pack_own(const Part& part, const double* panel, std::size_t strip_number) {
  const std::size_t width = 3 * std::size_t{part.columns}, height = width + 3 * std::size_t{part.rows};
  const std::size_t first = strip * strip_number, rows = std::min(strip, width - first);
  double* to = numbers_.data() + part.own_at + triangle_size(first);
  for (std::size_t k = 0; k < first + strip; ++k, to += strip) {
    for (std::size_t i = 0; k < width && i < rows; ++i) {
      if (first + i > k) to[i] = panel[k * height + first + i];
      if (first + i == k) to[i] = 1.0 / panel[k * height + k];
    }
  }
}

void PackedFactor::pack_below(const Part& part, const double* panel, std::size_t strip_number) {
  const std::size_t width = 3 * std::size_t{part.columns}, below = 3 * std::size_t{part.rows};
  const std::size_t height = width + below, first = strip * strip_number, rows = std::min(strip, below - first);
  double* to = numbers_.data() + part.below_at + first * width;
  for (std::size_t k = 0; k < width; ++k, to += strip) std::copy_n(panel + k * height + width + first, rows, to);
}

std::vector<PointResponse> PackedFactor::respond(std::span<const CarriedPoint> points, Kernel kernel) const {
  std::vector<std::vector<bool>> meets(points.size(), std::vector<bool>(parts_.size(), false));
  std::vector<bool> met(parts_.size(), false);
  for (std::size_t p = 0; p < points.size(); ++p) {
    for (const CarriedPoint::Share& share : points[p].shares) {
      for (std::uint32_t at = part_of_[position_[share.node]]; !meets[p][at]; at = parts_[at].parent)
        meets[p][at] = met[at] = true;
    }
  }
  // Of all equations only those on the points' paths take part, a few of a hundred: these are numbered anew, so that
  // neither memory nor clearing it grows with the body.
  std::vector<std::uint32_t> begin(parts_.size(), 0);
  std::uint32_t nodes_met = 0;
  for (std::uint32_t s = 0; s < parts_.size(); ++s) {
    begin[s] = nodes_met;
    if (met[s]) nodes_met += parts_[s].columns;
  }
  const auto place_of = [this, &begin](std::uint32_t position) {
    const std::uint32_t part = part_of_[position];
    return begin[part] + (position - parts_[part].first);
  };
  const std::size_t lead = 3 * std::size_t{nodes_met};
  std::vector<double> columns(3 * lead * points.size(), 0.0);
  for (std::size_t p = 0; p < points.size(); ++p) {
    for (const CarriedPoint::Share& share : points[p].shares) {
      const std::size_t at = 3 * std::size_t{place_of(position_[share.node])};
      for (std::size_t c = 0; c < 3; ++c) columns[(3 * p + c) * lead + at + c] += share.weight;
    }
  }
  std::vector<std::uint32_t> rows;
  std::vector<PointResponse> responses(points.size());
  std::vector<double*> here;
  std::vector<std::size_t> which;
  for (std::uint32_t s = 0; s < parts_.size(); ++s) {
    if (!met[s]) continue;
    const Part& part = parts_[s];
    here.clear();
    which.clear();
    for (std::size_t p = 0; p < points.size(); ++p) {
      if (!meets[p][s]) continue;
      here.push_back(columns.data() + 3 * p * lead);
      which.push_back(p);
    }
    rows.clear();
    for (std::size_t k = 0; k < part.rows; ++k) rows.push_back(place_of(rows_[part.rows_at + k]));
    const SweepStep step{.own = numbers_.data() + part.own_at,
                         .below = numbers_.data() + part.below_at,
                         .width = 3 * std::size_t{part.columns},
                         .height = 3 * std::size_t{part.rows},
                         .first = 3 * std::size_t{begin[s]},
                         .rows = rows.data(),
                         .lead = lead,
                         .points = here.data(),
                         .count = here.size()};
    if (kernel == Kernel::widest)
      sweep_widest(step);
    else
      sweep_plain(step);
    const std::size_t length = (step.width + lane_count - 1) / lane_count * lane_count;
    for (const std::size_t p : which) {
      PointResponse& response = responses[p];
      const std::size_t at = response.numbers.size();
      response.path.push_back({s, at, length});
      response.numbers.resize(at + 3 * length, 0.0);
      for (std::size_t c = 0; c < 3; ++c) {
        const double* const from = columns.data() + (3 * p + c) * lead + step.first;
        std::copy_n(from, step.width, response.numbers.data() + at + c * length);
      }
    }
  }
  return responses;
}

Mat3 compliance_between(const PointResponse& a, const PointResponse& b, PackedFactor::Kernel kernel) {
  Lanes sums[9] = {};
  std::size_t i = 0, j = 0;
  while (i < a.path.size() && j < b.path.size()) {
    const PointResponse::Piece &one = a.path[i], &other = b.path[j];
    if (one.supernode == other.supernode) {
      const double *const left = a.numbers.data() + one.at, *const right = b.numbers.data() + other.at;
      if (kernel == PackedFactor::Kernel::widest)
        products_widest(left, right, one.length, sums);
      else
        products_plain(left, right, one.length, sums);
    }
    if (one.supernode <= other.supernode) ++i;
    if (other.supernode <= one.supernode) ++j;
  }
  Mat3 between;
  for (std::size_t k = 0; k < 9; ++k)
    between(static_cast<Eigen::Index>(k / 3), static_cast<Eigen::Index>(k % 3)) = sum_of_lanes(sums[k]);
  return between;
}

}  // namespace bodkin::fem
