#pragma once

#include <cstddef>
#include <cstdint>

namespace bodkin::imaging::kernel {

// Where little of a ray's light is left steps are twice and then four times as long.
inline constexpr int step_lengths = 3;

// What the inner loops know of a volume and its look: plain pointers, all in the index of the volume with its border.
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
  // Tissue that has moved, null: none has. For each point of a lattice, x fastest, how far off (index, four numbers)
  // at rest that lies which now is there.
  const float* moved = nullptr;
  int moved_size[3] = {};      // points
  float moved_spacing = 1.0F;  // mm
  int moved_blocks = 0;        // by how many blocks in each direction anything has moved at most
};

// The part of a ray within the volume: sample n lies (n + 1/2) steps behind `entry`; the last one stands for what is
// left of the way, in its middle.
struct Way {
  float entry[3] = {};       // index
  float direction[3] = {};   // index for each mm
  float until_next[3] = {};  // mm for each index; where the ray goes neither way, more than any ray is long
  float light[3] = {};       // unit, along i, j, k in mm, towards the light
  float lattice_entry[3] = {}, lattice_direction[3] = {};  // as entry and direction, in the lattice of what has moved
  int samples = 0;
  float last = 1.0F;       // mm that the last sample stands for, at most `step`
  float last_at = 0.0F;    // mm behind `entry` of the last sample
  bool far_apart = false;  // see RayCaster::cast()
};

struct Met {
  float red = 0.0F, green = 0.0F, blue = 0.0F, opacity = 0.0F;
  float most = -32768.0F;
  float sum = 0.0F;
};

void cast_light(const Field& field, const Way& way, Met& met) noexcept;
// The same where tissue has moved, in a function of its own: without it the other would be slower.
void cast_moved_light(const Field& field, const Way& way, Met& met) noexcept;
void cast_maximum(const Field& field, const Way& way, Met& met) noexcept;
void cast_sum(const Field& field, const Way& way, Met& met) noexcept;

}  // namespace bodkin::imaging::kernel
