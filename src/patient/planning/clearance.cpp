#include "patient/planning/clearance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace bodkin::patient {
namespace {

constexpr double look = 0.25;          // mm between looks along a path
constexpr double thin = 0.3;           // mm of a tissue that are not reported
constexpr double report_reach = 30.0;  // mm

// Calls `visit(kind, square, i, j, k)` for every marked voxel whose centre may lie within `reach` of the path.
template <typename Visit>
void visit_near(const Obstacles& obstacles, const anatomy::NeedlePath& path, double reach, const Visit& visit) {
  const anatomy::Grid& grid = obstacles.at.grid;
  // mm along the axes of the lattice, from the centre of its first voxel.
  const Vec3 from = grid.direction.transpose() * (path.entry - grid.origin);
  const Vec3 to = grid.direction.transpose() * (path.target - grid.origin);
  const Vec3 way = to - from;
  const double square_length = way.squaredNorm();
  Eigen::Index main = 2;
  if (square_length > 0.0) way.cwiseAbs().maxCoeff(&main);
  const Eigen::Index u = main == 0 ? 1 : 0, v = main == 2 ? 1 : 2;
  const double along = way[main];
  // Across the main axis the cylinder about the path is wider than it is thick.
  const double half = along == 0.0 ? reach : reach * std::sqrt(square_length) / std::abs(along);
  const auto first = [&grid](Eigen::Index axis, double place) {
    return std::max(0, static_cast<int>(std::ceil(place / grid.spacing[axis])));
  };
  const auto last = [&grid](Eigen::Index axis, double place) {
    return std::min(grid.size[static_cast<std::size_t>(axis)] - 1,
                    static_cast<int>(std::floor(place / grid.spacing[axis])));
  };
  const int main_last = last(main, std::max(from[main], to[main]) + reach);
  for (int a = first(main, std::min(from[main], to[main]) - reach); a <= main_last; ++a) {
    const double place = a * grid.spacing[main];
    const double share = along == 0.0 ? 0.0 : (place - from[main]) / along;
    const Vec3 middle = from + share * way;
    const int u_last = last(u, middle[u] + half), v_last = last(v, middle[v] + half);
    const int u_first = first(u, middle[u] - half);
    for (int c = first(v, middle[v] - half); c <= v_last; ++c) {
      for (int b = u_first; b <= u_last; ++b) {
        int index[3];
        index[main] = a;
        index[u] = b;
        index[v] = c;
        const std::uint8_t mark = obstacles.at.at(index[0], index[1], index[2]);
        if (mark == 0) continue;
        const Vec3 centre = grid.spacing.cwiseProduct(Vec3(index[0], index[1], index[2]));
        const double t = square_length > 0.0 ? std::clamp((centre - from).dot(way) / square_length, 0.0, 1.0) : 0.0;
        visit(static_cast<std::size_t>(mark - 1), (centre - from - t * way).squaredNorm(), index[0], index[1],
              index[2]);
      }
    }
  }
}

// Calls `visit(kind, depth)` for each sample of the path in an obstacle.
template <typename Visit>
void visit_inside(const Obstacles& obstacles, const anatomy::NeedlePath& path, const Visit& visit) {
  const double length = path.length();
  const int looks = std::max(1, static_cast<int>(std::ceil(length / look)));
  for (int i = 0; i <= looks; ++i) {
    const Vec3 point = path.entry + (static_cast<double>(i) / looks) * (path.target - path.entry);
    const std::uint8_t mark = anatomy::nearest(obstacles.at, point, std::uint8_t{0});
    if (mark != 0 && !visit(static_cast<std::size_t>(mark - 1), length * i / looks)) return;
  }
}

double half_voxel(const Obstacles& obstacles) {
  return 0.5 * obstacles.at.grid.spacing.minCoeff();
}

// Extends the last stretch or begins another.
void extend(std::vector<Crossed>& stretches, anatomy::TissueId tissue, double from, double to) {
  if (!stretches.empty() && stretches.back().tissue == tissue && from - stretches.back().to < 1e-6) {
    stretches.back().to = to;
    return;
  }
  stretches.push_back({tissue, from, to});
}

}  // namespace

std::vector<Clearance> clearances(const Obstacles& obstacles, const anatomy::NeedlePath& path, double reach) {
  constexpr double none = std::numeric_limits<double>::infinity();
  const double half = half_voxel(obstacles);
  std::vector<double> squares(obstacles.kinds.size(), none);
  std::vector<Vec3> places(obstacles.kinds.size(), Vec3::Zero());
  visit_near(obstacles, path, reach + half, [&](std::size_t kind, double square, int i, int j, int k) {
    if (square >= squares[kind]) return;
    squares[kind] = square;
    places[kind] = Vec3(i, j, k);
  });
  visit_inside(obstacles, path, [&](std::size_t kind, double) {
    squares[kind] = std::min(squares[kind], 0.0);
    return true;
  });
  std::vector<Clearance> found;
  for (std::size_t kind = 0; kind < squares.size(); ++kind) {
    const double distance = std::max(0.0, std::sqrt(squares[kind]) - half);
    if (distance <= reach) found.push_back({kind, distance, obstacles.at.grid.to_patient(places[kind])});
  }
  return found;
}

Room clearance_along(const Obstacles& obstacles, const anatomy::NeedlePath& path, double most) {
  Room room{false, most, most, 0};
  visit_inside(obstacles, path, [&](std::size_t kind, double) {
    room = {true, 0.0, -obstacles.kinds[kind].margin, kind};
    return false;
  });
  if (room.blocked) return room;
  double widest = 0.0;
  for (const Obstacle& kind : obstacles.kinds) widest = std::max(widest, kind.margin);
  for (const Clearance& each : clearances(obstacles, path, most + widest)) {
    room.clearance = std::min(room.clearance, each.distance);
    const double spare = each.distance - obstacles.kinds[each.kind].margin;
    if (spare >= room.spare) continue;
    room.spare = spare;
    room.kind = each.kind;
  }
  return room;
}

PathReport report_on(const PatientView& patient, const Obstacles& obstacles, const anatomy::NeedlePath& path) {
  PathReport report;
  report.path = path;
  report.near = clearances(obstacles, path, report_reach);
  report.room = {false, report_reach, report_reach, 0};
  for (const Clearance& each : report.near) {
    report.room.clearance = std::min(report.room.clearance, each.distance);
    const double spare = each.distance - obstacles.kinds[each.kind].margin;
    if (spare < report.room.spare) {
      report.room.spare = spare;
      report.room.kind = each.kind;
    }
  }
  std::stable_sort(report.near.begin(), report.near.end(), [&](const Clearance& a, const Clearance& b) {
    return a.distance - obstacles.kinds[a.kind].margin < b.distance - obstacles.kinds[b.kind].margin;
  });
  const double length = path.length();
  if (length <= 0.0) return report;
  const Vec3 along = path.direction();
  report.cranial = std::asin(std::clamp(along.z(), -1.0, 1.0)) / degree;
  report.lateral = std::asin(std::clamp(along.x(), -1.0, 1.0)) / degree;
  const int steps = std::max(1, static_cast<int>(std::ceil(length / look)));
  const double step = length / steps;
  for (int i = 0; i < steps; ++i) {
    const double from = i * step, to = from + step;
    const Vec3 middle = path.entry + (from + 0.5 * step) * along;
    const anatomy::TissueId tissue = anatomy::nearest(patient.tissues, middle, anatomy::tissue::air);
    if (tissue != anatomy::tissue::air) extend(report.crosses, tissue, from, to);
    if (anatomy::nearest(obstacles.at, middle, std::uint8_t{0}) == 0) continue;
    report.room.blocked = true;
    extend(report.blocked, tissue, from, to);
  }
  std::erase_if(report.crosses, [](const Crossed& each) { return each.to - each.from < thin; });
  return report;
}

std::string nearest_text(const Obstacles& obstacles, const PathReport& report, std::size_t most) {
  std::string text;
  for (const Clearance& each : report.near) {
    if (most-- == 0) break;
    const std::string& title = obstacles.kinds[each.kind].title;
    text += text.empty() ? "" : ", ";
    text += each.distance > 0.0 ? fmt::format("{} {:.1f} mm", title, each.distance) : fmt::format("into {}", title);
  }
  return text.empty() ? fmt::format("nothing to avoid within {:.0f} mm", report_reach) : text;
}

}  // namespace bodkin::patient
