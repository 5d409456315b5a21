#pragma once

#include <optional>
#include <string>
#include <vector>

#include "anatomy/case.h"
#include "imaging/slice.h"

namespace bodkin {

// One slice of a picture and what is drawn upon it.
struct SlicePanel {
  Slice slice;
  std::string title;
  std::optional<NeedlePath> path;  // planned: entry dot, line, depth ticks every 10 mm, target cross
  std::vector<Vec3> travelled;     // LPS mm, where the tip really went, in order
};

// Slices side by side, all `height` px high, with orientation letters, millimetre bars and the names of the tissues
// that they show. Parts of a line further than 2 mm from a slice are dashed. The result is an SVG document.
std::string slice_picture(const std::vector<SlicePanel>& panels, const TissueLibrary& library,
                          const std::string& title, double height);

// The three orthogonal slices of a case through its planned path (or its middle, when it has none): sagittal along
// the path and close to it, axial and coronal through the target and the whole body.
std::string case_picture(const Case& patient);

}  // namespace bodkin
