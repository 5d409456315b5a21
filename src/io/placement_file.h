#pragma once

#include <filesystem>

#include "core/geometry.h"

namespace bodkin::io {

// Where one set of points was laid upon another: point -> scale * pose.linear() * point + pose.translation(), mm.
struct Placement {
  Pose pose = Pose::Identity();
  double scale = 1.0;
  double fre_rms = 0.0;  // mm, fiducial registration error
};

// Of the JSON file that `bodkin register` writes. Throws InputError that names file and field.
Placement read_placement(const std::filesystem::path& file);

}  // namespace bodkin::io
