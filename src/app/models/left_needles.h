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

// The needles that a person left in a patient, and where they are now.
class LeftNeedles {
 public:
  // Of another patient: those that are in the body before.
  void begin(const std::vector<anatomy::NeedlePath>& before);
  // One more, from its entry to its tip where they lie when the patient has breathed out.
  void add(const anatomy::NeedlePath& path) { left_.push_back(path); }
  // The one that was left last; false: there is none.
  bool take_out();
  const std::vector<anatomy::NeedlePath>& paths() const noexcept { return left_; }

  // A session begins in which these needles are in the body, and moves `others` too (LPS mm, at rest). Returns the
  // points whose displacements the session is asked for: `others`, then those along the needles.
  std::vector<Vec3> follow(std::vector<Vec3> others, const std::optional<anatomy::BreathField>& breath);
  // Of the displacements of those points: those of `others`; all of them where no session was asked.
  std::span<const float> of_others(std::span<const float> displacements) const;
  // Where the needles are; unchanged until the next call.
  std::span<const views::LeftNeedle> now(std::span<const float> displacements, double drawn_in);

 private:
  std::vector<anatomy::NeedlePath> left_;
  station::LeftNeedleMotion motion_;  // of the session; a needle that was taken out since is its last
  std::size_t others_ = 0;            // points of the session that are not of needles
  std::vector<views::LeftNeedle> now_;
};

}  // namespace bodkin::app
