#pragma once

#include <span>

#include "imaging/ultrasound/acoustic_volume.h"
#include "imaging/ultrasound/frame.h"

namespace bodkin::imaging {

inline constexpr double thickest_gel = 5.0;  // mm
// mm of air that count as contact without gel: the limit of the CT's accuracy of the skin.
inline constexpr double touching = 0.5;
inline constexpr double deepest_press = 40.0;  // mm; a face further below the skin is inside the body

// The contact of a probe's face with a patient.
struct FaceContact {
  NoImage why = NoImage::none;
  double share = 0.0;  // of the lines that reach the patient
  double press = 0.0;  // mm that the middle of the face is below the resting skin; >= 0
};

// Searches along every line of a probe at `pose` (`origins` on the face and unit `directions` in the probe's frame)
// for the skin: out of the face through gel if there is air, back from the face if it is pressed in. `gap` and
// `press` (one value per line, mm) receive the distance from the face to whole tissue, beyond the voxels that the
// skin shares with air (more than thickest_gel: no contact), and the distance behind it.
FaceContact face_contact(const AcousticVolume& patient, std::span<const Vec3> origins,
                         std::span<const Vec3> directions, const Pose& pose, bool gel, std::span<float> gap,
                         std::span<float> press) noexcept;

}  // namespace bodkin::imaging
