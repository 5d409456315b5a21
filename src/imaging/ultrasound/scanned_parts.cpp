#include "imaging/ultrasound/scanned_parts.h"

#include <algorithm>
#include <cmath>

#include "imaging/ultrasound/acoustic_volume.h"
#include "imaging/ultrasound/face_contact.h"
#include "imaging/ultrasound/scan_lines.h"

namespace bodkin::imaging {

namespace {

constexpr int sight_lines = 64;          // so that lines of a linear probe are less than a millimetre apart
constexpr double soft_impedance = 1.63;  // MRayl, of muscle
// Of the sound's amplitude: the border of soft tissue with bone reflects 0.3 and more, with gas nearly 1, between
// soft tissues at most 0.1.
constexpr double hardly_passed = 0.25;

bool stops_sound(const anatomy::TissueProperties& tissue) {
  const double own = tissue.acoustic.impedance;
  const double impedance = own > 0.0 ? own : impedance_of_hounsfield(tissue.hounsfield);
  return std::abs(impedance - soft_impedance) / (impedance + soft_impedance) > hardly_passed;
}

}  // namespace

ScannedSearch::ScannedSearch(const anatomy::Case& patient, const anatomy::UltrasoundProbe& probe)
    : patient_(patient), probe_(probe) {
  for (const anatomy::TissueProperties& tissue : patient.library.tissues())
    ends_line_[tissue.id] = stops_sound(tissue);
  // Half a voxel, so that a layer as thin as one is not skipped.
  step_ = std::clamp(0.5 * patient.tissues.grid.spacing.minCoeff(), 0.2, 2.0);
}

void ScannedSearch::add(const Pose& pose, const UltrasoundSettings& settings, ScannedParts& parts) const {
  if (!pose.matrix().allFinite()) return;
  UltrasoundDetail detail;
  detail.lines = sight_lines;
  const ScanLines lines = scan_lines(probe_, settings, detail);
  const double thickest = settings.gel ? thickest_gel : touching;
  for (int line = 0; line < sight_lines; ++line) {
    const Vec3 from = pose * lines.origin(line);
    const Vec3 along = pose.linear() * lines.direction(line);
    bool in_body = false;
    for (double way = 0.0; way <= settings.depth; way += step_) {
      const Vec3 place = from + way * along;
      const anatomy::TissueId tissue = anatomy::nearest(patient_.tissues, place, anatomy::tissue::air);
      if (!in_body && tissue == anatomy::tissue::air) {
        if (way > thickest) break;
        continue;
      }
      in_body = true;
      if (tissue == anatomy::tissue::air) break;  // the body ends
      parts.tissues.set(tissue);
      if (!patient_.structures.empty()) {
        const auto label = anatomy::nearest<std::uint16_t>(patient_.structures, place, 0);
        if (label != 0) parts.structures.insert(label);
      }
      if (ends_line_[tissue]) break;
    }
  }
}

}  // namespace bodkin::imaging
