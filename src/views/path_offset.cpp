#include "views/path_offset.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bodkin::views {

PathOffset path_offset(const anatomy::NeedlePath& path, const Vec3& tip, const Vec3& axis) {
  PathOffset offset;
  if (!(path.length() > 0.0)) return offset;
  const Vec3 along = path.direction();
  // Upwards in the image: the patient's head, or the front for a path along the body.
  const Vec3 head = std::abs(along.z()) < 0.9 ? Vec3::UnitZ() : Vec3(-Vec3::UnitY());
  const Vec3 up = (head - head.dot(along) * along).normalized();
  const Vec3 right = along.cross(up);
  const auto across = [&](const Vec3& point) {
    return Eigen::Vector2d(right.dot(point - path.entry), up.dot(point - path.entry));
  };
  offset.tip = across(tip);
  const double forwards = axis.dot(along);
  const Vec3 back = std::abs(forwards) > 1e-6 ? Vec3(tip - along.dot(tip - path.entry) / forwards * axis) : tip;
  offset.hub = across(back);
  offset.distance = offset.tip.norm();
  offset.angle = std::atan2(axis.cross(along).norm(), forwards) / degree;
  offset.to_target = along.dot(path.target - tip);
  constexpr double worth_saying = 0.5;  // mm
  if (offset.distance > worth_saying) {
    const Vec3 away = offset.tip.x() * right + offset.tip.y() * up;
    Eigen::Index largest = 0;
    away.cwiseAbs().maxCoeff(&largest);
    constexpr std::array<std::array<Side, 2>, 3> sides = {
        {{Side::left, Side::right}, {Side::posterior, Side::anterior}, {Side::cranial, Side::caudal}}};
    offset.side = sides[static_cast<std::size_t>(largest)][away[largest] < 0.0 ? 1 : 0];
  }
  return offset;
}

}  // namespace bodkin::views
