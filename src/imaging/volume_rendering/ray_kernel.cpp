// The inner loops of the ray caster. Eight samples along a ray are taken at once: their places and the interpolation
// between voxels are loops that the compiler turns into vector instructions, which give the same bits as any other.
#include "imaging/volume_rendering/ray_kernel.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/simd.h"

namespace bodkin::imaging::kernel {

namespace {

constexpr int packet = 8;                // samples at once
constexpr int block_bits = 3;            // PreparedVolume::block voxels
constexpr float opaque = 1.0F / 256.0F;  // light that is left where nothing behind can be seen
// Where less of the light than this is left, steps are twice as long; where less than its square is left, four times:
// what is there is hardly seen.
constexpr float faint = 0.25F;
constexpr int most_doubled = 2;
constexpr float seen = 0.015F;  // share of a ray's light from which on a sample is shaded

constexpr float unlit = 0.85F;  // brightness of what has no edge

// Eight numbers that are computed with at once, each as it would be alone.
using Floats = float __attribute__((vector_size(4 * packet)));
using Ints = std::int32_t __attribute__((vector_size(4 * packet)));

struct Samples {
  Floats x, y, z;  // index
  Floats value;    // HU
};

BODKIN_LANES_INLINE float place_of(const Way& way, float step, int sample) noexcept {
  return sample >= way.samples - 1 ? way.last_at : (static_cast<float>(sample) + 0.5F) * step;
}

// Two neighbours along i are read as one word: the lower in its low half.
BODKIN_LANES_INLINE std::int32_t pair_at(const std::int16_t* voxel) noexcept {
  std::int32_t pair = 0;
  std::memcpy(&pair, voxel, sizeof pair);
  return pair;
}
BODKIN_LANES_INLINE void read_pairs(const std::int16_t* from, const Ints& offset, const Floats& share,
                                    Floats& between) noexcept {
  const Ints pairs = {pair_at(from + offset[0]), pair_at(from + offset[1]), pair_at(from + offset[2]),
                      pair_at(from + offset[3]), pair_at(from + offset[4]), pair_at(from + offset[5]),
                      pair_at(from + offset[6]), pair_at(from + offset[7])};
  const Floats low = __builtin_convertvector((pairs << 16) >> 16, Floats);
  const Floats high = __builtin_convertvector(pairs >> 16, Floats);
  between = low + share * (high - low);
}

// HU of eight samples from `first` on, linear between voxels; beyond the last one they repeat it.
BODKIN_LANES_INLINE void take_samples(const Field& field, const Way& way, float step, int first,
                                      Samples& samples) noexcept {
  constexpr Floats counted = {0.5F, 1.5F, 2.5F, 3.5F, 4.5F, 5.5F, 6.5F, 7.5F};
  Floats at = (static_cast<float>(first) + counted) * step;
  if (first + packet >= way.samples) {
    for (int l = 0; l < packet; ++l) at[l] = place_of(way, step, first + l);
  }
  samples.x = way.entry[0] + at * way.direction[0];
  samples.y = way.entry[1] + at * way.direction[1];
  samples.z = way.entry[2] + at * way.direction[2];
  const Ints i = __builtin_convertvector(samples.x, Ints), j = __builtin_convertvector(samples.y, Ints),
             k = __builtin_convertvector(samples.z, Ints);
  const Floats fx = samples.x - __builtin_convertvector(i, Floats),
               fy = samples.y - __builtin_convertvector(j, Floats),
               fz = samples.z - __builtin_convertvector(k, Floats);
  const int row = field.size[0], slice = field.size[0] * field.size[1];
  const Ints offset = i + j * row + k * slice;
  Floats along[4];
  read_pairs(field.hounsfield, offset, fx, along[0]);
  read_pairs(field.hounsfield + row, offset, fx, along[1]);
  read_pairs(field.hounsfield + slice, offset, fx, along[2]);
  read_pairs(field.hounsfield + slice + row, offset, fx, along[3]);
  const Floats near = along[0] + fy * (along[1] - along[0]);
  const Floats far = along[2] + fy * (along[3] - along[2]);
  samples.value = near + fz * (far - near);
}

// Whether any of eight numbers is greater than a bound: comparing all at once waits for less than the largest would.
BODKIN_LANES_INLINE bool any_above(const Floats& numbers, float bound) noexcept {
  using Words = std::int64_t __attribute__((vector_size(4 * packet)));
  const auto above = reinterpret_cast<Words>(numbers > Floats{} + bound);
  return ((above[0] | above[1]) | (above[2] | above[3])) != 0;
}

BODKIN_LANES_INLINE void find_rows(const Samples& samples, Ints& rows) noexcept {
  constexpr Floats least = Floats{} - 1024.0F, most = Floats{} + 3071.0F;
  const Floats below = samples.value < most ? samples.value : most;
  const Floats bound = below > least ? below : least;
  rows = __builtin_convertvector(bound + 1024.5F, Ints);
}

struct Block {
  int i, j, k;
  std::size_t index;
};
BODKIN_LANES_INLINE Block block_at(const Field& field, const Way& way, float at) noexcept {
  Block block;
  block.i = static_cast<int>(way.entry[0] + at * way.direction[0]) >> block_bits;
  block.j = static_cast<int>(way.entry[1] + at * way.direction[1]) >> block_bits;
  block.k = static_cast<int>(way.entry[2] + at * way.direction[2]) >> block_bits;
  const int in_order = (block.k * field.blocks[1] + block.j) * field.blocks[0] + block.i;
  block.index = static_cast<std::size_t>(in_order);
  return block;
}

// The first sample that may lie outside the cube of blocks less than `away` from `block`, later than `sample`.
BODKIN_LANES_INLINE int sample_beyond(const Way& way, float step, const Block& block, int away, int sample) noexcept {
  const int at[3] = {block.i, block.j, block.k};
  float end = 1e9F;
  for (int axis = 0; axis < 3; ++axis) {
    const float speed = way.direction[axis];
    const int border = speed > 0.0F ? at[axis] + away : at[axis] - away + 1;
    const float distance = static_cast<float>(border * (1 << block_bits)) - way.entry[axis];
    if (std::abs(speed) > 1e-9F) end = std::min(end, distance / speed);
  }
  const float next = end / step - 0.52F;  // a little too early, for rounding
  return next > static_cast<float>(sample + 1) ? static_cast<int>(std::min(next, 1e6F)) + 1 : sample + 1;
}

// Two neighbouring voxels' gradients, four bytes each, as numbers.
BODKIN_LANES_INLINE void read_gradients(const std::int8_t* voxel, Floats& read) noexcept {
  using Words = std::int64_t __attribute__((vector_size(4 * packet)));
  using Bytes = std::int8_t __attribute__((vector_size(4 * packet)));
  std::int64_t word = 0;
  std::memcpy(&word, voxel, sizeof word);
  const Words words = {word, word, word, word};
  const auto bytes = reinterpret_cast<Bytes>(words);
  // Each byte into the upper end of a number of its own, from where it is shifted down with its sign.
  const Bytes spread = __builtin_shufflevector(bytes, bytes, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 20, 20,
                                               20, 20, 21, 21, 21, 21, 22, 22, 22, 22, 23, 23, 23, 23);
  read = __builtin_convertvector(reinterpret_cast<Ints>(spread) >> 24, Floats);
}

// How bright those of eight samples are that take more than `seen` of the ray's light, by the gradient of the HU
// there, linear between voxels. All others are as bright as what has no edge.
BODKIN_LANES_INLINE void find_brightness(const Field& field, const Way& way, const Samples& samples,
                                         const Floats& shares, Floats& brightness) noexcept {
  float gx[packet] = {}, gy[packet] = {}, gz[packet] = {};
  const std::ptrdiff_t row = 4 * static_cast<std::ptrdiff_t>(field.size[0]), slice = row * field.size[1];
  for (int l = 0; l < packet; ++l) {
    if (!(shares[l] > seen)) continue;
    const float x = samples.x[l], y = samples.y[l], z = samples.z[l];
    const int i = static_cast<int>(x), j = static_cast<int>(y), k = static_cast<int>(z);
    const float fx = x - static_cast<float>(i), fy = y - static_cast<float>(j), fz = z - static_cast<float>(k);
    const std::int8_t* const voxel = field.gradients + 4 * static_cast<std::ptrdiff_t>(i) + j * row + k * slice;
    Floats a, b, c, d;
    read_gradients(voxel, a);
    read_gradients(voxel + row, b);
    read_gradients(voxel + slice, c);
    read_gradients(voxel + slice + row, d);
    const Floats near = a + fy * (b - a), far = c + fy * (d - c), here = near + fz * (far - near);
    gx[l] = here[0] + fx * (here[4] - here[0]);
    gy[l] = here[1] + fx * (here[5] - here[1]);
    gz[l] = here[2] + fx * (here[6] - here[2]);
  }
  float sizes[packet];
  for (int l = 0; l < packet; ++l) sizes[l] = std::sqrt(gx[l] * gx[l] + gy[l] * gy[l] + gz[l] * gz[l]);
  Floats size, x, y, z;
  std::memcpy(&size, sizes, sizeof size);
  std::memcpy(&x, gx, sizeof x);
  std::memcpy(&y, gy, sizeof y);
  std::memcpy(&z, gz, sizeof z);
  // The gradient points into what is denser; the normal is its opposite, and a boundary has no wrong side.
  const Floats along = x * way.light[0] + y * way.light[1] + z * way.light[2];
  const Floats facing = (along < 0.0F ? -along : along) / (size + 1e-3F);
  const Floats sharp = size * (1.0F / 24.0F), edge = sharp < 1.0F ? sharp : Floats{} + 1.0F;  // no edge, no shade
  const Floats square = facing * facing, shine = square * square * square * square;
  const Floats lit = 0.22F + 0.74F * facing + 0.22F * shine * shine;
  brightness = unlit + edge * (lit - unlit);
}

using Colour = float __attribute__((vector_size(16)));  // red, green, blue, 0

BODKIN_LANES_INLINE const float* colour_of(const Field& field, const Samples& samples, const Ints& rows,
                                           int lane) noexcept {
  if (field.tissues == nullptr) return field.colours + 4 * static_cast<std::ptrdiff_t>(rows[lane]);
  const int i = static_cast<int>(samples.x[lane] + 0.5F), j = static_cast<int>(samples.y[lane] + 0.5F),
            k = static_cast<int>(samples.z[lane] + 0.5F);
  const std::size_t voxel =
      static_cast<std::size_t>(k * field.size[1] + j) * static_cast<std::size_t>(field.size[0]) +
      static_cast<std::size_t>(i);
  return field.tissue_colours + 4 * static_cast<std::ptrdiff_t>(field.tissues[voxel]);
}

// The light that reaches each of eight samples, and what is left behind them, by the share that each lets pass:
// products of two, of four and of eight, which wait less for each other than one after the other.
BODKIN_LANES_INLINE float pass_light(const Floats& passed, float left, Floats& before) noexcept {
  constexpr Floats one = Floats{} + 1.0F;
  const Floats two = passed * __builtin_shufflevector(passed, one, 8, 0, 1, 2, 3, 4, 5, 6);
  const Floats four = two * __builtin_shufflevector(two, one, 8, 8, 0, 1, 2, 3, 4, 5);
  const Floats eight = four * __builtin_shufflevector(four, one, 8, 8, 8, 8, 0, 1, 2, 3);
  before = left * __builtin_shufflevector(eight, one, 8, 0, 1, 2, 3, 4, 5, 6);
  return left * eight[7];
}

// Twice as long steps from sample `from` on.
BODKIN_LANES_INLINE void lengthen_steps(Way& way, float& step, int from) noexcept {
  const float gone = static_cast<float>(from) * step;
  const float length = static_cast<float>(way.samples - 1) * step + way.last - gone;
  for (int axis = 0; axis < 3; ++axis) way.entry[axis] += gone * way.direction[axis];
  step *= 2.0F;
  way.samples = std::max(1, static_cast<int>(std::ceil(length / step - 1e-3F)));
  const float before = static_cast<float>(way.samples - 1) * step;
  way.last = length - before;
  way.last_at = before + 0.5F * way.last;
}

}  // namespace

BODKIN_PROCESSOR_CLONES
void cast_light(const Field& field, const Way& whole, Met& met) noexcept {
  Way way = whole;
  float left = 1.0F, step = field.step, next_faint = faint;
  int doubled = 0;
  Colour light = {};
  Samples samples;
  Ints rows;
  Floats alpha, shares, brightness = Floats{} + (field.gradients != nullptr ? unlit : 1.0F);
  int sample = 0;
  while (sample < way.samples && left > opaque) {
    const Block block = block_at(field, way, place_of(way, step, sample));
    const int away = field.away[block.index];
    if (away > 0) {
      sample = sample_beyond(way, step, block, away, sample);
      continue;
    }
    take_samples(field, way, step, sample, samples);
    find_rows(samples, rows);
    for (int l = 0; l < packet; ++l) alpha[l] = field.opacity[rows[l]];
    for (int n = 0; n < doubled; ++n) alpha = alpha * (2.0F - alpha);
    const int count = std::min(packet, way.samples - sample);
    if (sample + count == way.samples) {
      alpha[count - 1] = 1.0F - std::exp(-field.depth[rows[count - 1]] * way.last);
      for (int l = count; l < packet; ++l) alpha[l] = 0.0F;
    }
    if (!any_above(alpha, 0.0F)) {
      sample += packet;
      continue;
    }
    const Floats passed = 1.0F - alpha;
    int used = packet;  // samples up to the one that made the ray fainter
    Floats before;      // light that reaches each
    const float after = pass_light(passed, left, before);
    if (after > next_faint) {
      left = after;
    } else {
      before = Floats{};
      for (used = 0; used < packet && left > next_faint; ++used) {
        before[used] = left;
        left *= passed[used];
      }
    }
    shares = before * alpha;
    if (field.gradients != nullptr) {
      if (any_above(shares, seen)) {
        find_brightness(field, way, samples, shares, brightness);
      } else {
        brightness = Floats{} + unlit;
      }
    }
    for (int l = 0; l < packet; ++l) {
      Colour colour;
      std::memcpy(&colour, colour_of(field, samples, rows, l), sizeof colour);
      light += (shares[l] * brightness[l]) * colour;
    }
    sample += packet;
    if (left > next_faint) continue;
    sample += used - packet;
    if (doubled == most_doubled || sample >= way.samples) break;
    lengthen_steps(way, step, sample);
    ++doubled;
    next_faint = doubled < most_doubled ? next_faint * faint : opaque;
    sample = 0;
  }
  met.red = light[0];
  met.green = light[1];
  met.blue = light[2];
  met.opacity = 1.0F - left;
}

BODKIN_PROCESSOR_CLONES
void cast_maximum(const Field& field, const Way& way, Met& met) noexcept {
  float most = -32768.0F;
  Samples samples;
  int sample = 0;
  while (sample < way.samples) {
    const Block block = block_at(field, way, place_of(way, field.step, sample));
    if (static_cast<float>(field.ranges[2 * block.index + 1]) <= most) {
      sample = sample_beyond(way, field.step, block, 1, sample);
      continue;
    }
    take_samples(field, way, field.step, sample, samples);
    for (int l = 0; l < packet; ++l) most = std::max(most, samples.value[l]);  // those beyond repeat the last one
    sample += packet;
  }
  met.most = most;
  met.opacity = way.samples > 0 ? 1.0F : 0.0F;
}

BODKIN_PROCESSOR_CLONES
void cast_sum(const Field& field, const Way& way, Met& met) noexcept {
  float sum = 0.0F;
  Samples samples;
  Ints rows;
  Floats weights;
  int sample = 0;
  while (sample < way.samples) {
    const Block block = block_at(field, way, place_of(way, field.step, sample));
    const int away = field.away[block.index];
    if (away > 0) {
      sample = sample_beyond(way, field.step, block, away, sample);
      continue;
    }
    take_samples(field, way, field.step, sample, samples);
    find_rows(samples, rows);
    for (int l = 0; l < packet; ++l) weights[l] = field.step * field.depth[rows[l]];
    const int count = std::min(packet, way.samples - sample);
    if (sample + count == way.samples) weights[count - 1] = way.last * field.depth[rows[count - 1]];
    for (int l = 0; l < count; ++l) sum += weights[l];
    sample += packet;
  }
  met.sum = sum;
  met.opacity = way.samples > 0 ? 1.0F : 0.0F;
}

}  // namespace bodkin::imaging::kernel
