#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "station/left_needle_motion.h"
#include "views/frame.h"

#include "anatomy/breathing.h"
#include "anatomy/needle_path.h"

namespace bodkin::app {

// The needles left in a patient, and their present positions.
class LeftNeedles {
 public:
  // For another patient, with the needles already in the body.
  void begin(const std::vector<anatomy::NeedlePath>& before);
  // Adds one, from entry to tip, in the position after expiration.
  void add(const anatomy::NeedlePath& path) { left_.push_back(path); }
  // Removes the needle that was left last; false: there is none.
  bool take_out();
  const std::vector<anatomy::NeedlePath>& paths() const noexcept { return left_; }

  // Begins a session with these needles in the body; it also displaces `others` (LPS mm, at rest). Returns the points
  // whose displacements the session must report: `others`, then those along the needles.
  std::vector<Vec3> follow(std::vector<Vec3> others, const std::optional<anatomy::BreathField>& breath);
  // The displacements of `others`; all displacements if no session reports any.
  std::span<const float> of_others(std::span<const float> displacements) const;
  // The present positions of the needles; unchanged until the next call.
  std::span<const views::LeftNeedle> now(std::span<const float> displacements, double drawn_in);

 private:
  std::vector<anatomy::NeedlePath> left_;
  station::LeftNeedleMotion motion_;  // of the session; its last needle may have been removed since
  std::size_t others_ = 0;            // points of the session that do not belong to needles
  std::vector<views::LeftNeedle> now_;
};

}  // namespace bodkin::app
