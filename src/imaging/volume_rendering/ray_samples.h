// How the inner loops of the ray caster read a volume. Eight samples along a ray are computed at once: their
// positions and the interpolation between voxels are loops that the compiler turns into vector instructions, with the
// same bits as scalar ones.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/simd.h"
#include "imaging/volume_rendering/prepared_volume.h"
#include "imaging/volume_rendering/ray_kernel.h"

namespace bodkin::imaging::kernel {

inline constexpr int packet = 8;      // samples at once
inline constexpr int block_bits = 3;  // PreparedVolume::block voxels
inline constexpr int brick_row = PreparedVolume::brick_side, brick_slice = brick_row * brick_row;
inline constexpr auto brick_size = static_cast<int>(PreparedVolume::brick_size);
static_assert(PreparedVolume::block == 1 << block_bits);

// Eight numbers for vector arithmetic, with the same results as scalar arithmetic.
using Floats = float __attribute__((vector_size(4 * packet)));
using Ints = std::int32_t __attribute__((vector_size(4 * packet)));
// Unsigned, because none is negative, and widening is free.
using Indices = std::uint32_t __attribute__((vector_size(4 * packet)));
using Colour = float __attribute__((vector_size(16)));  // red, green, blue, and a fourth

struct Samples {
  Floats x, y, z;  // index
  Floats value;    // HU
};

// For eight positions: the voxels behind which they lie, and the distances behind them, 0 to 1.
struct Places {
  Indices offset;  // see PreparedVolume::offset()
  Floats fx, fy, fz;
};
BODKIN_LANES_INLINE void find_places(const Field& field, const Floats& x, const Floats& y, const Floats& z,
                                     Places& places) noexcept {
  const Ints i = __builtin_convertvector(x, Ints), j = __builtin_convertvector(y, Ints),
             k = __builtin_convertvector(z, Ints);
  places.fx = x - __builtin_convertvector(i, Floats);
  places.fy = y - __builtin_convertvector(j, Floats);
  places.fz = z - __builtin_convertvector(k, Floats);
  // Within a brick, and the additional offset of the next one.
  constexpr int next = 1 << block_bits;
  const int row_of_bricks = field.blocks[0] * brick_size, slice_of_bricks = field.blocks[1] * row_of_bricks;
  const Ints offset = i + j * brick_row + k * brick_slice + (i >> block_bits) * (brick_size - next) +
                      (j >> block_bits) * (row_of_bricks - next * brick_row) +
                      (k >> block_bits) * (slice_of_bricks - next * brick_slice);
  places.offset = reinterpret_cast<Indices>(offset);
}

BODKIN_LANES_INLINE float place_of(const RaySection& section, float step, int sample) noexcept {
  return sample >= section.samples - 1 ? section.last_at : (static_cast<float>(sample) + 0.5F) * step;
}

// Two neighbours along i are read as one word: the lower in its low half.
BODKIN_LANES_INLINE std::int32_t pair_at(const std::int16_t* voxel) noexcept {
  std::int32_t pair = 0;
  std::memcpy(&pair, voxel, sizeof pair);
  return pair;
}
BODKIN_LANES_INLINE void read_pairs(const std::int16_t* from, const Indices& offset, const Floats& share,
                                    Floats& between) noexcept {
  const Ints pairs = {pair_at(from + offset[0]), pair_at(from + offset[1]), pair_at(from + offset[2]),
                      pair_at(from + offset[3]), pair_at(from + offset[4]), pair_at(from + offset[5]),
                      pair_at(from + offset[6]), pair_at(from + offset[7])};
  const Floats low = __builtin_convertvector((pairs << 16) >> 16, Floats);
  const Floats high = __builtin_convertvector(pairs >> 16, Floats);
  between = low + share * (high - low);
}

// The offset (index) to the position at rest of the tissue now `at` mm behind a ray's entry, linear between the
// points of the lattice, and constant beyond its border.
BODKIN_LANES_INLINE void find_offset(const Field& field, const RaySection& section, float at,
                                     Colour& offset) noexcept {
  int point = 0, stride = 1, next[3];
  float share[3];
  for (int axis = 0; axis < 3; ++axis) {
    const int last = field.moved_size[axis] - 1;
    const float place =
        bounded(section.lattice_entry[axis] + at * section.lattice_direction[axis], 0.0F, static_cast<float>(last));
    const int before = std::min(static_cast<int>(place), last - 1);
    share[axis] = place - static_cast<float>(before);
    point += before * stride;
    next[axis] = 4 * stride;
    stride *= field.moved_size[axis];
  }
  Colour rows[4];
  for (int row = 0; row < 4; ++row) {
    const float* const from = field.moved + 4 * static_cast<std::ptrdiff_t>(point) +
                              static_cast<std::ptrdiff_t>((row & 1) * next[1] + (row >> 1) * next[2]);
    Colour behind;
    std::memcpy(&rows[row], from, sizeof rows[row]);
    std::memcpy(&behind, from + 4, sizeof behind);
    rows[row] += share[0] * (behind - rows[row]);
  }
  const Colour near = rows[0] + share[1] * (rows[1] - rows[0]), far = rows[2] + share[1] * (rows[3] - rows[2]);
  offset = near + share[2] * (far - near);
}

// Moves samples to the positions at rest of the tissue that they meet: exact at lattice points, linear between them.
BODKIN_LANES_INLINE void go_to_rest(const Field& field, const RaySection& section, float step, const Floats& at,
                                    Samples& samples) noexcept {
  const int stride = static_cast<int>(bounded(field.moved_spacing / step, 1.0F, packet - 1.0F));
  Colour offset, behind;
  find_offset(field, section, at[0], offset);
  for (int from = 0; from < packet - 1; from += stride, offset = behind) {
    const int to = std::min(from + stride, packet - 1);
    find_offset(field, section, at[to], behind);
    const Colour slope = (behind - offset) / static_cast<float>(to - from);
    for (int l = from; l < to + (to == packet - 1 ? 1 : 0); ++l) {
      const Colour here = offset + static_cast<float>(l - from) * slope;
      samples.x[l] += here[0];
      samples.y[l] += here[1];
      samples.z[l] += here[2];
    }
  }
  const auto within = [](Floats& index, int size) {
    const Floats low = Floats{} + 0.5F, high = Floats{} + (static_cast<float>(size) - 1.5F);
    index = index < low ? low : index;
    index = index > high ? high : index;
  };
  within(samples.x, field.size[0]);
  within(samples.y, field.size[1]);
  within(samples.z, field.size[2]);
}

// HU of eight samples from `first` on, linear between voxels; the last one is repeated beyond the end.
BODKIN_LANES_INLINE void take_samples(const Field& field, const RaySection& section, float step, int first,
                                      bool moved, Samples& samples) noexcept {
  constexpr Floats counted = {0.5F, 1.5F, 2.5F, 3.5F, 4.5F, 5.5F, 6.5F, 7.5F};
  Floats at = (static_cast<float>(first) + counted) * step;
  if (first + packet >= section.samples) {
    for (int l = 0; l < packet; ++l) at[l] = place_of(section, step, first + l);
  }
  samples.x = section.entry[0] + at * section.direction[0];
  samples.y = section.entry[1] + at * section.direction[1];
  samples.z = section.entry[2] + at * section.direction[2];
  if (moved) go_to_rest(field, section, step, at, samples);
  Places places;
  find_places(field, samples.x, samples.y, samples.z, places);
  Floats along[4];
  read_pairs(field.hounsfield, places.offset, places.fx, along[0]);
  read_pairs(field.hounsfield + brick_row, places.offset, places.fx, along[1]);
  read_pairs(field.hounsfield + brick_slice, places.offset, places.fx, along[2]);
  read_pairs(field.hounsfield + brick_slice + brick_row, places.offset, places.fx, along[3]);
  const Floats near = along[0] + places.fy * (along[1] - along[0]);
  const Floats far = along[2] + places.fy * (along[3] - along[2]);
  samples.value = near + places.fz * (far - near);
}

// Prefetches the data that the samples from `first` on will read: HU and, if they may be shaded, gradients, and the
// HU next to them, for the next rays. Reading from memory takes as long as computing one or two packets.
BODKIN_LANES_INLINE void fetch(const Field& field, const RaySection& section, float step, int first,
                               bool gradients) noexcept {
  constexpr Floats counted = {0.5F, 1.5F, 2.5F, 3.5F, 4.5F, 5.5F, 6.5F, 7.5F};
  const Floats at = (static_cast<float>(first) + counted) * step;
  Places places;
  find_places(field, section.entry[0] + at * section.direction[0], section.entry[1] + at * section.direction[1],
              section.entry[2] + at * section.direction[2], places);
  for (int l = 0; l < packet; l += 2) {
    const auto voxel = static_cast<std::ptrdiff_t>(places.offset[l]);
    for (std::ptrdiff_t slice = -1; slice <= 2; ++slice) {
      const std::ptrdiff_t there = voxel + slice * brick_slice;
      if (there < 0) continue;
      __builtin_prefetch(field.hounsfield + there);
      if (!gradients || slice < 0 || slice > 1) continue;  // only data read by these samples themselves
      __builtin_prefetch(field.gradients + 4 * there);
      __builtin_prefetch(field.gradients + 4 * (there + brick_row));
    }
  }
}

// Rows of the tables: HU are limited to the scale.
BODKIN_LANES_INLINE void find_rows(const Samples& samples, Indices& rows) noexcept {
  rows = reinterpret_cast<Indices>(__builtin_convertvector(samples.value + 1024.5F, Ints));
}

struct Block {
  int i, j, k;
  std::size_t index;
};
BODKIN_LANES_INLINE Block block_at(const Field& field, const RaySection& section, float at) noexcept {
  Block block;
  block.i = static_cast<int>(section.entry[0] + at * section.direction[0]) >> block_bits;
  block.j = static_cast<int>(section.entry[1] + at * section.direction[1]) >> block_bits;
  block.k = static_cast<int>(section.entry[2] + at * section.direction[2]) >> block_bits;
  const int in_order = (block.k * field.blocks[1] + block.j) * field.blocks[0] + block.i;
  block.index = static_cast<std::size_t>(in_order);
  return block;
}

// The first sample after `sample` that may lie outside the cube of blocks less than `away` from `block`.
BODKIN_LANES_INLINE int sample_beyond(const RaySection& section, float step, const Block& block, int away,
                                      int sample) noexcept {
  const int at[3] = {block.i, block.j, block.k};
  float end = 1e9F;
  for (int axis = 0; axis < 3; ++axis) {
    const int border = section.direction[axis] > 0.0F ? at[axis] + away : at[axis] - away + 1;
    const float distance = static_cast<float>(border * (1 << block_bits)) - section.entry[axis];
    end = std::min(end, distance * section.until_next[axis]);
  }
  const float next = end / step - 0.52F;  // slightly too early, for rounding
  return next > static_cast<float>(sample + 1) ? static_cast<int>(std::min(next, 1e6F)) + 1 : sample + 1;
}

}  // namespace bodkin::imaging::kernel
