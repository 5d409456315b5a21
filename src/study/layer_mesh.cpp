#include "study/layer_mesh.h"

#include <cmath>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::study {

namespace {

constexpr double most_nodes = 400000.0;

struct Planes {
  std::vector<double> depth;               // mm
  std::vector<anatomy::TissueId> between;  // each and the next
};

Planes planes_of(std::span<const MeshLayer> layers, double edge) {
  Planes planes{{0.0}, {}};
  for (const MeshLayer& layer : layers) {
    const double top = planes.depth.back();
    const int parts = static_cast<int>(std::ceil(layer.thickness / edge));
    for (int part = 1; part <= parts; ++part) {
      planes.depth.push_back(top + layer.thickness * part / parts);
      planes.between.push_back(layer.tissue);
    }
  }
  return planes;
}

// A brick is cut along its diagonal from corner 0 to 7 (bits: x, y, z): one tetrahedron for each order of axes of a
// way along its edges, corners ordered for positive volume.
constexpr std::array<std::array<unsigned, 4>, 6> tetrahedra_of_brick = {
    {{0, 1, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 3, 2, 7}, {0, 6, 4, 7}, {0, 5, 1, 7}}};

}  // namespace

anatomy::TetrahedralMesh mesh_of_layers(std::span<const MeshLayer> layers, double width, double edge) {
  const Planes planes = planes_of(layers, edge);
  const double cells = 2.0 * std::ceil(0.5 * width / edge);  // even, so that nodes lie on the middle line
  const double count = (cells + 1.0) * (cells + 1.0) * static_cast<double>(planes.depth.size());
  if (count > most_nodes) {
    throw InputError(
        fmt::format("the mesh of the layers has {:.0f} nodes, expected at most {:.0f}; make mesh_mm larger or "
                    "width_mm smaller",
                    count, most_nodes));
  }
  const auto across = static_cast<std::uint32_t>(cells);
  anatomy::TetrahedralMesh mesh;
  for (const double depth : planes.depth) {
    for (std::uint32_t j = 0; j <= across; ++j) {
      for (std::uint32_t i = 0; i <= across; ++i)
        mesh.nodes.emplace_back(width * (i / cells - 0.5), width * (j / cells - 0.5), depth);
    }
  }
  const std::uint32_t row = across + 1, plane = row * row;
  for (std::uint32_t k = 0; k < planes.between.size(); ++k) {
    for (std::uint32_t j = 0; j < across; ++j) {
      for (std::uint32_t i = 0; i < across; ++i) {
        const std::uint32_t corner = k * plane + j * row + i;
        for (const auto& tetrahedron : tetrahedra_of_brick) {
          std::array<std::uint32_t, 4> nodes{};
          for (std::size_t n = 0; n < nodes.size(); ++n) {
            const unsigned bits = tetrahedron[n];
            nodes[n] = corner + (bits & 1U) + row * ((bits >> 1U) & 1U) + plane * (bits >> 2U);
          }
          mesh.elements.push_back(nodes);
          mesh.tissues.push_back(planes.between[k]);
        }
      }
    }
  }
  return mesh;
}

}  // namespace bodkin::study
