#pragma once

#include <deque>
#include <string>
#include <vector>

#include "tracking/tracker.h"

namespace bodkin::tracking {

// Notices that the camera is no longer the one that was calibrated: its lens was turned, or its focus moved. Then
// picture and model disagree for every body at once, also at rest; motion or a bent body shows on one alone or
// passes. Another focal length shows on a wide board alone, for a small cube looks much the same through it: as
// perspective that is too strong or too weak (CameraMisfit::focal). So does a board that is bent. One picture knows
// it to a tenth or a few tenths of a percent, by the board's tilt; those of the last second at rest, wherever the
// board lay in them, are taken together.
class LensWatch {
 public:
  // The poses of the next picture, of the same bodies in the same order.
  void add(const std::vector<TrackedPose>& poses);
  // One sentence while it is so; else empty.
  std::string warning() const;

 private:
  using Disagreements = std::deque<bool>;  // of the last pictures in which something rested

  // A body, in the last pictures that show it as a board at rest.
  struct Board {
    Disagreements disagreements;  // it does not fit
    std::deque<Estimate> focal;   // where it does
  };

  static bool has_other_focal(const Board& board);

  Disagreements all_;
  std::vector<Board> boards_;
  std::vector<TrackedPose> before_;
};

}  // namespace bodkin::tracking
