#pragma once

#include <memory>
#include <vector>

#include "imaging/ultrasound/face_contact.h"
#include "imaging/ultrasound/layered_compression.h"
#include "imaging/ultrasound/scan_lines.h"

namespace bodkin::station {

// Compression of the tissue under a probe in the slice, as Ultrasound computes it without a displacement field: layer
// by layer along every line. For images to which a needle's effect is added.
class CompressedLayers {
 public:
  CompressedLayers(std::shared_ptr<const imaging::AcousticVolume> patient, anatomy::UltrasoundProbe probe);

  // Sets the probe to `pose`, its image `depth` mm deep.
  void settle(const Pose& pose, double depth, bool gel);
  // Whether anything has moved.
  bool pressed() const noexcept { return press_ > 0.0; }
  // mm, patient axes: displacement of the tissue that is now at a point of the slice (mm, probe's frame).
  Vec3 moved(const Vec3& place) const noexcept;

 private:
  std::shared_ptr<const imaging::AcousticVolume> patient_;
  anatomy::UltrasoundProbe probe_;
  imaging::LayeredCompression compression_;
  imaging::UltrasoundSettings settings_;
  imaging::UltrasoundDetail detail_;
  imaging::ScanLines lines_;
  std::vector<Vec3> origins_, directions_;  // of the lines, probe's frame
  std::vector<float> gap_, by_line_;        // mm, of every line
  double press_ = 0.0;                      // mm, at the middle; 0: no compression
  Pose pose_ = Pose::Identity();
};

}  // namespace bodkin::station
