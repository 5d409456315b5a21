#pragma once

#include <string>
#include <vector>

#include "tracking/grey_image.h"
#include "tracking/marker_body.h"
#include "tracking/marker_search.h"

namespace bodkin::tracking {

// A chessboard with a marker on every white square (ChArUco): the markers identify its corners, so an image may show
// a part of it. Markers 22 to 49, which no body of a teaching station has.
struct CalibrationBoard {
  int columns = 7, rows = 8;  // squares; the upper left one is black
  double square = 26.0;       // edge, mm

  // The white squares with their markers, and the places of the black ones. Frame: origin in the middle of the board,
  // x to the right, y down, z away from the viewer.
  MarkerBody body() const;
  // As body(), with its black squares as sheets, for printing and drawing.
  MarkerBody printed() const;
  // Inner corners: there are (columns - 1) (rows - 1), row by row.
  int corner_count() const { return (columns - 1) * (rows - 1); }
  Vec3 corner(int index) const;
};

// A corner of the chessboard in an image.
struct FoundCorner {
  int index = 0;
  Eigen::Vector2d at = Eigen::Vector2d::Zero();  // pixels
};

// The inner corners next to two white squares that were found. Where four squares meet, blur and tone curve cause no
// shift: unlike the corners of a marker these have no bias.
std::vector<FoundCorner> find_corners(const GreyImage& picture, const CalibrationBoard& board,
                                      const std::vector<FoundMarker>& markers);

// A PDF (A4) of the board to print at 100 %, with a ruler. Throws InputError when it does not fit on the page.
std::string calibration_board_pdf(const CalibrationBoard& board);

}  // namespace bodkin::tracking
