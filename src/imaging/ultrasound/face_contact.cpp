#include "imaging/ultrasound/face_contact.h"

#include <algorithm>
#include <cmath>

namespace bodkin::imaging {

namespace {

constexpr double face_step = 0.25;  // mm
constexpr double rigid = 1e-3;      // error of a rotation's products

// A point that moves along a line, in voxels.
struct FaceRay {
  const AcousticVolume& patient;
  Vec3 start, step;  // voxels, voxels per mm

  bool in_air(double distance) const noexcept {
    const Vec3 index = (start + distance * step).array() + 0.5;
    const auto& size = patient.grid.size;
    const bool within = index.x() >= 0.0 && index.y() >= 0.0 && index.z() >= 0.0 && index.x() < size[0] &&
                        index.y() < size[1] && index.z() < size[2];
    if (!within) return true;
    return patient.tissue(patient.grid.offset(static_cast<int>(index.x()), static_cast<int>(index.y()),
                                              static_cast<int>(index.z()))) == anatomy::tissue::air;
  }
  // Whether air contributes to the interpolation between the voxels there.
  bool partly_air(double distance) const noexcept {
    constexpr double negligible = 0.002;  // of a voxel
    const Vec3 index = start + distance * step;
    const Vec3 low = (index.array() + negligible).floor(), high = (index.array() - negligible).ceil();
    for (int corner = 0; corner < 8; ++corner) {
      const int i = static_cast<int>((corner & 1) != 0 ? high.x() : low.x()),
                j = static_cast<int>((corner & 2) != 0 ? high.y() : low.y()),
                k = static_cast<int>((corner & 4) != 0 ? high.z() : low.z());
      if (!patient.grid.contains(i, j, k) || patient.tissue(patient.grid.offset(i, j, k)) == anatomy::tissue::air)
        return true;
    }
    return false;
  }
  // mm from `distance` to the end of that region, because the voxel of the skin seems half air; 0 if it does not end
  // within a few voxels.
  double to_whole_tissue(double distance) const noexcept {
    constexpr double farthest = 2.0;  // mm
    for (double further = 0.0; further <= farthest; further += face_step)
      if (!partly_air(distance + further)) return further;
    return 0.0;
  }
};

struct Touch {
  double gap = 0.0, press = 0.0;  // mm from the face to the skin, before and behind it
  double gel = 0.0;               // mm from the face to where only tissue is, before it
  double tissue = 0.0;            // and behind it
};

Touch touch(const FaceRay& ray, double reach) noexcept {
  if (ray.in_air(0.0)) {
    for (double ahead = face_step; ahead <= reach; ahead += face_step) {
      if (!ray.in_air(ahead)) return {ahead, 0.0, std::min(thickest_gel, ahead + ray.to_whole_tissue(ahead)), 0.0};
    }
    return {2.0 * thickest_gel, 0.0, 2.0 * thickest_gel, 0.0};
  }
  double behind = face_step;
  while (behind <= deepest_press && !ray.in_air(-behind)) behind += face_step;
  const double press = behind - face_step, left = press - ray.to_whole_tissue(-press);
  return {0.0, press, std::max(0.0, -left), std::max(0.0, left)};
}

}  // namespace

FaceContact face_contact(const AcousticVolume& patient, std::span<const Vec3> origins,
                         std::span<const Vec3> directions, const Pose& pose, bool gel, std::span<float> gap,
                         std::span<float> press) noexcept {
  FaceContact contact;
  if (!pose.matrix().allFinite() || !(pose.linear().transpose() * pose.linear()).isIdentity(rigid) ||
      pose.linear().determinant() < 0.0) {
    contact.why = NoImage::broken_pose;
    return contact;
  }
  const anatomy::Grid& grid = patient.grid;
  const Mat3 into_voxels = grid.spacing.cwiseInverse().asDiagonal() * grid.direction.transpose();
  const double reach = gel ? thickest_gel : touching;
  const Mat3 turned = into_voxels * pose.linear();
  const Vec3 face = grid.to_index(pose.translation());
  const Vec3 margin = grid.spacing.cwiseInverse() * deepest_press;  // air invisible in a CT is still air
  for (int axis = 0; axis < 3; ++axis) {
    if (face[axis] < -margin[axis] || face[axis] > grid.size[static_cast<std::size_t>(axis)] - 1 + margin[axis])
      contact.why = NoImage::outside_volume;
  }
  if (contact.why != NoImage::none) return contact;
  contact.press = touch({patient, face, turned.col(1)}, reach).press;
  if (contact.press >= deepest_press) {
    contact.why = NoImage::inside_body;
    return contact;
  }
  int reached = 0;
  for (std::size_t line = 0; line < origins.size(); ++line) {
    const Touch found = touch({patient, face + turned * origins[line], turned * directions[line]}, reach);
    gap[line] = static_cast<float>(found.gel);
    press[line] = static_cast<float>(found.tissue);
    reached += found.gap <= thickest_gel ? 1 : 0;
  }
  contact.share = static_cast<double>(reached) / static_cast<double>(origins.size());
  if (reached == 0) contact.why = NoImage::no_contact;
  return contact;
}

}  // namespace bodkin::imaging
