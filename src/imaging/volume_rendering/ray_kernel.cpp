// The inner loops of the ray caster.
#include "imaging/volume_rendering/ray_kernel.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/simd.h"
#include "imaging/volume_rendering/ray_samples.h"

namespace bodkin::imaging::kernel {

namespace {

constexpr int most_gathered = 128;       // samples shaded together
constexpr float opaque = 1.0F / 256.0F;  // remaining light below which nothing behind is visible
// With less than this light left, steps are twice as long; with less than its square, four times: samples there are
// hardly visible.
constexpr float faint = 0.25F;
constexpr int most_doubled = step_lengths - 1;
constexpr float seen = 0.015F;  // fraction of a ray's light from which a sample is shaded

constexpr float unlit = 0.85F;  // brightness of samples without an edge

// Samples that take light from a ray, collected for shading together: shading only the visible ones is then a
// separate loop without unpredictable branches.
struct Gathered {
  float x[most_gathered], y[most_gathered], z[most_gathered];  // index
  std::uint32_t row[most_gathered];                            // of the table of colours
  float shares[most_gathered];                                 // of the ray's light, taken by each
  int count = 0;
};

// Whether any of eight numbers exceeds a bound: comparing all at once waits less than finding the largest.
BODKIN_LANES_INLINE bool any_above(const Floats& numbers, float bound) noexcept {
  using Words = std::int64_t __attribute__((vector_size(4 * packet)));
  const auto above = reinterpret_cast<Words>(numbers > Floats{} + bound);
  return ((above[0] | above[1]) | (above[2] | above[3])) != 0;
}

// Of eight voxels.
struct Gradients {
  Floats x, y, z;
};
// Two neighbours along i are read as one word of 64 bits: the lower in its low half.
BODKIN_LANES_INLINE std::int64_t gradients_at(const std::int8_t* voxel) noexcept {
  std::int64_t word = 0;
  std::memcpy(&word, voxel, sizeof word);
  return word;
}
BODKIN_LANES_INLINE void take_gradients(const Ints& words, Gradients& taken) noexcept {
  // Moves each byte to the upper end of the word, then shifts it down with its sign.
  taken.x = __builtin_convertvector((words << 24) >> 24, Floats);
  taken.y = __builtin_convertvector((words << 16) >> 24, Floats);
  taken.z = __builtin_convertvector((words << 8) >> 24, Floats);
}
BODKIN_LANES_INLINE void read_gradients(const std::int8_t* from, const Indices& offset, Gradients& here,
                                        Gradients& next) noexcept {
  using Pairs = std::int64_t __attribute__((vector_size(4 * packet)));
  const auto at = [&](int l) { return gradients_at(from + 4 * std::size_t{offset[l]}); };
  // Orders the halves of the words within the halves of a register.
  const Ints outer = reinterpret_cast<Ints>(Pairs{at(0), at(1), at(4), at(5)});
  const Ints inner = reinterpret_cast<Ints>(Pairs{at(2), at(3), at(6), at(7)});
  take_gradients(__builtin_shufflevector(outer, inner, 0, 2, 8, 10, 4, 6, 12, 14), here);
  take_gradients(__builtin_shufflevector(outer, inner, 1, 3, 9, 11, 5, 7, 13, 15), next);
}
// From `near` towards `far`.
BODKIN_LANES_INLINE void go_between(const Gradients& far, const Floats& share, Gradients& near) noexcept {
  near.x += share * (far.x - near.x);
  near.y += share * (far.y - near.y);
  near.z += share * (far.z - near.z);
}
// At eight places, linear along i and j.
BODKIN_LANES_INLINE void read_slice(const std::int8_t* from, const Places& places, Gradients& here) noexcept {
  Gradients next, row, next_in_row;
  read_gradients(from, places.offset, here, next);
  go_between(next, places.fx, here);
  read_gradients(from + 4 * brick_row, places.offset, row, next_in_row);
  go_between(next_in_row, places.fx, row);
  go_between(row, places.fy, here);
}

// Brightness of eight samples, by the gradient of the HU there, linear between voxels.
BODKIN_LANES_INLINE void find_brightness(const Field& field, const RaySection& section, const Gathered& gathered,
                                         const int* which, Floats& brightness) noexcept {
  Floats x, y, z;
  for (int l = 0; l < packet; ++l) {
    x[l] = gathered.x[which[l]];
    y[l] = gathered.y[which[l]];
    z[l] = gathered.z[which[l]];
  }
  Places places;
  find_places(field, x, y, z, places);
  Gradients here, behind;
  read_slice(field.gradients, places, here);
  read_slice(field.gradients + 4 * brick_slice, places, behind);
  go_between(behind, places.fz, here);
  const Floats square_size = here.x * here.x + here.y * here.y + here.z * here.z;
  Floats size;
  for (int l = 0; l < packet; ++l) size[l] = std::sqrt(square_size[l]);
  // The gradient points into denser tissue; the normal is its opposite, and both sides of a boundary are shaded.
  const Floats along = here.x * section.light[0] + here.y * section.light[1] + here.z * section.light[2];
  const Floats facing = (along < 0.0F ? -along : along) / (size + 1e-3F);
  const Floats sharp = size * (1.0F / 24.0F), edge = sharp < 1.0F ? sharp : Floats{} + 1.0F;  // no edge, no shade
  const Floats square = facing * facing, shine = square * square * square * square;
  const Floats lit = 0.22F + 0.74F * facing + 0.22F * shine * shine;
  brightness = unlit + edge * (lit - unlit);
}

// The light that reaches each of eight samples, and the rest behind them, by the fraction that each transmits:
// products of two and of four within each half, which wait less for each other than a sequential product.
BODKIN_LANES_INLINE float pass_light(const Floats& passed, float left, Floats& before) noexcept {
  constexpr Floats one = Floats{} + 1.0F;
  const Floats two = passed * __builtin_shufflevector(passed, one, 8, 0, 1, 2, 12, 4, 5, 6);
  const Floats four = two * __builtin_shufflevector(two, one, 8, 9, 0, 1, 12, 13, 4, 5);
  const float half = left * four[3];
  const Floats reaches = {left, left, left, left, half, half, half, half};
  before = reaches * __builtin_shufflevector(four, one, 8, 0, 1, 2, 12, 4, 5, 6);
  return half * four[7];
}

// Doubles the steps from sample `from` on.
BODKIN_LANES_INLINE void lengthen_steps(RaySection& section, float& step, int from) noexcept {
  const float gone = static_cast<float>(from) * step;
  const float length = static_cast<float>(section.samples - 1) * step + section.last - gone;
  for (int axis = 0; axis < 3; ++axis) {
    section.entry[axis] += gone * section.direction[axis];
    section.lattice_entry[axis] += gone * section.lattice_direction[axis];
  }
  step *= 2.0F;
  section.samples = std::max(1, static_cast<int>(std::ceil(length / step - 1e-3F)));
  const float before = static_cast<float>(section.samples - 1) * step;
  section.last = length - before;
  section.last_at = before + 0.5F * section.last;
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
    gathered.row[l] = field.tissues[voxel];
  }
}

// Adds the light of the samples, shaded where they take more than `seen` of the ray's.
BODKIN_LANES_INLINE void add_light(const Field& field, const RaySection& section, Gathered& gathered,
                                   Colour& light) noexcept {
  float brightness[most_gathered + packet];
  const int count = gathered.count;
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
      find_brightness(field, section, gathered, which + first, bright);
      for (int l = 0; l < packet; ++l) brightness[which[first + l]] = bright[l];
    }
  }
  if (field.tissues != nullptr) colour_by_tissue(field, gathered);
  const float* const colours = field.tissues != nullptr ? field.tissue_colours : field.colours;
  Colour sums[4] = {};
  for (int first = 0; first < count; first += 4) {  // whole packets
#pragma GCC unroll 4
    for (int l = 0; l < 4; ++l) {
      Colour colour;
      std::memcpy(&colour, colours + 4 * std::size_t{gathered.row[first + l]}, sizeof colour);
      sums[l] += gathered.shares[first + l] * brightness[first + l] * colour;
    }
  }
  light += (sums[0] + sums[1]) + (sums[2] + sums[3]);
  gathered.count = 0;
}

BODKIN_LANES_INLINE void light_along(const Field& field, const RaySection& whole, bool moved,
                                     RayResult& result) noexcept {
  RaySection section = whole;
  float left = 1.0F, step = field.step, next_faint = faint;
  int doubled = 0;
  const float* table = field.shown[0];
  Colour light = {};
  Gathered gathered;
  Samples samples;
  Indices rows;
  Floats alpha;
  int sample = 0;
  bool dark = true;  // the samples before took no light: only then testing for empty space pays
  while (sample < section.samples && left > opaque) {
    if (dark) {
      const Block block = block_at(field, section, place_of(section, step, sample));
      const int away = field.away[block.index] - (moved ? field.moved_blocks : 0);
      if (away > 0) {
        sample = sample_beyond(section, step, block, away, sample);
        continue;
      }
    }
    if (section.far_apart && sample + 3 * packet < section.samples) {
      fetch(field, section, step, sample + 2 * packet, field.gradients != nullptr && doubled == 0);
    }
    take_samples(field, section, step, sample, moved, samples);
    find_rows(samples, rows);
    alpha = Floats{table[rows[0]], table[rows[1]], table[rows[2]], table[rows[3]],
                   table[rows[4]], table[rows[5]], table[rows[6]], table[rows[7]]};
    const int count = std::min(packet, section.samples - sample);
    if (sample + count == section.samples) {
      alpha[count - 1] = 1.0F - std::exp(-field.depth[rows[count - 1]] * section.last);
      for (int l = count; l < packet; ++l) alpha[l] = 0.0F;
    }
    const Floats passed = 1.0F - alpha;
    int used = packet;  // samples up to the one that made the ray fainter
    Floats before;      // light that arrives at each
    const float after = pass_light(passed, left, before);
    dark = after == left;
    if (dark) {  // none takes any
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
    std::memcpy(gathered.row + gathered.count, &rows, sizeof rows);
    std::memcpy(gathered.shares + gathered.count, &shares, sizeof shares);
    gathered.count += packet;
    if (gathered.count == most_gathered) add_light(field, section, gathered, light);
    sample += used;
    if (left > next_faint) continue;
    if (doubled == most_doubled || sample >= section.samples) break;
    lengthen_steps(section, step, sample);
    ++doubled;
    table = field.shown[doubled];
    next_faint = doubled < most_doubled ? next_faint * faint : opaque;
    sample = 0;
  }
  add_light(field, section, gathered, light);
  result.red = light[0];
  result.green = light[1];
  result.blue = light[2];
  result.opacity = 1.0F - left;
}

namespace {

// One version for every processor. Clang rejects such versions of a function declared without them.
namespace wide {

BODKIN_PROCESSOR_CLONES
void cast_light(const Field& field, const RaySection& section, RayResult& result) noexcept {
  light_along(field, section, false, result);
}

BODKIN_PROCESSOR_CLONES
void cast_moved_light(const Field& field, const RaySection& section, RayResult& result) noexcept {
  light_along(field, section, true, result);
}

BODKIN_PROCESSOR_CLONES
void cast_maximum(const Field& field, const RaySection& section, RayResult& result) noexcept {
  float most = -32768.0F;
  Samples samples;
  int sample = 0;
  while (sample < section.samples) {
    const Block block = block_at(field, section, place_of(section, field.step, sample));
    if (field.moved == nullptr && static_cast<float>(field.ranges[2 * block.index + 1]) <= most) {
      sample = sample_beyond(section, field.step, block, 1, sample);
      continue;
    }
    take_samples(field, section, field.step, sample, field.moved != nullptr, samples);
    for (int l = 0; l < packet; ++l) most = std::max(most, samples.value[l]);  // those beyond repeat the last one
    sample += packet;
  }
  result.most = most;
  result.opacity = section.samples > 0 ? 1.0F : 0.0F;
}

BODKIN_PROCESSOR_CLONES
void cast_sum(const Field& field, const RaySection& section, RayResult& result) noexcept {
  float sum = 0.0F;
  Samples samples;
  Indices rows;
  Floats weights;
  int sample = 0;
  while (sample < section.samples) {
    const Block block = block_at(field, section, place_of(section, field.step, sample));
    const int away = field.away[block.index] - field.moved_blocks;
    if (away > 0) {
      sample = sample_beyond(section, field.step, block, away, sample);
      continue;
    }
    take_samples(field, section, field.step, sample, field.moved != nullptr, samples);
    find_rows(samples, rows);
    for (int l = 0; l < packet; ++l) weights[l] = field.step * field.depth[rows[l]];
    const int count = std::min(packet, section.samples - sample);
    if (sample + count == section.samples) weights[count - 1] = section.last * field.depth[rows[count - 1]];
    for (int l = 0; l < count; ++l) sum += weights[l];
    sample += packet;
  }
  result.sum = sum;
  result.opacity = section.samples > 0 ? 1.0F : 0.0F;
}

}  // namespace wide

}  // namespace

void cast_light(const Field& field, const RaySection& section, RayResult& result) noexcept {
  wide::cast_light(field, section, result);
}

void cast_moved_light(const Field& field, const RaySection& section, RayResult& result) noexcept {
  wide::cast_moved_light(field, section, result);
}

void cast_maximum(const Field& field, const RaySection& section, RayResult& result) noexcept {
  wide::cast_maximum(field, section, result);
}

void cast_sum(const Field& field, const RaySection& section, RayResult& result) noexcept {
  wide::cast_sum(field, section, result);
}

}  // namespace bodkin::imaging::kernel
