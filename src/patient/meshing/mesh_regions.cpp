#include "patient/meshing/mesh_regions.h"

#include <cmath>
#include <map>

#include <fmt/format.h>

#include "anatomy/mesh_parts.h"
#include "core/error.h"
#include "io/label_scheme.h"

namespace bodkin::patient {
namespace {

constexpr double least_volume = 1e-9;  // mm^3

std::string region_name(const io::ForeignMesh& foreign, std::int64_t region) {
  const auto name = foreign.names.find(region);
  return name == foreign.names.end() ? fmt::format("region {}", region)
                                     : fmt::format("region {} ('{}')", region, name->second);
}

anatomy::TissueId tissue_of(const io::ForeignMesh& foreign, std::int64_t region,
                            const anatomy::TissueLibrary& library, const std::vector<anatomy::Structure>& scheme,
                            const std::string& origin) {
  if (scheme.empty()) {
    const bool known = region > 0 && region < 255 && library.find(static_cast<anatomy::TissueId>(region)) != nullptr;
    if (!known) {
      throw InputError(
          fmt::format("{}: {} is not the id of a tissue of the case; say with --regions what the regions are made of",
                      origin, region_name(foreign, region)));
    }
    return static_cast<anatomy::TissueId>(region);
  }
  for (const anatomy::Structure& entry : scheme) {
    if (entry.label != region) continue;
    const anatomy::TissueProperties* found = library.find(entry.tissue);
    if (found == nullptr || io::is_resolved_by_construction(entry.tissue) || found->id == anatomy::tissue::air) {
      throw InputError(
          fmt::format("{}: the tissue of {} is '{}', expected the name of one tissue, such as "
                      "cortical_bone",
                      origin, region_name(foreign, region), entry.tissue));
    }
    return found->id;
  }
  throw InputError(fmt::format("{}: there is no row for {} of the mesh", origin, region_name(foreign, region)));
}

}  // namespace

anatomy::TetrahedralMesh with_tissues(const io::ForeignMesh& foreign, const anatomy::TissueLibrary& library,
                                      const std::vector<anatomy::Structure>& scheme, const std::string& origin,
                                      std::vector<std::string>& notes) {
  anatomy::TetrahedralMesh mesh{foreign.nodes, foreign.elements, {}};
  std::map<std::int64_t, anatomy::TissueId> known;
  mesh.tissues.reserve(foreign.regions.size());
  for (const std::int64_t region : foreign.regions) {
    auto found = known.find(region);
    if (found == known.end()) {
      found = known.emplace(region, tissue_of(foreign, region, library, scheme, origin)).first;
    }
    mesh.tissues.push_back(found->second);
  }
  if (const std::size_t turned = anatomy::orient_elements(mesh); turned > 0) {
    notes.push_back(fmt::format("{} tetrahedra were inside out and have been turned.", turned));
  }
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (anatomy::element_volume(mesh, e) >= least_volume) continue;
    const Vec3& place = mesh.nodes[mesh.elements[e].front()];
    throw InputError(
        fmt::format("{}: tetrahedron {} of the mesh, at ({:.1f}, {:.1f}, {:.1f}) mm, has no volume; "
                    "repair the mesh where it was made",
                    origin, e + 1, place.x(), place.y(), place.z()));
  }
  return mesh;
}

}  // namespace bodkin::patient
