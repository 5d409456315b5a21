#pragma once

#include <utility>
#include <vector>

#include "patient/synthetic/shapes.h"
#include "patient/synthetic/sizes.h"

namespace bodkin::patient {

// The bone of one vertebra as an implicit shape in its own frame: origin in the middle of the body, x left,
// y posterior, z superior. The spinal canal is not cut out here.
class Vertebra {
 public:
  // `below` is the interspace below, `lower_facet_half_distance` and `lower_facet_angle` belong to the joint with the
  // next vertebra.
  Vertebra(const VertebraSize& size, const InterspaceSize& below, double lower_facet_half_distance,
           double lower_facet_angle, double facet_scale, double osteophyte);

  // Negative inside the bone. Accurate to a few percent within some mm of the surface; beyond kFar it may be any
  // value above kFar.
  double distance(const Vec3& p) const;
  // Outline of the spinous process and lamina in the sagittal plane, whatever x is: negative at the heights and
  // depths of the process. Points outside the outlines of two neighbours lie between them.
  double process_outline(const Vec3& p) const;
  // The cross-section of the body at p, whatever its height: negative within the body's sides.
  double body_section(const Vec3& p) const;
  // Half height of the body at p (endplates are tilted by the wedge and slightly hollow).
  double half_height(const Vec3& p) const;

  const VertebraSize& size() const { return size_; }
  double canal_front() const { return 0.5 * size_.endplate_depth - 0.5; }
  double canal_centre() const { return canal_front() + 0.5 * size_.canal_depth; }
  double canal_back() const { return canal_front() + size_.canal_depth; }
  // Most posterior point of the spinous process, and the middle of the lamina at the back of the canal.
  Vec3 process_tip() const { return {0.0, tip_back_, tip_z_}; }
  Vec3 lamina_middle() const { return {0.0, canal_back(), lamina_z_}; }
  // Lowest and highest point in another frame, given this one's pose in it.
  std::pair<double, double> extent(const Pose& pose) const;
  static constexpr double kFar = 8.0;

 private:
  double arch(const Vec3& p) const;

  VertebraSize size_;
  double osteophyte_;
  double lamina_z_, base_y_, tip_back_, tip_z_;
  struct BoundedRod {
    shapes::Rod rod;
    Vec3 centre;
    double reach;  // farther away the rod can be ignored
  };
  std::vector<BoundedRod> arch_rods_;  // right and left are mirror images: for x >= 0
};

}  // namespace bodkin::patient
