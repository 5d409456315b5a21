#include "anatomy/mesh_parts.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace bodkin::anatomy {
namespace {

// Sets of elements that are joined one pair at a time.
class Partition {
 public:
  explicit Partition(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }

  std::size_t set_of(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[set_of(a)] = set_of(b); }

 private:
  std::vector<std::size_t> parent_;
};

struct Face {
  std::array<std::uint32_t, 3> nodes;  // rising
  std::size_t element;

  bool operator<(const Face& other) const { return std::tie(nodes, element) < std::tie(other.nodes, other.element); }
};

std::vector<Face> faces_of(const TetrahedralMesh& mesh) {
  std::vector<Face> faces;
  faces.reserve(4 * mesh.elements.size());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    for (std::size_t left_out = 0; left_out < 4; ++left_out) {
      Face face{{}, e};
      std::size_t at = 0;
      for (std::size_t corner = 0; corner < 4; ++corner) {
        if (corner != left_out) face.nodes[at++] = mesh.elements[e][corner];
      }
      std::sort(face.nodes.begin(), face.nodes.end());
      faces.push_back(face);
    }
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace

std::size_t keep_largest_part(TetrahedralMesh& mesh) {
  if (mesh.elements.empty()) return 0;
  Partition partition(mesh.elements.size());
  const std::vector<Face> faces = faces_of(mesh);
  for (std::size_t i = 1; i < faces.size(); ++i) {
    if (faces[i].nodes == faces[i - 1].nodes) partition.join(faces[i].element, faces[i - 1].element);
  }
  std::vector<std::size_t> sizes(mesh.elements.size(), 0);
  for (std::size_t e = 0; e < sizes.size(); ++e) ++sizes[partition.set_of(e)];
  const auto largest = static_cast<std::size_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());

  TetrahedralMesh kept;
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(mesh.nodes.size(), unused);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (partition.set_of(e) != largest) continue;
    kept.elements.push_back(mesh.elements[e]);
    kept.tissues.push_back(mesh.tissues[e]);
    for (const std::uint32_t node : mesh.elements[e]) number[node] = 0;
  }
  for (std::size_t node = 0; node < number.size(); ++node) {
    if (number[node] == unused) continue;
    number[node] = static_cast<std::uint32_t>(kept.nodes.size());
    kept.nodes.push_back(mesh.nodes[node]);
  }
  for (auto& element : kept.elements) {
    for (std::uint32_t& node : element) node = number[node];
  }
  const std::size_t removed = mesh.elements.size() - kept.elements.size();
  mesh = std::move(kept);
  return removed;
}

double element_volume(const TetrahedralMesh& mesh, std::size_t e) {
  const auto& corners = mesh.elements[e];
  const Vec3& a = mesh.nodes[corners[0]];
  const Vec3 ab = mesh.nodes[corners[1]] - a, ac = mesh.nodes[corners[2]] - a, ad = mesh.nodes[corners[3]] - a;
  return ab.cross(ac).dot(ad) / 6.0;
}

std::size_t orient_elements(TetrahedralMesh& mesh) {
  std::size_t turned = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (element_volume(mesh, e) >= 0.0) continue;
    std::swap(mesh.elements[e][2], mesh.elements[e][3]);
    ++turned;
  }
  return turned;
}

}  // namespace bodkin::anatomy
