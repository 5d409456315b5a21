#include "desktop/body_view.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "imaging/mesh_cut.h"

namespace bodkin::desktop {

namespace {

constexpr double seen = 110.0;         // mm of the plane that are shown
constexpr double shown_needle = 60.0;  // mm from the tip
constexpr Colour needle_colour{232, 238, 245};

using Corner = std::array<long, 3>;  // um
using Edge = std::pair<Corner, Corner>;

Corner corner_of(const Vec3& point) {
  return {std::lround(1e3 * point.x()), std::lround(1e3 * point.y()), std::lround(1e3 * point.z())};
}

Colour colour_of_tissue(const anatomy::TissueLibrary& library, anatomy::TissueId id) {
  const anatomy::TissueProperties* tissue = library.find(id);
  const std::uint32_t colour = tissue == nullptr ? 0x808080U : tissue->colour;
  const auto part = [colour](unsigned shift) { return static_cast<std::uint8_t>((colour >> shift) & 0xFFU); };
  return {part(16), part(8), part(0)};
}

// The lines of the plane on whose two sides the tissue is not the same, by the tissue with the higher number there.
std::map<anatomy::TissueId, std::vector<Vec3>> borders_in(const anatomy::TetrahedralMesh& mesh,
                                                          const imaging::SlicePlane& plane) {
  struct Sides {
    Vec3 from, to;
    std::multiset<anatomy::TissueId> tissues;
  };
  std::map<Edge, Sides> edges;
  for (const imaging::CutElement& element : imaging::cut_mesh(mesh, plane)) {
    for (int i = 0; i < element.corners; ++i) {
      const Vec3& from = element.points[static_cast<std::size_t>(i)];
      const Vec3& to = element.points[static_cast<std::size_t>((i + 1) % element.corners)];
      if (std::abs(plane.place(from).x()) > 2.0 * plane.width || std::abs(plane.place(from).y()) > 2.0 * plane.height)
        continue;
      Edge edge{corner_of(from), corner_of(to)};
      if (edge.second < edge.first) std::swap(edge.first, edge.second);
      Sides& sides = edges.try_emplace(edge, Sides{from, to, {}}).first->second;
      sides.tissues.insert(element.tissue);
    }
  }
  std::map<anatomy::TissueId, std::vector<Vec3>> borders;
  for (const auto& [edge, sides] : edges) {
    if (sides.tissues.size() == 2 && *sides.tissues.begin() == *sides.tissues.rbegin()) continue;
    std::vector<Vec3>& lines = borders[*sides.tissues.rbegin()];
    lines.push_back(sides.from);
    lines.push_back(sides.to);
  }
  return borders;
}

}  // namespace

BodyView::BodyView(const anatomy::Case& patient, const anatomy::TetrahedralMesh& mesh) {
  const anatomy::NeedlePath& path = patient.corridor.path;
  plane_ = imaging::sagittal_plane_along(path, 0.5 * (path.entry + path.target), seen, seen, 1.0);
  for (const auto& [tissue, lines] : borders_in(mesh, plane_)) {
    borders_.emplace_back(colour_of_tissue(patient.library, tissue), lines.size());
    points_.insert(points_.end(), lines.begin(), lines.end());
  }
}

void BodyView::draw(SdlScreen& screen, double x, double y, double size, const Pose& needle,
                    std::span<const float> displacements) {
  const double scale = size / std::max(plane_.width - 1, plane_.height - 1);
  const auto pixel = [&](const Vec3& point) {
    return Eigen::Vector2f((Eigen::Vector2d(x, y) + scale * plane_.place(point)).cast<float>());
  };
  const auto inside = [&](const Eigen::Vector2f& at) {
    return static_cast<double>(at.x()) >= x && static_cast<double>(at.x()) <= x + size &&
           static_cast<double>(at.y()) >= y && static_cast<double>(at.y()) <= y + size;
  };
  const auto draw_line = [&](const Vec3& from, const Vec3& to) {
    const Eigen::Vector2f a = pixel(from), b = pixel(to);
    if (!inside(a) || !inside(b)) return;
    drawn_.push_back(a);
    drawn_.push_back(b);
  };
  const auto moved = [&](std::size_t point) {
    if (displacements.size() != 3 * points_.size()) return points_[point];  // not known yet
    return Vec3(points_[point] + Eigen::Map<const Eigen::Vector3f>(displacements.data() + 3 * point).cast<double>());
  };
  std::size_t point = 0;
  for (const auto& [colour, count] : borders_) {
    drawn_.clear();
    for (const std::size_t last = point + count; point < last; point += 2) draw_line(moved(point), moved(point + 1));
    screen.segments(drawn_, colour);
  }
  drawn_.clear();
  const Vec3 tip = needle.translation(), along = needle_axis(needle);
  for (double back = 0.0; back < shown_needle; back += 2.0) draw_line(tip - back * along, tip - (back + 2.0) * along);
  screen.segments(drawn_, needle_colour);
}

}  // namespace bodkin::desktop
