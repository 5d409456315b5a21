#include "patient/whole_body/body_landmarks.h"

#include <array>
#include <cmath>

#include "patient/synthetic/shapes.h"

namespace bodkin::patient {
namespace {

// Unit vector at an angle (deg, 0 to 360) between two axes.
Vec3 towards(const Vec3& first, const Vec3& second, double angle) {
  // The series of shapes.h hold to 90 degrees: turn by quarters.
  Vec3 a = first, b = second;
  while (angle > 90.0) {
    const Vec3 turned = -a;
    a = b;
    b = turned;
    angle -= 90.0;
  }
  return shapes::cosine(angle * shapes::degrees) * a + shapes::sine(angle * shapes::degrees) * b;
}

}  // namespace

Vec3 SkinFinder::along(const Vec3& from, const Vec3& direction, bool with_ears) const {
  double inside = shape_.drawn_distance(from, with_ears);
  const double sign = inside < 0.0 ? -1.0 : 1.0;
  double t = 0.0, before = 0.0;
  for (int i = 0; i < 4000; ++i) {
    if (sign * inside <= 0.0) break;
    before = t;
    t += std::clamp(0.6 * std::abs(inside), 0.25, 20.0);
    inside = shape_.drawn_distance(from + t * direction, with_ears);
  }
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (before + t);
    (sign * shape_.drawn_distance(from + middle * direction, with_ears) > 0.0 ? before : t) = middle;
  }
  return from + t * direction;
}

Vec3 SkinFinder::arm(double w, double angle) const {
  const Mat3& axes = shape_.arm_axes();
  return along(shape_.from_arm(Vec3(0.0, 0.0, w)), towards(axes.col(0), axes.col(1), angle));
}

Vec3 SkinFinder::leg(double z, double angle) const {
  const Tube& leg = shape_.leg();
  return along(Vec3(leg.centre_a(z), leg.centre_b(z), z), towards(Vec3::UnitX(), -Vec3::UnitY(), angle));
}

Vec3 SkinFinder::neck(double z, double angle) const {
  return along(Vec3(0.0, 26.0, z), towards(Vec3::UnitX(), -Vec3::UnitY(), angle));
}

Vec3 SkinFinder::hand(double across, double w, double to_palm) const {
  return along(shape_.from_arm(Vec3(across, 70.0 * to_palm, w)), -to_palm * shape_.arm_axes().col(1));
}

void SkinFinder::add(std::string_view name, BodyLandmark::Kind kind, std::vector<Vec3> places) {
  for (Vec3& place : places) place *= shape_.scale();
  landmarks_.insert_or_assign(std::string(name), BodyLandmark{kind, std::move(places)});
}

BodyLandmarks body_landmarks(const BodyShape& shape) {
  BodyLandmarks landmarks;
  SkinFinder skin(shape, landmarks);
  add_head_landmarks(skin);
  add_trunk_landmarks(skin);
  add_arm_landmarks(skin);
  add_leg_landmarks(skin);
  add_foot_landmarks(skin);
  return landmarks;
}

double spinous_height(int vertebra) {
  constexpr double c7 = 1428.0, thoracic = 24.0, lumbar = 36.0;
  if (vertebra <= 12) return c7 - thoracic * vertebra;
  if (vertebra == 17) return 962.0;
  return c7 - 12.0 * thoracic - lumbar * (vertebra - 12);
}

double rib_height(int rib, double position) {
  // In front, ribs 1 to 7 meet the breastbone and 8 to 10 the costal arch; 11 and 12 end freely at the side.
  static constexpr std::array<double, 12> front = {1374.0, 1347.0, 1322.0, 1297.0, 1272.0, 1248.0,
                                                   1226.0, 1204.0, 1180.0, 1150.0, 1092.0, 1084.0};
  const double behind = spinous_height(rib) + 24.0;
  const double sag = 12.0 + 2.0 * rib;  // below the straight line, most in the middle
  return behind + position * (front[static_cast<std::size_t>(rib - 1)] - behind) -
         4.0 * sag * position * (1.0 - position);
}

double position_along_ribs(const Vec3& q) {
  // By the direction from the middle of the chest; a rational stand-in for the angle.
  const double x = std::abs(q.x()), y = q.y();
  const double sum = x + std::abs(y);
  if (sum < 1e-9) return 0.0;
  return y > 0.0 ? 0.5 * x / sum : 1.0 - 0.5 * x / sum;
}

}  // namespace bodkin::patient
