#pragma once

#include <vector>

#include "patient/synthetic/shapes.h"
#include "patient/whole_body/body_shape.h"

#include "anatomy/tissue.h"

namespace bodkin::patient {

// The tissues of a synthetic body, everywhere: skin, fat, muscle, bones, lungs, heart, liver, kidneys, brain, cord,
// great vessels and nerves. Simple shapes at their anatomical places: enough for the tissues under a point, and the
// depth of bone, pleura or a vessel there; not an atlas of anatomy. Immutable and thread-safe.
class BodyTissues {
 public:
  explicit BodyTissues(const BodyShape& shape);

  // The tissue at p (LPS mm) in a volume of voxels of `spacing` mm: the skin is at least one of them thick.
  // `distance` is shape.distance(p).
  anatomy::TissueId at(const Vec3& p, double distance, double spacing) const;

 private:
  struct Rod {
    shapes::Rod rod;
    Vec3 centre;
    double reach;
    anatomy::TissueId tissue;
  };
  void add(std::vector<Rod>& rods, const Vec3& a, const Vec3& b, double ra, double rb, anatomy::TissueId tissue);
  anatomy::TissueId head(const Vec3& q) const;
  anatomy::TissueId spine(const Vec3& q) const;
  anatomy::TissueId chest_and_belly(const Vec3& q, double depth) const;
  anatomy::TissueId in_rods(const std::vector<Rod>& rods, const Vec3& q) const;
  double fat(const Vec3& q) const;

  const BodyShape& shape_;
  std::vector<Rod> body_rods_, arm_rods_;  // the arm's in its own frame
  Curve back_;                             // of the skin over the spine
};

}  // namespace bodkin::patient
