#pragma once

#include <cstddef>
#include <cstdint>

// Data-parallel arithmetic on the vector extensions of GCC and Clang. The compiler maps four doubles to two SSE2 or
// NEON registers or one AVX2 register. Every element is computed as in scalar code, and floating point is strict
// (-ffp-contract=off), so results have the same bits on every processor.

// Put it before a function: the function is compiled for every x86-64 processor and again for those with AVX2
// (without fused multiply-add), and the program chooses at start. A function outside a class must not have an earlier
// declaration without this macro, for example in a header, or Clang omits the versions. Other compilers and
// processors, and the sanitizers, get only the plain version.
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define BODKIN_ONE_VERSION
#endif
#endif
#if defined(__x86_64__) && defined(__GNUC__) && defined(__linux__) && !defined(BODKIN_ONE_VERSION)
#define BODKIN_PROCESSOR_CLONES __attribute__((target_clones("default", "avx2")))
#else
#define BODKIN_PROCESSOR_CLONES
#endif

// For functions called by them: a function that is not inlined would not be compiled for AVX2, and a function
// compiled with options for a newer processor must not be shared with files that are compiled without. Vectors are
// passed by reference because passing by value depends on the processor.
#define BODKIN_LANES_INLINE [[gnu::always_inline]] inline

namespace bodkin {

// Four doubles ("lanes"), and the result of comparing them: all bits of a lane are set where the comparison holds.
// AVX2 expects multiples of 32 bytes as their addresses; without it GCC would use multiples of 16.
inline constexpr std::size_t lane_count = 4;
using Lanes [[gnu::aligned(32)]] = double __attribute__((vector_size(32)));
using LaneMask [[gnu::aligned(32)]] = long long __attribute__((vector_size(32)));
// Four doubles anywhere in an array, and four floats at a multiple of 16 bytes in one.
using UnalignedLanes [[gnu::aligned(8), gnu::may_alias]] = double __attribute__((vector_size(32)));
using FloatLanes [[gnu::may_alias]] = float __attribute__((vector_size(16)));
static_assert(sizeof(Lanes) == lane_count * sizeof(double));
static_assert(alignof(Lanes) == 32 && alignof(LaneMask) == 32 && alignof(UnalignedLanes) == alignof(double));

// The four doubles from `numbers` on. A pointer, because Clang assumes that references are aligned.
BODKIN_LANES_INLINE const UnalignedLanes* lanes_at(const double* numbers) {
  return reinterpret_cast<const UnalignedLanes*>(numbers);
}
BODKIN_LANES_INLINE UnalignedLanes* lanes_at(double* numbers) {
  return reinterpret_cast<UnalignedLanes*>(numbers);
}

BODKIN_LANES_INLINE double sum_of_lanes(const Lanes& a) {
  return (a[0] + a[1]) + (a[2] + a[3]);
}

// Four vectors and four matrices of three dimensions; a matrix is stored as its columns.
struct LaneVector {
  Lanes x, y, z;
};
struct LaneMatrix {
  LaneVector column[3];
};

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

// Arithmetic on single numbers that the compiler turns into vector instructions in a loop.

// x, limited to the bounds; `high` where low > high.
BODKIN_LANES_INLINE float bounded(float x, float low, float high) noexcept {
  const float above = low > x ? low : x;
  return high < above ? high : above;
}

BODKIN_LANES_INLINE float float_from_bits(std::uint32_t bits) noexcept {
  return __builtin_bit_cast(float, bits);
}

}  // namespace bodkin
