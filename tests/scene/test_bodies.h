#pragma once

#include <cmath>

#include "scene/mesh.h"
#include "scene/surfaces.h"

#include "anatomy/volume.h"

namespace bodkin::scene {

// A ball of radius 40 mm about (10, 20, 30): skin, in it muscle, and in that a ball of bone of radius 15 mm.
inline const Vec3 ball_middle(10.0, 20.0, 30.0);
inline constexpr double ball_radius = 40.0, bone_radius = 15.0;

inline anatomy::TissueVolume ball_of_tissues(double spacing = 1.0) {
  anatomy::Grid grid;
  const int size = static_cast<int>(std::lround(100.0 / spacing));
  grid.size = {size, size, size};
  grid.spacing = Vec3::Constant(spacing);
  grid.origin = ball_middle - Vec3::Constant(0.5 * spacing * (size - 1));
  anatomy::TissueVolume tissues(grid);
  for (int k = 0; k < size; ++k) {
    for (int j = 0; j < size; ++j) {
      for (int i = 0; i < size; ++i) {
        const double distance = (grid.to_patient(Vec3(i, j, k)) - ball_middle).norm();
        if (distance < bone_radius) {
          tissues.at(i, j, k) = anatomy::tissue::cortical_bone;
        } else if (distance < ball_radius - 3.0) {
          tissues.at(i, j, k) = anatomy::tissue::muscle;
        } else if (distance < ball_radius) {
          tissues.at(i, j, k) = anatomy::tissue::skin;
        }
      }
    }
  }
  return tissues;
}

inline const PatientSurfaces& ball_surfaces() {
  static const PatientSurfaces surfaces = make_surfaces(ball_of_tissues());
  return surfaces;
}

}  // namespace bodkin::scene
