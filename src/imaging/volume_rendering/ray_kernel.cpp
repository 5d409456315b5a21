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
constexpr float seen = 0.015F;           // share of a ray's light from which on a sample is shaded

constexpr float unlit = 0.85F;  // brightness of what has no edge

struct Samples {
  float x[packet], y[packet], z[packet];  // index
  float value[packet];                    // HU
};

BODKIN_LANES_INLINE float place_of(const Way& way, const Field& field, int sample) noexcept {
  return sample >= way.samples - 1 ? way.last_at : (static_cast<float>(sample) + 0.5F) * field.step;
}

// HU of eight samples from `first` on, linear between voxels; beyond the last one they repeat it.
BODKIN_LANES_INLINE void take_samples(const Field& field, const Way& way, int first, Samples& samples) noexcept {
  float at[packet];
  for (int l = 0; l < packet; ++l) at[l] = (static_cast<float>(first + l) + 0.5F) * field.step;
  if (first + packet >= way.samples) {
    for (int l = 0; l < packet; ++l) at[l] = place_of(way, field, first + l);
  }
  for (int l = 0; l < packet; ++l) {
    samples.x[l] = way.entry[0] + at[l] * way.direction[0];
    samples.y[l] = way.entry[1] + at[l] * way.direction[1];
    samples.z[l] = way.entry[2] + at[l] * way.direction[2];
  }
  const int row = field.size[0], slice = field.size[0] * field.size[1];
  int offset[packet];
  float fx[packet], fy[packet], fz[packet];
  for (int l = 0; l < packet; ++l) {
    const int i = static_cast<int>(samples.x[l]), j = static_cast<int>(samples.y[l]),
              k = static_cast<int>(samples.z[l]);
    fx[l] = samples.x[l] - static_cast<float>(i);
    fy[l] = samples.y[l] - static_cast<float>(j);
    fz[l] = samples.z[l] - static_cast<float>(k);
    offset[l] = i + j * row + k * slice;
  }
  // Two neighbours along i are read as one word.
  std::uint32_t pairs[4][packet];
  for (int l = 0; l < packet; ++l) {
    const std::int16_t* const voxel = field.hounsfield + offset[l];
    std::memcpy(&pairs[0][l], voxel, 4);
    std::memcpy(&pairs[1][l], voxel + row, 4);
    std::memcpy(&pairs[2][l], voxel + slice, 4);
    std::memcpy(&pairs[3][l], voxel + slice + row, 4);
  }
  float along[4][packet];
  for (int c = 0; c < 4; ++c) {
    for (int l = 0; l < packet; ++l) {
      const auto low = static_cast<float>(static_cast<std::int32_t>(pairs[c][l] << 16U) >> 16);
      const auto high = static_cast<float>(static_cast<std::int32_t>(pairs[c][l]) >> 16);
      along[c][l] = low + fx[l] * (high - low);
    }
  }
  for (int l = 0; l < packet; ++l) {
    const float near = along[0][l] + fy[l] * (along[1][l] - along[0][l]);
    const float far = along[2][l] + fy[l] * (along[3][l] - along[2][l]);
    samples.value[l] = near + fz[l] * (far - near);
  }
}

BODKIN_LANES_INLINE void find_rows(const Samples& samples, std::int32_t* rows) noexcept {
  for (int l = 0; l < packet; ++l) {
    const float bound = std::max(std::min(samples.value[l], 3071.0F), -1024.0F);
    rows[l] = static_cast<std::int32_t>(bound + 1024.5F);
  }
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
BODKIN_LANES_INLINE int sample_beyond(const Field& field, const Way& way, const Block& block, int away,
                                      int sample) noexcept {
  const int at[3] = {block.i, block.j, block.k};
  float end = 1e9F;
  for (int axis = 0; axis < 3; ++axis) {
    const float speed = way.direction[axis];
    const int border = speed > 0.0F ? at[axis] + away : at[axis] - away + 1;
    const float distance = static_cast<float>(border * (1 << block_bits)) - way.entry[axis];
    if (std::abs(speed) > 1e-9F) end = std::min(end, distance / speed);
  }
  const float next = end / field.step - 0.52F;  // a little too early, for rounding
  return next > static_cast<float>(sample + 1) ? static_cast<int>(std::min(next, 1e6F)) + 1 : sample + 1;
}

// How bright a place is by the gradient of the HU there, linear between voxels.
BODKIN_LANES_INLINE float brightness_at(const Field& field, const Way& way, float x, float y, float z) noexcept {
  const int i = static_cast<int>(x), j = static_cast<int>(y), k = static_cast<int>(z);
  const float fx = x - static_cast<float>(i), fy = y - static_cast<float>(j), fz = z - static_cast<float>(k);
  const std::ptrdiff_t row = 4 * static_cast<std::ptrdiff_t>(field.size[0]), slice = row * field.size[1];
  const std::int8_t* const voxel = field.gradients + 4 * static_cast<std::ptrdiff_t>(i) + j * row + k * slice;
  const float w[8] = {(1.0F - fx) * (1.0F - fy) * (1.0F - fz),
                      fx * (1.0F - fy) * (1.0F - fz),
                      (1.0F - fx) * fy * (1.0F - fz),
                      fx * fy * (1.0F - fz),
                      (1.0F - fx) * (1.0F - fy) * fz,
                      fx * (1.0F - fy) * fz,
                      (1.0F - fx) * fy * fz,
                      fx * fy * fz};
  const std::int8_t* const corner[8] = {
      voxel,         voxel + 4,         voxel + row,         voxel + row + 4,
      voxel + slice, voxel + slice + 4, voxel + slice + row, voxel + slice + row + 4};
  float gx = 0.0F, gy = 0.0F, gz = 0.0F;
  for (int c = 0; c < 8; ++c) {
    gx += w[c] * static_cast<float>(corner[c][0]);
    gy += w[c] * static_cast<float>(corner[c][1]);
    gz += w[c] * static_cast<float>(corner[c][2]);
  }
  const float size = std::sqrt(gx * gx + gy * gy + gz * gz);
  // The gradient points into what is denser; the normal is its opposite, and a boundary has no wrong side.
  const float facing = std::abs(gx * way.light[0] + gy * way.light[1] + gz * way.light[2]) / (size + 1e-3F);
  const float edge = std::min(size * (1.0F / 24.0F), 1.0F);  // no edge, no shade
  const float square = facing * facing, shine = square * square * square * square;
  const float lit = 0.22F + 0.74F * facing + 0.22F * shine * shine;
  return unlit + edge * (lit - unlit);
}

}  // namespace

BODKIN_PROCESSOR_CLONES
void cast_light(const Field& field, const Way& way, Met& met) noexcept {
  float left = 1.0F, red = 0.0F, green = 0.0F, blue = 0.0F;
  Samples samples;
  std::int32_t rows[packet];
  float alpha[packet];
  int sample = 0;
  while (sample < way.samples && left > opaque) {
    const Block block = block_at(field, way, place_of(way, field, sample));
    const int away = field.away[block.index];
    if (away > 0) {
      sample = sample_beyond(field, way, block, away, sample);
      continue;
    }
    take_samples(field, way, sample, samples);
    find_rows(samples, rows);
    for (int l = 0; l < packet; ++l) alpha[l] = field.opacity[rows[l]];
    const int count = std::min(packet, way.samples - sample);
    if (sample + count == way.samples) alpha[count - 1] = 1.0F - std::exp(-field.depth[rows[count - 1]] * way.last);
    for (int l = 0; l < count && left > opaque; ++l) {
      if (alpha[l] <= 0.0F) continue;
      const float* colour = field.colours + 4 * static_cast<std::ptrdiff_t>(rows[l]);
      if (field.tissues != nullptr) {
        const int i = static_cast<int>(samples.x[l] + 0.5F), j = static_cast<int>(samples.y[l] + 0.5F),
                  k = static_cast<int>(samples.z[l] + 0.5F);
        const std::size_t voxel =
            static_cast<std::size_t>(k * field.size[1] + j) * static_cast<std::size_t>(field.size[0]) +
            static_cast<std::size_t>(i);
        colour = field.tissue_colours + 4 * static_cast<std::ptrdiff_t>(field.tissues[voxel]);
      }
      float share = left * alpha[l];
      left -= share;
      if (field.gradients != nullptr && share > seen) {
        share *= brightness_at(field, way, samples.x[l], samples.y[l], samples.z[l]);
      } else if (field.gradients != nullptr) {
        share *= unlit;
      }
      red += share * colour[0];
      green += share * colour[1];
      blue += share * colour[2];
    }
    sample += packet;
  }
  met.red = red;
  met.green = green;
  met.blue = blue;
  met.opacity = 1.0F - left;
}

BODKIN_PROCESSOR_CLONES
void cast_maximum(const Field& field, const Way& way, Met& met) noexcept {
  float most = -32768.0F;
  Samples samples;
  int sample = 0;
  while (sample < way.samples) {
    const Block block = block_at(field, way, place_of(way, field, sample));
    if (static_cast<float>(field.ranges[2 * block.index + 1]) <= most) {
      sample = sample_beyond(field, way, block, 1, sample);
      continue;
    }
    take_samples(field, way, sample, samples);
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
  std::int32_t rows[packet];
  float weights[packet];
  int sample = 0;
  while (sample < way.samples) {
    const Block block = block_at(field, way, place_of(way, field, sample));
    const int away = field.away[block.index];
    if (away > 0) {
      sample = sample_beyond(field, way, block, away, sample);
      continue;
    }
    take_samples(field, way, sample, samples);
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
