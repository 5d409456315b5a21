#pragma once

#include <vector>

#include "patient/synthetic/shapes.h"
#include "patient/synthetic/sizes.h"

namespace bodkin::patient {

// The sacrum as an implicit shape in its own frame: origin in the middle of the upper endplate of S1, x left,
// y posterior, z along the sacrum's axis upwards. The sacral canal is not cut out here.
class Sacrum {
 public:
  Sacrum(const SpineSizes& sizes, double scale);

  double distance(const Vec3& p) const;
  double process_outline(const Vec3& p) const;  // of the median crest, as Vertebra::process_outline
  double body_section(const Vec3& p) const;

  double canal_front(double z) const;  // z <= 0
  double canal_depth(double z) const;
  double canal_half_width(double z) const;
  double crest_back(double z) const;                      // y of the median crest
  double first_segment() const { return 31.0 * scale_; }  // mm below the endplate at which S2 begins

 private:
  SpineSizes sizes_;
  double scale_;
  std::vector<shapes::Rod> rods_;  // for x >= 0
};

// Both wings of the ilium: bent plates from the posterior superior spine forwards and outwards, with a crest. The
// frame is the sacrum's, turned upright.
class Ilium {
 public:
  explicit Ilium(double scale) : scale_(scale) {}
  double distance(const Vec3& p) const;

 private:
  double scale_;
};

}  // namespace bodkin::patient
