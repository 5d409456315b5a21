#include "scene/skin_patch.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "scene/picking.h"

namespace bodkin::scene {

namespace {

using SkinTriangle = std::array<std::int32_t, 3>;
using SideOfTwo = std::pair<std::int32_t, std::int32_t>;

constexpr double fading =
    10.0;  // mm, over which displacements fade out, since the skin around the patch stands still
constexpr double searched = 40.0;  // mm before and behind the entry, searched for the skin

std::size_t index_of(std::int32_t i) {
  return static_cast<std::size_t>(i);
}

SideOfTwo edge(std::int32_t a, std::int32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

// mm, desired edge at a distance from the needle.
double edge_length(double distance) {
  return std::max(0.8, 0.16 * distance);
}

// f at `from`, relative to the needle's entry into the skin at rest, and its gradient (1/mm).
struct Dent {
  double shape = 0.0;
  Vec3 gradient = Vec3::Zero();
};

Dent dent_at(const Vec3& from, const Vec3& along, double reach) {
  const double distance = from.norm();
  if (distance >= reach) return {};
  const Vec3 across = from - from.dot(along) * along;
  const double width = SkinPatch::dent_width;
  const double core = 1.0 / std::sqrt(1.0 + across.squaredNorm() / (width * width));
  const double ratio = distance / reach, window = 1.0 - ratio * ratio;
  return {core * window * window, across * (-core * core * core * window * window / (width * width)) -
                                      from * (4.0 * core * window / (reach * reach))};
}

}  // namespace

SkinPatch::SkinPatch(const SceneMesh& skin, const Vec3& entry, const Vec3& direction) : entry_(entry) {
  around_ = skin.triangles;
  const std::optional<SurfacePoint> middle = first_hit(skin, {entry - searched * direction, direction});
  if (!middle || (middle->point - entry).norm() > searched) return;
  std::vector<std::int32_t> index(skin.points.size(), -1);
  std::vector<bool> near(skin.points.size());
  for (std::size_t i = 0; i < near.size(); ++i) {
    near[i] = (skin.points[i].cast<double>() - middle->point).norm() < radius &&
              skin.normals[i].cast<double>().dot(middle->normal) > 0.0;  // not the opposite side of a thin part
  }
  const auto take = [&](std::int32_t old) {
    std::int32_t& known = index[index_of(old)];
    if (known < 0) {
      known = static_cast<std::int32_t>(mesh_.points.size());
      mesh_.points.push_back(skin.points[index_of(old)]);
      mesh_.normals.push_back(skin.normals[index_of(old)]);
      mesh_.openness.push_back(skin.openness[index_of(old)]);
    }
    return known;
  };
  around_.clear();
  for (std::size_t t = 0; t < skin.triangles.size(); ++t) {
    const SkinTriangle& old = skin.triangles[t];
    if (t != middle->triangle && !(near[index_of(old[0])] || near[index_of(old[1])] || near[index_of(old[2])])) {
      around_.push_back(old);
      continue;
    }
    const SkinTriangle corners = {take(old[0]), take(old[1]), take(old[2])};
    if (t != middle->triangle) {
      mesh_.triangles.push_back(corners);
      continue;
    }
    bottom_ = mesh_.points.size();
    const auto tip = static_cast<std::int32_t>(bottom_);
    mesh_.points.push_back(middle->point.cast<float>());
    mesh_.normals.push_back(middle->normal.cast<float>());
    float open = 0.0F;
    for (std::size_t c = 0; c < 3; ++c) {
      open += static_cast<float>(middle->weights[static_cast<Eigen::Index>(c)]) * skin.openness[index_of(old[c])];
    }
    mesh_.openness.push_back(open);
    for (std::size_t c = 0; c < 3; ++c) mesh_.triangles.push_back({corners[c], corners[(c + 1) % 3], tip});
  }
  find_reach(middle->point);
  divide(middle->point);
  rest_.reserve(mesh_.points.size());
  for (const Eigen::Vector3f& point : mesh_.points) rest_.push_back(point.cast<double>());
  rest_normals_ = mesh_.normals;
}

// A dent ends before the border, beyond which the skin does not move.
void SkinPatch::find_reach(const Vec3& middle) {
  std::map<SideOfTwo, int> count;
  for (const SkinTriangle& corners : mesh_.triangles) {
    for (std::size_t c = 0; c < 3; ++c) ++count[edge(corners[c], corners[(c + 1) % 3])];
  }
  reach_ = radius;
  for (const auto& [between, triangles] : count) {
    if (triangles > 1) continue;
    for (const std::int32_t end : {between.first, between.second}) {
      reach_ = std::min(reach_, (mesh_.points[index_of(end)].cast<double>() - middle).norm());
    }
  }
}

// Halves edges that are too long, consistently between neighbours, until none is; the border is unchanged.
void SkinPatch::divide(const Vec3& middle) {
  for (int round = 0; round < 6; ++round) {
    std::map<SideOfTwo, int> count;
    for (const SkinTriangle& corners : mesh_.triangles) {
      for (std::size_t c = 0; c < 3; ++c) ++count[edge(corners[c], corners[(c + 1) % 3])];
    }
    std::map<SideOfTwo, std::int32_t> halves;
    for (const auto& [between, triangles] : count) {
      const Eigen::Vector3f a = mesh_.points[index_of(between.first)], b = mesh_.points[index_of(between.second)];
      const Vec3 half = (0.5F * (a + b)).cast<double>();
      if (triangles < 2 || static_cast<double>((a - b).norm()) < 1.5 * edge_length((half - middle).norm())) continue;
      halves[between] = static_cast<std::int32_t>(mesh_.points.size());
      mesh_.points.push_back(half.cast<float>());
      mesh_.normals.push_back(
          (mesh_.normals[index_of(between.first)] + mesh_.normals[index_of(between.second)]).normalized());
      mesh_.openness.push_back(0.5F *
                               (mesh_.openness[index_of(between.first)] + mesh_.openness[index_of(between.second)]));
    }
    if (halves.empty()) break;
    std::vector<SkinTriangle> divided;
    for (const SkinTriangle& corners : mesh_.triangles) {
      std::array<std::int32_t, 3> half{};
      int cut = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        const auto found = halves.find(edge(corners[c], corners[(c + 1) % 3]));
        half[c] = found == halves.end() ? -1 : found->second;
        cut += half[c] < 0 ? 0 : 1;
      }
      // Rotated so that the first edge is cut, and of two cut edges the last one is not.
      std::size_t first = 0;
      while (cut > 0 && (half[first] < 0 || (cut == 2 && half[(first + 2) % 3] >= 0))) ++first;
      const std::int32_t a = corners[first % 3], b = corners[(first + 1) % 3], c = corners[(first + 2) % 3];
      const std::int32_t ab = half[first % 3], bc = half[(first + 1) % 3], ca = half[(first + 2) % 3];
      switch (cut) {
        case 0:
          divided.push_back(corners);
          break;
        case 1:
          divided.insert(divided.end(), {{a, ab, c}, {ab, b, c}});
          break;
        case 2:
          divided.insert(divided.end(), {{a, ab, c}, {ab, bc, c}, {ab, b, bc}});
          break;
        default:
          divided.insert(divided.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
          break;
      }
    }
    mesh_.triangles = std::move(divided);
  }
}

std::size_t SkinPatch::nearest_to(const Vec3& point) const {
  const auto distance = [&](const Vec3& rest) { return (rest - point).squaredNorm(); };
  const auto nearest = std::min_element(rest_.begin(), rest_.end(),
                                        [&](const Vec3& a, const Vec3& b) { return distance(a) < distance(b); });
  return static_cast<std::size_t>(nearest - rest_.begin());
}

void SkinPatch::deform(const SkinDent& dent, std::span<const float> displacements, const BreathMotion& breath) {
  if (empty()) return;
  const bool moved = displacements.size() == 3 * rest_.size();
  const Vec3 along = dent.direction.normalized();
  bottom_ = nearest_to(dent.entry);
  const auto moved_by = [&](std::size_t i) {
    return Vec3(Eigen::Map<const Eigen::Vector3f>(displacements.data() + 3 * i).cast<double>());
  };
  // The drawn surface and the tissues meet the needle's line at places that differ by parts of a voxel, and a body's
  // displacements are coarser than a dent: the dent is the difference at the needle.
  Vec3 dip = Vec3::Zero();
  if (dent.depth != 0.0) dip = dent.entry + dent.depth * along - rest_[bottom_];
  if (dent.depth != 0.0 && moved) dip -= moved_by(bottom_);
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    Vec3 point = rest_[i];
    const Vec3 from = point - rest_[bottom_];
    const Dent here = dent_at(from, along, reach_);
    if (moved) point += std::clamp((reach_ - from.norm()) / fading, 0.0, 1.0) * moved_by(i);
    mesh_.points[i] = (point + here.shape * dip + breath.of(rest_[i])).cast<float>();
    // Normals turn with the inverse transpose of the deformation's gradient 1 + dip gradient^T.
    const Vec3 normal = rest_normals_[i].cast<double>();
    const double stretch = std::max(0.05, 1.0 + dip.dot(here.gradient));
    mesh_.normals[i] = (normal - here.gradient * (dip.dot(normal) / stretch)).normalized().cast<float>();
  }
}

}  // namespace bodkin::scene
