#include "fem/moving/probe_press.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "core/settings_check.h"

namespace bodkin::fem {

namespace {

constexpr double farthest_probe = 1e5;  // mm; farther, a sensor failed
constexpr double least_pull = 1e-6;     // N; less is rounding

// Nodes of the faces that belong to only one element.
std::vector<bool> on_surface(const anatomy::TetrahedralMesh& mesh) {
  std::vector<std::array<std::uint32_t, 3>> faces;
  faces.reserve(4 * mesh.elements.size());
  for (const auto& element : mesh.elements) {
    for (std::size_t left_out = 0; left_out < 4; ++left_out) {
      std::array<std::uint32_t, 3> face{};
      for (std::size_t a = 0, b = 0; a < 4; ++a)
        if (a != left_out) face[b++] = element[a];
      std::sort(face.begin(), face.end());
      faces.push_back(face);
    }
  }
  std::sort(faces.begin(), faces.end());
  std::vector<bool> found(mesh.nodes.size(), false);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if ((i > 0 && faces[i] == faces[i - 1]) || (i + 1 < faces.size() && faces[i] == faces[i + 1])) continue;
    for (const std::uint32_t node : faces[i]) found[node] = true;
  }
  return found;
}

bool is_rigid(const Pose& pose) noexcept {
  const Mat3 turn = pose.linear();
  return pose.matrix().allFinite() && pose.translation().norm() < farthest_probe &&
         (turn.transpose() * turn - Mat3::Identity()).norm() < 1e-6 && turn.determinant() > 0.0;
}

}  // namespace

ProbePress::ProbePress(const anatomy::TetrahedralMesh& mesh, std::span<const std::uint32_t> fixed,
                       const ProbeFace& face)
    : face_(face) {
  constexpr auto origin = "face of the probe";
  check_range(origin, "width", face.width, {1.0, 200.0}, "mm");
  check_range(origin, "thickness", face.thickness, {1.0, 100.0}, "mm");
  check_range(origin, "reach", face.reach, {1.0, 100.0}, "mm");
  if (face.radius != 0.0) {
    check_range(origin, "radius", face.radius, {5.0, 500.0}, "mm");
    check_range(origin, "width", face.width, {1.0, 1.9 * face.radius}, "mm");
  }
  std::vector<bool> free = on_surface(mesh);
  for (const std::uint32_t node : fixed) free[node] = false;
  for (std::uint32_t node = 0; node < mesh.nodes.size(); ++node)
    if (free[node]) surface_.push_back(node);
  held_at_.assign(surface_.size(), Vec3::Zero());
  is_held_.assign(surface_.size(), 0);
}

// mm along the third axis; 0 in the middle, below it at the ends of a convex array.
double ProbePress::height_of_face(double along) const noexcept {
  if (face_.radius == 0.0) return 0.0;
  return std::sqrt(face_.radius * face_.radius - along * along) - face_.radius;
}

Vec3 ProbePress::outward(double along) const noexcept {
  if (face_.radius == 0.0) return Vec3::UnitZ();
  return Vec3(along, 0.0, height_of_face(along) + face_.radius) / face_.radius;
}

void ProbePress::press(const Pose& probe, CorotationalBody& body) noexcept {
  if (!is_rigid(probe)) {
    lift(body);
    return;
  }
  probe_ = probe;
  for (std::size_t i = 0; i < surface_.size(); ++i) {
    if (is_held_[i] == 0) {
      const Vec3 at = probe.linear().transpose() * (body.position(surface_[i]) - probe.translation());
      if (!(std::abs(at.x()) <= 0.5 * face_.width && std::abs(at.y()) <= 0.5 * face_.thickness)) continue;
      const double face = height_of_face(at.x());
      if (at.z() >= face || at.z() < face - face_.reach) continue;
      held_at_[i] = Vec3(at.x(), at.y(), face);
      is_held_[i] = 1;
      ++held_;
    }
    body.hold(surface_[i], probe * held_at_[i]);
  }
}

void ProbePress::lift(CorotationalBody& body) noexcept {
  for (std::size_t i = 0; i < surface_.size(); ++i) {
    if (is_held_[i] == 0) continue;
    body.release(surface_[i]);
    is_held_[i] = 0;
  }
  held_ = 0;
}

void ProbePress::release_pulled_nodes(CorotationalBody& body) noexcept {
  for (std::size_t i = 0; i < surface_.size(); ++i) {
    if (is_held_[i] == 0) continue;
    const Vec3 push = body.holding_force(surface_[i]);
    if (push.dot(probe_.linear() * outward(held_at_[i].x())) >= -least_pull) continue;
    body.release(surface_[i]);
    is_held_[i] = 0;
    --held_;
  }
}

void ProbePress::held_nodes(std::span<std::uint32_t> nodes) const noexcept {
  std::size_t count = 0;
  for (std::size_t i = 0; i < surface_.size(); ++i)
    if (is_held_[i] != 0) nodes[count++] = surface_[i];
}

bool ProbePress::holds(std::span<const std::uint32_t> nodes) const noexcept {
  std::size_t count = 0;
  for (std::size_t i = 0; i < surface_.size(); ++i) {
    if (is_held_[i] == 0) continue;
    if (count == nodes.size() || nodes[count] != surface_[i]) return false;
    ++count;
  }
  return count == nodes.size();
}

Wrench ProbePress::on_probe(const CorotationalBody& body) const noexcept {
  Wrench sum;
  for (std::size_t i = 0; i < surface_.size(); ++i) {
    if (is_held_[i] == 0) continue;
    const Vec3 force = -body.holding_force(surface_[i]);
    sum.force += force;
    sum.torque += (body.position(surface_[i]) - probe_.translation()).cross(force);
  }
  return sum;
}

Wrench ProbePress::from_middle(const Wrench& wrench, const CorotationalBody& body) const noexcept {
  if (held_ == 0) return {};
  Vec3 middle = Vec3::Zero();
  for (std::size_t i = 0; i < surface_.size(); ++i)
    if (is_held_[i] != 0) middle += body.position(surface_[i]) / static_cast<double>(held_);
  return {wrench.force, wrench.torque + (middle - probe_.translation()).cross(wrench.force)};
}

}  // namespace bodkin::fem
