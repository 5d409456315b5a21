#pragma once

#include <deque>
#include <string>
#include <vector>

#include "tracking/tracker.h"

namespace bodkin::tracking {

// Detects that the camera is no longer as calibrated: its lens was turned, or its focus moved. Then image and model
// disagree for every body at once, also at rest; motion or a bent body affects only one or passes. A changed focal
// length is visible only on a wide board, as perspective that is too strong or too weak (CameraMisfit::focal),
// because a small cube looks much the same through it. So is a bent board. One image determines it to a tenth or a
// few tenths of a percent, depending on the board's tilt; those of the last second at rest, wherever the board was in
// them, are combined.
class LensWatch {
 public:
  // The poses of the next image, of the same bodies in the same order.
  void add(const std::vector<TrackedPose>& poses);
  // A warning, one sentence, while the condition holds; else empty.
  std::string warning() const;

 private:
  using Disagreements = std::deque<bool>;  // of the last images in which a body rested

  // A body, in the last images that show it as a board at rest.
  struct Board {
    Disagreements disagreements;  // it does not fit
    std::deque<Estimate> focal;   // where it fits
  };

  static bool has_other_focal(const Board& board);

  Disagreements all_;
  std::vector<Board> boards_;
  std::vector<TrackedPose> before_;
};

}  // namespace bodkin::tracking
