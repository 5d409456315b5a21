// VTK meshes from anybody: refused with a sentence, or sound as far as their numbers go, and the same once written.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/error.h"
#include "io/mesh/foreign_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const bodkin::ForeignMesh mesh = bodkin::parse_vtu(text, "body.vtu");
    if (mesh.elements.empty() || mesh.regions.size() != mesh.elements.size()) std::abort();
    for (const auto& element : mesh.elements) {
      for (const std::uint32_t node : element) {
        if (node >= mesh.nodes.size()) std::abort();
      }
    }
    const bodkin::TetrahedralMesh plain{mesh.nodes, mesh.elements,
                                        std::vector<bodkin::TissueId>(mesh.elements.size(), bodkin::tissue::fat)};
    const bodkin::ForeignMesh again = bodkin::parse_vtu(bodkin::vtu_text(plain), "again.vtu");
    if (again.nodes != mesh.nodes || again.elements != mesh.elements) std::abort();
  } catch (const bodkin::InputError&) {
  }
  return 0;
}
