#include "fem/solid/elastic_material.h"

#include <cmath>

#include <fmt/format.h>

#include "core/error.h"
#include "fem/solid/mesh_place.h"

namespace bodkin::fem {

namespace {

constexpr double most_poisson = 0.49;
constexpr double most_contrast = 1e6;  // of Young's moduli; beyond, too few digits are left of the softer one

}  // namespace

LameConstants lame_constants(const ElasticMaterial& material) noexcept {
  const double nu = material.poisson;
  return {material.young * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), material.young / (2.0 * (1.0 + nu))};
}

void ElasticMaterials::set(anatomy::TissueId tissue, const ElasticMaterial& material) {
  if (!(material.young > 0.0 && std::isfinite(material.young))) {
    throw InputError(
        fmt::format("the Young's modulus of tissue {} is {} MPa, expected more than 0; soft tissue has "
                    "about 0.02, bone about 10000",
                    tissue, material.young));
  }
  if (!(material.poisson > -1.0 && material.poisson <= most_poisson)) {
    throw InputError(
        fmt::format("Poisson's ratio of tissue {} is {}, expected more than -1 and at most {}: linear "
                    "tetrahedra cannot be nearly incompressible; 0.45 or less is usual for soft tissue",
                    tissue, material.poisson, most_poisson));
  }
  by_tissue_[tissue] = material;
}

std::vector<std::string> check_materials(const anatomy::TetrahedralMesh& mesh, const ElasticMaterials& materials) {
  std::size_t softest = 0, stiffest = 0;
  const auto young_of = [&](std::size_t element) { return materials.find(mesh.tissues[element])->young; };
  for (std::size_t element = 0; element < mesh.elements.size(); ++element) {
    if (materials.find(mesh.tissues[element]) != nullptr) {
      if (young_of(element) < young_of(softest)) softest = element;
      if (young_of(element) > young_of(stiffest)) stiffest = element;
      continue;
    }
    throw InputError(
        fmt::format("tissue {} of element {} at {} has no material; give the tissue a Young's modulus and "
                    "a Poisson's ratio, or mesh the body without it",
                    mesh.tissues[element], element, place_of_element(mesh, element)));
  }
  if (mesh.elements.empty() || young_of(stiffest) <= most_contrast * young_of(softest)) return {};
  return {fmt::format(
      "tissue {} has a Young's modulus of {:g} MPa and tissue {} one of {:g} MPa, more than {:.0e} times as much: "
      "the "
      "body is used, but what is softer has few exact digits; hold the stiffer tissue (fix_bone) or choose moduli "
      "that "
      "are closer to each other",
      mesh.tissues[softest], young_of(softest), mesh.tissues[stiffest], young_of(stiffest), most_contrast)};
}

}  // namespace bodkin::fem
