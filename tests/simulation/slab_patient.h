#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "anatomy/case.h"
#include "simulation/tick_record.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::simulation;

// A block of tissue slabs along z, 60 x 60 mm wide, skin at z = 0, voxels of 1 mm: paths through it are known.
inline TissueLibrary slab_library() {
  std::vector<TissueProperties> tissues;
  const auto add = [&tissues](TissueId id, const char* name, const LayeredTissue& layered) {
    tissues.push_back({.id = id, .name = name, .title = name, .layered = layered});
  };
  const LayeredTissue skin{.kind = LayeredKind::viscoelastic,
                           .stiffness = 0.05,
                           .viscosity = 0.001,
                           .break_force = 1.0,
                           .shaft_stiffness = 0.02,
                           .static_friction = 0.024,
                           .dynamic_friction = 0.02,
                           .roughness = 0.1};
  const LayeredTissue muscle{.kind = LayeredKind::viscoelastic,
                             .stiffness = 0.03,
                             .viscosity = 0.001,
                             .break_force = 0.5,
                             .shaft_stiffness = 0.02,
                             .static_friction = 0.018,
                             .dynamic_friction = 0.015};
  LayeredTissue flavum = muscle;
  flavum.stiffness = 1.7;
  flavum.element_spacing = 20.0;
  flavum.break_force = 3.0;
  add(tissue::air, "air", {});
  add(tissue::skin, "skin", skin);
  add(tissue::fat, "fat", {.kind = LayeredKind::viscous, .drag = 0.0004});
  add(tissue::muscle, "muscle", muscle);
  add(tissue::cortical_bone, "bone", {.kind = LayeredKind::rigid, .contact_stiffness = 3.16});
  add(tissue::ligamentum_flavum, "flavum", flavum);
  add(tissue::epidural_fat, "epidural", {.kind = LayeredKind::viscous, .drag = 0.0004});
  return TissueLibrary(tissues);
}

// Skin 2, fat 10, muscle 20, flavum 4, epidural space 8, then bone to 120 mm.
inline std::vector<TissueId> spine_slabs() {
  std::vector<TissueId> slabs(120, tissue::cortical_bone);
  std::fill(slabs.begin(), slabs.begin() + 2, tissue::skin);
  std::fill(slabs.begin() + 2, slabs.begin() + 12, tissue::fat);
  std::fill(slabs.begin() + 12, slabs.begin() + 32, tissue::muscle);
  std::fill(slabs.begin() + 32, slabs.begin() + 36, tissue::ligamentum_flavum);
  std::fill(slabs.begin() + 36, slabs.begin() + 44, tissue::epidural_fat);
  return slabs;
}

inline Case slab_patient(const std::vector<TissueId>& slabs = spine_slabs()) {
  Case patient;
  patient.library = slab_library();
  Grid grid;
  grid.size = {60, 60, static_cast<int>(slabs.size())};
  grid.origin = {-29.5, -29.5, 0.5};
  patient.tissues = TissueVolume(grid);
  const std::size_t slice = 3600;
  for (std::size_t k = 0; k < slabs.size(); ++k) {
    std::fill_n(patient.tissues.voxels.begin() + static_cast<std::ptrdiff_t>(k * slice), slice, slabs[k]);
  }
  return patient;
}

inline TickInput needle_at(const Vec3& tip, const Vec3& axis = Vec3::UnitZ()) {
  return {needle_pose(tip, axis)};
}
inline TickInput needle_at(double depth) {
  return needle_at(Vec3(0.0, 0.0, depth));
}

}  // namespace bodkin
