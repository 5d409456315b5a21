#include "scene/camera_moves.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace bodkin::scene {

namespace {

constexpr double beside_needle = 55.0 * degree, above_needle = 8.0 * degree;  // of the operator's view [D]
constexpr double least_distance = 60.0, most_distance = 3000.0;               // mm

}  // namespace

Camera standard_view(StandardView view, const ViewSubject& subject) {
  Camera camera;
  const double distance = 0.5 * subject.height / std::tan(0.5 * camera.angle);
  const Vec3 head = Vec3::UnitZ();
  Vec3 from = Vec3::UnitY(), up = head;
  switch (view) {
    case StandardView::operator_side: {
      const Vec3 out = -subject.direction;
      const Vec3 side = std::abs(out.dot(head)) < 0.9 ? Vec3(out.cross(head).normalized()) : Vec3::UnitX();
      // To the patient's left, the operator's place in textbook pictures.
      const Vec3 left = side.x() >= 0.0 ? side : Vec3(-side);
      from = (std::cos(beside_needle) * out + std::sin(beside_needle) * left).normalized() +
             std::tan(above_needle) * head;
      break;
    }
    case StandardView::anterior:
      from = -Vec3::UnitY();
      break;
    case StandardView::posterior:
      from = Vec3::UnitY();
      break;
    case StandardView::left:
      from = Vec3::UnitX();
      break;
    case StandardView::right:
      from = -Vec3::UnitX();
      break;
    case StandardView::superior:
      from = head;
      up = -Vec3::UnitY();
      break;
    case StandardView::inferior:
      from = -head;
      up = -Vec3::UnitY();
      break;
  }
  camera.focus = subject.middle;
  camera.eye = subject.middle + distance * from.normalized();
  camera.up = up;
  return camera;
}

Camera turned(const Camera& camera, double right, double down) {
  const Mat3 axes = camera.axes();
  const Mat3 turn =
      (Eigen::AngleAxisd(-right, -axes.col(1)) * Eigen::AngleAxisd(down, -axes.col(0))).toRotationMatrix();
  Camera result = camera;
  result.eye = camera.focus + turn * (camera.eye - camera.focus);
  result.up = turn * -axes.col(1);
  return result;
}

Camera panned(const Camera& camera, double right, double down, int height) {
  const Mat3 axes = camera.axes();
  const double mm_per_pixel = 2.0 * camera.distance() * std::tan(0.5 * camera.angle) / height;
  const Vec3 move = -mm_per_pixel * (right * axes.col(0) + down * axes.col(1));
  Camera result = camera;
  result.eye += move;
  result.focus += move;
  return result;
}

Camera zoomed(const Camera& camera, double factor, const Vec3& place) {
  const double distance = std::clamp(camera.distance() / factor, least_distance, most_distance);
  const double kept = distance / camera.distance();
  // Everything shrinks towards `place`, which thus stays in place in the image.
  Camera result = camera;
  result.focus = place + kept * (camera.focus - place);
  result.eye = place + kept * (camera.eye - place);
  return result;
}

CameraFlight::CameraFlight(const Camera& from, const Camera& to, double duration)
    : from_(from), to_(to), duration_(duration) {}

Camera CameraFlight::at(double time) const {
  const double t = std::clamp(time / duration_, 0.0, 1.0);
  if (t >= 1.0) return to_;
  const double s = t * t * (3.0 - 2.0 * t);
  const Mat3 first = from_.axes(), last = to_.axes();
  const Mat3 axes = Eigen::Quaterniond(first).slerp(s, Eigen::Quaterniond(last)).toRotationMatrix();
  const double distance = from_.distance() * std::pow(to_.distance() / from_.distance(), s);
  Camera camera;
  camera.angle = from_.angle + s * (to_.angle - from_.angle);
  camera.focus = from_.focus + s * (to_.focus - from_.focus);
  camera.eye = camera.focus - distance * axes.col(2);
  camera.up = -axes.col(1);
  return camera;
}

}  // namespace bodkin::scene
