#include "patient/synthetic/approach.h"

namespace bodkin::patient {
namespace {

// Steps of the search, and maximum length of a needle's path (mm).
constexpr double kSample = 1.0;
constexpr double kLongest = 260.0;

// Distance from `target` against `direction` to the skin, or a negative number if there is none.
double distance_to_skin(const LumbarModel& model, const Vec3& target, const Vec3& direction) {
  double inside = 0.0, outside = -1.0;
  for (double t = 10.0; t < kLongest; t += 5.0) {
    if (model.skin_distance(target - t * direction) > 0.0) {
      outside = t;
      break;
    }
    inside = t;
  }
  if (outside < 0.0) return outside;
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (inside + outside);
    (model.skin_distance(target - middle * direction) > 0.0 ? outside : inside) = middle;
  }
  return inside;
}

}  // namespace

Approach plan_approach(const LumbarModel& model, int upper) {
  const Spine& spine = model.spine();
  const Vec3 interspace = spine.interspace(upper);
  // The plane of the two spinous processes: vertebrae are slightly turned and tilted sideways.
  const Mat3 mean = spine.pose(upper).linear() + spine.pose(upper + 1).linear();
  const Vec3 lateral = mean.col(0).normalized();
  const Vec3 inwards = -(mean.col(1) - mean.col(1).dot(lateral) * lateral).normalized();
  const Vec3 headwards = lateral.cross(-inwards).normalized();

  Approach best;
  double best_score = -1e9;
  for (int shift = -12; shift <= 12; ++shift) {
    const SpineSection section = spine.section(interspace.z() + shift);
    // Halfway between the back of the sac and the roots, which lie in its front half.
    const double middle_y = section.sac_y + 0.25 * section.sac_half_depth;
    const Vec3 target(section.canal_x, section.canal_y + middle_y / section.tilt, section.z);
    for (int cephalad = -8; cephalad <= 40; ++cephalad) {
      const double angle = cephalad * shapes::degrees;
      const Vec3 direction = shapes::cosine(angle) * inwards + shapes::sine(angle) * headwards;
      const double enough = 5.0;
      double clearance = enough;
      const double worst_useful = best_score;
      const double penalty = 0.02 * std::abs(cephalad - 8) + 0.03 * std::abs(shift);
      for (double t = 4.0; t < 60.0 && clearance - penalty > worst_useful; t += kSample)
        clearance = std::min(clearance, model.bone_clearance(target - t * direction));
      if (clearance - penalty <= best_score) continue;
      const double length = distance_to_skin(model, target, direction);
      if (length < 0.0) continue;
      best_score = clearance - penalty;
      best = {{target - length * direction, target}, clearance, angle};
    }
  }
  return best;
}

}  // namespace bodkin::patient
