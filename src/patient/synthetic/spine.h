#pragma once

#include <array>
#include <string>
#include <vector>

#include "patient/synthetic/curve.h"
#include "patient/synthetic/pelvis.h"
#include "patient/synthetic/vertebra.h"

namespace bodkin::patient {

// Cross-sections of everything that runs along the spine, at one height z (patient frame, mm). The canal's section is
// perpendicular to the canal: y is shortened by `tilt`, the cosine of its slope.
struct SpineSection {
  double z;
  double canal_x, canal_y, tilt;                     // centre
  double canal_half_width, canal_front, canal_back;  // front and back as distances from the centre, both > 0
  double sac_half_width, sac_half_depth, sac_y;      // dural sac; sac_y: its centre relative to the canal's
  double cord_half_width, cord_half_depth;           // 0 below the conus
  double flavum;                                     // thickness of the ligamentum flavum
  double tip_x, tip_y;                               // line along the tips of the spinous processes
  double back_y;                                     // the same, bridging the hollow behind L5 and S1
  double midline_slope;  // of the midline behind the canal, x over y: 0 except in a rotated spine
  double body_x, body_y, body_half_width, body_half_depth;
};

// The bones met at a point.
struct BoneHit {
  int bone = -1;          // 0 T11 .. 6 L5, 7 sacrum, 8 ilium; -1 none near
  double distance = 1e6;  // of the nearest bone, canal cut out; negative inside
  double second = 1e6;    // of the next bone
  int second_bone = -1;
};

// The bony spine from T11 to the sacrum in the patient's frame (LPS mm; middle of the body of L3 at the origin), and
// the curves along it.
class Spine {
 public:
  Spine(const SpineSizes& sizes, double scale);

  static constexpr int sacrum = level::s1, ilium = level::s1 + 1, bones = level::s1 + 2;

  SpineSection section(double z) const;
  // Bones at p, among those whose bit is set in `mask`. `section` is that of p.z().
  BoneHit bones_at(const Vec3& p, const SpineSection& section, unsigned mask = ~0u) const;
  // The bones that may be within `margin` mm at height z.
  unsigned bones_near(double z, double margin) const;
  // The number of the disc that contains p (that of the vertebra above), or -1. `mask` as above.
  int disc_at(const Vec3& p, unsigned mask) const;
  // Whether p is in a nerve root on its way out through a foramen.
  bool root_at(const Vec3& p) const;
  // The number of the upper of the two vertebrae between whose spinous processes p lies, or -1.
  int between_processes(const Vec3& p) const;

  // Signed distance to the wall of the spinal canal and to the outside of the dura.
  static double canal_distance(const Vec3& p, const SpineSection& s);
  static double sac_distance(const Vec3& p, const SpineSection& s);

  const Pose& pose(int bone) const { return poses_[static_cast<std::size_t>(bone)]; }
  const Vertebra& vertebra(int index) const { return vertebrae_[static_cast<std::size_t>(index)]; }
  const SpineSizes& sizes() const { return sizes_; }
  // Middle of the canal halfway between two laminae, below vertebra `index`.
  Vec3 interspace(int index) const;
  Vec3 conus() const { return conus_; }
  double top() const;     // z of the highest point of L1
  double bottom() const;  // z of the lowest point of S1
  // Height of p above the border between S1 and S2, along the sacrum.
  double above_second_sacral(const Vec3& p) const {
    return (inverses_[static_cast<std::size_t>(sacrum)] * p).z() + sacrum_.first_segment();
  }

 private:
  double bone_distance(int bone, const Vec3& p) const;

  SpineSizes sizes_;
  double scale_;
  std::vector<Vertebra> vertebrae_;
  Sacrum sacrum_;
  Ilium ilium_;
  std::array<Pose, bones> poses_, inverses_;
  std::array<double, bones> lowest_{}, highest_{};
  Curve canal_x_, canal_y_, canal_half_width_, canal_half_depth_, tip_x_, tip_y_, back_y_, body_x_, body_y_,
      body_half_width_, body_half_depth_, flavum_, bulge_;
  Vec3 conus_;
  std::vector<shapes::Rod> roots_;
};

}  // namespace bodkin::patient
