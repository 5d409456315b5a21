#pragma once

#include <memory>
#include <vector>

#include "imaging/ultrasound/face_contact.h"
#include "imaging/ultrasound/layered_compression.h"
#include "imaging/ultrasound/scan_lines.h"

namespace bodkin::station {

// How tissue under a probe gives way in the slice, as Ultrasound has it where it is given no displacement: layer by
// layer along every line. For pictures that add to it what a needle does.
class PressedLayers {
 public:
  PressedLayers(std::shared_ptr<const imaging::AcousticVolume> patient, anatomy::UltrasoundProbe probe);

  // The probe at `pose`, its picture `depth` mm deep.
  void settle(const Pose& pose, double depth, bool gel);
  // Anything has moved.
  bool pressed() const noexcept { return press_ > 0.0; }
  // mm, patient axes: how what now is at a place of the slice (mm, probe's frame) has moved.
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
  double press_ = 0.0;                      // mm, at the middle; 0: nothing moves
  Pose pose_ = Pose::Identity();
};

}  // namespace bodkin::station
