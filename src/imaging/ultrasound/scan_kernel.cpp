// Compiled once for each processor path (BODKIN_PATH names it), from this one source and with strict floating point,
// so that all of them give the same bits. Loops over the lanes are kept short and plain: what loads from scattered
// places stands in loops of its own, and the rest turns into vectors.
#include "imaging/ultrasound/scan_kernel.h"

#include <cstring>

#include "imaging/ultrasound/scan_arithmetic.h"

namespace bodkin::scan {

void BODKIN_JOIN(compress_, BODKIN_PATH)(const Row& row) noexcept;
void BODKIN_JOIN(convert_, BODKIN_PATH)(const Conversion& in, std::size_t first, std::size_t last) noexcept;

namespace {

constexpr int half = lanes / 2;  // lines that have a register of the widest processor path

// sqrt of the processor: exact, without what <cmath> does for errno.
inline float root(float x) noexcept {
  return __builtin_sqrtf(x);
}

// What travels with a line.
struct State {
  alignas(64) float start[lanes];      // impedance where the present ramp began
  alignas(64) float previous[lanes];   // impedance of the last sample
  alignas(64) float reflected[lanes];  // amplitude thrown back by the present ramp so far
  alignas(64) float before[lanes];     // amplitude, there and back, before the present ramp
  alignas(64) float along[lanes];      // slopes as in Sample, where the present ramp is steepest
  alignas(64) float steep[lanes];
  alignas(64) float strong_at[lanes];
  alignas(64) float strong_echo[lanes];
  alignas(64) float strong_now[lanes];  // 1 on the ramp of that surface
};

// Which scatterer and which bundle of fibres are there.
struct Scatterer {
  alignas(64) std::int32_t cell[lanes];
  alignas(64) std::int32_t bundle[lanes];
  alignas(64) std::uint32_t parts[lanes];
  alignas(64) std::int32_t fibre[lanes];
};

// What the present sample of each line is.
struct Sample {
  alignas(64) std::int32_t corner[lanes];             // position of the lowest of its eight voxels
  alignas(64) std::int32_t tissue[lanes];             // of the nearest of them
  alignas(64) float x[lanes], y[lanes], z[lanes];     // voxels
  alignas(64) float fx[lanes], fy[lanes], fz[lanes];  // between the voxels
  alignas(64) std::uint64_t pair[4][lanes];           // neighbours along i, at (j, k), (j+1, k), (j, k+1), (j+1, k+1)
  alignas(64) std::uint64_t medium[lanes];            // as March::media
  Scatterer here, opposite;                           // `opposite`: on the other side of the slice's middle
  alignas(64) float impedance[lanes];
  alignas(64) float along[lanes];  // the impedance's change in a mm along the line
  alignas(64) float steep[lanes];  // where it is steepest, squared
};

// Where the samples of row k lie, and which voxels surround them. `moved`: the tissue has moved; `aside`: this ray is
// not in the middle of the slice.
template <int count, bool moved, bool aside>
inline void place(const March& __restrict in, int line, int k, Sample& __restrict s) noexcept {
  constexpr float hair = 1.0F / 1024.0F;  // voxels: the outermost places still have a voxel behind them
  const float last_x = static_cast<float>(in.size[0] - 1) - hair, last_y = static_cast<float>(in.size[1] - 1) - hair,
              last_z = static_cast<float>(in.size[2] - 1) - hair;
  const std::int32_t row = in.size[0], slice = in.size[0] * in.size[1];
  const float depth = static_cast<float>(k), part = static_cast<float>(k % coarse) * (1.0F / coarse);
  const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(k / coarse) * in.stride + line, next = at + in.stride;
  const float off = aside ? in.offset[k] : 0.0F;
  const float ax = in.across[0] * off, ay = in.across[1] * off, az = in.across[2] * off;
  for (int l = 0; l < count; ++l) {
    float x = in.origin.x[line + l] + in.step.x[line + l] * depth;
    float y = in.origin.y[line + l] + in.step.y[line + l] * depth;
    float z = in.origin.z[line + l] + in.step.z[line + l] * depth;
    if constexpr (moved) {
      x -= in.moved[0][at + l] + part * (in.moved[0][next + l] - in.moved[0][at + l]);
      y -= in.moved[1][at + l] + part * (in.moved[1][next + l] - in.moved[1][at + l]);
      z -= in.moved[2][at + l] + part * (in.moved[2][next + l] - in.moved[2][at + l]);
    }
    if constexpr (aside) {
      x += ax * in.sides[l];
      y += ay * in.sides[l];
      z += az * in.sides[l];
    }
    s.x[l] = x;
    s.y[l] = y;
    s.z[l] = z;
    const float bx = bounded(x, 0.0F, last_x), by = bounded(y, 0.0F, last_y), bz = bounded(z, 0.0F, last_z);
    const auto i = static_cast<std::int32_t>(bx), j = static_cast<std::int32_t>(by),
               m = static_cast<std::int32_t>(bz);
    s.fx[l] = bx - static_cast<float>(i);
    s.fy[l] = by - static_cast<float>(j);
    s.fz[l] = bz - static_cast<float>(m);
    s.corner[l] = i + row * j + slice * m;
  }
}

// Which cells of the scatterer and the fibre volume hold them. Both volumes go on for ever; each time one starts anew
// it is shifted, so that no pattern repeats along a line.
template <int count, bool opposite>
inline void find_cells(const March& __restrict in, int k, const Sample& __restrict s,
                       Scatterer& __restrict found) noexcept {
  const float off = opposite ? -2.0F * in.offset[k] : 0.0F;
  const float ax = in.across[0] * off, ay = in.across[1] * off, az = in.across[2] * off;
  for (int l = 0; l < count; ++l) {
    float x = s.x[l], y = s.y[l], z = s.z[l];
    if constexpr (opposite) {
      x += ax * in.sides[l];
      y += ay * in.sides[l];
      z += az * in.sides[l];
    }
    const auto depth = static_cast<std::int32_t>(in.cells_per_voxel[2] * z + in.first_cell[2]);
    const auto i = static_cast<std::int32_t>(in.cells_per_voxel[0] * x + in.first_cell[0]) + 19 * (depth >> 5);
    const auto j = static_cast<std::int32_t>(in.cells_per_voxel[1] * y + in.first_cell[1]) + 23 * (i >> 5);
    const std::int32_t m = depth + 37 * (j >> 5) + 11 * (i >> 5);
    found.cell[l] = (i & (cells - 1)) | (j & (cells - 1)) << 5 | (m & (cells - 1)) << 10;
    const auto a = static_cast<std::int32_t>(in.bundles_per_voxel[0] * x + in.first_bundle[0]);
    const auto b = static_cast<std::int32_t>(in.bundles_per_voxel[1] * y + in.first_bundle[1]) + 7 * (a >> 5);
    const auto c = static_cast<std::int32_t>(in.bundles_per_voxel[2] * z + in.first_bundle[2]) + 13 * (b >> 5);
    found.bundle[l] = (a & (bundles - 1)) | (b & (bundles - 1)) << 5 | (c & (bundles - 1)) << 10;
  }
}

// Everything that comes from scattered places. Four lines a turn, for the loop itself costs as much as a load.
inline void load_line(const March& __restrict in, std::ptrdiff_t row, std::ptrdiff_t slice, Sample& __restrict s,
                      int l) noexcept {
  const std::uint32_t* const corner = in.voxels + s.corner[l];
  std::memcpy(&s.pair[0][l], corner, 8);
  std::memcpy(&s.pair[1][l], corner + row, 8);
  std::memcpy(&s.pair[2][l], corner + slice, 8);
  std::memcpy(&s.pair[3][l], corner + slice + row, 8);
}

template <int count>
inline void load(const March& __restrict in, Sample& __restrict s) noexcept {
  const std::ptrdiff_t row = in.size[0], slice = row * in.size[1];
  for (int l = 0; l < count; l += 4) {
    load_line(in, row, slice, s, l);
    load_line(in, row, slice, s, l + 1);
    load_line(in, row, slice, s, l + 2);
    load_line(in, row, slice, s, l + 3);
  }
}

template <int count>
inline void load_scatterers(const March& __restrict in, Scatterer& __restrict at) noexcept {
  for (int l = 0; l < count; l += 4) {
    at.parts[l] = in.scatterers[at.cell[l]];
    at.fibre[l] = in.fibres[at.bundle[l]];
    at.parts[l + 1] = in.scatterers[at.cell[l + 1]];
    at.fibre[l + 1] = in.fibres[at.bundle[l + 1]];
    at.parts[l + 2] = in.scatterers[at.cell[l + 2]];
    at.fibre[l + 2] = in.fibres[at.bundle[l + 2]];
    at.parts[l + 3] = in.scatterers[at.cell[l + 3]];
    at.fibre[l + 3] = in.fibres[at.bundle[l + 3]];
  }
}

template <int count>
inline void load_speckle(const March& __restrict in, Sample& __restrict s) noexcept {
  load_scatterers<count>(in, s.here);
  if (in.both_sides) load_scatterers<count>(in, s.opposite);
}

template <int count>
inline void load_media(const March& __restrict in, Sample& __restrict s) noexcept {
  for (int l = 0; l < count; l += 4) {
    s.medium[l] = in.media[s.tissue[l]];
    s.medium[l + 1] = in.media[s.tissue[l + 1]];
    s.medium[l + 2] = in.media[s.tissue[l + 2]];
    s.medium[l + 3] = in.media[s.tissue[l + 3]];
  }
}

inline float impedance_of(std::uint32_t voxel) noexcept {
  return static_cast<float>(static_cast<std::int32_t>(voxel & 0xFFFFU));
}

// The impedance there, linear between the voxels, and how steeply the line meets its surfaces.
template <int count>
inline void meet(const March& __restrict in, int line, Sample& __restrict s) noexcept {
  for (int l = 0; l < count; ++l) {
    const auto va0 = static_cast<std::uint32_t>(s.pair[0][l]), va1 = static_cast<std::uint32_t>(s.pair[0][l] >> 32);
    const auto vb0 = static_cast<std::uint32_t>(s.pair[1][l]), vb1 = static_cast<std::uint32_t>(s.pair[1][l] >> 32);
    const auto vc0 = static_cast<std::uint32_t>(s.pair[2][l]), vc1 = static_cast<std::uint32_t>(s.pair[2][l] >> 32);
    const auto vd0 = static_cast<std::uint32_t>(s.pair[3][l]), vd1 = static_cast<std::uint32_t>(s.pair[3][l] >> 32);
    const float fx = s.fx[l], fy = s.fy[l], fz = s.fz[l];
    const std::uint32_t va = fx < 0.5F ? va0 : va1, vb = fx < 0.5F ? vb0 : vb1, vc = fx < 0.5F ? vc0 : vc1,
                        vd = fx < 0.5F ? vd0 : vd1;
    const std::uint32_t vab = fy < 0.5F ? va : vb, vcd = fy < 0.5F ? vc : vd;
    s.tissue[l] = static_cast<std::int32_t>((fz < 0.5F ? vab : vcd) >> 16);
    const float a0 = impedance_of(va0), a1 = impedance_of(va1), b0 = impedance_of(vb0), b1 = impedance_of(vb1);
    const float c0 = impedance_of(vc0), c1 = impedance_of(vc1), d0 = impedance_of(vd0), d1 = impedance_of(vd1);
    const float da = a1 - a0, db = b1 - b0, dc = c1 - c0, dd = d1 - d0;
    const float a = a0 + fx * da, b = b0 + fx * db, c = c0 + fx * dc, d = d0 + fx * dd;
    const float ab = a + fy * (b - a), cd = c + fy * (d - c);
    const float inside = ab + fz * (cd - ab);
    const float dab = da + fy * (db - da), dcd = dc + fy * (dd - dc);
    const float gx = (dab + fz * (dcd - dab)) * in.per_mm[0];
    const float gy = ((b - a) + fz * ((d - c) - (b - a))) * in.per_mm[1];
    const float gz = (cd - ab) * in.per_mm[2];
    const float along = gx * in.direction.x[line + l] + gy * in.direction.y[line + l] + gz * in.direction.z[line + l];
    const float steep = gx * gx + gy * gy + gz * gz;
    s.along[l] = along < 0.0F ? -along : along;
    s.steep[l] = steep;
    s.impedance[l] = inside;
  }
}

// What a surface's echo is made of its reflection r so that it has its level though it is drawn out over a voxel.
// Weak ones, which may be the CT's noise, stay as they are: the factor grows with r^2 to its whole at 0.03. Of strong
// ones no more than 0.3 gets it: bone is bright anyway, and the stairs of its voxels would shine.
inline float drawn_out(float reflected, float sharpness) noexcept {
  constexpr float from = 1.0F / (0.03F * 0.03F);
  const float soft = bounded(reflected, -0.3F, 0.3F), sure = soft * soft * from;
  return reflected + sharpness * soft * (1.0F < sure ? 1.0F : sure);
}

// Surfaces: reflection, refraction, and what is left of the sound. The impedance rises or falls over some samples (a
// "ramp") from `start`; the whole ramp throws back what the sharp surface between its two ends would (Fresnel's law
// for pressure), each sample its part, and transmission is what that leaves. Its angle is that of its steepest
// sample, the one before it included: the last one often lies behind it, where the slope says nothing.
// `coupled`: there may still be gel. `leads`: this is the ray that tells of strong surfaces.
template <int count, bool coupled, bool leads>
inline void reflect(const March& __restrict in, int line, int k, const Sample& __restrict s, State& __restrict state,
                    float* __restrict echo, float* __restrict reaches) noexcept {
  constexpr float flat = 0.004F;  // relative change in a sample below which a ramp has ended
  const float depth = static_cast<float>(k);
  const float matched = in.matched, soft_mirror = in.mirror, bone_mirror = in.bone_mirror, bone_edge = in.bone_edge,
              surface = in.surface;
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
    // the angle of incidence. Where nothing has a slope the line counts as perpendicular.
    const bool steepest = here_at_all >= last_at_all;
    const float slope_at_all = steepest ? here_at_all : last_at_all, slope_along = steepest ? here_along : last_along;
    const bool level = slope_at_all < 1.0F;
    const float within = level ? 1.0F : slope_at_all, beside = level ? 1.0F : slope_along;
    const float normal = in_gel ? 1.0F : within, along = in_gel ? 1.0F : beside;
    const bool ended = size < flat * z;
    const float kept_along = ended ? here_along : slope_along, kept_at_all = ended ? here_at_all : slope_at_all;
    state.along[l] = in_gel ? 0.0F : kept_along;
    state.steep[l] = in_gel ? 0.0F : kept_at_all;

    // Speeds of sound: 1040 m/s + 310 m/s per MRayl holds for soft tissue within 2 % and for cortical bone within its
    // spread.
    constexpr float faster = 310.0F / 4096.0F / 1040.0F;
    const float speed = 1.0F + faster * z, speed_before = 1.0F + faster * start;
    // A beam is wider than the stairs that voxels make of a soft surface: along one, less than 60 degrees are not
    // believed.
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
    const float part = drawn_out(reflected, in.sharpness) - drawn_out(so_far, in.sharpness);
    echo[l] = before * part * received * (1.0F + bone_edge * bone) * surface;

    const float fall = float_of(static_cast<std::uint32_t>(s.medium[l]));
    const float kept = depth < in.leaves[line + l] ? fall : 0.0F;  // beyond the volume everything is swallowed
    const float left = before * (in_gel ? 1.0F : kept);
    if constexpr (leads) {
      const float total = reflected < 0.0F ? -reflected : reflected;
      const float at = state.strong_at[l], last_echo = state.strong_echo[l];
      float strong = total > 0.35F ? 1.0F : 0.0F;  // steep enough, still heard, and the first on its line
      strong = cosine2 > 0.5F ? strong : 0.0F;
      strong = before > 1e-4F ? strong : 0.0F;
      strong = at < 0.0F ? strong : 0.0F;
      const float still = going_on ? state.strong_now[l] : 0.0F;  // its ramp goes on, and its echo grows
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

// What scatterers return, of the amplitude that `reaches` them. `more`: in addition to what is there already.
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
    const float full = float_of(texture & 0xFFFF0000U) * reaches[l] * gain * bundle;
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

template <int count, bool leads>
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
  // What the next sample loads is on its way while this one is worked on: numbers that were stored one by one and are
  // read as a whole right afterwards would have to be waited for.
  const bool speckled = in.scatterers != nullptr;
  approach<count>(in, line, 0, s);
  if (speckled) load_speckle<count>(in, s);
  meet<count>(in, line, s);
  for (int k = 0; k < in.samples; ++k) {
    const bool more = k + 1 < in.samples;
    load_media<count>(in, s);
    if (more) approach<count>(in, line, k + 1, s);
    if (k < gel_rows) {
      reflect<count, true, leads>(in, line, k, s, state, echo, reaches);
    } else {
      reflect<count, false, leads>(in, line, k, s, state, echo, reaches);
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

// Lines whose face has no contact hear nothing.
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

// The lines of a block, together or by halves.
template <bool leads>
void march_block(const March& in, int line) noexcept {
  const bool first = any_contact(in, line), second = any_contact(in, line + half);
  if (first && second) {
    march_lines<lanes, leads>(in, line);
    return;
  }
  if (first) {
    march_lines<half, leads>(in, line);
  } else {
    leave_silent<leads>(in, line);
  }
  if (second) {
    march_lines<half, leads>(in, line + half);
  } else {
    leave_silent<leads>(in, line + half);
  }
}

void march(const March& in, int block) noexcept {
  if (in.first) {
    march_block<true>(in, block * lanes);
  } else {
    march_block<false>(in, block * lanes);
  }
}

}  // namespace

extern const Kernel BODKIN_JOIN(kernel_, BODKIN_PATH);
const Kernel BODKIN_JOIN(kernel_, BODKIN_PATH) = {march, BODKIN_JOIN(compress_, BODKIN_PATH),
                                                  BODKIN_JOIN(convert_, BODKIN_PATH)};

}  // namespace bodkin::scan
