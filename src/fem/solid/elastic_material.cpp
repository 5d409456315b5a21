#include "fem/solid/elastic_material.h"

#include <cmath>

#include <fmt/format.h>

#include "core/error.h"
#include "fem/solid/mesh_place.h"

namespace bodkin::fem {

namespace {

constexpr double most_poisson = 0.49;

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

void check_materials(const anatomy::TetrahedralMesh& mesh, const ElasticMaterials& materials) {
  for (std::size_t element = 0; element < mesh.elements.size(); ++element) {
    if (materials.find(mesh.tissues[element]) != nullptr) continue;
    throw InputError(
        fmt::format("tissue {} of element {} at {} has no material; give the tissue a Young's modulus and "
                    "a Poisson's ratio, or mesh the body without it",
                    mesh.tissues[element], element, place_of_element(mesh, element)));
  }
}

}  // namespace bodkin::fem
