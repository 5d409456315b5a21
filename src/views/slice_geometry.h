#pragma once

#include <vector>

#include <Eigen/Core>

#include "imaging/slice.h"

namespace bodkin::views {

// The four slices. Orientation is that of radiology, see imaging::View.
enum class SliceKind { axial, coronal, sagittal, along_needle };

// The visible part of the patient in a view.
struct SliceWindow {
  Vec3 middle = Vec3::Zero();  // LPS mm, in the middle of the view
  double field = 135.0;        // mm along the longer side of the view
  int width = 0, height = 0;   // pixels of the image
};

// The plane of a view. `axis`: of the needle, unit, hub to tip; used only along the needle, whose plane contains it
// and is otherwise as close to sagittal as possible.
imaging::SlicePlane slice_plane(SliceKind kind, const SliceWindow& window, const Vec3& axis);

// The middle of a view whose plane contains `point`, moved only along the plane's normal: the image does not slide
// during an insertion.
Vec3 middle_through(const imaging::SlicePlane& plane, const Vec3& middle, const Vec3& point);

// As above, also moving the image when `point` comes within `margin` (fraction of the width and height, under 0.5) of
// the edge or leaves it: then it is centred.
Vec3 middle_that_shows(const imaging::SlicePlane& plane, const Vec3& middle, const Vec3& point, double margin);

// A needle in a slice. Positions are pixels of the image.
struct NeedleOnSlice {
  struct Tick {
    Eigen::Vector2d at;
    int millimetres = 0;  // from the tip
    bool near = false;    // see Piece
  };
  struct Piece {
    Eigen::Vector2d from, to;
    bool near = false;  // within `thickness` of the plane
  };
  Eigen::Vector2d tip, hub;
  std::vector<Piece> pieces;         // from the tip to the hub
  std::vector<Tick> ticks;           // every 10 mm of the shaft, without the tip
  Eigen::Vector2d along{0.0, -1.0};  // unit, from the tip to the hub in the image; upright when seen end-on
  double distance = 0.0;             // mm from the plane to the tip, positive away from the eye
  double foreshortening = 1.0;       // visible fraction of the needle's length
};

// `tip` and `hub`: LPS mm. `thickness`: mm before and behind the plane that count as near.
NeedleOnSlice project_needle(const imaging::SlicePlane& plane, const Vec3& tip, const Vec3& hub, double thickness);

// The length of a round bar of scale (1, 2, 5, 10, 20, 50, 100 mm), at most `most` pixels long.
double scale_bar(double millimetres_a_pixel, double most);

// "R 0.5": position of a plane along its normal, in the notation of a scanner: the letter of the side, then mm.
std::string position_text(const imaging::SlicePlane& plane, const Vec3& middle);

}  // namespace bodkin::views
