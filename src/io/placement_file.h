#pragma once

#include <filesystem>
#include <string>
#include <string_view>

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

// The same for what is not scaled: throws InputError, which ends in `advice`, where the scale is not 1 within 2 %.
Pose read_rigid_placement(const std::filesystem::path& file, std::string_view advice);

// The text of such a file, without what only `bodkin register` knows of its points.
std::string placement_json(const Placement& placement);

}  // namespace bodkin::io
