#include "fem/solid/patient_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "fem/solid/mesh_place.h"

namespace bodkin::fem {

namespace {

constexpr double before_skin = 5.0;    // mm of the planned line before the entry, part of the corridor
constexpr double behind_face = 2.5;    // mm outwards of a face, to look for more tissue
constexpr double closest_voxel = 3.0;  // mm from a node, to search for its tissue
constexpr anatomy::TissueId outside_volume = 255;

// By TissueId: whether it neither moves nor can be punctured.
std::array<bool, 256> rigid_tissues(const anatomy::TissueLibrary& library) {
  std::array<bool, 256> rigid{};
  for (const anatomy::TissueProperties& tissue : library.tissues())
    rigid[tissue.id] = tissue.layered.kind == anatomy::LayeredKind::rigid;
  return rigid;
}

// Patients lie along the axes of their CT: +x to the left, +y to the back, +z to the head.
ElasticMaterial material_of(const anatomy::DeformableTissue& tissue, double scale) {
  ElasticMaterial material{.young = scale * tissue.young, .poisson = tissue.poisson};
  if (tissue.fibres == anatomy::FibreAxis::none) return material;
  material.fibre = tissue.fibres == anatomy::FibreAxis::superior ? Vec3::UnitZ()
                   : tissue.fibres == anatomy::FibreAxis::left   ? Vec3::UnitX()
                                                                 : Vec3::UnitY();
  material.young_along = tissue.young_along > 0.0 ? scale * tissue.young_along : material.young;
  material.shear_along = tissue.shear_along > 0.0 ? scale * tissue.shear_along : lame_constants(material).mu;
  return material;
}

ElasticMaterials materials_of(const anatomy::TetrahedralMesh& mesh, const anatomy::TissueLibrary& library,
                              double scale) {
  std::array<bool, 256> met{};
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const anatomy::TissueId id = mesh.tissues[e];
    const anatomy::TissueProperties* tissue = library.find(id);
    if (tissue != nullptr && tissue->deformable.young > 0.0) {
      met[id] = true;
      continue;
    }
    throw InputError(
        fmt::format("element {} of the mesh at {} is of {}, which has no material; give the tissue an element "
                    "<deformable> in the "
                    "tissue library",
                    e, place_of_element(mesh, e), library.title(id)));
  }
  ElasticMaterials materials;
  for (const anatomy::TissueProperties& tissue : library.tissues()) {
    if (met[tissue.id]) materials.set(tissue.id, material_of(tissue.deformable, scale));
  }
  return materials;
}

struct OuterFace {
  std::array<std::uint32_t, 3> nodes;
  std::uint32_t opposite;  // the fourth corner of its element
};

// Faces that belong to one element only.
std::vector<OuterFace> outer_faces(const anatomy::TetrahedralMesh& mesh) {
  std::map<std::array<std::uint32_t, 3>, std::pair<OuterFace, int>> faces;
  for (const auto& element : mesh.elements) {
    for (std::size_t left_out = 0; left_out < 4; ++left_out) {
      OuterFace face{};
      for (std::size_t i = 0; i < 3; ++i) face.nodes[i] = element[(left_out + 1 + i) % 4];
      face.opposite = element[left_out];
      std::array<std::uint32_t, 3> key = face.nodes;
      std::sort(key.begin(), key.end());
      auto& [kept, count] = faces.try_emplace(key, face, 0).first->second;
      ++count;
    }
  }
  std::vector<OuterFace> outer;
  for (const auto& [key, face] : faces)
    if (face.second == 1) outer.push_back(face.first);
  return outer;
}

// Whether more of the patient lies behind the face.
bool is_cut(const OuterFace& face, const anatomy::TetrahedralMesh& mesh, const anatomy::TissueVolume& tissues) {
  const Vec3 &a = mesh.nodes[face.nodes[0]], &b = mesh.nodes[face.nodes[1]], &c = mesh.nodes[face.nodes[2]];
  Vec3 outwards = (b - a).cross(c - a).normalized();
  if (outwards.dot(mesh.nodes[face.opposite] - a) > 0.0) outwards = -outwards;
  const Vec3 behind = (a + b + c) / 3.0 + behind_face * outwards;
  return anatomy::nearest<anatomy::TissueId>(tissues, behind, outside_volume) != anatomy::tissue::air;
}

std::vector<std::uint32_t> fixed_nodes(const anatomy::TetrahedralMesh& mesh, const anatomy::Case& patient,
                                       const anatomy::NeedlePath& path,
                                       const anatomy::DeformableBodySettings& settings) {
  std::vector<bool> fixed(mesh.nodes.size(), false);
  if (settings.fix_bone) {
    const std::array<bool, 256> rigid = rigid_tissues(patient.library);
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
      if (!rigid[mesh.tissues[e]]) continue;
      for (const std::uint32_t node : mesh.elements[e]) fixed[node] = true;
    }
  }
  if (settings.fix_cut) {
    for (const OuterFace& face : outer_faces(mesh)) {
      if (!is_cut(face, mesh, patient.tissues)) continue;
      for (const std::uint32_t node : face.nodes) fixed[node] = true;
    }
  }
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t node = 0; node < mesh.nodes.size(); ++node) {
    if (fixed[node] || (mesh.nodes[node] - path.entry).dot(path.direction()) > settings.fix_beyond)
      nodes.push_back(node);
  }
  return nodes;
}

double distance_to_segment(const Vec3& point, const Vec3& from, const Vec3& to) {
  const Vec3 along = to - from;
  const double share = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (point - (from + share * along)).norm();
}

// The planned path, extended at both ends, along which the corridor is prepared.
std::pair<Vec3, Vec3> corridor_line(const anatomy::NeedlePath& path, const anatomy::CorridorSettings& settings) {
  return {path.entry - before_skin * path.direction(), path.target + settings.beyond * path.direction()};
}

// Tissue of the closest voxel within closest_voxel that is not air; air when there is no such voxel.
anatomy::TissueId tissue_beside(const anatomy::TissueVolume& tissues, const Vec3& point) {
  const anatomy::TissueId here = anatomy::nearest<anatomy::TissueId>(tissues, point, anatomy::tissue::air);
  if (here != anatomy::tissue::air) return here;
  const Vec3 index = tissues.grid.to_index(point);
  double closest = closest_voxel;
  anatomy::TissueId found = anatomy::tissue::air;
  std::array<int, 3> low{}, high{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<Eigen::Index>(axis);
    const double reach = closest_voxel / tissues.grid.spacing[at];
    low[axis] = std::max(0, static_cast<int>(std::floor(index[at] - reach)));
    high[axis] = std::min(tissues.grid.size[axis] - 1, static_cast<int>(std::ceil(index[at] + reach)));
  }
  for (int k = low[2]; k <= high[2]; ++k) {
    for (int j = low[1]; j <= high[1]; ++j) {
      for (int i = low[0]; i <= high[0]; ++i) {
        const anatomy::TissueId there = tissues.at(i, j, k);
        if (there == anatomy::tissue::air) continue;
        const double away = (tissues.grid.to_patient(Vec3(i, j, k)) - point).norm();
        if (away >= closest) continue;
        closest = away;
        found = there;
      }
    }
  }
  return found;
}

}  // namespace

std::vector<std::uint32_t> corridor_about(const BodyDescription& body, const anatomy::NeedlePath& path,
                                          const anatomy::CorridorSettings& settings,
                                          std::vector<std::string>& notes) {
  const auto [from, to] = corridor_line(path, settings);
  std::vector<bool> fixed(body.mesh.nodes.size(), false);
  for (const std::uint32_t node : body.fixed) fixed[node] = true;
  std::vector<std::pair<double, std::uint32_t>> near;
  for (std::uint32_t node = 0; node < body.mesh.nodes.size(); ++node) {
    const double away = distance_to_segment(body.mesh.nodes[node], from, to);
    if (!fixed[node] && away <= settings.radius) near.emplace_back(away, node);
  }
  if (near.empty()) {
    throw InputError(
        fmt::format("no node of the mesh that can move lies within {:g} mm of the path; mesh the patient again "
                    "around this path, or give a larger corridor_radius_mm",
                    settings.radius));
  }
  const auto most = static_cast<std::size_t>(settings.nodes);
  if (near.size() > most) {
    std::sort(near.begin(), near.end());
    notes.push_back(fmt::format(
        "the corridor reaches {:.1f} mm from the path, because it has at most {} nodes, and {} lie within "
        "{:g} mm; give a larger corridor_nodes where the needle is to be free to enter",
        near[most - 1].first, most, near.size(), settings.radius));
    near.resize(most);
  }
  std::vector<std::uint32_t> nodes;
  for (const auto& [away, node] : near) nodes.push_back(node);
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

BodyDescription describe_body(anatomy::TetrahedralMesh mesh, const anatomy::Case& patient,
                              const anatomy::DeformableBodySettings& settings, const anatomy::NeedlePath& path) {
  if (!(path.length() > 0.0)) {
    throw InputError(
        "the path about which the deformable body is prepared ends where it begins; give another target");
  }
  BodyDescription body;
  body.mesh = std::move(mesh);
  body.materials = materials_of(body.mesh, patient.library, settings.stiffness_scale);
  body.fixed = fixed_nodes(body.mesh, patient, patient.description.procedure.path.value_or(path), settings);
  return body;
}

void take_tissues_of_voxels(anatomy::CondensedBody& body, const anatomy::Case& patient) {
  const std::array<bool, 256> rigid = rigid_tissues(patient.library);
  for (std::size_t node = 0; node < body.nodes.size(); ++node) {
    const anatomy::TissueId found = tissue_beside(patient.tissues, body.nodes[node]);
    if (found != anatomy::tissue::air && !rigid[found]) body.tissues[node] = found;
  }
}

}  // namespace bodkin::fem
