#include "desktop/body_view.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "station/node_field.h"

#include "fem/solid/display_columns.h"
#include "imaging/mesh_cut.h"

namespace bodkin {

namespace {

constexpr double seen = 110.0;         // mm of the plane that are shown
constexpr double shown_needle = 60.0;  // mm from the tip
constexpr Colour needle_colour{232, 238, 245};

using Corner = std::array<long, 3>;  // um
using Edge = std::pair<Corner, Corner>;

Corner corner_of(const Vec3& point) {
  return {std::lround(1e3 * point.x()), std::lround(1e3 * point.y()), std::lround(1e3 * point.z())};
}

Colour colour_of_tissue(const TissueLibrary& library, TissueId id) {
  const TissueProperties* tissue = library.find(id);
  const std::uint32_t colour = tissue == nullptr ? 0x808080U : tissue->colour;
  const auto part = [colour](unsigned shift) { return static_cast<std::uint8_t>((colour >> shift) & 0xFFU); };
  return {part(16), part(8), part(0)};
}

// The lines of the plane on whose two sides the tissue is not the same, by the tissue with the higher number there.
std::map<TissueId, std::vector<Vec3>> borders_in(const TetrahedralMesh& mesh, const SlicePlane& plane) {
  struct Sides {
    Vec3 from, to;
    std::multiset<TissueId> tissues;
  };
  std::map<Edge, Sides> edges;
  for (const CutElement& element : cut_mesh(mesh, plane)) {
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
  std::map<TissueId, std::vector<Vec3>> borders;
  for (const auto& [edge, sides] : edges) {
    if (sides.tissues.size() == 2 && *sides.tissues.begin() == *sides.tissues.rbegin()) continue;
    std::vector<Vec3>& lines = borders[*sides.tissues.rbegin()];
    lines.push_back(sides.from);
    lines.push_back(sides.to);
  }
  return borders;
}

}  // namespace

// The ends of the lines, in their order.
std::vector<Vec3> BodyView::find_borders(const Case& patient, const TetrahedralMesh& mesh) {
  const NeedlePath& path = patient.corridor.path;
  plane_ = sagittal_plane_along(path, 0.5 * (path.entry + path.target), seen, seen, 1.0);
  std::vector<Vec3> points;
  for (auto& [tissue, lines] : borders_in(mesh, plane_)) {
    points.insert(points.end(), lines.begin(), lines.end());
    borders_.emplace_back(colour_of_tissue(patient.library, tissue), std::move(lines));
  }
  return points;
}

BodyView::BodyView(const Case& patient, const BodyDescription& body, std::shared_ptr<PressedPatient> pressed)
    : pressed_(std::move(pressed)) {
  points_ = find_points(body.mesh, find_borders(patient, body.mesh));
  moved_.assign(3 * points_.size(), 0.0F);
}

BodyView::BodyView(const Case& patient, const BodyDescription& body, const ElasticBody& elastic,
                   const Progress& progress) {
  const NeedlePath& path = patient.corridor.path;
  const std::vector<Vec3> points = find_borders(patient, body.mesh);
  display_ = std::make_shared<DisplayThread>(
      display_columns(elastic, find_points(body.mesh, points), nodes_of_shaft(elastic, body.mesh, path), progress));
}

// mm, of every point in turn.
std::span<const float> BodyView::displacements() {
  if (pressed_ == nullptr) return display_->moment().displacements;
  const std::vector<float>& nodes = pressed_->picture().displacements;
  for (std::size_t point = 0; point < points_.size(); ++point) {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (std::size_t corner = 0; corner < 4; ++corner) {
      sum += static_cast<float>(points_[point].weights[corner]) *
             Eigen::Map<const Eigen::Vector3f>(nodes.data() + 3 * std::size_t{points_[point].nodes[corner]});
    }
    Eigen::Map<Eigen::Vector3f>(moved_.data() + 3 * point) = sum;
  }
  return moved_;
}

void BodyView::draw(SdlScreen& screen, double x, double y, double size, const Pose& needle) {
  const std::span<const float> by_point = displacements();
  const double scale = size / std::max(plane_.width - 1, plane_.height - 1);
  const auto pixel = [&](const Vec3& point) {
    return Eigen::Vector2f((Eigen::Vector2d(x, y) + scale * plane_.place(point)).cast<float>());
  };
  const auto inside = [&](const Eigen::Vector2f& at) {
    return static_cast<double>(at.x()) >= x && static_cast<double>(at.x()) <= x + size &&
           static_cast<double>(at.y()) >= y && static_cast<double>(at.y()) <= y + size;
  };
  std::size_t number = 0;
  const auto draw_line = [&](const Vec3& from, const Vec3& to) {
    const Eigen::Vector2f a = pixel(from), b = pixel(to);
    if (!inside(a) || !inside(b)) return;
    drawn_.push_back(a);
    drawn_.push_back(b);
  };
  const auto moved = [&](const Vec3& rest) {
    const float* const by = by_point.data() + 3 * number++;
    return Vec3(rest + Eigen::Map<const Eigen::Vector3f>(by).cast<double>());
  };
  for (const auto& [colour, lines] : borders_) {
    drawn_.clear();
    for (std::size_t i = 0; i + 1 < lines.size(); i += 2) {
      const Vec3 from = moved(lines[i]), to = moved(lines[i + 1]);
      draw_line(from, to);
    }
    screen.segments(drawn_, colour);
  }
  drawn_.clear();
  const Vec3 tip = needle.translation(), along = needle_axis(needle);
  for (double back = 0.0; back < shown_needle; back += 2.0) draw_line(tip - back * along, tip - (back + 2.0) * along);
  screen.segments(drawn_, needle_colour);
}

}  // namespace bodkin
