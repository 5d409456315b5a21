#include "programs/mesher/label_mesher.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Random.h>
#include <CGAL/exude_mesh_3.h>
#include <CGAL/perturb_mesh_3.h>
#include <CGAL/refine_mesh_3.h>

namespace bodkin::programs {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Domain = CGAL::Labeled_mesh_domain_3<Kernel>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain, CGAL::Default, CGAL::Sequential_tag>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;
using Point = Kernel::Point_3;

// CGAL bounds radii, users specify edges: with these the mean edge is as requested (tests/cli measures it).
constexpr double cell_radius = 0.82;   // circumradius / edge
constexpr double facet_radius = 0.75;  // radius of the surface ball / edge
constexpr double facet_error = 0.12;   // distance of a facet from the interface / edge
constexpr double facet_angle = 25.0;   // degrees, smallest of a facet
constexpr double radius_to_edge = 2.0;
constexpr double sliver_bound = 12.0;        // degrees of dihedral angle, goal of the improvement
constexpr double intersection_error = 1e-5;  // of the box's diagonal
constexpr double first_points = 2.5;         // wanted edges between the first points on the interfaces

// The lattice in the form that CGAL queries.
class Field {
 public:
  explicit Field(const LabelLattice& lattice)
      : lattice_(lattice),
        stride_{1, static_cast<std::size_t>(lattice.size[0]),
                static_cast<std::size_t>(lattice.size[0]) * static_cast<std::size_t>(lattice.size[1])} {}

  int label(const Point& p) const {
    Corner corner;
    if (!locate(p, corner)) return 0;
    std::array<std::uint8_t, 8> labels;
    bool same = true;
    for (std::size_t c = 0; c < 8; ++c) {
      labels[c] = lattice_.labels[corner.first + offset(c)];
      same = same && labels[c] == labels[0];
    }
    if (same) return labels[0];
    int best = 0;
    double most = -1.0;
    for (std::size_t c = 0; c < 8; ++c) {
      double sum = 0.0;
      for (std::size_t other = 0; other < 8; ++other) {
        if (labels[other] == labels[c]) sum += weight(corner, other);
      }
      if (sum > most || (sum == most && labels[c] < best)) {
        most = sum;
        best = labels[c];
      }
    }
    return best;
  }

  double edge(const Point& p) const {
    Corner corner;
    if (!locate(p, corner)) return lattice_.edges[0];
    double sum = 0.0;
    for (std::size_t c = 0; c < 8; ++c) {
      sum += weight(corner, c) * static_cast<double>(lattice_.edges[corner.first + offset(c)]);
    }
    return sum;
  }

  Point point(const std::array<int, 3>& voxel) const {
    return {voxel[0] * lattice_.spacing[0], voxel[1] * lattice_.spacing[1], voxel[2] * lattice_.spacing[2]};
  }
  std::size_t stride(std::size_t axis) const { return stride_[axis]; }
  const LabelLattice& lattice() const { return lattice_; }

 private:
  struct Corner {
    std::size_t first = 0;
    std::array<double, 3> share{};
  };

  bool locate(const Point& p, Corner& corner) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double x = p[static_cast<int>(axis)] / lattice_.spacing[axis];
      if (!(x >= 0.0 && x < lattice_.size[axis] - 1)) return false;
      const double base = std::floor(x);
      corner.share[axis] = x - base;
      corner.first += static_cast<std::size_t>(base) * stride_[axis];
    }
    return true;
  }
  std::size_t offset(std::size_t c) const {
    return (c & 1) * stride_[0] + ((c >> 1) & 1) * stride_[1] + ((c >> 2) & 1) * stride_[2];
  }
  static double weight(const Corner& corner, std::size_t c) {
    double product = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      product *= ((c >> axis) & 1) != 0 ? corner.share[axis] : 1.0 - corner.share[axis];
    }
    return product;
  }

  const LabelLattice& lattice_;
  std::array<std::size_t, 3> stride_;
};

// The wanted edge times a factor, as a sizing field; every few thousand queries it reports progress.
class Sizing {
 public:
  using FT = double;
  Sizing(const Field& field, double factor, const std::function<void()>& sign_of_life)
      : field_(&field), factor_(factor), sign_of_life_(&sign_of_life) {}

  template <typename Index>
  FT operator()(const Point& p, int, const Index&) const {
    if (++asked_ % 4096 == 0) (*sign_of_life_)();
    return factor_ * field_->edge(p);
  }

 private:
  const Field* field_;
  double factor_;
  const std::function<void()>* sign_of_life_;
  mutable std::size_t asked_ = 0;
};

// Points where neighbouring voxels differ, about `first_points` edges from each other, so that refinement finds every
// piece of every label, however small.
void insert_first_points(const Field& field, const Domain& domain, Complex& complex) {
  const LabelLattice& lattice = field.lattice();
  std::unordered_map<std::uint64_t, bool> taken;  // a cell of space and its pair of labels
  const auto& size = lattice.size;
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        const std::array<int, 3> voxel = {i, j, k};
        const std::size_t here = static_cast<std::size_t>(i) + static_cast<std::size_t>(j) * field.stride(1) +
                                 static_cast<std::size_t>(k) * field.stride(2);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          if (voxel[axis] + 1 >= size[axis]) continue;
          const std::uint8_t a = lattice.labels[here], b = lattice.labels[here + field.stride(axis)];
          if (a == b) continue;
          const double cell = std::exp2(std::ceil(
              std::log2(first_points * static_cast<double>(lattice.edges[here]))));  // few sizes, nested cells
          std::uint64_t key = std::min(a, b) * 256ULL + std::max(a, b);
          for (std::size_t other = 0; other < 3; ++other) {
            key = key * 16384ULL + static_cast<std::uint64_t>(voxel[other] * lattice.spacing[other] / cell);
          }
          if (!taken.emplace(key, true).second) continue;
          std::array<int, 3> next = voxel;
          ++next[axis];
          const auto crossing =
              domain.construct_intersection_object()(Domain::Segment_3(field.point(voxel), field.point(next)));
          if (std::get<2>(crossing) == 0) continue;
          const auto vertex = complex.triangulation().insert(Triangulation::Weighted_point(std::get<0>(crossing)));
          complex.set_dimension(vertex, 2);
          complex.set_index(vertex, std::get<1>(crossing));
        }
      }
    }
  }
}

LabelMesh plain(const Complex& complex) {
  LabelMesh mesh;
  std::unordered_map<const void*, std::uint32_t> numbers;
  const auto number = [&](const Triangulation::Vertex_handle& vertex) {
    const auto [place, fresh] = numbers.emplace(&*vertex, static_cast<std::uint32_t>(mesh.nodes.size()));
    if (fresh) {
      const auto& p = vertex->point();
      mesh.nodes.push_back({p.x(), p.y(), p.z()});
    }
    return place->second;
  };
  for (auto cell = complex.cells_in_complex_begin(); cell != complex.cells_in_complex_end(); ++cell) {
    // CGAL's cells are positive in the same order as VTK's.
    mesh.elements.push_back(
        {number(cell->vertex(0)), number(cell->vertex(1)), number(cell->vertex(2)), number(cell->vertex(3))});
    mesh.labels.push_back(static_cast<std::uint8_t>(complex.subdomain_index(cell)));
  }
  mesh.node_count = mesh.nodes.size();
  return mesh;
}

}  // namespace

LabelMesh mesh_labels(const LabelLattice& lattice, const LabelMeshing& meshing,
                      const std::function<void(const char* stage, double fraction)>& progress) {
  namespace params = CGAL::parameters;
  CGAL::get_default_random() = CGAL::Random(0);  // every run makes the same choices
  CGAL::Random random(0);
  const Field field(lattice);
  const auto far = [&](std::size_t axis) { return (lattice.size[axis] - 1) * lattice.spacing[axis]; };
  const Domain domain(
      params::function = [&field](const Point& p) { return field.label(p); },
      params::bounding_object = CGAL::Bbox_3(0.0, 0.0, 0.0, far(0), far(1), far(2)),
      params::relative_error_bound = intersection_error, params::p_rng = &random);

  Complex complex;
  const std::function<void()> sign_of_life = [&] {
    progress("filling with tetrahedra",
             std::min(1.0, static_cast<double>(complex.triangulation().number_of_vertices()) /
                               static_cast<double>(meshing.expected)));
  };
  insert_first_points(field, domain, complex);
  const Criteria criteria(Criteria::Facet_criteria(facet_angle, Sizing(field, facet_radius, sign_of_life),
                                                   Sizing(field, facet_error, sign_of_life)),
                          Criteria::Cell_criteria(radius_to_edge, Sizing(field, cell_radius, sign_of_life)));
  CGAL::refine_mesh_3(complex, domain, criteria, params::no_perturb(), params::no_exude());

  LabelMesh mesh = plain(complex);
  if (mesh.node_count < meshing.fewest || mesh.node_count > meshing.most) {
    const std::size_t missed = mesh.node_count;
    return LabelMesh{.node_count = missed, .nodes = {}, .elements = {}, .labels = {}};
  }
  progress("moving nodes of flat tetrahedra", 0.0);
  CGAL::perturb_mesh_3(complex, domain, params::sliver_bound = sliver_bound);
  progress("weighting nodes of flat tetrahedra", 0.0);
  CGAL::exude_mesh_3(complex, params::sliver_bound = sliver_bound);
  return plain(complex);
}

}  // namespace bodkin::programs
