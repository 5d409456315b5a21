#pragma once

#include <memory>
#include <optional>
#include <span>

#include "anatomy/needle.h"
#include "core/geometry.h"
#include "imaging/ultrasound/acoustic_volume.h"
#include "imaging/ultrasound/frame.h"
#include "imaging/ultrasound/probe.h"
#include "imaging/ultrasound/processor_path.h"
#include "imaging/ultrasound/settings.h"

namespace bodkin::imaging {

// A needle as an acoustic object.
struct NeedleInUltrasound {
  Pose pose = Pose::Identity();  // tip and axis, patient
  anatomy::Needle needle;
};

// The displacement of tissue, on a plane of points through the scan plane: u(x), mm, of the tissue that now is at x.
// Row by row, x y z of each point. Constant across the plane.
struct ScanDisplacement {
  Vec3 corner = Vec3::Zero();  // mm, the first point in the probe's frame; z is ignored
  double spacing = 2.0;        // mm between points, along the probe's x (columns) and y (rows)
  int columns = 0, rows = 0;
  std::span<const float>
      moved;  // 3 x rows x columns, mm, patient axes: x - X, with X the position at rest of the tissue now at x
};

// An ultrasound machine: a probe on a patient. Everything is prepared at construction and when a setting changes;
// image() allocates nothing after its first call, throws nothing and reads no clock. An image depends only on
// patient, probe, settings and the arguments: the same bits on every processor path and for any number of threads.
class Ultrasound {
 public:
  // Throws InputError when the probe, a setting or a detail is out of range, or the patient has fewer than two voxels
  // along an axis.
  Ultrasound(std::shared_ptr<const AcousticVolume> patient, anatomy::UltrasoundProbe probe,
             UltrasoundSettings settings = {}, UltrasoundDetail detail = {},
             ProcessorPath path = best_processor_path());
  Ultrasound(Ultrasound&&) noexcept;
  Ultrasound& operator=(Ultrasound&&) noexcept;
  ~Ultrasound();

  const anatomy::UltrasoundProbe& probe() const;
  const UltrasoundSettings& settings() const;
  const UltrasoundDetail& detail() const;
  // Throws InputError as the constructor does, without effect.
  void set(const UltrasoundSettings& settings);

  // The image with the probe at `pose` (probe to patient). Valid until the next call. A displacement that is not
  // finite or too small for its rows and columns is ignored. `others`: more needles.
  const UltrasoundFrame& image(const Pose& pose, const std::optional<NeedleInUltrasound>& needle = std::nullopt,
                               const std::optional<ScanDisplacement>& displacement = std::nullopt,
                               std::span<const NeedleInUltrasound> others = {}) noexcept;

 private:
  struct Lines;
  struct Machine;
  std::unique_ptr<Machine> machine_;
};

}  // namespace bodkin::imaging
