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

// A window in a picture and what is said of it.
struct WindowSaid {
  GreyWindow window;
  std::vector<std::string> words;  // lines below the picture
};

// A picture that a real machine made.
struct RealPicture {
  GreyPicture picture;
  std::string caption;           // where it comes from
  std::optional<MarkSide> mark;  // where the probe's marked side stands in it; nothing: not known
  std::optional<WindowSaid> window;
};

// A moment as the picture that a machine would store.
struct MachinePicture {
  ScanMoment moment;
  MarkSide mark = MarkSide::left;
  std::string patient;  // its name
  std::vector<Caliper> calipers;
  std::vector<ImageMarker> markers;
  std::optional<RealPicture> beside;  // at the same scale
  std::optional<WindowSaid> window;
  std::optional<SlicePanel> ct;  // the same plane of the CT, beside it
  bool touch = true;             // says how the probe touches the patient
};

Canvas machine_picture(const MachinePicture& picture, const anatomy::TissueLibrary& library);

// The CT in the plane of a frame with the border of what the probe sees; `path` and `needle` (places from its entry
// to its tip, LPS mm) are drawn where there are any.
SlicePanel ct_panel(const anatomy::Case& patient, const ScanMoment& moment, MarkSide mark,
                    const std::vector<Vec3>& needle);

}  // namespace bodkin::imaging
