#pragma once

#include <vector>

#include <Eigen/Core>

#include "imaging/slice.h"

namespace bodkin::views {

// The four slices. Orientation is that of radiology, see imaging::View.
enum class SliceKind { axial, coronal, sagittal, along_needle };

// What part of the patient a view shows.
struct SliceWindow {
  Vec3 middle = Vec3::Zero();  // LPS mm, in the middle of the view
  double field = 135.0;        // mm along the longer side of the view
  int width = 0, height = 0;   // pixels of the picture
};

// The plane of a view. `axis`: of the needle, unit, hub to tip; used along the needle only, whose plane holds it and
// is otherwise as close to sagittal as it can be.
imaging::SlicePlane slice_plane(SliceKind kind, const SliceWindow& window, const Vec3& axis);

// Where the middle of a view must be so that its plane holds `point`, moved along the plane's normal only: the
// picture does not slide while a needle goes in.
Vec3 middle_through(const imaging::SlicePlane& plane, const Vec3& middle, const Vec3& point);

// The same after moving the picture too when `point` comes within `margin` (share of the width and height, under 0.5)
// of the edge or leaves it: then it lies in the middle.
Vec3 middle_that_shows(const imaging::SlicePlane& plane, const Vec3& middle, const Vec3& point, double margin);

// A needle as a slice shows it. Places are pixels of the picture.
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
  std::vector<Tick> ticks;           // every 10 mm of the shaft, the tip left out
  Eigen::Vector2d along{0.0, -1.0};  // unit, from the tip to the hub in the picture; upright where seen end on
  double distance = 0.0;             // mm from the plane to the tip, positive away from the eye
  double foreshortening = 1.0;       // share of the needle's length that is seen
};

// `tip` and `hub`: LPS mm. `thickness`: mm before and behind the plane in which it is drawn as near.
NeedleOnSlice project_needle(const imaging::SlicePlane& plane, const Vec3& tip, const Vec3& hub, double thickness);

// The length of a round bar of scale (1, 2, 5, 10, 20, 50, 100 mm), at most `most` pixels long.
double scale_bar(double millimetres_a_pixel, double most);

// "R 0.5": how far a plane lies along its normal, in the words of a scanner: the letter of the side, then mm.
std::string position_text(const imaging::SlicePlane& plane, const Vec3& middle);

}  // namespace bodkin::views
