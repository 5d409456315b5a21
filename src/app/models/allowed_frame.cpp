#include "app/models/allowed_frame.h"

namespace bodkin::app {

Frame allowed_frame(const Frame& frame, const training::PlanAids& aids) {
  Frame allowed = frame;
  // After the attempt the planned path may be shown.
  if (!aids.overlay && frame.state != State::ended) {
    allowed.plan.reset();
    allowed.plan_broken.clear();
    allowed.target_distance = allowed.off_path = allowed.off_angle = 0.0;
    allowed.off_path_vector = Vec3::Zero();
    allowed.target_reached = false;
  }
  if (!aids.ladder) {
    allowed.place.clear();
    if (allowed.tissue != anatomy::tissue::air) allowed.tissue = anatomy::tissue::muscle;
  }
  if (!aids.needle) {
    allowed.has_needle = false;
    allowed.follows_tip = false;
    allowed.left_needles = {};
    allowed.dimple = {};
    allowed.displacements = {};
    allowed.moved_tissue = nullptr;
  }
  return allowed;
}

}  // namespace bodkin::app
