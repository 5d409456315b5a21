// The inner loops of the ray caster. Eight samples along a ray are taken at once: their places and the interpolation
// between voxels are loops that the compiler turns into vector instructions, which give the same bits as any other.
#include "imaging/volume_rendering/ray_kernel.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/simd.h"
#include "imaging/volume_rendering/prepared_volume.h"

namespace bodkin::imaging::kernel {

namespace {

constexpr int packet = 8;          // samples at once
constexpr int most_gathered = 64;  // samples that are given their light together
constexpr int block_bits = 3;      // PreparedVolume::block voxels
constexpr int brick_row = PreparedVolume::brick_side, brick_slice = brick_row * brick_row;
constexpr auto brick_size = static_cast<int>(PreparedVolume::brick_size);
static_assert(PreparedVolume::block == 1 << block_bits);
constexpr float opaque = 1.0F / 256.0F;  // light that is left where nothing behind can be seen
// Where less of the light than this is left, steps are twice as long; where less than its square is left, four times:
// what is there is hardly seen.
constexpr float faint = 0.25F;
constexpr int most_doubled = step_lengths - 1;
constexpr float seen = 0.015F;  // share of a ray's light from which on a sample is shaded

constexpr float unlit = 0.85F;  // brightness of what has no edge

// Eight numbers that are computed with at once, each as it would be alone.
using Floats = float __attribute__((vector_size(4 * packet)));
using Ints = std::int32_t __attribute__((vector_size(4 * packet)));

struct Samples {
  Floats x, y, z;  // index
  Floats value;    // HU
};

// Samples that take light from a ray, until they are given their own together: to light only those that are seen is
// then a loop of its own, in which nothing has to be guessed.
struct Gathered {
  float x[most_gathered], y[most_gathered], z[most_gathered];  // index
  float red[most_gathered], green[most_gathered], blue[most_gathered];
  float shares[most_gathered];  // of the ray's light, that each takes
  int count = 0;
};

// Of eight places: the voxels that they lie behind, and how far behind, 0 to 1.
struct Places {
  Ints offset;  // see PreparedVolume::offset()
  Floats fx, fy, fz;
};
BODKIN_LANES_INLINE void find_places(const Field& field, const Floats& x, const Floats& y, const Floats& z,
                                     Places& places) noexcept {
  const Ints i = __builtin_convertvector(x, Ints), j = __builtin_convertvector(y, Ints),
             k = __builtin_convertvector(z, Ints);
  places.fx = x - __builtin_convertvector(i, Floats);
  places.fy = y - __builtin_convertvector(j, Floats);
  places.fz = z - __builtin_convertvector(k, Floats);
  // Within a brick, and what going on to the next one adds to that.
  constexpr int next = 1 << block_bits;
  const int row_of_bricks = field.blocks[0] * brick_size, slice_of_bricks = field.blocks[1] * row_of_bricks;
  places.offset = i + j * brick_row + k * brick_slice + (i >> block_bits) * (brick_size - next) +
                  (j >> block_bits) * (row_of_bricks - next * brick_row) +
                  (k >> block_bits) * (slice_of_bricks - next * brick_slice);
}

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

// Asks for what the samples from `first` on will read of HU and, if they may be shaded, of gradients, and for what
// lies beside it, where the next rays go: memory is slow enough for a packet or two to be computed meanwhile.
BODKIN_LANES_INLINE void fetch(const Field& field, const Way& way, float step, int first, bool gradients) noexcept {
  constexpr Floats counted = {0.5F, 1.5F, 2.5F, 3.5F, 4.5F, 5.5F, 6.5F, 7.5F};
  const Floats at = (static_cast<float>(first) + counted) * step;
  Places places;
  find_places(field, way.entry[0] + at * way.direction[0], way.entry[1] + at * way.direction[1],
              way.entry[2] + at * way.direction[2], places);
  for (int l = 0; l < packet; l += 2) {
    const std::ptrdiff_t voxel = places.offset[l];
    for (std::ptrdiff_t slice = -1; slice <= 2; ++slice) {
      const std::ptrdiff_t there = voxel + slice * brick_slice;
      if (there < 0) continue;
      __builtin_prefetch(field.hounsfield + there);
      if (!gradients) continue;
      __builtin_prefetch(field.gradients + 4 * there);
      __builtin_prefetch(field.gradients + 4 * (there + brick_row));
    }
  }
}

// Whether any of eight numbers is greater than a bound: comparing all at once waits for less than the largest would.
BODKIN_LANES_INLINE bool any_above(const Floats& numbers, float bound) noexcept {
  using Words = std::int64_t __attribute__((vector_size(4 * packet)));
  const auto above = reinterpret_cast<Words>(numbers > Floats{} + bound);
  return ((above[0] | above[1]) | (above[2] | above[3])) != 0;
}

// Of the tables: what lies between HU of the scale is on the scale.
BODKIN_LANES_INLINE void find_rows(const Samples& samples, Ints& rows) noexcept {
  rows = __builtin_convertvector(samples.value + 1024.5F, Ints);
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
    const int border = way.direction[axis] > 0.0F ? at[axis] + away : at[axis] - away + 1;
    const float distance = static_cast<float>(border * (1 << block_bits)) - way.entry[axis];
    end = std::min(end, distance * way.until_next[axis]);
  }
  const float next = end / step - 0.52F;  // a little too early, for rounding
  return next > static_cast<float>(sample + 1) ? static_cast<int>(std::min(next, 1e6F)) + 1 : sample + 1;
}

using Colour = float __attribute__((vector_size(16)));  // red, green, blue, and a fourth

// Eight rows of four numbers as four vectors of eight: lanes l of which are row l.
BODKIN_LANES_INLINE void turn(const Colour (&rows)[packet], Floats& a, Floats& b, Floats& c, Floats& d) noexcept {
  const Floats r0 = __builtin_shufflevector(rows[0], rows[4], 0, 1, 2, 3, 4, 5, 6, 7),
               r1 = __builtin_shufflevector(rows[1], rows[5], 0, 1, 2, 3, 4, 5, 6, 7),
               r2 = __builtin_shufflevector(rows[2], rows[6], 0, 1, 2, 3, 4, 5, 6, 7),
               r3 = __builtin_shufflevector(rows[3], rows[7], 0, 1, 2, 3, 4, 5, 6, 7);
  const Floats ab01 = __builtin_shufflevector(r0, r1, 0, 8, 1, 9, 4, 12, 5, 13),
               ab23 = __builtin_shufflevector(r2, r3, 0, 8, 1, 9, 4, 12, 5, 13),
               cd01 = __builtin_shufflevector(r0, r1, 2, 10, 3, 11, 6, 14, 7, 15),
               cd23 = __builtin_shufflevector(r2, r3, 2, 10, 3, 11, 6, 14, 7, 15);
  a = __builtin_shufflevector(ab01, ab23, 0, 1, 8, 9, 4, 5, 12, 13);
  b = __builtin_shufflevector(ab01, ab23, 2, 3, 10, 11, 6, 7, 14, 15);
  c = __builtin_shufflevector(cd01, cd23, 0, 1, 8, 9, 4, 5, 12, 13);
  d = __builtin_shufflevector(cd01, cd23, 2, 3, 10, 11, 6, 7, 14, 15);
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

// How bright eight of the samples are, by the gradient of the HU there, linear between voxels.
BODKIN_LANES_INLINE void find_brightness(const Field& field, const Way& way, const Gathered& gathered,
                                         const int* which, Floats& brightness) noexcept {
  Floats x, y, z;
  for (int l = 0; l < packet; ++l) {
    x[l] = gathered.x[which[l]];
    y[l] = gathered.y[which[l]];
    z[l] = gathered.z[which[l]];
  }
  Places places;
  find_places(field, x, y, z, places);
  Colour gradients[packet];
  for (int l = 0; l < packet; ++l) {
    const std::int8_t* const voxel = field.gradients + 4 * static_cast<std::ptrdiff_t>(places.offset[l]);
    Floats a, b, c, d;
    read_gradients(voxel, a);
    read_gradients(voxel + 4 * brick_row, b);
    read_gradients(voxel + 4 * brick_slice, c);
    read_gradients(voxel + 4 * (brick_slice + brick_row), d);
    const float fx = places.fx[l], fy = places.fy[l], fz = places.fz[l];
    const Floats near = a + fy * (b - a), far = c + fy * (d - c), here = near + fz * (far - near);
    const Colour before = __builtin_shufflevector(here, here, 0, 1, 2, 3),
                 behind = __builtin_shufflevector(here, here, 4, 5, 6, 7);
    gradients[l] = before + fx * (behind - before);
  }
  Floats gx, gy, gz, unused;
  turn(gradients, gx, gy, gz, unused);
  const Floats square_size = gx * gx + gy * gy + gz * gz;
  Floats size;
  for (int l = 0; l < packet; ++l) size[l] = std::sqrt(square_size[l]);
  // The gradient points into what is denser; the normal is its opposite, and a boundary has no wrong side.
  const Floats along = gx * way.light[0] + gy * way.light[1] + gz * way.light[2];
  const Floats facing = (along < 0.0F ? -along : along) / (size + 1e-3F);
  const Floats sharp = size * (1.0F / 24.0F), edge = sharp < 1.0F ? sharp : Floats{} + 1.0F;  // no edge, no shade
  const Floats square = facing * facing, shine = square * square * square * square;
  const Floats lit = 0.22F + 0.74F * facing + 0.22F * shine * shine;
  brightness = unlit + edge * (lit - unlit);
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

// The colours of the tissues instead of those of the HU.
BODKIN_LANES_INLINE void colour_by_tissue(const Field& field, Gathered& gathered) noexcept {
  for (int l = 0; l < gathered.count; ++l) {
    const int i = static_cast<int>(gathered.x[l] + 0.5F), j = static_cast<int>(gathered.y[l] + 0.5F),
              k = static_cast<int>(gathered.z[l] + 0.5F);
    const std::size_t voxel =
        static_cast<std::size_t>(k * field.size[1] + j) * static_cast<std::size_t>(field.size[0]) +
        static_cast<std::size_t>(i);
    const float* const colour = field.tissue_colours + 4 * static_cast<std::ptrdiff_t>(field.tissues[voxel]);
    gathered.red[l] = colour[0];
    gathered.green[l] = colour[1];
    gathered.blue[l] = colour[2];
  }
}

// Adds the light of the samples, shaded where they take more than `seen` of the ray's.
BODKIN_LANES_INLINE void add_light(const Field& field, const Way& way, Gathered& gathered, Colour& light) noexcept {
  float brightness[most_gathered + packet];
  const int count = gathered.count;
  if (field.tissues != nullptr) colour_by_tissue(field, gathered);
  for (int l = 0; l < count; ++l) brightness[l] = field.gradients != nullptr ? unlit : 1.0F;
  if (field.gradients != nullptr) {
    int which[most_gathered + packet];
    int shaded = 0;
    for (int first = 0; first < count; first += packet) {
      Floats share;
      std::memcpy(&share, gathered.shares + first, sizeof share);
      if (!any_above(share, seen)) continue;
      for (int l = first; l < first + packet; ++l) {
        which[shaded] = l;
        shaded += gathered.shares[l] > seen ? 1 : 0;
      }
    }
    for (int l = 0; l < packet; ++l) which[shaded + l] = which[0];
    for (int first = 0; first < shaded; first += packet) {
      Floats bright;
      find_brightness(field, way, gathered, which + first, bright);
      for (int l = 0; l < packet; ++l) brightness[which[first + l]] = bright[l];
    }
  }
  Floats red = {}, green = {}, blue = {};
  for (int first = 0; first < count; first += packet) {
    Floats share, bright, part;
    std::memcpy(&share, gathered.shares + first, sizeof share);
    std::memcpy(&bright, brightness + first, sizeof bright);
    share = share * bright;
    std::memcpy(&part, gathered.red + first, sizeof part);
    red = red + share * part;
    std::memcpy(&part, gathered.green + first, sizeof part);
    green = green + share * part;
    std::memcpy(&part, gathered.blue + first, sizeof part);
    blue = blue + share * part;
  }
  for (int l = 0; l < packet; ++l) light += Colour{red[l], green[l], blue[l], 0.0F};
  gathered.count = 0;
}

BODKIN_PROCESSOR_CLONES
void cast_light(const Field& field, const Way& whole, Met& met) noexcept {
  Way way = whole;
  float left = 1.0F, step = field.step, next_faint = faint;
  int doubled = 0;
  const float* table = field.shown[0];
  Colour light = {};
  Gathered gathered;
  Samples samples;
  Ints rows;
  Floats red, green, blue, alpha;
  int sample = 0;
  while (sample < way.samples && left > opaque) {
    const Block block = block_at(field, way, place_of(way, step, sample));
    const int away = field.away[block.index];
    if (away > 0) {
      sample = sample_beyond(way, step, block, away, sample);
      continue;
    }
    if (way.far_apart && sample + 3 * packet < way.samples) {
      fetch(field, way, step, sample + 2 * packet, field.gradients != nullptr && doubled == 0);
    }
    take_samples(field, way, step, sample, samples);
    find_rows(samples, rows);
    Colour shown[packet];
    for (int l = 0; l < packet; ++l) {
      std::memcpy(&shown[l], table + 4 * static_cast<std::ptrdiff_t>(rows[l]), sizeof shown[l]);
    }
    turn(shown, red, green, blue, alpha);
    const int count = std::min(packet, way.samples - sample);
    if (sample + count == way.samples) {
      alpha[count - 1] = 1.0F - std::exp(-field.depth[rows[count - 1]] * way.last);
      for (int l = count; l < packet; ++l) alpha[l] = 0.0F;
    }
    const Floats passed = 1.0F - alpha;
    int used = packet;  // samples up to the one that made the ray fainter
    Floats before;      // light that reaches each
    const float after = pass_light(passed, left, before);
    if (after == left) {  // none takes any
      sample += packet;
      continue;
    }
    if (after > next_faint) {
      left = after;
    } else {
      before = Floats{};
      for (used = 0; used < packet && left > next_faint; ++used) {
        before[used] = left;
        left *= passed[used];
      }
    }
    const Floats shares = before * alpha;
    std::memcpy(gathered.x + gathered.count, &samples.x, sizeof samples.x);
    std::memcpy(gathered.y + gathered.count, &samples.y, sizeof samples.y);
    std::memcpy(gathered.z + gathered.count, &samples.z, sizeof samples.z);
    std::memcpy(gathered.red + gathered.count, &red, sizeof red);
    std::memcpy(gathered.green + gathered.count, &green, sizeof green);
    std::memcpy(gathered.blue + gathered.count, &blue, sizeof blue);
    std::memcpy(gathered.shares + gathered.count, &shares, sizeof shares);
    gathered.count += packet;
    if (gathered.count == most_gathered) add_light(field, way, gathered, light);
    sample += used;
    if (left > next_faint) continue;
    if (doubled == most_doubled || sample >= way.samples) break;
    lengthen_steps(way, step, sample);
    ++doubled;
    table = field.shown[doubled];
    next_faint = doubled < most_doubled ? next_faint * faint : opaque;
    sample = 0;
  }
  add_light(field, way, gathered, light);
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
