#pragma once

#include <optional>

#include "patient/from_ct/spinal_canal.h"

namespace bodkin::patient {

// A length measured in the CT, mm.
struct Measured {
  double value;
  double uncertainty;  // half the distance over which the HU change from a quarter to three quarters of the step; at
                       // least half a voxel
};

// Layers behind the dural sac in the midline of one interspace, as far as visible in its HU.
struct LayersSeen {
  std::optional<Measured> wall;      // front edge of the ligamentum flavum, mm behind CanalSection::back
  std::optional<Measured> epidural;  // depth of the posterior epidural fat
};

// Searches backwards from the middle of the canal over the heights `low` to `high` (LPS z) for the first step of at
// least 35 HU, or four times the noise, within 8 mm, from fluid or fat up to ligament; rows in which bone follows at
// once show a lamina and are ignored. Fat behind the ligament lies behind the step and is never met. In front of it
// the epidural fat is where the HU fall by at least 25 below those of the sac. `voxel` is the longest edge (mm) of a
// CT voxel.
LayersSeen see_layers(const SpineView& view, const SpinalCanal& canal, double low, double high, double voxel);

}  // namespace bodkin::patient
