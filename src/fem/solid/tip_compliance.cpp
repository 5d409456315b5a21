#include "fem/solid/tip_compliance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <optional>

#include "anatomy/mesh_parts.h"
#include "core/repeatable.h"
#include "fem/solid/elastic_assembly.h"
#include "fem/solid/mesh_patch.h"
#include "fem/solid/packed_factor.h"

namespace bodkin::fem {

namespace {

constexpr int places_in_disk = 400;
constexpr double edges_around = 2.0;  // of elements about the disk that are refined
constexpr int most_levels = 7;

// Edge over the disk's radius, of meshes below which elements are split no further, and of those used unchanged.
constexpr double cut_down_to = 1.0, fine_enough = 0.35;
// Remaining gain over the last gain: after a further split of second-order elements, and after first-order elements
// have become second-order. Against CalculiX (docs/contact-points.md): a disk then sinks 0.1 to 0.6 % less than it
// should.
constexpr double rest_of_cutting = 1.0 / 3.0, rest_of_order = 1.0 / 4.0;

constexpr double ball_of_element = 0.6;  // radius over edge, as compliant as a barycentric point
constexpr double least_gain = 0.01;
constexpr int wave_directions = 1000;  // between along the fibres and across them

// The points in the disk over which the force is spread: a sunflower pattern, each with the same area.
Vec3 place_in(const TipDisk& disk, int i) {
  const double angle = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
  const double away = disk.radius * std::sqrt((i + 0.5) / places_in_disk);
  const Vec3 side = disk.normal.unitOrthogonal(), other = disk.normal.cross(side);
  return disk.centre + away * (repeatable::cos(angle) * side + repeatable::sin(angle) * other);
}

// mm, mean over the elements that contain or adjoin the disk; 0: it is outside the mesh.
double edge_about(const anatomy::TetrahedralMesh& mesh, const TipDisk& disk, const PointFinder& finder) {
  std::map<std::uint32_t, double> met;
  for (int i = 0; i < places_in_disk; i += 16) {
    const PointInMesh found = finder.find(place_in(disk, i));
    if (!found.moves()) continue;
    met[found.element] = edge_of_volume(anatomy::element_volume(mesh, found.element));
  }
  double sum = 0.0;
  for (const auto& [element, edge] : met) sum += edge;
  return met.empty() ? 0.0 : sum / static_cast<double>(met.size());
}

// The points of a disk in the mesh, those outside it moved to its surface: a patch of the mesh finds them at once.
// Nothing for an immobile disk.
using DiskPlaces = std::vector<std::optional<Vec3>>;

DiskPlaces in_mesh(const std::vector<PointInMesh>& places, const std::vector<Vec3>& nodes) {
  DiskPlaces found;
  found.reserve(places.size());
  for (const PointInMesh& place : places) {
    Vec3 at = Vec3::Zero();
    for (std::size_t i = 0; i < 4; ++i) at += place.weights[i] * nodes[place.nodes[i]];
    found.push_back(place.moves() ? std::optional<Vec3>(at) : std::nullopt);
  }
  return found;
}

// Compliance of the disk in a patch; nothing if the patch cannot be solved.
std::optional<Mat3> compliance_in(const MeshPatch& patch, const ElasticMaterials& materials, const DiskPlaces& disk) {
  std::vector<std::uint32_t> held;
  for (std::uint32_t node = 0; node < patch.fixed.size(); ++node)
    if (patch.fixed[node]) held.push_back(node);
  if (held.size() == patch.fixed.size()) return Mat3(Mat3::Zero());
  const ElasticSystem system =
      assemble(patch.mesh, materials, held, QuadraticEdges(patch.mesh, patch.quadratic, patch.fixed));
  const PointFinder finder(patch.mesh);
  std::vector<PointInMesh> places;
  places.reserve(disk.size());
  for (const std::optional<Vec3>& place : disk) places.push_back(place ? finder.find(*place) : PointInMesh());
  const CarriedPoint carried = carried_point(places, system.free_nodes, system.edges);
  try {
    const MultifrontalCholesky factor(system.stiffness, analyse(graph_of(system.stiffness), {}), {.threads = 1});
    const std::vector<PointResponse> responses = PackedFactor(factor).respond({&carried, 1});
    return compliance_between(responses[0], responses[0]);
  } catch (const NotPositiveDefinite&) {
    return {};  // elements of the patch hang together by an edge
  }
}

}  // namespace

std::vector<PointInMesh> places_of(const TipDisk& disk, const PointFinder& finder, double reach) {
  std::vector<PointInMesh> places;
  places.reserve(places_in_disk);
  for (int i = 0; i < places_in_disk; ++i) places.push_back(finder.find(place_in(disk, i), reach));
  return places;
}

Mat3 refinement_gain(const MeshView& whole, const PointFinder& finder, const ElasticMaterials& materials,
                     const TipDisk& disk) {
  const PointInMesh middle = finder.find(disk.centre);
  const bool quadratic = middle.moves() && whole.quadratic[middle.element];
  double edge = edge_about(whole.mesh, disk, finder);
  if (edge <= (quadratic ? cut_down_to : fine_enough) * disk.radius) return Mat3::Zero();
  const DiskPlaces places = in_mesh(places_of(disk, finder), whole.mesh.nodes);
  Mat3 gained = Mat3::Zero(), last = Mat3::Zero();
  const auto gain = [&](const MeshPatch& coarse, const MeshPatch& fine) {
    const std::optional<Mat3> before = compliance_in(coarse, materials, places);
    const std::optional<Mat3> after = compliance_in(fine, materials, places);
    if (!before || !after) return false;
    last = *after - *before;
    gained += last;
    return true;
  };
  MeshPatch patch = patch_around(whole, disk.centre, edges_around * edge + disk.radius);
  for (int level = 0; level < most_levels && edge > cut_down_to * disk.radius; ++level) {
    if (patch.mesh.elements.empty()) return gained;
    const MeshPatch finer = refined(patch);
    if (!gain(patch, finer)) return gained + rest_of_cutting * last;
    edge *= 0.5;
    patch = patch_around({finer.mesh, finer.fixed, finer.quadratic}, disk.centre, edges_around * edge + disk.radius);
  }
  if (quadratic) return gained + rest_of_cutting * last;
  if (patch.mesh.elements.empty()) return gained;
  MeshPatch second_order = patch;
  second_order.quadratic.assign(second_order.quadratic.size(), true);
  return gain(patch, second_order) ? Mat3(gained + rest_of_order * last) : gained;
}

// The displacement by a force that varies as a wave with the normal n has the amplitude C(n)^-1 of the force over the
// square of the wave number, C(n) the Christoffel tensor: C(n) v is the stress of the strain by v along n, on n. A
// ball is a sum of equal waves in all directions, so that only the mean of C(n)^-1 remains. About fibres C rotates
// with n.
Mat3 ball_compliance(const ElasticMaterial& material) noexcept {
  if (!material.has_fibres()) {
    const double nu = material.poisson, shear = material.young / (2.0 * (1.0 + nu));
    return (3.0 - 4.0 * nu + 1.0 / 3.0) / (16.0 * std::numbers::pi * shear * (1.0 - nu)) * Mat3::Identity();
  }
  const ElasticConstants constants = elastic_constants(material);
  const Vec3 &fibre = material.fibre, side = fibre.unitOrthogonal();
  double along = 0.0, across = 0.0;
  for (int i = 0; i < wave_directions; ++i) {
    const double cosine = (i + 0.5) / wave_directions;
    const Vec3 normal = cosine * fibre + std::sqrt(1.0 - cosine * cosine) * side;
    Mat3 christoffel;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const Mat3 gradient = Vec3::Unit(axis) * normal.transpose();
      christoffel.col(axis) = stress_of(constants, 0.5 * (gradient + gradient.transpose())) * normal;
    }
    const Mat3 inverse = christoffel.inverse();
    const double here = fibre.dot(inverse * fibre);
    along += here / wave_directions;
    across += 0.5 * (inverse.trace() - here) / wave_directions;
  }
  const Mat3 of_fibre = fibre * fibre.transpose();
  return (along * of_fibre + across * (Mat3::Identity() - of_fibre)) / (4.0 * std::numbers::pi);
}

Mat3 shaft_gain(const ElasticMaterial& material, double edge, double radius) noexcept {
  const Mat3 ball = ball_compliance(material), there = ball * 6.0 / (5.0 * ball_of_element * edge);
  const Mat3 gain = ball * 6.0 / (5.0 * radius) - there, least = least_gain * there;
  return gain.trace() > least.trace() ? gain : least;
}

}  // namespace bodkin::fem
