#pragma once

#include <utility>
#include <vector>

#include "anatomy/case.h"
#include "io/tissue_library_file.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;

// Tissues and their thicknesses in mm, multiples of 0.5, from the skin inwards.
using Slabs = std::vector<std::pair<TissueId, double>>;

// A body of flat layers whose back is the plane y = 0 and which reaches towards negative y, with air behind it. The
// planned path runs from (0, 0, 0) straight in, to the middle of the last layer. Tissue voxels are 2 x 0.5 x 2 mm.
inline Case slab_case(const Slabs& slabs) {
  constexpr double thin = 0.5, wide = 2.0, air = 20.0;
  constexpr int across = 31;
  double depth = 0.0;
  for (const auto& [id, thickness] : slabs) depth += thickness;

  Case patient;
  patient.library = default_tissue_library();
  Grid grid;
  grid.size = {across, static_cast<int>((depth + air) / thin), across};
  grid.spacing = Vec3(wide, thin, wide);
  grid.origin = Vec3(-wide * (across / 2), -depth + 0.5 * thin, -wide * (across / 2));
  patient.tissues = TissueVolume(grid, tissue::air);
  patient.ct = CtVolume(grid, -1000);
  for (int j = 0; j < grid.size[1]; ++j) {
    const double below = -(grid.origin.y() + thin * j);  // mm below the skin
    TissueId here = tissue::air;
    double from = 0.0;
    for (const auto& [id, thickness] : slabs) {
      if (below > from && below < from + thickness) here = id;
      from += thickness;
    }
    const TissueProperties* properties = patient.library.find(here);
    for (int k = 0; k < across; ++k) {
      for (int i = 0; i < across; ++i) {
        patient.tissues.at(i, j, k) = here;
        patient.ct.at(i, j, k) = static_cast<std::int16_t>(properties->hounsfield);
      }
    }
  }
  patient.description.name = "slabs";
  patient.description.procedure.path = NeedlePath{Vec3::Zero(), Vec3(0.0, -depth + 0.5 * slabs.back().second, 0.0)};
  return patient;
}

// The back of a lumbar puncture, simplified.
inline Slabs lumbar_slabs() {
  return {{tissue::skin, 2.0},
          {tissue::fat, 12.0},
          {tissue::supraspinous_ligament, 3.0},
          {tissue::interspinous_ligament, 20.0},
          {tissue::ligamentum_flavum, 3.5},
          {tissue::epidural_fat, 5.0},
          {tissue::dura, 0.5},
          {tissue::cerebrospinal_fluid, 12.0}};
}

}  // namespace bodkin
