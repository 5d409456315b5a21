#pragma once

#include <optional>
#include <string>
#include <vector>

#include "anatomy/case.h"
#include "imaging/canvas.h"
#include "imaging/mesh_cut.h"
#include "imaging/slice.h"

namespace bodkin::imaging {

// A level of the spine: a short line across the canal, lettered with its name.
struct LevelMark {
  Vec3 place = Vec3::Zero();  // LPS mm, the middle of the canal
  std::string name;
  bool end_of_cord = false;  // the conus, drawn longer and in a colour of its own
};

// One slice of an image and its overlays.
struct SlicePanel {
  Slice slice;
  std::string title;
  std::optional<anatomy::NeedlePath> path;    // planned: entry dot, line, depth ticks every 10 mm, target cross
  std::vector<Vec3> travelled;                // LPS mm, actual path of the tip, in order
  std::vector<CutElement> elements = {};      // of a mesh; if there are any, they are drawn instead of the pixels
  std::vector<Vec3> outline = {};             // LPS mm, a closed line: field of view of an ultrasound probe
  std::vector<anatomy::TissueId> named = {};  // always in the legend, for images of a series to have one size
  std::vector<LevelMark> levels = {};         // of the spine; those farther than 25 mm from the slice are left out
};

struct SlicesDrawn {
  Canvas canvas;
  double top = 0.0;  // px, of the slices themselves
};

// Slices side by side, all `height` px high, with orientation letters, millimetre bars and the names of the tissues
// in them. Parts of a line farther than 2 mm from a slice are dashed.
SlicesDrawn draw_slices(const std::vector<SlicePanel>& panels, const anatomy::TissueLibrary& library,
                        const std::string& title, double height);
Canvas slice_picture(const std::vector<SlicePanel>& panels, const anatomy::TissueLibrary& library,
                     const std::string& title, double height);

// The three orthogonal slices of a case through its planned path (or its middle, if it has none): sagittal along the
// path in close-up, axial and coronal through the target and the whole body. The sagittal and the coronal one show
// the levels of the spine that are landmarks of the case: interspaces by name, and the conus.
Canvas case_picture(const anatomy::Case& patient);

}  // namespace bodkin::imaging
