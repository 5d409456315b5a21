#pragma once

#include <string>

namespace bodkin::scene {

// The version of the VTK in use: "9.1.0".
std::string vtk_version();

}  // namespace bodkin::scene
