// Untrusted meshes of Gmsh: refused with a sentence, or numerically sound.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/error.h"
#include "io/mesh/foreign_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const bodkin::io::ForeignMesh mesh = bodkin::io::parse_gmsh(text, "body.msh");
    if (mesh.elements.empty() || mesh.regions.size() != mesh.elements.size()) std::abort();
    for (const auto& element : mesh.elements) {
      for (const std::uint32_t node : element) {
        if (node >= mesh.nodes.size()) std::abort();
      }
    }
  } catch (const bodkin::InputError&) {
  }
  return 0;
}
