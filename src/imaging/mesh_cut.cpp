#include "imaging/mesh_cut.h"

#include <algorithm>

namespace bodkin::imaging {

std::vector<CutElement> cut_mesh(const anatomy::TetrahedralMesh& mesh, const SlicePlane& plane) {
  std::vector<double> distance(mesh.nodes.size());
  std::transform(mesh.nodes.begin(), mesh.nodes.end(), distance.begin(),
                 [&](const Vec3& node) { return plane.distance(node); });
  std::vector<CutElement> cuts;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    std::array<std::uint32_t, 4> before{}, behind{};
    std::size_t fore = 0, back = 0;
    for (const std::uint32_t node : mesh.elements[e]) (distance[node] < 0.0 ? before[fore++] : behind[back++]) = node;
    if (fore == 0 || back == 0) continue;
    CutElement cut{mesh.tissues[e], 0, {}};
    const auto cross = [&](std::uint32_t a, std::uint32_t b) {
      const double share = distance[a] / (distance[a] - distance[b]);
      cut.points[static_cast<std::size_t>(cut.corners++)] = mesh.nodes[a] + share * (mesh.nodes[b] - mesh.nodes[a]);
    };
    if (fore == 2) {
      cross(before[0], behind[0]);
      cross(before[0], behind[1]);
      cross(before[1], behind[1]);
      cross(before[1], behind[0]);
    } else {
      const bool single_before = fore == 1;
      const std::uint32_t apex = single_before ? before[0] : behind[0];
      const auto& base = single_before ? behind : before;
      for (std::size_t i = 0; i < 3; ++i) cross(apex, base[i]);
    }
    cuts.push_back(cut);
  }
  return cuts;
}

}  // namespace bodkin::imaging
