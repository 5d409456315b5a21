#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "anatomy/tetrahedral_mesh.h"
#include "anatomy/tissue.h"
#include "core/geometry.h"

namespace bodkin::fem {

// A linear elastic material: isotropic, or with fibres and isotropic across them. Tension along its fibres also makes
// it thinner by Poisson's ratio.
struct ElasticMaterial {
  double young = 0.0;         // MPa, above 0; across the fibres if there are any
  double poisson = 0.0;       // above -1, at most 0.49; closer to 1/2 linear tetrahedra lock
  Vec3 fibre = Vec3::Zero();  // unit vector along the fibres; zero: none
  double young_along = 0.0;   // MPa, along the fibres, above 0
  double shear_along = 0.0;   // MPa, between the fibres and directions across them, above 0

  bool has_fibres() const noexcept { return !fibre.isZero(0.0); }
};

// Lame's constants of a material, MPa: stress = lambda tr(strain) 1 + 2 mu strain.
struct LameConstants {
  double lambda = 0.0;  // E nu / ((1 + nu) (1 - 2 nu))
  double mu = 0.0;      // E / (2 (1 + nu))
};

// For a material with fibres: those across the fibres.
LameConstants lame_constants(const ElasticMaterial& material) noexcept;

// All constants of a material (Spencer 1984): with f along the fibres and e the strain, MPa,
//   stress = lambda tr(e) 1 + 2 mu e + coupling ((f.e f) 1 + tr(e) f f) + shear (f (e f) + (e f) f)
//            + tension (f.e f) f f.
// Without fibres the last three are zero.
struct ElasticConstants {
  LameConstants across;
  double coupling = 0.0, shear = 0.0, tension = 0.0;
  Vec3 fibre = Vec3::Zero();
};

ElasticConstants elastic_constants(const ElasticMaterial& material) noexcept;

Mat3 stress_of(const ElasticConstants& material, const Mat3& strain) noexcept;

// The materials of a body, one per tissue.
class ElasticMaterials {
 public:
  // Throws InputError when a value is outside its range.
  void set(anatomy::TissueId tissue, const ElasticMaterial& material);
  // nullptr for an id without a material.
  const ElasticMaterial* find(anatomy::TissueId tissue) const noexcept {
    return by_tissue_[tissue] ? &*by_tissue_[tissue] : nullptr;
  }

 private:
  std::array<std::optional<ElasticMaterial>, 256> by_tissue_;  // by TissueId
};

// The first tissue of a mesh that has fibres; empty: none has.
std::optional<anatomy::TissueId> tissue_with_fibres(const anatomy::TetrahedralMesh& mesh,
                                                    const ElasticMaterials& materials) noexcept;

// Throws InputError naming the first element whose tissue has no material, and its position. Returns a warning, one
// sentence, if one tissue is more than a million times as stiff as another. The mesh's indices must be in range.
std::vector<std::string> check_materials(const anatomy::TetrahedralMesh& mesh, const ElasticMaterials& materials);

}  // namespace bodkin::fem
