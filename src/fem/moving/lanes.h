#pragma once

#include <array>
#include <cstddef>

namespace bodkin {

// Four numbers at once, one for each of four elements: what the compiler makes of it is two SSE2 or one AVX2
// operation, with the same bits. Only for functions marked BODKIN_PROCESSOR_CLONES and what is inlined into them.
inline constexpr std::size_t lane_count = 4;
using Lanes = double __attribute__((vector_size(32), aligned(32)));
using LaneMask = long long __attribute__((vector_size(32), aligned(32)));
static_assert(sizeof(Lanes) == lane_count * sizeof(double));

// Vectors and matrices of lanes; a matrix is its columns.
struct LaneVector {
  Lanes x, y, z;
};
struct LaneMatrix {
  LaneVector column[3];
};

#define BODKIN_LANES_INLINE [[gnu::always_inline]] inline

BODKIN_LANES_INLINE void cross_lanes(const LaneVector& a, const LaneVector& b, LaneVector& product) {
  product.x = a.y * b.z - a.z * b.y;
  product.y = a.z * b.x - a.x * b.z;
  product.z = a.x * b.y - a.y * b.x;
}

BODKIN_LANES_INLINE void dot_lanes(const LaneVector& a, const LaneVector& b, Lanes& product) {
  product = a.x * b.x + a.y * b.y + a.z * b.z;
}

// sum += factor a
BODKIN_LANES_INLINE void add_lanes(const LaneVector& a, const Lanes& factor, LaneVector& sum) {
  sum.x += factor * a.x;
  sum.y += factor * a.y;
  sum.z += factor * a.z;
}

// product = matrix vector
BODKIN_LANES_INLINE void multiply_lanes(const LaneMatrix& m, const LaneVector& v, LaneVector& product) {
  product.x = m.column[0].x * v.x + m.column[1].x * v.y + m.column[2].x * v.z;
  product.y = m.column[0].y * v.x + m.column[1].y * v.y + m.column[2].y * v.z;
  product.z = m.column[0].z * v.x + m.column[1].z * v.y + m.column[2].z * v.z;
}

// product = a^T b
BODKIN_LANES_INLINE void multiply_transposed_lanes(const LaneMatrix& a, const LaneMatrix& b, LaneMatrix& product) {
  for (int j = 0; j < 3; ++j) {
    dot_lanes(a.column[0], b.column[j], product.column[j].x);
    dot_lanes(a.column[1], b.column[j], product.column[j].y);
    dot_lanes(a.column[2], b.column[j], product.column[j].z);
  }
}

}  // namespace bodkin
