#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "anatomy/case.h"
#include "imaging/ultrasound/probe.h"
#include "imaging/ultrasound_screen/probe_on_skin.h"

namespace bodkin::imaging {

// The ways in which a sonographer positions the probe.
enum class ScanView {
  paramedian,  // lengthwise lateral to the midline, tilted towards it
  sagittal,    // lengthwise, orientation marker to the head
  transverse,  // across, orientation marker to the patient's right
  needle,      // lengthwise next to the planned entry, the needle in the slice
  kidney       // lengthwise from the flank
};

// "paramedian", "sagittal", ...; empty for other words.
std::optional<ScanView> scan_view_from(std::string_view name);
// All of them, for messages: "paramedian, sagittal, ...".
std::string scan_view_names();

// The requested position. Empty members are derived from the case.
struct ScanRequest {
  ScanView view = ScanView::paramedian;
  std::optional<Vec3> at;  // LPS mm, the point to view; otherwise the planned target, a kidney, or the body's middle
  std::optional<Vec3> outward;  // from there to the probe; otherwise along the planned path, from the flank, or back
};

// The position of a landmark or of the middle of a structure of that name, LPS mm; empty if the case has none.
std::optional<Vec3> place_named(const anatomy::Case& patient, std::string_view name);

// The probe on the skin, not pressed. Throws InputError when the view's requirements are missing: a path, a kidney,
// skin.
ProbeOnSkin place_probe(const anatomy::Case& patient, const anatomy::UltrasoundProbe& probe,
                        const ScanRequest& request);

}  // namespace bodkin::imaging
