#pragma once

// Surfaces with known answers for the tests of the surface proxy.
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "anatomy/surface.h"

namespace bodkin::shapes {

using namespace bodkin::anatomy;

using Triangles = std::vector<std::array<int, 3>>;

// Patches of n x n squares spanned by u and v at corner; u x v points outwards.
struct Patch {
  Vec3 corner, u, v;
};

// Patches stuck together where their vertices coincide.
inline Surface patches(const std::vector<Patch>& list, int n) {
  std::map<std::array<long, 3>, int> known;
  std::vector<Vec3> vertices;
  Triangles triangles;
  const auto vertex = [&](const Vec3& at) {
    const std::array<long, 3> key = {std::lround(at.x() * 1e6), std::lround(at.y() * 1e6), std::lround(at.z() * 1e6)};
    const auto [place, fresh] = known.emplace(key, static_cast<int>(vertices.size()));
    if (fresh) vertices.push_back(at);
    return place->second;
  };
  for (const Patch& patch : list) {
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const auto at = [&](int di, int dj) {
          return vertex(patch.corner + patch.u * (i + di) / n + patch.v * (j + dj) / n);
        };
        const int a = at(0, 0), b = at(1, 0), c = at(1, 1), d = at(0, 1);
        if ((i + j) % 2 == 0) {
          triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
        } else {
          triangles.insert(triangles.end(), {{a, b, d}, {b, c, d}});
        }
      }
    }
  }
  return Surface(std::move(vertices), std::move(triangles));
}

// The plane z = 0, outside above, 40 mm each way.
inline Surface plane(int n = 8) {
  return patches({{Vec3(-40, -40, 0), Vec3(80, 0, 0), Vec3(0, 80, 0)}}, n);
}

// Six faces of the box from `low` to `high`; turned inside out it is a room.
inline Surface box(const Vec3& low, const Vec3& high, int n, bool room = false) {
  const Vec3 size = high - low;
  std::vector<Patch> faces;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 u = Vec3::Zero(), v = Vec3::Zero(), w = Vec3::Zero();
    u[(axis + 1) % 3] = size[(axis + 1) % 3];
    v[(axis + 2) % 3] = size[(axis + 2) % 3];
    w[axis] = size[axis];
    faces.push_back({low + w, u, v});
    faces.push_back({low, v, u});
  }
  if (room) {
    for (Patch& face : faces) std::swap(face.u, face.v);
  }
  return patches(faces, n);
}

// A ball of 20 4^level triangles whose vertices lie on the sphere.
inline Surface sphere(double radius, int level, const Vec3& centre = Vec3::Zero()) {
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  std::vector<Vec3> points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                              {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  Triangles triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                         {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                         {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (Vec3& point : points) point.normalize();
  for (; level > 0; --level) {
    std::map<std::pair<int, int>, int> middles;
    Triangles finer;
    const auto middle = [&](int a, int b) {
      const auto [place, fresh] = middles.emplace(std::minmax(a, b), static_cast<int>(points.size()));
      if (fresh) {
        points.push_back((points[static_cast<std::size_t>(a)] + points[static_cast<std::size_t>(b)]).normalized());
      }
      return place->second;
    };
    for (const auto& [a, b, c] : triangles) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    triangles = std::move(finer);
  }
  for (Vec3& point : points) point = centre + radius * point;
  return Surface(std::move(points), std::move(triangles));
}

}  // namespace bodkin::shapes
