#include "scene/sections.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include <Eigen/Geometry>

namespace bodkin::scene {

namespace {

// mm below the middle of a triangle searched for its structure, the first found counts; lastly above it, for surfaces
// moved inwards by smoothing.
constexpr std::array<double, 5> depths_of_search = {0.5, 1.5, 3.0, -0.7, -1.5};
constexpr std::size_t fewest_triangles = 20;  // of a section: less is left with the rest

// Required tissue of a structure for a surface to be its outside; a structure with tissue by HU may be any.
std::span<const std::string_view> tissues_of(std::string_view surface) {
  static constexpr std::array<std::string_view, 3> bone = {"bone", "cortical_bone", "cancellous_bone"};
  static constexpr std::array<std::string_view, 5> others = {"disc", "cartilage", "metal", "vessel", "organ"};
  static constexpr std::array<std::string_view, 1> lesion = {"mass"};
  if (surface == "bone") return bone;
  if (surface == "lesion") return lesion;
  const auto found = std::find(others.begin(), others.end(), surface);
  return found == others.end() ? std::span<const std::string_view>() : std::span(&*found, 1);
}

// Names of the structures that may have a part of the surface, by label.
using SectionNames = std::map<std::uint16_t, std::string>;

SectionNames names_for(const PatientSurface& surface, std::span<const anatomy::Structure> structures) {
  SectionNames names;
  const std::span<const std::string_view> tissues = tissues_of(surface.name);
  if (tissues.empty()) return names;
  for (const anatomy::Structure& structure : structures) {
    const bool fits =
        structure.tissue.empty() || std::find(tissues.begin(), tissues.end(), structure.tissue) != tissues.end();
    if (fits) names[structure.label] = structure.name;
  }
  return names;
}

const std::string* structure_under(const SceneMesh& mesh, const std::array<std::int32_t, 3>& triangle,
                                   const anatomy::LabelVolume& labels, const SectionNames& names) {
  Eigen::Vector3f middle = Eigen::Vector3f::Zero(), outwards = Eigen::Vector3f::Zero();
  for (const std::int32_t corner_index : triangle) {
    middle += mesh.points[static_cast<std::size_t>(corner_index)];
    outwards += mesh.normals[static_cast<std::size_t>(corner_index)];
  }
  const Vec3 at = middle.cast<double>() / 3.0, normal = outwards.cast<double>().stableNormalized();
  for (const double depth : depths_of_search) {
    const auto name = names.find(anatomy::nearest(labels, Vec3(at - depth * normal), std::uint16_t{0}));
    if (name != names.end()) return &name->second;
  }
  return nullptr;
}

}  // namespace

void find_sections(const anatomy::LabelVolume& labels, std::span<const anatomy::Structure> structures,
                   PatientSurfaces& surfaces) {
  if (labels.empty()) return;
  for (PatientSurface& surface : surfaces.parts) {
    surface.sections.clear();
    const SectionNames names = names_for(surface, structures);
    if (names.empty()) continue;
    std::map<std::string, std::vector<std::array<std::int32_t, 3>>> by_name;
    for (const std::array<std::int32_t, 3>& triangle : surface.mesh.triangles) {
      const std::string* const name = structure_under(surface.mesh, triangle, labels, names);
      by_name[name == nullptr ? surface.name : *name].push_back(triangle);
    }
    for (auto& [name, triangles] : by_name) {
      if (name == surface.name || triangles.size() >= fewest_triangles) continue;
      auto& rest = by_name[surface.name];
      rest.insert(rest.end(), triangles.begin(), triangles.end());
      triangles.clear();
    }
    std::erase_if(by_name, [](const auto& entry) { return entry.second.empty(); });
    if (by_name.size() == 1 && by_name.begin()->first == surface.name) continue;
    surface.mesh.triangles.clear();
    for (const auto& [name, triangles] : by_name) {
      surface.sections.push_back({name, surface.mesh.triangles.size(), triangles.size()});
      surface.mesh.triangles.insert(surface.mesh.triangles.end(), triangles.begin(), triangles.end());
    }
  }
}

}  // namespace bodkin::scene
