#include "fem/solid/elastic_material.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.h"
#include "fem/solid/mesh_place.h"

namespace bodkin::fem {

namespace {

constexpr double most_poisson = 0.49;
constexpr double most_contrast = 1e6;  // of Young's moduli; beyond it, too few digits remain of the softer one

// A pull along the fibres must not create energy: nu < sqrt(E_a / E), and positive moduli.
void check_fibres(anatomy::TissueId tissue, const ElasticMaterial& material) {
  const double nu = material.poisson, n = material.young / material.young_along;
  if (!(material.young_along > 0.0 && material.shear_along > 0.0 && std::isfinite(material.young_along) &&
        std::isfinite(material.shear_along))) {
    throw InputError(fmt::format(
        "along its fibres tissue {} has a Young's modulus of {} MPa and a shear modulus of {} MPa, expected "
        "more than 0",
        tissue, material.young_along, material.shear_along));
  }
  if (!(1.0 - nu - 2.0 * n * nu * nu > 0.01)) {
    throw InputError(fmt::format(
        "along its fibres tissue {} has a Young's modulus of {} MPa, too soft for {} MPa across them with a "
        "Poisson's ratio of {}; give more along the fibres, or a smaller ratio",
        tissue, material.young_along, material.young, nu));
  }
  if (!(std::abs(material.fibre.norm() - 1.0) < 1e-9))
    throw InputError(fmt::format("the direction of the fibres of tissue {} is not a unit vector", tissue));
}

}  // namespace

LameConstants lame_constants(const ElasticMaterial& material) noexcept {
  const double nu = material.poisson;
  if (material.has_fibres()) {
    const double n = material.young / material.young_along, m = 1.0 - nu - 2.0 * n * nu * nu;
    return {material.young * (nu + n * nu * nu) / ((1.0 + nu) * m), material.young / (2.0 * (1.0 + nu))};
  }
  return {material.young * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), material.young / (2.0 * (1.0 + nu))};
}

// Inverts the compliances 1/E, -nu/E across, 1/E_a, -nu/E_a along and 1/G_a, in the invariants of the fibre.
ElasticConstants elastic_constants(const ElasticMaterial& material) noexcept {
  ElasticConstants constants;
  constants.across = lame_constants(material);
  if (!material.has_fibres()) return constants;
  const double nu = material.poisson, n = material.young / material.young_along;
  const double m = 1.0 - nu - 2.0 * n * nu * nu;
  const double both = material.young * nu / m, along = material.young_along * (1.0 - nu) / m;  // C_13 and C_33
  constants.fibre = material.fibre;
  constants.coupling = both - constants.across.lambda;
  constants.shear = 2.0 * (material.shear_along - constants.across.mu);
  constants.tension =
      along - constants.across.lambda - 2.0 * constants.across.mu - 2.0 * constants.coupling - 2.0 * constants.shear;
  return constants;
}

Mat3 stress_of(const ElasticConstants& material, const Mat3& strain) noexcept {
  const LameConstants& across = material.across;
  const Vec3 &f = material.fibre, drawn = strain * f;
  const double along = f.dot(drawn), trace = strain.trace();
  return across.lambda * trace * Mat3::Identity() + 2.0 * across.mu * strain +
         material.coupling * (along * Mat3::Identity() + trace * (f * f.transpose())) +
         material.shear * (f * drawn.transpose() + drawn * f.transpose()) +
         material.tension * along * (f * f.transpose());
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
  if (material.has_fibres()) check_fibres(tissue, material);
  by_tissue_[tissue] = material;
}

std::optional<anatomy::TissueId> tissue_with_fibres(const anatomy::TetrahedralMesh& mesh,
                                                    const ElasticMaterials& materials) noexcept {
  for (const anatomy::TissueId tissue : mesh.tissues) {
    const ElasticMaterial* const material = materials.find(tissue);
    if (material != nullptr && material->has_fibres()) return tissue;
  }
  return {};
}

std::vector<std::string> check_materials(const anatomy::TetrahedralMesh& mesh, const ElasticMaterials& materials) {
  std::size_t softest = 0, stiffest = 0;
  const auto young_of = [&](std::size_t element) {
    const ElasticMaterial& material = *materials.find(mesh.tissues[element]);
    return std::max(material.young, material.young_along);
  };
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
      "the body is used, but the softer tissue's results are inaccurate; fix the stiffer tissue (fix_bone) or choose "
      "moduli that are closer to each other",
      mesh.tissues[softest], young_of(softest), mesh.tissues[stiffest], young_of(stiffest), most_contrast)};
}

}  // namespace bodkin::fem
