#pragma once

#include <cstddef>
#include <cstdint>

namespace bodkin::imaging::kernel {

// When little of a ray's light is left, steps are twice and then four times as long.
inline constexpr int step_lengths = 3;

// Input of the inner loops about a volume and its look: plain pointers, all in the index of the volume with its
// border.
struct Field {
  const std::int16_t* hounsfield = nullptr;  // in bricks, see PreparedVolume
  const std::uint8_t* tissues = nullptr;     // null: colours by HU
  const std::int8_t* gradients = nullptr;    // in bricks, four for each voxel; null: not shaded
  const std::uint8_t* away = nullptr;        // see RayCaster; for the maximum: null
  const std::int16_t* ranges = nullptr;      // least and most of every block
  int size[3] = {};                          // voxels
  int blocks[3] = {};
  const float* depth = nullptr;           // by HU + 1024, 4096 of each
  const float* colours = nullptr;         // four for each: red, green, blue, and a fourth
  const float* shown[step_lengths] = {};  // the opacity of one step, of one twice and of one four times as long
  const float* tissue_colours = nullptr;  // four for each TissueId
  float step = 1.0F;                      // mm
  // Moved tissue, null: none. For each point of a lattice, x fastest, the offset (index, four numbers) to the
  // position at rest of the tissue that is there now.
  const float* moved = nullptr;
  int moved_size[3] = {};      // points
  float moved_spacing = 1.0F;  // mm
  int moved_blocks = 0;        // largest displacement, in blocks, in each direction
};

// The part of a ray within the volume: sample n lies (n + 1/2) steps behind `entry`; the last one represents the rest
// of the ray, in its middle.
struct RaySection {
  float entry[3] = {};       // index
  float direction[3] = {};   // index per mm
  float until_next[3] = {};  // mm per index; if the ray does not advance along an axis, more than any ray is long
  float light[3] = {};       // unit, along i, j, k in mm, towards the light
  float lattice_entry[3] = {}, lattice_direction[3] = {};  // as entry and direction, in the lattice of moved tissue
  int samples = 0;
  float last = 1.0F;       // mm represented by the last sample, at most `step`
  float last_at = 0.0F;    // mm behind `entry` of the last sample
  bool far_apart = false;  // see RayCaster::cast()
};

struct RayResult {
  float red = 0.0F, green = 0.0F, blue = 0.0F, opacity = 0.0F;
  float most = -32768.0F;
  float sum = 0.0F;
};

void cast_light(const Field& field, const RaySection& section, RayResult& result) noexcept;
// As above for moved tissue, in a separate function: combined, the other case would be slower.
void cast_moved_light(const Field& field, const RaySection& section, RayResult& result) noexcept;
void cast_maximum(const Field& field, const RaySection& section, RayResult& result) noexcept;
void cast_sum(const Field& field, const RaySection& section, RayResult& result) noexcept;

}  // namespace bodkin::imaging::kernel
