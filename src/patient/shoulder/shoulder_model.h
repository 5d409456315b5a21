#pragma once

#include <array>

#include "patient/shoulder/shoulder.h"
#include "patient/synthetic/shapes.h"
#include "patient/synthetic/torso.h"

namespace bodkin::patient {

// Ids of the segmentation: TotalSegmentator's of the left side, if it has one; that of the right side is one more.
namespace shoulder_label {
inline constexpr std::uint16_t humerus = 69, scapula = 71, clavicle = 73, joint = 201, artery = 202, vein = 203,
                               plexus = 204, axillary_nerve = 205, suprascapular_nerve = 206, lung_left = 10,
                               lung_right = 12;
}

// Sizes in mm.
struct ShoulderSizes {
  double scale;        // of everything that grows with body height
  double head;         // radius of the head of the humerus with its cartilage
  double fluid;        // between head and capsule
  double glenoid_gap;  // between head and the cartilage of the glenoid
  double cuff;         // thickness of the rotator cuff
  double deltoid, fat, skin;
};
ShoulderSizes shoulder_sizes(const ShoulderParameters& parameters);

// A left shoulder as a function of position: x to the side, y backwards, z upwards, the origin in the centre of the
// head of the humerus. Immutable and thread-safe.
class ShoulderModel {
 public:
  ShoulderModel(const ShoulderSizes& sizes, double spacing);

  // The tissue and label of the voxel at p, for the left side. Skin, capsule and cartilage are at least one voxel
  // thick.
  Material at(const Vec3& p) const;
  // Signed distance to the skin, negative inside; good to a few percent within a centimetre.
  double skin_distance(const Vec3& p) const { return fascia(p) - sizes_.fat - sizes_.skin; }

  const Vec3& acromion_corner() const { return acromion_corner_; }
  const Vec3& coracoid_tip() const { return coracoid_tip_; }
  const Vec3& glenoid() const { return glenoid_; }  // the middle of its face
  // Where the posterior approach enters the skin, and its direction (unit).
  const Vec3& entry() const { return entry_; }
  const Vec3& direction() const { return direction_; }
  // The point of the suprascapular nerve block, next to the nerve in the supraspinous fossa; its axis there, and the
  // skin above.
  const Vec3& block() const { return block_; }
  const Vec3& blocked_nerve() const { return blocked_nerve_; }
  const Vec3& block_entry() const { return block_entry_; }
  // The box that holds the shoulder: the trunk is cut off medially and below.
  Vec3 lowest() const;
  Vec3 highest() const;

 private:
  double fascia(const Vec3& p) const;
  Vec3 skin_from(const Vec3& inner, const Vec3& out) const;
  double humerus(const Vec3& p) const;
  double scapula(const Vec3& p) const;
  bool in_vault(const Vec3& p) const;
  Material bones(const Vec3& p) const;
  Material joint(const Vec3& p, double radius) const;
  Material bundle(const Vec3& p) const;
  Material chest(const Vec3& p) const;
  Material muscles(const Vec3& p, double radius, double fascia) const;

  ShoulderSizes sizes_;
  double spacing_;
  Vec3 outwards_, backwards_;            // of the glenoid: its facing direction; along its face, backwards
  Vec3 blade_medial_, blade_backwards_;  // of the blade of the scapula
  Vec3 articular_;                       // axis of the joint surface of the head
  Vec3 glenoid_, coracoid_tip_, entry_, direction_, acromion_corner_;
  Vec3 blocked_nerve_, block_, block_entry_;
  std::array<shapes::Rod, 2> acromion_, coracoid_, spine_;
  std::array<shapes::Rod, 2> clavicle_;
  struct Strand {
    shapes::Rod rod;
    Material material;
  };
  std::array<Strand, 14> strands_;
};

}  // namespace bodkin::patient
