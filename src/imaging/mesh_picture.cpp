#include "imaging/mesh_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "imaging/mesh_cut.h"
#include "imaging/slice_picture.h"

namespace bodkin::imaging {
namespace {

constexpr double mesh_panel_height = 560.0;  // px
constexpr double chart_width = 360.0;        // px, of the bars
constexpr double chart_height = 300.0;
constexpr double chart_left = 56.0, chart_top = 130.0;
constexpr double chart_right = 22.0;  // px
constexpr std::uint32_t tick_colour = 0x9FB0BB, text_colour = 0xCFD8DF, mesh_background = 0x10151A;
constexpr double angle_of_regular = 70.5288;  // degrees, of the regular tetrahedron
constexpr double around_mesh = 1.04;          // of the mesh's box
constexpr double mesh_pixels_across = 640.0;
constexpr double beyond_path = 1.35;    // of the path's length, side of the closer view
constexpr double smallest_view = 45.0;  // mm

struct MeshBox {
  Vec3 low, high;
};

MeshBox box_of(const anatomy::TetrahedralMesh& mesh) {
  MeshBox box{mesh.nodes.front(), mesh.nodes.front()};
  for (const Vec3& node : mesh.nodes) {
    box.low = box.low.cwiseMin(node);
    box.high = box.high.cwiseMax(node);
  }
  return box;
}

// The place inside an element closest to `place`.
Vec3 in_mesh_near(const anatomy::TetrahedralMesh& mesh, const Vec3& place) {
  Vec3 nearest = mesh.nodes.front();
  double least = std::numeric_limits<double>::infinity();
  for (const auto& element : mesh.elements) {
    Vec3 middle = Vec3::Zero();
    for (const std::uint32_t node : element) middle += 0.25 * mesh.nodes[node];
    const double away = (middle - place).squaredNorm();
    if (away >= least) continue;
    least = away;
    nearest = middle;
  }
  return nearest;
}

SlicePlane plane_through(const std::optional<anatomy::NeedlePath>& path, const Vec3& middle, double width,
                         double height) {
  const double pixel = std::max(width, height) / mesh_pixels_across;
  return path ? sagittal_plane_along(*path, middle, width, height, pixel)
              : view_plane(View::sagittal, middle, width, height, pixel);
}

SlicePanel panel(const anatomy::TetrahedralMesh& mesh, const SlicePlane& plane,
                 const std::optional<anatomy::NeedlePath>& path, const std::string& title) {
  SlicePanel result;
  result.slice.plane = plane;
  result.title = title;
  result.path = path;
  result.elements = cut_mesh(mesh, plane);
  return result;
}

// A number of elements in print: 112,345.
std::string grouped(std::size_t number) {
  const std::string digits = std::to_string(number);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

// The histogram of the dihedral angles.
class Chart {
 public:
  Chart(const anatomy::MeshQuality& quality, double height)
      : quality_(quality), canvas_(chart_left + chart_width + chart_right, height) {}

  Canvas draw() {
    std::size_t all = 0, most = 0;
    for (const std::size_t count : quality_.angles) {
      all += count;
      most = std::max(most, count);
    }
    const double top = std::max(1.0, std::ceil(100.0 * static_cast<double>(most) / static_cast<double>(all)));
    lines_of_text();
    for (int percent = 0; percent <= static_cast<int>(top); percent += top > 8.0 ? 2 : 1) {
      const double y = height_of(percent / top);
      canvas_.stroke(Path::segment({chart_left, y}, {chart_left + chart_width, y}), {0x2B3640});
      text({chart_left - 8.0, y + 4.0}, fmt::format("{} %", percent), TextAnchor::end, 11.0, tick_colour);
    }
    const double wide = chart_width / anatomy::angle_bins;
    for (std::size_t bin = 0; bin < quality_.angles.size(); ++bin) {
      const double share = 100.0 * static_cast<double>(quality_.angles[bin]) / static_cast<double>(all) / top;
      const double degrees = 180.0 / anatomy::angle_bins * static_cast<double>(bin);
      const bool poor = degrees < 10.0 || degrees >= 165.0;
      canvas_.fill(Path::rectangle(chart_left + wide * static_cast<double>(bin) + 0.5, height_of(share), wide - 1.0,
                                   chart_top + chart_height - height_of(share)),
                   poor ? 0xFF5470 : 0x4FA3D9);
    }
    for (int degrees = 0; degrees <= 180; degrees += 30) {
      text({place_of(degrees), chart_top + chart_height + 18.0}, std::to_string(degrees), TextAnchor::middle, 11.0,
           tick_colour);
    }
    text({chart_left + 0.5 * chart_width, chart_top + chart_height + 38.0}, "dihedral angle, degrees",
         TextAnchor::middle, 12.0, text_colour);
    mark(angle_of_regular, "regular, 70.5", TextAnchor::middle, -8.0, 0xE8EEF2);
    mark(quality_.smallest_angle, fmt::format("smallest {:.1f}", quality_.smallest_angle), TextAnchor::start, 14.0,
         0xFFB3C0);
    mark(quality_.largest_angle, fmt::format("largest {:.1f}", quality_.largest_angle), TextAnchor::end, 14.0,
         0xFFB3C0);
    return std::move(canvas_);
  }

 private:
  void text(const Eigen::Vector2d& at, const std::string& words, TextAnchor anchor, double size,
            std::uint32_t colour) {
    canvas_.text(at, words, {.size = size, .ink = colour, .anchor = anchor});
  }
  static double height_of(double share) { return chart_top + chart_height * (1.0 - share); }
  static double place_of(double degrees) { return chart_left + chart_width * degrees / 180.0; }

  void mark(double degrees, const std::string& words, TextAnchor anchor, double down, std::uint32_t colour) {
    const double x = place_of(degrees);
    canvas_.stroke(Path::segment({x, chart_top}, {x, chart_top + chart_height}), {colour, 1.0, {3.0, 3.0}});
    const double aside = anchor == TextAnchor::start ? 4.0 : (anchor == TextAnchor::end ? -4.0 : 0.0);
    text({x + aside, chart_top + down}, words, anchor, 11.0, colour);
  }

  void lines_of_text() {
    double y = chart_top - 92.0;
    const auto line = [&](const std::string& words) {
      text({chart_left, y}, words, TextAnchor::start, 13.0, text_colour);
      y += 19.0;
    };
    line(fmt::format("{} nodes, {} tetrahedra", grouped(quality_.nodes), grouped(quality_.elements)));
    if (quality_.nodes_in_region > 0) {
      line(fmt::format("mean edge {:.1f} mm; {:.1f} mm in the corridor,", quality_.mean_edge,
                       quality_.mean_edge_in_region));
      line(fmt::format("where {} of the nodes are", grouped(quality_.nodes_in_region)));
    } else {
      line(fmt::format("mean edge {:.1f} mm", quality_.mean_edge));
    }
  }

  const anatomy::MeshQuality& quality_;
  Canvas canvas_;
};

}  // namespace

Canvas mesh_picture(const anatomy::TetrahedralMesh& mesh, const anatomy::MeshQuality& quality,
                    const std::optional<anatomy::NeedlePath>& path, const anatomy::TissueLibrary& library,
                    const std::string& title) {
  const MeshBox box = box_of(mesh);
  const Vec3 size = around_mesh * (box.high - box.low), middle = 0.5 * (box.low + box.high);
  std::vector<SlicePanel> panels;
  const auto add = [&](const SlicePlane& plane, const std::optional<anatomy::NeedlePath>& shown, const char* words) {
    panels.push_back(panel(mesh, plane, shown, words));
    if (panels.back().elements.empty()) panels.pop_back();
  };
  if (path) {
    add(plane_through(path, middle, size.y(), size.z()), path, "the mesh, cut along the planned path");
    const double side = std::max(smallest_view, beyond_path * path->length());
    const Vec3 centre = 0.5 * (path->entry + path->target);
    add(plane_through(path, centre, side, side), path, "closer");
  }
  // Also for a mesh beside the path.
  if (panels.empty()) {
    add(plane_through({}, in_mesh_near(mesh, middle), size.y(), size.z()), {},
        path ? "the mesh, sagittal; the planned path does not meet it" : "the mesh, sagittal through its middle");
  }
  Canvas slices = slice_picture(panels, library, title, mesh_panel_height);
  const double chart_x = slices.width() - 14.0;
  Canvas chart = Chart(quality, slices.height()).draw();
  Canvas picture(chart_x + chart.width(), slices.height());
  picture.fill_all(mesh_background);
  picture.place(std::move(slices), 0.0, 0.0);
  picture.place(std::move(chart), chart_x, 0.0);
  return picture;
}

}  // namespace bodkin::imaging
