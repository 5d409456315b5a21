#pragma once

#include <optional>
#include <string>
#include <vector>

#include "anatomy/tissue.h"
#include "imaging/canvas.h"
#include "imaging/slice_picture.h"
#include "imaging/ultrasound_screen/grey_statistics.h"
#include "imaging/ultrasound_screen/screen.h"

namespace bodkin::imaging {

// A window in an image and its captions.
struct WindowMessage {
  GreyWindow window;
  std::vector<std::string> words;  // lines below the image
};

// An image from a real machine.
struct ReferenceImage {
  GreyImage picture;
  std::string caption;                        // its source
  std::optional<OrientationMarkerSide> mark;  // side of the orientation marker in it; empty: unknown
  std::optional<WindowMessage> window;
};

// An image in the form that a machine stores.
struct ScannerImage {
  ScanState moment;
  OrientationMarkerSide mark = OrientationMarkerSide::left;
  std::string patient;  // its name
  std::vector<Caliper> calipers;
  std::vector<ImageMarker> markers;
  std::optional<ReferenceImage> reference;  // at the same scale
  std::optional<WindowMessage> window;
  std::optional<SlicePanel> ct;  // the same plane of the CT, next to it
  bool touch = true;             // includes how the probe touches the patient
};

Canvas draw_scanner_image(const ScannerImage& picture, const anatomy::TissueLibrary& library);

// The CT in the plane of a frame with the border of the probe's field of view; `path` and `needle` (positions from
// its entry to its tip, LPS mm) are drawn if there are any.
SlicePanel ct_panel(const anatomy::Case& patient, const ScanState& moment, OrientationMarkerSide mark,
                    const std::vector<Vec3>& needle);

}  // namespace bodkin::imaging
