#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "patient/from_ct/morphology.h"

#include "anatomy/case.h"

namespace bodkin::patient {

// The role of a structure in the spine.
namespace spine_role {
inline constexpr std::uint8_t none = 0;
// 1 .. 13: vertebrae T1 .. T13
inline constexpr std::uint8_t l1 = 14;  // .. l1 + 5: L1 .. L6
inline constexpr std::uint8_t sacrum = 20;
inline constexpr std::uint8_t vertebra = 21;  // a vertebra, or a part of one, of unknown level
inline constexpr std::uint8_t canal = 22;
}  // namespace spine_role

// Derives roles from the names of structures ("vertebrae_L3", "L3", "sacrum", "Arcus_Vertebrae", ...) and from the
// tissue "spinal_canal". One entry per label, 65536.
std::vector<std::uint8_t> spine_roles(const std::vector<anatomy::Structure>& table);

// "L3", "T12", "S1"; empty for roles without a level.
std::string level_name(std::uint8_t role);

// A stretch of the spine on its own lattice, whatever the axes of the CT: isotropic, i to the left, j to the back, k
// to the head.
struct SpineView {
  anatomy::Volume<std::int16_t> hounsfield;
  MaskVolume bone;
  anatomy::Volume<std::uint8_t> role;

  const anatomy::Grid& grid() const { return hounsfield.grid; }
  // Nearest indices of LPS coordinates.
  int i_of(double x) const;
  int j_of(double y) const;
  int k_of(double z) const;
  double x_of(int i) const { return grid().origin.x() + i * grid().spacing.x(); }
  double y_of(int j) const { return grid().origin.y() + j * grid().spacing.y(); }
  double z_of(int k) const { return grid().origin.z() + k * grid().spacing.z(); }
  // Bone at indices; false outside the view.
  bool bone_at(int i, int j, int k) const { return grid().contains(i, j, k) && bone.at(i, j, k) != 0; }
};

// An axis-parallel box, LPS mm.
struct PatientBox {
  Vec3 low, high;
};

// Box about all voxels of the roles `first` to `last`, if there are any.
std::optional<PatientBox> box_of_roles(const anatomy::LabelVolume& structures, const std::vector<std::uint8_t>& roles,
                                       std::uint8_t first, std::uint8_t last);
// Box about the whole image.
PatientBox box_of_image(const anatomy::Grid& grid);

SpineView view_spine(const anatomy::CtVolume& ct, const anatomy::LabelVolume& structures,
                     const std::vector<std::uint8_t>& roles, const anatomy::TissueVolume& tissues,
                     const PatientBox& box, double spacing);

}  // namespace bodkin::patient
