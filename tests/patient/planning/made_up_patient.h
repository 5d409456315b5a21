#pragma once

#include "patient/planning/path_search.h"

namespace bodkin::patient {

// A block of soft tissue in air, 100 mm wide and deep, 1.5 mm voxels along z, on a lattice that does not begin at 0.
class MadeUpPatient {
 public:
  MadeUpPatient();

  // Fills the voxels whose centres lie within `half` (mm, to each side) of `middle`.
  void paint(const Vec3& middle, const Vec3& half, anatomy::TissueId tissue, std::uint16_t label = 0);
  void name(std::uint16_t label, const std::string& name, bool critical);
  PatientView view() const { return {tissues_, labels_, table_, landmarks_, library_}; }
  std::vector<anatomy::Landmark>& landmarks() { return landmarks_; }

 private:
  anatomy::TissueVolume tissues_;
  anatomy::LabelVolume labels_;
  std::vector<anatomy::Structure> table_;
  std::vector<anatomy::Landmark> landmarks_;
  anatomy::TissueLibrary library_;
};

inline MadeUpPatient::MadeUpPatient() {
  anatomy::Grid grid;
  grid.size = {120, 120, 80};
  grid.spacing = {1.0, 1.0, 1.5};
  grid.origin = {-60.0, -60.0, -60.0};
  tissues_ = anatomy::TissueVolume(grid, anatomy::tissue::air);
  labels_ = anatomy::LabelVolume(grid, 0);
  std::vector<anatomy::TissueProperties> tissues;
  for (const auto& [id, tissue_name] :
       {std::pair(anatomy::tissue::air, "air"), std::pair(anatomy::tissue::soft, "soft"),
        std::pair(anatomy::tissue::cortical_bone, "cortical_bone"), std::pair(anatomy::tissue::vessel, "vessel"),
        std::pair(anatomy::tissue::organ, "organ"), std::pair(anatomy::tissue::mass, "mass"),
        std::pair(anatomy::tissue::spinal_cord, "spinal_cord")}) {
    anatomy::TissueProperties one;
    one.id = id;
    one.name = one.title = tissue_name;
    tissues.push_back(one);
  }
  library_ = anatomy::TissueLibrary(tissues);
  paint(Vec3::Zero(), {50.0, 50.0, 50.0}, anatomy::tissue::soft);
}

inline void MadeUpPatient::paint(const Vec3& middle, const Vec3& half, anatomy::TissueId tissue,
                                 std::uint16_t label) {
  const anatomy::Grid& grid = tissues_.grid;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const Vec3 away = (grid.to_patient(Vec3(i, j, k)) - middle).cwiseAbs();
        if ((away.array() > half.array()).any()) continue;
        tissues_.at(i, j, k) = tissue;
        labels_.at(i, j, k) = label;
      }
    }
  }
}

inline void MadeUpPatient::name(std::uint16_t label, const std::string& name, bool critical) {
  anatomy::Structure structure;
  structure.label = label;
  structure.name = name;
  structure.critical = critical;
  table_.push_back(structure);
}

// A path straight in from behind (+y) to `target`.
inline anatomy::NeedlePath straight_to(const Vec3& target) {
  return {{target.x(), 49.5, target.z()}, target};
}

}  // namespace bodkin::patient
