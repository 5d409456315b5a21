#pragma once

#include <string>

namespace bodkin::scene {

// Of the VTK that this program runs with: "9.1.0".
std::string vtk_version();

}  // namespace bodkin::scene
