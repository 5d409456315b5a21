#include "scene/inner_patch.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace bodkin::scene {

namespace {

constexpr double fading_inside = 8.0;  // mm

using InnerTriangle = std::array<std::int32_t, 3>;

// Depth of a point within the cylinder about the needle's line, mm; negative: outside.
double within_cylinder(const Vec3& point, const Vec3& entry, const Vec3& direction) {
  const Vec3 from = point - entry;
  const double along = from.dot(direction);
  const double beside = (from - along * direction).norm();
  return std::min({InnerPatch::radius - beside, along + InnerPatch::before, InnerPatch::beyond - along});
}

// Area times normal of each triangle, added up at its corners, unit.
std::vector<Eigen::Vector3f> face_normals(const std::vector<Eigen::Vector3f>& points,
                                          const std::vector<InnerTriangle>& triangles) {
  std::vector<Eigen::Vector3f> sums(points.size(), Eigen::Vector3f::Zero());
  for (const InnerTriangle& corners : triangles) {
    const Eigen::Vector3f& a = points[static_cast<std::size_t>(corners[0])];
    const Eigen::Vector3f normal =
        (points[static_cast<std::size_t>(corners[1])] - a).cross(points[static_cast<std::size_t>(corners[2])] - a);
    for (const std::int32_t corner : corners) sums[static_cast<std::size_t>(corner)] += normal;
  }
  for (Eigen::Vector3f& sum : sums) sum.normalize();
  return sums;
}

}  // namespace

InnerPatch::InnerPatch(const PatientSurfaces& surfaces, const Vec3& entry, const Vec3& direction) {
  for (std::size_t s = 0; s < surfaces.parts.size(); ++s) {
    const PatientSurface& surface = surfaces.parts[s];
    if (surface.kind != SurfaceKind::tissue && surface.kind != SurfaceKind::forbidden) continue;
    std::vector<double> within(surface.mesh.points.size());
    for (std::size_t i = 0; i < within.size(); ++i)
      within[i] = within_cylinder(surface.mesh.points[i].cast<double>(), entry, direction);
    Part part;
    part.surface = s;
    part.first = rest_.size();
    std::vector<std::int32_t> index(within.size(), -1);
    const auto take = [&](std::int32_t old) {
      const auto at = static_cast<std::size_t>(old);
      if (index[at] < 0) {
        index[at] = static_cast<std::int32_t>(part.mesh.points.size());
        part.mesh.points.push_back(surface.mesh.points[at]);
        part.mesh.normals.push_back(surface.mesh.normals[at]);
        part.mesh.openness.push_back(surface.mesh.openness[at]);
        share_.push_back(static_cast<float>(std::clamp(within[at] / fading_inside, 0.0, 1.0)));
      }
      return index[at];
    };
    const SurfaceSection whole{surface.name, 0, surface.mesh.triangles.size()};
    const std::span<const SurfaceSection> sections =
        surface.sections.empty() ? std::span<const SurfaceSection>(&whole, 1) : std::span(surface.sections);
    for (const SurfaceSection& section : sections) {
      const std::size_t first = part.mesh.triangles.size(), first_still = part.still_triangles.size();
      for (std::size_t t = section.first; t < section.first + section.count; ++t) {
        const InnerTriangle& corners = surface.mesh.triangles[t];
        const bool moves = std::any_of(corners.begin(), corners.end(), [&](std::int32_t corner) {
          return within[static_cast<std::size_t>(corner)] > 0.0;
        });
        if (moves) {
          part.mesh.triangles.push_back({take(corners[0]), take(corners[1]), take(corners[2])});
        } else {
          part.still_triangles.push_back(corners);
        }
      }
      part.sections.push_back({section.name, first, part.mesh.triangles.size() - first});
      part.around.push_back({section.name, first_still, part.still_triangles.size() - first_still});
    }
    if (part.mesh.empty()) continue;
    for (const Eigen::Vector3f& point : part.mesh.points) rest_.push_back(point.cast<double>());
    rest_normals_.insert(rest_normals_.end(), part.mesh.normals.begin(), part.mesh.normals.end());
    parts_.push_back(std::move(part));
  }
}

const InnerPatch::Part* InnerPatch::part_of(std::size_t surface) const {
  const auto found =
      std::find_if(parts_.begin(), parts_.end(), [surface](const Part& part) { return part.surface == surface; });
  return found == parts_.end() ? nullptr : &*found;
}

void InnerPatch::deform(std::span<const float> displacements, const BreathMotion& breath) {
  const bool moved = displacements.size() == 3 * rest_.size();
  for (Part& part : parts_) {
    for (std::size_t i = 0; i < part.mesh.points.size(); ++i) {
      const std::size_t at = part.first + i;
      part.mesh.points[i] = rest_[at].cast<float>();
      if (moved) part.mesh.points[i] += share_[at] * Eigen::Map<const Eigen::Vector3f>(displacements.data() + 3 * at);
    }
    turn_normals(part);
    for (std::size_t i = 0; i < part.mesh.points.size(); ++i)
      part.mesh.points[i] += breath.of(rest_[part.first + i]).cast<float>();
  }
}

// Normals change by the changes of the faces' normals, so that a surface at rest keeps its smooth ones.
void InnerPatch::turn_normals(Part& part) const {
  std::vector<Eigen::Vector3f> rest;
  rest.reserve(part.mesh.points.size());
  for (std::size_t i = 0; i < part.mesh.points.size(); ++i) rest.push_back(rest_[part.first + i].cast<float>());
  const std::vector<Eigen::Vector3f> before_it = face_normals(rest, part.mesh.triangles),
                                     now = face_normals(part.mesh.points, part.mesh.triangles);
  for (std::size_t i = 0; i < rest.size(); ++i)
    part.mesh.normals[i] = (rest_normals_[part.first + i] + now[i] - before_it[i]).normalized();
}

}  // namespace bodkin::scene
