#include "fem/solid/elastic_assembly.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/error.h"
#include "fem/solid/element_stiffness.h"

namespace bodkin::fem {

namespace {

std::array<Vec3, 4> corners_at(const anatomy::TetrahedralMesh& mesh, std::size_t element) {
  const auto& nodes = mesh.elements[element];
  return {mesh.nodes[nodes[0]], mesh.nodes[nodes[1]], mesh.nodes[nodes[2]], mesh.nodes[nodes[3]]};
}

// The elements around each node: those of node n are `element[start[n]]` to `element[start[n + 1]]`.
struct Incidence {
  std::vector<std::size_t> start;
  std::vector<std::uint32_t> element;
};

Incidence incidence_of(const anatomy::TetrahedralMesh& mesh) {
  Incidence incidence;
  incidence.start.assign(mesh.nodes.size() + 1, 0);
  for (const auto& element : mesh.elements)
    for (const std::uint32_t node : element) ++incidence.start[node + 1];
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) incidence.start[node + 1] += incidence.start[node];
  incidence.element.resize(4 * mesh.elements.size());
  std::vector<std::size_t> next(incidence.start.begin(), incidence.start.end() - 1);
  for (std::uint32_t element = 0; element < mesh.elements.size(); ++element)
    for (const std::uint32_t node : mesh.elements[element]) incidence.element[next[node]++] = element;
  return incidence;
}

// A shape function of an element: of a corner, or of the edge between two.
struct ShapeFunction {
  std::uint32_t unknown = 0;
  std::size_t a = 0, b = 0;  // corners; both the same for a corner function
  bool is_of_edge() const noexcept { return a != b; }
};

// The unknowns that are not fixed, at most ten.
class ShapeFunctions {
 public:
  ShapeFunctions(const std::array<std::uint32_t, 4>& corners, const ElasticSystem& system) {
    for (std::size_t a = 0; a < 4; ++a) {
      const std::uint32_t free = system.free_nodes[corners[a]];
      if (free != ElasticSystem::fixed) all_[count_++] = {free, a, a};
    }
    if (system.edges.size() == 0) return;
    for (std::size_t a = 0; a < 4; ++a) {
      for (std::size_t b = a + 1; b < 4; ++b) {
        const std::uint32_t edge = system.edges.unknown(corners[a], corners[b]);
        if (edge != QuadraticEdges::none) all_[count_++] = {edge, a, b};
      }
    }
  }
  const ShapeFunction* begin() const noexcept { return all_.data(); }
  const ShapeFunction* end() const noexcept { return all_.data() + count_; }

 private:
  std::array<ShapeFunction, 10> all_{};
  std::size_t count_ = 0;
};

// The pattern of the matrix: pairs of unknowns that share an element.
void find_pattern(const anatomy::TetrahedralMesh& mesh, ElasticSystem& system) {
  const Incidence incidence = incidence_of(mesh);
  BlockMatrix& matrix = system.stiffness;
  matrix.nodes = static_cast<std::uint32_t>(system.mesh_nodes.size() + system.edges.size());
  matrix.start.reserve(matrix.nodes + 1);
  matrix.start.push_back(0);
  matrix.row.reserve(9 * std::size_t{matrix.nodes});
  for (std::uint32_t column = 0; column < matrix.nodes; ++column) {
    const std::uint32_t node = system.mesh_node_of(column);
    for (std::size_t i = incidence.start[node]; i < incidence.start[node + 1]; ++i) {
      const ShapeFunctions functions(mesh.elements[incidence.element[i]], system);
      if (std::ranges::none_of(functions, [column](const ShapeFunction& f) { return f.unknown == column; })) continue;
      for (const ShapeFunction& function : functions)
        if (function.unknown >= column) matrix.row.push_back(function.unknown);
    }
    const auto first = matrix.row.begin() + static_cast<std::ptrdiff_t>(matrix.start.back());
    std::sort(first, matrix.row.end());
    matrix.row.erase(std::unique(first, matrix.row.end()), matrix.row.end());
    matrix.start.push_back(matrix.row.size());
  }
}

// N/mm, between the corners of an element.
using CornerBlocks = std::array<std::array<Mat3, 4>, 4>;

// Between two shape functions; if p is of a corner, q is, too. The gradient of an edge's is 4 (w_a g_b + w_b g_a);
// the mean of w_i over an element is 1/4, that of w_i w_j 1/20, of w_i^2 1/10.
Mat3 block_between(const ShapeFunction& p, const ShapeFunction& q, const CornerBlocks& corners) {
  if (!p.is_of_edge()) return corners[p.a][q.a];
  if (!q.is_of_edge()) return corners[p.a][q.a] + corners[p.b][q.a];
  const auto mean = [](std::size_t i, std::size_t j) { return i == j ? 1.6 : 0.8; };  // times 16
  const Mat3 straight = mean(p.a, q.a) * corners[p.b][q.b] + mean(p.b, q.b) * corners[p.a][q.a],
             crossed = mean(p.a, q.b) * corners[p.b][q.a] + mean(p.b, q.a) * corners[p.a][q.b];
  return straight + crossed;
}

void add_element(const anatomy::TetrahedralMesh& mesh, const ElasticMaterials& materials, std::size_t element,
                 ElasticSystem& system) {
  const TetrahedronGradients shape = tetrahedron_gradients(corners_at(mesh, element));
  const ElasticConstants constants = elastic_constants(*materials.find(mesh.tissues[element]));
  BlockMatrix& matrix = system.stiffness;
  const ShapeFunctions functions(mesh.elements[element], system);
  const bool linear = std::ranges::none_of(functions, &ShapeFunction::is_of_edge);
  CornerBlocks corners;
  for (std::size_t a = 0; a < 4 && !linear; ++a)
    for (std::size_t b = 0; b < 4; ++b) corners[a][b] = stiffness_block(shape, constants, a, b);
  for (const ShapeFunction& of_column : functions) {
    const auto first = matrix.row.begin() + static_cast<std::ptrdiff_t>(matrix.start[of_column.unknown]);
    const auto last = matrix.row.begin() + static_cast<std::ptrdiff_t>(matrix.start[of_column.unknown + 1]);
    for (const ShapeFunction& of_row : functions) {
      if (of_row.unknown < of_column.unknown) continue;
      const auto place = static_cast<std::size_t>(std::lower_bound(first, last, of_row.unknown) - matrix.row.begin());
      matrix.block[place] += linear ? stiffness_block(shape, constants, of_row.a, of_column.a)
                                    : block_between(of_row, of_column, corners);
    }
  }
}

}  // namespace

ElasticSystem assemble(const anatomy::TetrahedralMesh& mesh, const ElasticMaterials& materials,
                       std::span<const std::uint32_t> fixed_nodes, QuadraticEdges edges) {
  ElasticSystem system;
  system.edges = std::move(edges);
  system.free_nodes.assign(mesh.nodes.size(), 0);
  for (const std::uint32_t node : fixed_nodes) system.free_nodes[node] = ElasticSystem::fixed;
  for (std::uint32_t node = 0; node < mesh.nodes.size(); ++node) {
    if (system.free_nodes[node] == ElasticSystem::fixed) continue;
    system.free_nodes[node] = static_cast<std::uint32_t>(system.mesh_nodes.size());
    system.mesh_nodes.push_back(node);
  }
  if (system.mesh_nodes.empty()) {
    throw InputError("every node of the body is fixed, so that nothing can move; fix fewer of them");
  }
  find_pattern(mesh, system);
  system.stiffness.block.assign(system.stiffness.row.size(), Mat3::Zero());
  for (std::size_t element = 0; element < mesh.elements.size(); ++element)
    add_element(mesh, materials, element, system);
  return system;
}

Eigen::VectorXd elastic_forces(const anatomy::TetrahedralMesh& mesh, const ElasticMaterials& materials,
                               const Eigen::VectorXd& displacement) {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(displacement.size());
  for (std::size_t element = 0; element < mesh.elements.size(); ++element) {
    const TetrahedronGradients shape = tetrahedron_gradients(corners_at(mesh, element));
    const ElasticConstants constants = elastic_constants(*materials.find(mesh.tissues[element]));
    Mat3 gradient = Mat3::Zero();  // of the displacement
    for (std::size_t corner = 0; corner < 4; ++corner)
      gradient += displacement.segment<3>(3 * Eigen::Index{mesh.elements[element][corner]}) *
                  shape.gradient[corner].transpose();
    const Mat3 stress = stress_of(constants, 0.5 * (gradient + gradient.transpose()));
    for (std::size_t corner = 0; corner < 4; ++corner)
      forces.segment<3>(3 * Eigen::Index{mesh.elements[element][corner]}) +=
          shape.volume * (stress * shape.gradient[corner]);
  }
  return forces;
}

std::vector<std::uint32_t> nodes_of_tissues(const anatomy::TetrahedralMesh& mesh,
                                            std::span<const anatomy::TissueId> tissues) {
  std::vector<bool> chosen(mesh.nodes.size(), false);
  for (std::size_t element = 0; element < mesh.elements.size(); ++element) {
    if (std::find(tissues.begin(), tissues.end(), mesh.tissues[element]) == tissues.end()) continue;
    for (const std::uint32_t node : mesh.elements[element]) chosen[node] = true;
  }
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t node = 0; node < mesh.nodes.size(); ++node)
    if (chosen[node]) nodes.push_back(node);
  return nodes;
}

std::vector<std::uint32_t> nodes_beyond(const anatomy::TetrahedralMesh& mesh, const Vec3& point, const Vec3& normal) {
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t node = 0; node < mesh.nodes.size(); ++node)
    if ((mesh.nodes[node] - point).dot(normal) >= 0.0) nodes.push_back(node);
  return nodes;
}

}  // namespace bodkin::fem
