#include "anatomy/surface.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include "core/error.h"

namespace bodkin::anatomy {
namespace {

constexpr double farthest_vertex = 1e4;  // mm
constexpr double least_height = 1e-8;    // mm: far above the rounding error of a triangle 1e4 mm from the origin

// Twice the area over the longest edge; 0 when corners coincide.
double height(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  return longest > 0.0 ? (b - a).cross(c - a).norm() / longest : 0.0;
}

struct Edge {
  int low, high;  // vertices
  bool upwards;   // the triangle runs from low to high
  int triangle, side;
};

}  // namespace

Surface::Surface(std::vector<Vec3> vertices, std::vector<std::array<int, 3>> triangles)
    : vertices_(std::move(vertices)), triangles_(std::move(triangles)) {
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    if (vertices_[i].norm() <= farthest_vertex) continue;
    throw InputError("surface: vertex " + std::to_string(i) +
                     " is not finite or farther than 1e4 mm from the origin; give vertices in LPS mm");
  }
  const int count = static_cast<int>(vertices_.size());
  const auto is_vertex = [count](int corner) { return corner >= 0 && corner < count; };
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    if (std::all_of(triangles_[t].begin(), triangles_[t].end(), is_vertex)) continue;
    throw InputError("surface: triangle " + std::to_string(t) + " has a corner that is none of the " +
                     std::to_string(count) + " vertices; corners count from 0");
  }
  const auto flat = [this](const std::array<int, 3>& corners) {
    const auto at = [&](std::size_t i) { return vertices_[static_cast<std::size_t>(corners[i])]; };
    return !(height(at(0), at(1), at(2)) >= least_height);
  };
  left_out_ = std::erase_if(triangles_, flat);
  find_neighbours();
}

void Surface::find_neighbours() {
  std::vector<Edge> edges;
  edges.reserve(3 * triangles_.size());
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    for (std::size_t side = 0; side < 3; ++side) {
      const int from = triangles_[t][side], to = triangles_[t][(side + 1) % 3];
      edges.push_back(
          {std::min(from, to), std::max(from, to), from < to, static_cast<int>(t), static_cast<int>(side)});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::tie(a.low, a.high, a.upwards, a.triangle) < std::tie(b.low, b.high, b.upwards, b.triangle);
  });
  neighbours_.assign(triangles_.size(), {-1, -1, -1});
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const Edge &one = edges[i], &two = edges[i + 1];
    if (one.low != two.low || one.high != two.high) continue;
    if (one.upwards == two.upwards) {
      throw InputError("surface: triangles " + std::to_string(one.triangle) + " and " + std::to_string(two.triangle) +
                       " run along the edge of vertices " + std::to_string(one.low) + " and " +
                       std::to_string(one.high) +
                       " in the same direction; turn all triangles the same side out, two to an edge");
    }
    neighbours_[static_cast<std::size_t>(one.triangle)][static_cast<std::size_t>(one.side)] = two.triangle;
    neighbours_[static_cast<std::size_t>(two.triangle)][static_cast<std::size_t>(two.side)] = one.triangle;
  }
}

bool Surface::closed() const {
  return std::all_of(neighbours_.begin(), neighbours_.end(), [](const std::array<int, 3>& around) {
    return std::all_of(around.begin(), around.end(), [](int neighbour) { return neighbour >= 0; });
  });
}

Vec3 Surface::normal(std::size_t t) const {
  const auto at = [&](std::size_t i) { return vertices_[static_cast<std::size_t>(triangles_[t][i])]; };
  return (at(1) - at(0)).cross(at(2) - at(0)).normalized();
}

}  // namespace bodkin::anatomy
