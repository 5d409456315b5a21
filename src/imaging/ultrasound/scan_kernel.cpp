// Compiled once for each processor path (BODKIN_PATH names it), from this one source and with strict floating point,
// so that all of them give the same bits. Loops over the lanes are kept short and plain: loads from scattered places
// are in separate loops, and the rest is vectorised.
#include "imaging/ultrasound/scan_kernel.h"

#include "core/simd.h"
#include "imaging/ultrasound/scan_sample.h"

namespace bodkin::imaging::scan {

namespace {

constexpr int half = lanes / 2;  // lines that have a register of the widest processor path

// The processor's sqrt: exact, without the errno handling of <cmath>.
inline float root(float x) noexcept {
  return __builtin_sqrtf(x);
}

// The state of a line along its path.
struct State {
  alignas(64) float start[lanes];      // impedance where the present ramp began
  alignas(64) float previous[lanes];   // impedance of the last sample
  alignas(64) float reflected[lanes];  // amplitude reflected by the present ramp so far
  alignas(64) float before[lanes];     // amplitude, there and back, before the present ramp
  alignas(64) float along[lanes];      // slopes as in Sample, where the present ramp is steepest
  alignas(64) float steep[lanes];
  alignas(64) float strong_at[lanes];
  alignas(64) float strong_echo[lanes];
  alignas(64) float strong_now[lanes];  // 1 on the ramp of that surface
};

// The echo of a surface with reflection r, corrected so that its level is right although it spreads over a voxel.
// Weak ones, which may be the CT's noise, remain unchanged: the factor grows with r^2 to its full value at 0.03. Of
// strong ones at most 0.3 is corrected: bone is bright anyway, and the stairs of its voxels would be visible.
inline float spread_echo(float reflected, float sharpness) noexcept {
  constexpr float from = 1.0F / (0.03F * 0.03F);
  const float soft = bounded(reflected, -0.3F, 0.3F), sure = soft * soft * from;
  return reflected + sharpness * soft * (1.0F < sure ? 1.0F : sure);
}

// Surfaces: reflection, refraction, and what is left of the sound. The impedance rises or falls over some samples (a
// "ramp") from `start`; the whole ramp reflects like a sharp surface between its two ends (Fresnel's law for
// pressure), each sample a part, and transmits the rest. Its angle is that of its steepest sample, including the one
// before it: the last one often lies behind it, where the slope is meaningless. `coupled`: there may still be gel.
// `leads`: this ray detects strong surfaces. `sharp`: echoes are spread over a voxel.
template <int count, bool coupled, bool leads, bool sharp>
inline void reflect(const March& __restrict in, int line, int k, const Sample& __restrict s, State& __restrict state,
                    float* __restrict echo, float* __restrict reaches) noexcept {
  constexpr float flat = 0.004F;  // relative change in a sample below which a ramp has ended
  const float depth = static_cast<float>(k);
  const float matched = in.matched, soft_mirror = in.mirror, bone_mirror = in.bone_mirror, bone_edge = in.bone_edge,
              surface = in.surface, sharpness = in.sharpness;
  for (int l = 0; l < count; ++l) {
    const bool in_gel = coupled && depth < in.gel_samples[line + l];
    const float impedance = s.impedance[l], here_along = s.along[l], here_at_all = s.steep[l];
    const float last_along = state.along[l], last_at_all = state.steep[l];
    const float last_start = state.start[l], last_reflected = state.reflected[l], last_before = state.before[l];
    const float z = in_gel ? matched : impedance;
    const float previous = state.previous[l];
    const float change = z - previous;
    const float size = change < 0.0F ? -change : change;
    const float grows = size < flat * z ? -1.0F : change * (previous - last_start);
    const bool going_on = grows >= 0.0F;
    const float start = going_on ? last_start : previous;
    const float so_far = going_on ? last_reflected : 0.0F;
    const float settled = last_before * (1.0F - last_reflected * last_reflected);
    const float before = going_on ? last_before : settled;
    // With `normal` the squared slope and `along` the slope along the line, along^2 / normal is the squared cosine of
    // the angle of incidence. Without a slope the line counts as perpendicular.
    const bool steepest = here_at_all >= last_at_all;
    const float slope_at_all = steepest ? here_at_all : last_at_all, slope_along = steepest ? here_along : last_along;
    const bool level = slope_at_all < 1.0F;
    const float within = level ? 1.0F : slope_at_all, transverse = level ? 1.0F : slope_along;
    const float normal = in_gel ? 1.0F : within, along = in_gel ? 1.0F : transverse;
    const bool ended = size < flat * z;
    const float kept_along = ended ? here_along : slope_along, kept_at_all = ended ? here_at_all : slope_at_all;
    state.along[l] = in_gel ? 0.0F : kept_along;
    state.steep[l] = in_gel ? 0.0F : kept_at_all;

    // Speeds of sound: 1040 m/s + 310 m/s per MRayl holds for soft tissue within 2 % and for cortical bone within its
    // spread.
    constexpr float faster = 310.0F / 4096.0F / 1040.0F;
    const float speed = 1.0F + faster * z, speed_before = 1.0F + faster * start;
    // A beam is wider than the voxel stairs of a soft surface: along one, angles below 60 degrees are not trusted.
    const float hard = z > start ? z : start;
    const float least = hard < bone_from ? 0.25F * normal : 0.0F;
    const float squared = along * along > least ? along * along : least;
    const float bent = speed_before * speed_before * normal - speed * speed * (normal - squared);
    const float behind = start * root(bent > 0.0F ? bent : 0.0F);  // 0: total reflection
    const float ahead = z * speed_before * root(squared);
    const float reflected = (ahead - behind) / (ahead + behind + 1e-3F);
    const float cosine2 = along * along / normal;

    const float dense = z >= bone_from ? 1.0F : 0.0F;
    const float bone = change > 0.0F ? dense : 0.0F;
    const float mirror = bone > 0.0F ? bone_mirror : soft_mirror;
    const float fourth = cosine2 * cosine2, eighth = fourth * fourth;
    const float received = mirror * (eighth * eighth) + (1.0F - mirror) * cosine2;
    const float part =
        sharp ? spread_echo(reflected, sharpness) - spread_echo(so_far, sharpness) : reflected - so_far;
    echo[l] = before * part * received * (1.0F + bone_edge * bone) * surface;

    const float fall = float_from_bits(static_cast<std::uint32_t>(s.medium[l]));
    const float kept = depth < in.leaves[line + l] ? fall : 0.0F;  // beyond the volume all sound is absorbed
    const float left = before * (in_gel ? 1.0F : kept);
    if constexpr (leads) {
      const float total = reflected < 0.0F ? -reflected : reflected;
      const float at = state.strong_at[l], last_echo = state.strong_echo[l];
      float strong = total > 0.35F ? 1.0F : 0.0F;  // steep enough, still audible, and the first on its line
      strong = cosine2 > 0.5F ? strong : 0.0F;
      strong = before > 1e-4F ? strong : 0.0F;
      strong = at < 0.0F ? strong : 0.0F;
      const float still = going_on ? state.strong_now[l] : 0.0F;  // its ramp continues, and its echo grows
      const float now = strong > 0.0F ? 1.0F : still;
      state.strong_now[l] = now;
      state.strong_at[l] = strong > 0.0F ? depth : at;
      state.strong_echo[l] = now > 0.0F ? total * before * received : last_echo;
    }
    const float through = before * (1.0F - reflected * reflected);
    reaches[l] = in_gel ? 0.0F : through;
    state.start[l] = start;
    state.previous[l] = z;
    state.reflected[l] = reflected;
    state.before[l] = left;
  }
}

// The echo of scatterers for the amplitude that `reaches` them. `more`: in addition to the present one.
template <int count, bool more>
inline void scatter(const March& __restrict in, int k, const Sample& __restrict s, const Scatterer& __restrict at,
                    const float* __restrict reaches, float* __restrict in_phase,
                    float* __restrict quadrature) noexcept {
  const float gain = in.speckle_gain[k] * (in.both_sides ? 0.5F / 64.0F : 1.0F / 64.0F);
  for (int l = 0; l < count; ++l) {
    const auto texture = static_cast<std::uint32_t>(s.medium[l] >> 32);
    const std::uint32_t scatterer = at.parts[l];
    const float variation = static_cast<float>(static_cast<std::int32_t>(texture & 0xFFU)) * (1.0F / 255.0F / 128.0F);
    const float bundle = 1.0F + variation * static_cast<float>(at.fibre[l]);
    const bool there = (scatterer >> 16 & 0xFFU) < (texture >> 8 & 0xFFU);
    const float full = float_from_bits(texture & 0xFFFF0000U) * reaches[l] * gain * bundle;
    const float level = there ? full : 0.0F;
    const float real = level * static_cast<float>(static_cast<std::int32_t>(scatterer << 24) >> 24);
    const float imaginary = level * static_cast<float>(static_cast<std::int32_t>(scatterer << 16) >> 24);
    in_phase[l] = more ? in_phase[l] + real : real;
    quadrature[l] = more ? quadrature[l] + imaginary : imaginary;
  }
}

// Where sample k of every line is, and the voxels about it.
template <int count>
inline void approach(const March& __restrict in, int line, int k, Sample& __restrict s) noexcept {
  if (in.moved[0] != nullptr) {
    if (in.offset != nullptr) {
      place<count, true, true>(in, line, k, s);
    } else {
      place<count, true, false>(in, line, k, s);
    }
  } else if (in.offset != nullptr) {
    place<count, false, true>(in, line, k, s);
  } else {
    place<count, false, false>(in, line, k, s);
  }
  if (in.scatterers != nullptr) {
    find_cells<count, false>(in, k, s, s.here);
    if (in.both_sides) find_cells<count, true>(in, k, s, s.opposite);
  }
  load<count>(in, s);
}

template <int count, bool leads, bool sharp>
void march_lines(const March& in, int line) noexcept {
  State state;
  for (int l = 0; l < count; ++l) {
    state.start[l] = state.previous[l] = in.matched;
    state.reflected[l] = state.along[l] = state.steep[l] = 0.0F;
    state.before[l] = in.gel_samples[line + l] <= static_cast<float>(in.samples) ? 1.0F : 0.0F;
    state.strong_at[l] = -1.0F;
    state.strong_echo[l] = state.strong_now[l] = 0.0F;
  }
  float thickest = 0.0F;
  for (int l = 0; l < count; ++l)
    thickest = in.gel_samples[line + l] > thickest ? in.gel_samples[line + l] : thickest;
  const int gel_rows = static_cast<int>(thickest) + 1;
  Sample s;
  alignas(64) float echo[lanes], reaches[lanes], in_phase[lanes], quadrature[lanes];
  // Loads of the next sample overlap with the work on this one: numbers stored one by one and read as a whole right
  // afterwards would stall.
  const bool speckled = in.scatterers != nullptr;
  approach<count>(in, line, 0, s);
  if (speckled) load_speckle<count>(in, s);
  meet<count>(in, line, s);
  for (int k = 0; k < in.samples; ++k) {
    const bool more = k + 1 < in.samples;
    load_media<count>(in, s);
    if (more) approach<count>(in, line, k + 1, s);
    if (k < gel_rows) {
      reflect<count, true, leads, sharp>(in, line, k, s, state, echo, reaches);
    } else {
      reflect<count, false, leads, sharp>(in, line, k, s, state, echo, reaches);
    }
    float* const sum_in_phase = in.in_phase + static_cast<std::ptrdiff_t>(k) * in.stride + line;
    float* const sum_quadrature = in.quadrature + static_cast<std::ptrdiff_t>(k) * in.stride + line;
    if (speckled) {
      scatter<count, false>(in, k, s, s.here, reaches, in_phase, quadrature);
      if (in.both_sides) scatter<count, true>(in, k, s, s.opposite, reaches, in_phase, quadrature);
      for (int l = 0; l < count; ++l) in_phase[l] += echo[l];
      if (more) load_speckle<count>(in, s);
    } else {
      for (int l = 0; l < count; ++l) in_phase[l] = echo[l];
      for (int l = 0; l < count; ++l) quadrature[l] = 0.0F;
    }
    if (more) meet<count>(in, line, s);
    if constexpr (leads) {
      float* const amplitude = in.amplitude + static_cast<std::ptrdiff_t>(k) * in.stride + line;
      for (int l = 0; l < count; ++l) sum_in_phase[l] = in.weight * in_phase[l];
      for (int l = 0; l < count; ++l) sum_quadrature[l] = in.weight * quadrature[l];
      for (int l = 0; l < count; ++l) amplitude[l] = reaches[l];
    } else {
      for (int l = 0; l < count; ++l) sum_in_phase[l] += in.weight * in_phase[l];
      for (int l = 0; l < count; ++l) sum_quadrature[l] += in.weight * quadrature[l];
    }
  }
  if constexpr (leads) {
    for (int l = 0; l < count; ++l) in.strong_at[line + l] = state.strong_at[l];
    for (int l = 0; l < count; ++l) in.strong_echo[line + l] = state.strong_echo[l];
  }
}

// Lines without contact of the face receive nothing.
template <bool leads>
void leave_silent(const March& in, int line) noexcept {
  if constexpr (leads) {
    for (int k = 0; k < in.samples; ++k) {
      const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(k) * in.stride + line;
      for (int l = 0; l < half; ++l) in.in_phase[at + l] = in.quadrature[at + l] = in.amplitude[at + l] = 0.0F;
    }
    for (int l = 0; l < half; ++l) {
      in.strong_at[line + l] = -1.0F;
      in.strong_echo[line + l] = 0.0F;
    }
  }
}

bool any_contact(const March& in, int line) noexcept {
  bool any = false;
  for (int l = 0; l < half; ++l) any = any || in.gel_samples[line + l] <= static_cast<float>(in.samples);
  return any && line < in.lines;
}

// The lines of a block, together or in halves.
template <bool leads, bool sharp>
void march_block(const March& in, int line) noexcept {
  const bool first = any_contact(in, line), second = any_contact(in, line + half);
  if (first && second) {
    march_lines<lanes, leads, sharp>(in, line);
    return;
  }
  if (first) {
    march_lines<half, leads, sharp>(in, line);
  } else {
    leave_silent<leads>(in, line);
  }
  if (second) {
    march_lines<half, leads, sharp>(in, line + half);
  } else {
    leave_silent<leads>(in, line + half);
  }
}

void march(const March& in, int block) noexcept {
  const int line = block * lanes;
  if (in.first) {
    in.sharpness > 0.0F ? march_block<true, true>(in, line) : march_block<true, false>(in, line);
  } else {
    in.sharpness > 0.0F ? march_block<false, true>(in, line) : march_block<false, false>(in, line);
  }
}

}  // namespace

extern const Kernel BODKIN_JOIN(kernel_, BODKIN_PATH);
const Kernel BODKIN_JOIN(kernel_, BODKIN_PATH) = {march, BODKIN_JOIN(compress_, BODKIN_PATH),
                                                  BODKIN_JOIN(convert_, BODKIN_PATH)};

}  // namespace bodkin::imaging::scan
