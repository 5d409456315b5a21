#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "anatomy/case.h"
#include "imaging/ultrasound/probe.h"
#include "imaging/ultrasound_screen/probe_on_skin.h"

namespace bodkin::imaging {

// How a sonographer puts the probe down.
enum class ScanView {
  paramedian,  // lengthwise lateral to the midline, tilted towards it
  sagittal,    // lengthwise, marked side to the head
  transverse,  // across, marked side to the patient's right
  needle,      // lengthwise next to the planned entry, the needle in the slice
  kidney       // lengthwise from the flank
};

// "paramedian", "sagittal", ...; nothing for other words.
std::optional<ScanView> scan_view_from(std::string_view name);
// All of them, for messages: "paramedian, sagittal, ...".
std::string scan_view_names();

// Where to put it down. What is empty is found in the case.
struct ScanRequest {
  ScanView view = ScanView::paramedian;
  std::optional<Vec3> at;  // LPS mm, what is looked at; otherwise the planned target, a kidney, or the body's middle
  std::optional<Vec3> outward;  // from there to the probe; otherwise along the planned path, from the flank, or back
};

// Where a landmark or the middle of a structure of that name lies, LPS mm; nothing when the case has none.
std::optional<Vec3> place_named(const anatomy::Case& patient, std::string_view name);

// The probe on the skin, not pressed. Throws InputError when what a view needs is not there: a path, a kidney, skin.
ProbeOnSkin place_probe(const anatomy::Case& patient, const anatomy::UltrasoundProbe& probe,
                        const ScanRequest& request);

}  // namespace bodkin::imaging
