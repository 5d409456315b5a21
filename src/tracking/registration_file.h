#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tracking/registration.h"

namespace bodkin::tracking {

// Points with or without names.
struct NamedPoints {
  std::vector<std::string> names;  // empty if the file has none
  std::vector<Vec3> points;        // mm
  std::vector<Vec3> deviations;    // mm, standard deviation of each along x, y, z; empty if the file has none
};

// A CSV file with a point on each line: "name,x,y,z" or "x,y,z", or either followed by three standard deviations. A
// first line of column names is allowed. Throws InputError that names file and line, also when two points have one
// name.
NamedPoints read_points(const std::filesystem::path& file);

// A registration as a JSON file, including its quality.
std::string registration_json(const Registration& registration);
// The placement and errors of such a file. Throws InputError.
Registration read_registration(const std::filesystem::path& file);

}  // namespace bodkin::tracking
