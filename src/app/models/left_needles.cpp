#include "app/models/left_needles.h"

namespace bodkin::app {

void LeftNeedles::begin(const std::vector<anatomy::NeedlePath>& before) {
  left_ = before;
  motion_ = station::LeftNeedleMotion(left_);
  others_ = 0;
}

bool LeftNeedles::take_out() {
  if (left_.empty()) return false;
  left_.pop_back();
  return true;
}

std::vector<Vec3> LeftNeedles::follow(std::vector<Vec3> others, const std::optional<anatomy::BreathField>& breath) {
  others_ = others.size();
  motion_ = station::LeftNeedleMotion(left_, breath);
  others.insert(others.end(), motion_.points().begin(), motion_.points().end());
  return others;
}

std::span<const float> LeftNeedles::of_others(std::span<const float> displacements) const {
  if (displacements.size() != 3 * (others_ + motion_.points().size())) return displacements;
  return displacements.first(3 * others_);
}

std::span<const views::LeftNeedle> LeftNeedles::now(std::span<const float> displacements, double drawn_in) {
  const std::span<const float> of_needles = displacements.subspan(of_others(displacements).size());
  const std::vector<Pose>& poses = motion_.poses(of_needles, drawn_in);
  now_.clear();
  for (std::size_t i = 0; i < left_.size(); ++i) {
    // A needle left just now is at rest until the next session begins.
    const Pose pose = i < poses.size() ? poses[i] : needle_pose(left_[i].target, left_[i].direction());
    now_.push_back({pose, left_[i].length()});
  }
  return now_;
}

}  // namespace bodkin::app
