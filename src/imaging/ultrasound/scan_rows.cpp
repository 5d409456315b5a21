// The inner loops of rows and pixels, compiled once for each processor path as scan_kernel.cpp is.
#include <cstring>

#include "core/simd.h"
#include "imaging/ultrasound/scan_kernel.h"

namespace bodkin::imaging::scan {

namespace {

// log2 of a positive normal number, to 1e-5: the exponent, and a polynomial through the mantissa's logarithm that is
// exact at both ends.
inline float log2_of(float x) noexcept {
  const auto bits = __builtin_bit_cast(std::uint32_t, x);
  const auto exponent = static_cast<float>(static_cast<std::int32_t>(bits >> 23) - 127);
  const float m = float_from_bits((bits & 0x007FFFFFU) | 0x3F800000U) - 1.0F;
  const float p =
      1.4426804F + m * (-0.7202988F + m * (0.4681255F + m * (-0.2999927F + m * (0.1424179F + m * -0.0329323F))));
  return exponent + m * p;
}

// The pulse's length, row upon row, into `out`.
void spread_axially(const Row& __restrict row, const float* __restrict rows, const float* __restrict clutter,
                    float* __restrict out) noexcept {
  for (int l = 0; l < row.stride; ++l) out[l] = 0.0F;
  for (int tap = -row.axial_half; tap <= row.axial_half; ++tap) {
    const int from = row.row + tap;
    if (from < 0 || from >= row.samples) continue;
    const float weight = row.axial[tap + row.axial_half];
    const float* const source = rows + static_cast<std::ptrdiff_t>(from) * row.stride;
    for (int l = 0; l < row.stride; ++l) out[l] += weight * source[l];
  }
  if (clutter == nullptr) return;
  const float* const source = clutter + static_cast<std::ptrdiff_t>(row.row) * row.stride;
  for (int l = 0; l < row.stride; ++l) out[l] += source[l];
}

// Blurs across lines by the beam's width. `in` is padded by `edge` lines on both sides with copies of its outermost
// lines.
void spread_laterally(const Row& __restrict row, const float* __restrict in, float* __restrict out) noexcept {
  for (int l = 0; l < row.stride; ++l) out[l] = row.lateral[0] * in[l];
  for (int tap = 1; tap <= row.lateral_half; ++tap) {
    const float weight = row.lateral[tap];
    const float* const left = in - tap;
    const float* const right = in + tap;
    for (int l = 0; l < row.stride; ++l) out[l] += weight * (left[l] + right[l]);
  }
}

void continue_edges(const Row& row, float* line) noexcept {
  for (int l = row.lines; l < row.stride + edge; ++l) line[l] = line[row.lines - 1];
  for (int l = -edge; l < 0; ++l) line[l] = line[0];
}

// Grey level of an echo, 0 to 255, by the logarithm of its amplitude.
void grade(const Row& __restrict row, const float* __restrict in_phase, const float* __restrict quadrature,
           float* __restrict grey) noexcept {
  const float gain = row.gain * row.gain, half = 0.5F * row.levels_per_octave, white = row.white;
  for (int l = 0; l < row.stride; ++l) {
    const float energy = (in_phase[l] * in_phase[l] + quadrature[l] * quadrature[l]) * gain;
    const float heard = energy > 1e-30F ? energy : 1e-30F;
    grey[l] = bounded(white + half * log2_of(heard), 0.0F, 255.0F) + 0.5F;
  }
}

void round(const float* __restrict from, int count, std::uint8_t* __restrict to) noexcept {
  for (int l = 0; l < count; ++l) to[l] = static_cast<std::uint8_t>(static_cast<std::int32_t>(from[l]));
}

}  // namespace

void BODKIN_JOIN(compress_, BODKIN_PATH)(const Row& row) noexcept {
  const std::ptrdiff_t length = row.stride + 2 * edge;
  float* const in_phase = row.work + edge;
  float* const quadrature = in_phase + length;
  float* const wide_in_phase = quadrature + length;
  float* const wide_quadrature = wide_in_phase + length;
  const std::ptrdiff_t here = static_cast<std::ptrdiff_t>(row.row) * row.stride;
  const bool spread = row.axial_half > 0 || row.lateral_half > 0 || row.clutter_in_phase != nullptr;
  if (spread) {
    spread_axially(row, row.in_phase, row.clutter_in_phase, in_phase);
    spread_axially(row, row.quadrature, row.clutter_quadrature, quadrature);
    continue_edges(row, in_phase);
    continue_edges(row, quadrature);
    spread_laterally(row, in_phase, wide_in_phase);
    spread_laterally(row, quadrature, wide_quadrature);
  }
  grade(row, spread ? wide_in_phase : row.in_phase + here, spread ? wide_quadrature : row.quadrature + here,
        in_phase);
  round(in_phase, row.stride, row.grey);
}

// Loads from scattered places are gathered for some pixels first; the arithmetic on them is then vectorised.
void BODKIN_JOIN(convert_, BODKIN_PATH)(const Conversion& in, std::size_t first, std::size_t last) noexcept {
  constexpr std::size_t turn = 64;                               // pixels
  alignas(64) std::uint16_t near[turn], far[turn], parts[turn];  // two neighbours each, the first in the lower byte
  for (std::size_t from = first; from < last; from += turn) {
    const std::size_t count = last - from < turn ? last - from : turn;
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint8_t* const at = in.grey + in.place[from + i];
      std::memcpy(&near[i], at, 2);
      std::memcpy(&far[i], at + in.stride, 2);
    }
    std::memcpy(parts, in.weights + 2 * from, 2 * count);
    std::uint8_t* const pixels = in.pixels + from;
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t line = parts[i] & 0xFFU, sample = parts[i] >> 8U;
      const std::uint32_t above = (near[i] & 0xFFU) * (256U - line) + (near[i] >> 8U) * line;
      const std::uint32_t below = (far[i] & 0xFFU) * (256U - line) + (far[i] >> 8U) * line;
      pixels[i] = static_cast<std::uint8_t>((above * (256U - sample) + below * sample + 32768U) >> 16U);
    }
  }
}

}  // namespace bodkin::imaging::scan
