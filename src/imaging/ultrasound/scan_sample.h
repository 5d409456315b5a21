#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/simd.h"
#include "imaging/ultrasound/scan_kernel.h"

// The content at a sample of each line: the part of the inner loops that reads the patient. Everything has internal
// linkage, because it is compiled once for every processor path.

namespace bodkin::imaging::scan {

// The scatterer and the bundle of fibres there.
struct Scatterer {
  alignas(64) std::int32_t cell[lanes];
  alignas(64) std::int32_t bundle[lanes];
  alignas(64) std::uint32_t parts[lanes];
  alignas(64) std::int32_t fibre[lanes];
};

// The present sample of each line.
struct Sample {
  alignas(64) std::int32_t corner[lanes];             // position of the lowest of its eight voxels
  alignas(64) std::int32_t tissue[lanes];             // of the nearest of them
  alignas(64) float x[lanes], y[lanes], z[lanes];     // voxels
  alignas(64) float fx[lanes], fy[lanes], fz[lanes];  // between the voxels
  alignas(64) std::uint64_t pair[4][lanes];           // neighbours along i, at (j, k), (j+1, k), (j, k+1), (j+1, k+1)
  alignas(64) std::uint64_t medium[lanes];            // as March::media
  Scatterer here, opposite;                           // `opposite`: on the other side of the slice's middle
  alignas(64) float impedance[lanes];
  alignas(64) float along[lanes];  // change of impedance per mm along the line
  alignas(64) float steep[lanes];  // its steepest change, squared
};

// The positions of the samples of row k, and the voxels that surround them. `moved`: the tissue has moved; `aside`:
// this ray is not in the middle of the slice.
template <int count, bool moved, bool aside>
static inline void place(const March& __restrict in, int line, int k, Sample& __restrict s) noexcept {
  constexpr float hair = 1.0F / 1024.0F;  // voxels: the outermost positions still have a voxel behind them
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

// The cells of the scatterer and the fibre volume that contain them. Both volumes are periodic; each repetition is
// shifted, so that no pattern repeats along a line.
template <int count, bool opposite>
static inline void find_cells(const March& __restrict in, int k, const Sample& __restrict s,
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

// Reads all data from scattered addresses. Four lines per iteration, because the loop itself costs as much as a load.
static inline void load_line(const March& __restrict in, std::ptrdiff_t row, std::ptrdiff_t slice,
                             Sample& __restrict s, int l) noexcept {
  const std::uint32_t* const corner = in.voxels + s.corner[l];
  std::memcpy(&s.pair[0][l], corner, 8);
  std::memcpy(&s.pair[1][l], corner + row, 8);
  std::memcpy(&s.pair[2][l], corner + slice, 8);
  std::memcpy(&s.pair[3][l], corner + slice + row, 8);
}

template <int count>
static inline void load(const March& __restrict in, Sample& __restrict s) noexcept {
  const std::ptrdiff_t row = in.size[0], slice = row * in.size[1];
  for (int l = 0; l < count; l += 4) {
    load_line(in, row, slice, s, l);
    load_line(in, row, slice, s, l + 1);
    load_line(in, row, slice, s, l + 2);
    load_line(in, row, slice, s, l + 3);
  }
}

template <int count>
static inline void load_scatterers(const March& __restrict in, Scatterer& __restrict at) noexcept {
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
static inline void load_speckle(const March& __restrict in, Sample& __restrict s) noexcept {
  load_scatterers<count>(in, s.here);
  if (in.both_sides) load_scatterers<count>(in, s.opposite);
}

template <int count>
static inline void load_media(const March& __restrict in, Sample& __restrict s) noexcept {
  for (int l = 0; l < count; l += 4) {
    s.medium[l] = in.media[s.tissue[l]];
    s.medium[l + 1] = in.media[s.tissue[l + 1]];
    s.medium[l + 2] = in.media[s.tissue[l + 2]];
    s.medium[l + 3] = in.media[s.tissue[l + 3]];
  }
}

static inline float impedance_of(std::uint32_t voxel) noexcept {
  return static_cast<float>(static_cast<std::int32_t>(voxel & 0xFFFFU));
}

// The impedance there, linear between the voxels, and the steepness of the surfaces along the line.
template <int count>
static inline void meet(const March& __restrict in, int line, Sample& __restrict s) noexcept {
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

}  // namespace bodkin::imaging::scan
