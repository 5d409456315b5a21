#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/geometry.h"

namespace bodkin::io {

// The placement of one set of points on another: point -> scale * pose.linear() * point + pose.translation(), mm.
struct Placement {
  Pose pose = Pose::Identity();
  double scale = 1.0;
  double fre_rms = 0.0;  // mm, fiducial registration error
};

// From the JSON file written by `bodkin register`. Throws InputError that names file and field.
Placement read_placement(const std::filesystem::path& file);

// As above, for rigid use: throws InputError, which ends in `advice`, if the scale is not 1 within 2 %.
Pose read_rigid_placement(const std::filesystem::path& file, std::string_view advice);

// The text of such a file, without the data of the points that only `bodkin register` has.
std::string placement_json(const Placement& placement);

}  // namespace bodkin::io
