// Untrusted VTK meshes: refused with a sentence, or numerically sound, and the same once written.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/error.h"
#include "io/mesh/foreign_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const bodkin::io::ForeignMesh mesh = bodkin::io::parse_vtu(text, "body.vtu");
    if (mesh.elements.empty() || mesh.regions.size() != mesh.elements.size()) std::abort();
    for (const auto& element : mesh.elements) {
      for (const std::uint32_t node : element) {
        if (node >= mesh.nodes.size()) std::abort();
      }
    }
    const bodkin::anatomy::TetrahedralMesh plain{
        mesh.nodes, mesh.elements,
        std::vector<bodkin::anatomy::TissueId>(mesh.elements.size(), bodkin::anatomy::tissue::fat)};
    const bodkin::io::ForeignMesh again = bodkin::io::parse_vtu(bodkin::io::vtu_text(plain), "again.vtu");
    if (again.nodes != mesh.nodes || again.elements != mesh.elements) std::abort();
  } catch (const bodkin::InputError&) {
  }
  return 0;
}
