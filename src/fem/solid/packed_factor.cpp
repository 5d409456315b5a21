#include "fem/solid/packed_factor.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/simd.h"
#include "core/thread_pool.h"

namespace bodkin::fem {

namespace {

constexpr std::size_t strip = strip_rows;
constexpr std::size_t numbers_at_once = std::size_t{1} << 16U;  // that one thread packs

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
  const double* own;          // packed triangle, with the inverse of its diagonal in place
  const double* below;        // packed strips
  std::size_t width, height;  // numbers: own columns; rows below
  std::size_t first;          // the supernode's first equation
  const std::uint32_t* rows;  // below, in nodes
  std::size_t lead;           // between the columns of a point
  double* const* points;      // three columns each, over the equations on their paths
  std::size_t count;
};

// x of the supernode := L^-1 x, and its product subtracted from the rows below.
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

// One supernode of a backward substitution, for several points.
struct BackStep {
  const double* own;  // as of SweepStep, all of it
  const double* below;
  std::size_t width, height;
  std::size_t first;
  const std::uint32_t* rows;
  std::size_t lead;
  double* columns;  // three per point, over all equations
  std::size_t count;
  double* sums;  // 3 x count x width lanes, to be subtracted from each of the supernode's equations
};

// For three columns: sums of column k += the strip's numbers, lane by lane, times x.
BODKIN_LANES_INLINE void add_transposed(const double* numbers, std::size_t columns,
                                        const std::array<std::array<double, strip>, 3>& x, std::size_t width,
                                        double* sums) noexcept {
  const Lanes low0 = *lanes_at(x[0].data()), high0 = *lanes_at(x[0].data() + lane_count);
  const Lanes low1 = *lanes_at(x[1].data()), high1 = *lanes_at(x[1].data() + lane_count);
  const Lanes low2 = *lanes_at(x[2].data()), high2 = *lanes_at(x[2].data() + lane_count);
  double *const sums1 = sums + lane_count * width, *const sums2 = sums1 + lane_count * width;
  for (std::size_t k = 0; k < columns; ++k) {
    const Lanes low = *lanes_at(numbers + strip * k), high = *lanes_at(numbers + strip * k + lane_count);
    *lanes_at(sums + lane_count * k) += low * low0 + high * high0;
    *lanes_at(sums1 + lane_count * k) += low * low1 + high * high1;
    *lanes_at(sums2 + lane_count * k) += low * low2 + high * high2;
  }
}

// x of the supernode := L^-T x, with the rows below known.
BODKIN_LANES_INLINE void back_inline(const BackStep& step) noexcept {
  const std::size_t of_point = 3 * lane_count * step.width;
  for (std::size_t i = 0; i < step.count * of_point; ++i) step.sums[i] = 0.0;
  std::array<std::array<double, strip>, 3> x;
  const double* numbers = step.below;
  for (std::size_t first = 0; first < step.height; first += strip) {
    const std::size_t here = step.height - first < strip ? step.height - first : strip;
    for (std::size_t p = 0; p < step.count; ++p) {
      for (std::size_t c = 0; c < 3; ++c) {
        const double* const column = step.columns + (3 * p + c) * step.lead;
        for (std::size_t i = 0; i < strip; ++i) {
          const std::size_t row = first + i;
          x[c][i] = i < here ? column[3 * std::size_t{step.rows[row / 3]} + row % 3] : 0.0;
        }
      }
      add_transposed(numbers, step.width, x, step.width, step.sums + p * of_point);
    }
    numbers += strip * step.width;
  }
  for (std::size_t strips = strips_of(step.width); strips-- > 0;) {
    const std::size_t first = strip * strips, here = step.width - first < strip ? step.width - first : strip;
    const double* const beside = step.own + triangle_size(first);
    const double* const triangle = beside + strip * first;
    for (std::size_t p = 0; p < step.count; ++p) {
      double* const sums = step.sums + p * of_point;
      for (std::size_t c = 0; c < 3; ++c) {
        double* const own = step.columns + (3 * p + c) * step.lead + step.first + first;
        for (std::size_t i = strip; i-- > 0;) {
          x[c][i] = 0.0;
          if (i >= here) continue;
          double value = own[i] - sum_of_lanes(*lanes_at(sums + lane_count * (c * step.width + first + i)));
          for (std::size_t j = i + 1; j < here; ++j) value -= triangle[strip * i + j] * x[c][j];
          own[i] = x[c][i] = value * triangle[strip * i + i];
        }
      }
      add_transposed(beside, first, x, step.width, sums);
    }
  }
}

BODKIN_PROCESSOR_CLONES
void back_widest(const BackStep& step) noexcept {
  back_inline(step);
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
  for (std::size_t s = 0; s < layout_.parts.size(); ++s) take(s, factor.kept_panel(s), alone);
}

PackedFactor::PackedFactor(const SymbolicFactor& symbolic) : layout_(symbolic) {}

PackedFactor::PackedFactor(FactorLayout layout, MappedFile file, std::size_t at)
    : layout_(std::move(layout)),
      file_(std::move(file)),
      numbers_(reinterpret_cast<const double*>(file_.bytes().data() + at)) {}

std::size_t PackedFactor::bytes() const noexcept {
  return sizeof(double) * layout_.numbers + layout_.bytes();
}

void PackedFactor::take(std::size_t supernode, const double* panel, ThreadPool& pool) {
  if (numbers_ == nullptr) {  // only after the memory was found to suffice
    pages_ = ZeroPages(layout_.numbers);
    numbers_ = pages_.data();
  }
  const Part& part = layout_.parts[supernode];
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
  double* to = pages_.data() + part.own_at + triangle_size(first);
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
  double* to = pages_.data() + part.below_at + first * width;
  for (std::size_t k = 0; k < width; ++k, to += strip) std::copy_n(panel + k * height + width + first, rows, to);
}

std::vector<PointResponse> PackedFactor::respond(std::span<const CarriedPoint> points, Kernel kernel) const {
  std::vector<std::vector<bool>> meets(points.size(), std::vector<bool>(layout_.parts.size(), false));
  std::vector<bool> met(layout_.parts.size(), false);
  for (std::size_t p = 0; p < points.size(); ++p) {
    for (const CarriedPoint::Share& share : points[p].shares) {
      for (std::uint32_t at = layout_.part_of[layout_.position[share.node]]; !meets[p][at];
           at = layout_.parts[at].parent)
        meets[p][at] = met[at] = true;
    }
  }
  // Only the equations on the points' paths take part, a few per cent: these are renumbered, so that neither memory
  // nor clearing it grows with the body.
  std::vector<std::uint32_t> begin(layout_.parts.size(), 0);
  std::uint32_t nodes_met = 0;
  for (std::uint32_t s = 0; s < layout_.parts.size(); ++s) {
    begin[s] = nodes_met;
    if (met[s]) nodes_met += layout_.parts[s].columns;
  }
  const auto place_of = [this, &begin](std::uint32_t position) {
    const std::uint32_t part = layout_.part_of[position];
    return begin[part] + (position - layout_.parts[part].first);
  };
  const std::size_t lead = 3 * std::size_t{nodes_met};
  std::vector<double> columns(3 * lead * points.size(), 0.0);
  for (std::size_t p = 0; p < points.size(); ++p) {
    for (const CarriedPoint::Share& share : points[p].shares) {
      const std::size_t at = 3 * std::size_t{place_of(layout_.position[share.node])};
      for (std::size_t c = 0; c < 3; ++c) columns[(3 * p + c) * lead + at + c] += share.weight;
    }
  }
  std::vector<std::uint32_t> rows;
  std::vector<PointResponse> responses(points.size());
  std::vector<double*> here;
  std::vector<std::size_t> which;
  for (std::uint32_t s = 0; s < layout_.parts.size(); ++s) {
    if (!met[s]) continue;
    const Part& part = layout_.parts[s];
    here.clear();
    which.clear();
    for (std::size_t p = 0; p < points.size(); ++p) {
      if (!meets[p][s]) continue;
      here.push_back(columns.data() + 3 * p * lead);
      which.push_back(p);
    }
    rows.clear();
    for (std::size_t k = 0; k < part.rows; ++k) rows.push_back(place_of(layout_.rows[part.rows_at + k]));
    const SweepStep step{.own = numbers_ + part.own_at,
                         .below = numbers_ + part.below_at,
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

Eigen::MatrixXd PackedFactor::displacements(std::span<const PointResponse> points,
                                            std::span<const std::uint32_t> wanted) const {
  std::vector<bool> met(layout_.parts.size(), false);
  for (const std::uint32_t node : wanted)
    for (std::uint32_t at = layout_.part_of[layout_.position[node]]; !met[at]; at = layout_.parts[at].parent)
      met[at] = true;
  const std::size_t lead = 3 * layout_.position.size();
  std::vector<double> columns(3 * lead * points.size(), 0.0);
  for (std::size_t p = 0; p < points.size(); ++p) {
    for (const PointResponse::Piece& piece : points[p].path) {
      const std::size_t first = 3 * std::size_t{layout_.parts[piece.supernode].first};
      for (std::size_t c = 0; c < 3; ++c)
        std::copy_n(points[p].numbers.data() + piece.at + c * piece.length,
                    3 * std::size_t{layout_.parts[piece.supernode].columns},
                    columns.data() + (3 * p + c) * lead + first);
    }
  }
  std::size_t widest = 0;
  for (const Part& part : layout_.parts) widest = std::max(widest, 3 * std::size_t{part.columns});
  std::vector<double> sums(3 * lane_count * widest * points.size());
  for (std::size_t s = layout_.parts.size(); s-- > 0;) {
    if (!met[s]) continue;
    const Part& part = layout_.parts[s];
    back_widest({.own = numbers_ + part.own_at,
                 .below = numbers_ + part.below_at,
                 .width = 3 * std::size_t{part.columns},
                 .height = 3 * std::size_t{part.rows},
                 .first = 3 * std::size_t{part.first},
                 .rows = layout_.rows.data() + part.rows_at,
                 .lead = lead,
                 .columns = columns.data(),
                 .count = points.size(),
                 .sums = sums.data()});
  }
  Eigen::MatrixXd found(static_cast<Eigen::Index>(3 * wanted.size()), static_cast<Eigen::Index>(3 * points.size()));
  for (std::size_t column = 0; column < 3 * points.size(); ++column)
    for (std::size_t i = 0; i < wanted.size(); ++i)
      std::copy_n(columns.data() + column * lead + 3 * std::size_t{layout_.position[wanted[i]]}, 3,
                  found.data() + 3 * (column * wanted.size() + i));
  return found;
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
