#pragma once

#include <cstddef>
#include <cstdint>

#include "imaging/ultrasound/processor_path.h"

// The inner loops of an ultrasound image, compiled once for each processor path. They work on plain arrays and call
// no inline functions of other headers except those of core/simd.h, which are always inlined: so code for one
// processor cannot be linked into code that another one runs.

namespace bodkin::imaging::scan {

inline constexpr int lanes = 32;     // scanlines side by side
inline constexpr int coarse = 8;     // samples between two rows of the displacement table
inline constexpr int cells = 32;     // of the scatterer volume along each axis
inline constexpr int bundles = 32;   // of the fibre volume along each axis
inline constexpr int gel = 256;      // medium after the tissues': the coupling gel
inline constexpr int outside = 257;  // beyond the patient's volume: absorbs everything
inline constexpr int media = 258;
inline constexpr float bone_from =
    10240.0F;  // AcousticVolume::unit of impedance (2.5 MRayl): from here a surface is bone's

// A position, a direction or a displacement of each line, in voxels.
struct LineVectors {
  const float* x;
  const float* y;
  const float* z;
};

// Common data of all rays of one slice. Every array of lines is padded to a whole number of `lanes`, every row of one
// is `stride` floats long.
struct March {
  // patient
  const std::uint32_t* voxels;  // as in AcousticVolume
  std::int32_t size[3];
  float per_mm[3];  // voxels per mm
  // By tissue id: in the lower half, as a float, the fraction of an amplitude that remains after a step, there and
  // back; in the upper half the amplitude of its speckle (bfloat16) << 16 | density << 8 | fibre variation.
  const std::uint64_t* media;
  float mirror, bone_mirror;  // share of a surface's echo that leaves as from a mirror
  float bone_edge;            // additional brightness of bone's surface
  float surface;              // of all surfaces' echoes; 0 does not affect the speckle
  float sharpness;            // partial-volume gain of a surface's echo
  float matched;              // AcousticVolume::unit, impedance of the probe's face and the gel
  // scatterers
  const std::uint32_t*
      scatterers;  // cells^3: in-phase, quadrature (signed bytes), chance (unsigned), unused; null: none
  float cells_per_voxel[3], first_cell[3];  // voxels to cells; far from 0, for truncation to be rounding down
  const std::int8_t* fibres;                // bundles^3
  float bundles_per_voxel[3], first_bundle[3];
  const float* speckle_gain;  // by sample
  // lines
  int lines, samples, stride;
  LineVectors origin;        // voxels
  LineVectors step;          // voxels per sample
  LineVectors direction;     // unit, along the lattice's axes
  const float* gel_samples;  // by line: samples before the skin; more than there are samples: no contact
  const float* leaves;       // by line: sample at which it leaves the patient's volume
  float across[3];           // voxels per mm across the slice
  const float* offset;       // by sample: mm across the slice; null: in its middle
  const float* sides;        // `lanes`: by line of a block, 1 or -1: on which side of the middle
  bool both_sides;           // scatterers are those of both sides, half of each
  const float* moved[3];  // rows of `stride` every `coarse` samples: voxels by which tissue has moved; null: at rest
  // results, rows of `stride`
  float weight;  // of this ray in the sum
  bool first;    // overwrites the sums, and stores the data that only the middle ray provides
  float* in_phase;
  float* quadrature;
  float* amplitude;    // there and back, of the sound that reaches a sample
  float* strong_at;    // by line: sample of the first surface that reflects most of the sound; < 0: none
  float* strong_echo;  // by line: its echo's amplitude
};

// One row of the image before scan conversion.
struct Row {
  const float* in_phase;
  const float* quadrature;
  int samples, stride, lines;
  int row;
  const float* axial;             // weights from -axial_half to axial_half
  int axial_half;                 // samples
  const float* lateral;           // weights from 0 to lateral_half, both sides alike
  int lateral_half;               // lines
  const float* clutter_in_phase;  // rows as above, or null
  const float* clutter_quadrature;
  float gain;                      // amplitude
  float levels_per_octave, white;  // grey = white + levels_per_octave * log2(amplitude)
  float* work;                     // 4 x (stride + 2 x edge)
  std::uint8_t* grey;              // stride bytes
};
inline constexpr int edge = 64;  // floats of padding at both ends of a working row; largest lateral_half

// The positions of an image's pixels among the samples.
struct Conversion {
  const std::uint8_t* grey;  // rows of `stride`
  int stride;
  const std::int32_t* place;    // by pixel: position of the sample before it; a black one outside
  const std::uint8_t* weights;  // 2 by pixel: 256ths towards the next line, towards the next sample
  std::uint8_t* pixels;
};

// The functions of one processor path.
struct Kernel {
  void (*march)(const March& march, int block) noexcept;  // `lanes` lines from lanes x block on
  void (*compress)(const Row& row) noexcept;
  void (*convert)(const Conversion& conversion, std::size_t first, std::size_t last) noexcept;
};

const Kernel& kernel(ProcessorPath path);

// For sources compiled once for each processor path: the functions and the kernel of the path named by BODKIN_PATH.
#ifdef BODKIN_PATH
#define BODKIN_JOIN_(a, b) a##b
#define BODKIN_JOIN(a, b) BODKIN_JOIN_(a, b)
void BODKIN_JOIN(compress_, BODKIN_PATH)(const Row& row) noexcept;
void BODKIN_JOIN(convert_, BODKIN_PATH)(const Conversion& in, std::size_t first, std::size_t last) noexcept;
#endif

}  // namespace bodkin::imaging::scan
