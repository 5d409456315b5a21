#pragma once

#include <cstdint>

#include "patient/synthetic/bowel.h"
#include "patient/synthetic/spine.h"

namespace bodkin::patient {

// The content of one voxel: tissue and structure label (0: none).
struct Material {
  anatomy::TissueId tissue = anatomy::tissue::air;
  std::uint16_t label = 0;
};

// TotalSegmentator ids of the structures that the synthetic patient has.
namespace structure {
inline constexpr std::uint16_t kidney_right = 2, kidney_left = 3, liver = 5, small_bowel = 18, colon = 20,
                               sacrum = 25, s1 = 26, l5 = 27, t11 = 33, aorta = 52, vena_cava = 63,
                               iliac_artery_left = 65, iliac_artery_right = 66, iliac_vein_left = 67,
                               iliac_vein_right = 68, hip_left = 77, hip_right = 78, canal = 79, autochthon_left = 86,
                               autochthon_right = 87, iliopsoas_left = 88, iliopsoas_right = 89, lesion = 1000;
}

// Outlines of the trunk at one height, superellipses in x and y with a furrow over the spine.
struct TorsoSection {
  struct Outline {
    double half_width, back, front;  // back > front, y of the outline behind and in front
    double furrow;                   // depth of the furrow at the midline
  };
  double middle_x;
  Outline skin, fascia;  // fascia: surface under the subcutaneous fat
};

// The trunk around the spine: skin, fat, muscles, organs and vessels.
class Torso {
 public:
  Torso(const TorsoSizes& sizes, const Spine& spine, std::uint64_t seed);

  // mm by which the supraspinous ligament lies behind the tips of the spinous processes: our choice.
  static constexpr double kSupraspinous = 3.7;

  TorsoSection section(double z, const SpineSection& spine) const;
  // Signed distance to an outline, negative inside; good to a few percent within a centimetre.
  static double outline_distance(const Vec3& p, const TorsoSection& section, const TorsoSection::Outline& outline);
  // The material at p outside bone, disc, canal and spinal ligaments; p is under the skin.
  Material soft_tissue(const Vec3& p, const TorsoSection& torso, const SpineSection& spine) const;
  // Half width and front of the box that holds the skin at every height of the spine.
  double half_width() const;
  double front() const;
  const TorsoSizes& sizes() const { return sizes_; }

 private:
  Material back_muscle(const Vec3& p, double fascia, const TorsoSection& torso, const SpineSection& spine) const;
  double wall_thickness(const Vec3& p, const TorsoSection& torso) const;
  Material vessel(const Vec3& p, const SpineSection& spine) const;
  Material kidney(const Vec3& p) const;
  Material gut(const Vec3& p, const SpineSection& spine) const;

  TorsoSizes sizes_;
  double l1_z_, l4_z_, l5_z_, s1_z_;
  Vec3 kidney_left_, kidney_right_;
  Bowel bowel_;
};

}  // namespace bodkin::patient
