#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "anatomy/tetrahedral_mesh.h"
#include "anatomy/tissue.h"

namespace bodkin::fem {

// A linear elastic isotropic material.
struct ElasticMaterial {
  double young = 0.0;    // MPa, above 0
  double poisson = 0.0;  // above -1, at most 0.49; nearer to 1/2 linear tetrahedra lock
};

// Lame's constants of a material, MPa: stress = lambda tr(strain) 1 + 2 mu strain.
struct LameConstants {
  double lambda = 0.0;  // E nu / ((1 + nu) (1 - 2 nu))
  double mu = 0.0;      // E / (2 (1 + nu))
};

LameConstants lame_constants(const ElasticMaterial& material) noexcept;

// The materials of a body, one per tissue.
class ElasticMaterials {
 public:
  // Throws InputError when a value is outside its range.
  void set(anatomy::TissueId tissue, const ElasticMaterial& material);
  // nullptr when no material has that id.
  const ElasticMaterial* find(anatomy::TissueId tissue) const noexcept {
    return by_tissue_[tissue] ? &*by_tissue_[tissue] : nullptr;
  }

 private:
  std::array<std::optional<ElasticMaterial>, 256> by_tissue_;  // by TissueId
};

// Throws InputError naming the first element whose tissue has no material, and where it is. Returns a warning, one
// sentence, where one tissue is more than a million times as stiff as another. The mesh's indices must be in range.
std::vector<std::string> check_materials(const anatomy::TetrahedralMesh& mesh, const ElasticMaterials& materials);

}  // namespace bodkin::fem
