#include "io/mesh/foreign_mesh.h"

#include <fmt/format.h>

#include "core/error.h"
#include "io/resources.h"

namespace bodkin::io {
namespace {

constexpr std::size_t largest_mesh_file = std::size_t{2} << 30U;  // bytes

}  // namespace

ForeignMesh read_foreign_mesh(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending != ".msh" && ending != ".vtu") {
    throw InputError(
        fmt::format("{}: the mesh has the ending '{}', expected .msh (Gmsh) or .vtu (VTK)", file.string(), ending));
  }
  const std::string bytes = read_text_file(file, largest_mesh_file);
  return ending == ".msh" ? parse_gmsh(bytes, file.string()) : parse_vtu(bytes, file.string());
}

}  // namespace bodkin::io
