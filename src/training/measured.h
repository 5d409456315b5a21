#pragma once

#include <optional>
#include <string>
#include <vector>

#include "training/attempt.h"
#include "training/motion.h"

namespace bodkin::training {

// A puncture and the motion that followed it.
struct Puncture {
  forces::EventKind kind = forces::EventKind::puncture;
  anatomy::TissueId tissue = anatomy::tissue::air;  // the punctured tissue
  double time = 0.0;                                // s since the first tick
  double depth = 0.0;                               // mm
  double force = 0.0;                               // N: puncture force; of a loss of resistance, the drop
  double overshoot = 0.0;  // mm of further travel of the tip until it stopped (slower than stop_mm_per_s inwards)
  double speed = 0.0;      // mm/s, largest during that travel, over 20 ms
  double reaction = 0.0;   // s until it stopped
  double approach = 0.0;   // mm/s, largest inwards in the second before, over 100 ms
};

// A tissue over the whole session, over all visits of the tip.
struct TissueTotal {
  anatomy::TissueId tissue = anatomy::tissue::air;
  double from = 0.0, to = 0.0;  // mm, shallowest and deepest depth of the tip in it
  double time = 0.0;            // s
  double peak_force = 0.0;      // N, largest resistance with the tip in it
  double peak_depth = 0.0;      // mm
  double work = 0.0;            // N mm done by the hand with the tip in it
};

// The position of a point relative to the planned target.
struct TargetError {
  double distance = 0.0;  // mm
  double axial = 0.0;     // mm along the planned path, positive = too deep
  double lateral = 0.0;   // mm across it
};
TargetError target_error(const Vec3& tip, const anatomy::NeedlePath& path);

// Intermediate results for several metrics, computed once.
struct Measured {
  // `named`: the tissues and structures relevant to the procedure, by name.
  explicit Measured(const Attempt& its_attempt, const std::vector<std::string>& named = {});

  const Attempt& attempt;
  Motion motion;
  std::vector<char> active;  // needle_in_action() of the motion
  double path_length = 0.0;  // mm in the body
  std::optional<Tremor> tremor;
  std::vector<Puncture> punctures;   // punctures and losses of resistance or pressure, in order
  std::vector<TissueTotal> tissues;  // in the order of their first depth
  // Those of `named` that appeared in the ultrasound image, in chronological order.
  std::vector<session::ScannedPart> scanned;
  int redirections = 0;     // retreats of over retreat_mm, then an advance with another axis
  double work = 0.0;        // N mm done by the hand against the applied force
  double peak_force = 0.0;  // N, largest resistance in the body
  double peak_depth = 0.0;  // mm, its depth
  anatomy::TissueId peak_tissue = anatomy::tissue::air;

  // mm, least distance of the inserted tip from anything that it must not enter; 0 if it entered. Not part of the
  // session: a caller with the patient's voxels sets it.
  std::optional<double> nearest_forbidden;

  // The first loss of resistance, or else of pressure; nullptr if there was none.
  const Puncture* loss() const;
};

}  // namespace bodkin::training
