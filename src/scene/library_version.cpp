#include "scene/library_version.h"

#include <vtkVersion.h>

namespace bodkin::scene {

std::string vtk_version() {
  return vtkVersion::GetVTKVersion();
}

}  // namespace bodkin::scene
