#include "imaging/mesh_picture.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "imaging/mesh_cut.h"
#include "imaging/slice_picture.h"
#include "imaging/svg.h"

namespace bodkin {
namespace {

constexpr double mesh_panel_height = 560.0;  // px
constexpr double chart_width = 360.0;        // px, of the bars
constexpr double chart_height = 300.0;
constexpr double chart_left = 56.0, chart_top = 130.0;
constexpr const char* mesh_background = "#10151a";
constexpr double angle_of_regular = 70.5288;  // degrees, of the regular tetrahedron
constexpr double around_mesh = 1.04;          // of the mesh's box
constexpr double mesh_pixels_across = 640.0;
constexpr double beyond_path = 1.35;    // of the path's length, the side of the closer view
constexpr double smallest_view = 45.0;  // mm

struct MeshBox {
  Vec3 low, high;
};

MeshBox box_of(const TetrahedralMesh& mesh) {
  MeshBox box{mesh.nodes.front(), mesh.nodes.front()};
  for (const Vec3& node : mesh.nodes) {
    box.low = box.low.cwiseMin(node);
    box.high = box.high.cwiseMax(node);
  }
  return box;
}

SlicePlane plane_through(const std::optional<NeedlePath>& path, const Vec3& middle, double width, double height) {
  const double pixel = std::max(width, height) / mesh_pixels_across;
  return path ? sagittal_plane_along(*path, middle, width, height, pixel)
              : view_plane(View::sagittal, middle, width, height, pixel);
}

SlicePanel panel(const TetrahedralMesh& mesh, const SlicePlane& plane, const std::optional<NeedlePath>& path,
                 const std::string& title) {
  SlicePanel result;
  result.slice.plane = plane;
  result.title = title;
  result.path = path;
  result.elements = cut_mesh(mesh, plane);
  return result;
}

// A number of elements as people write it: 112,345.
std::string grouped(std::size_t number) {
  const std::string digits = std::to_string(number);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

class Chart {
 public:
  explicit Chart(const MeshQuality& quality) : quality_(quality) {}

  std::string draw() {
    std::size_t all = 0, most = 0;
    for (const std::size_t count : quality_.angles) {
      all += count;
      most = std::max(most, count);
    }
    const double top = std::max(1.0, std::ceil(100.0 * static_cast<double>(most) / static_cast<double>(all)));
    lines_of_text();
    for (int percent = 0; percent <= static_cast<int>(top); percent += top > 8.0 ? 2 : 1) {
      const double y = height_of(percent / top);
      emit("<path d=\"M{:.1f} {:.1f}h{:.1f}\" stroke=\"#2b3640\"/>\n", chart_left, y, chart_width);
      text(chart_left - 8.0, y + 4.0, fmt::format("{} %", percent), "end", 11, "#9fb0bb");
    }
    const double wide = chart_width / angle_bins;
    for (std::size_t bin = 0; bin < quality_.angles.size(); ++bin) {
      const double share = 100.0 * static_cast<double>(quality_.angles[bin]) / static_cast<double>(all) / top;
      const double degrees = 180.0 / angle_bins * static_cast<double>(bin);
      const bool poor = degrees < 10.0 || degrees >= 165.0;
      emit("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>\n",
           chart_left + wide * static_cast<double>(bin) + 0.5, height_of(share), wide - 1.0,
           chart_top + chart_height - height_of(share), poor ? "#ff5470" : "#4fa3d9");
    }
    for (int degrees = 0; degrees <= 180; degrees += 30) {
      text(place_of(degrees), chart_top + chart_height + 18.0, std::to_string(degrees), "middle", 11, "#9fb0bb");
    }
    text(chart_left + 0.5 * chart_width, chart_top + chart_height + 38.0, "dihedral angle, degrees", "middle", 12,
         "#cfd8df");
    mark(angle_of_regular, "regular, 70.5", "middle", -8.0, "#e8eef2");
    mark(quality_.smallest_angle, fmt::format("smallest {:.1f}", quality_.smallest_angle), "start", 14.0, "#ffb3c0");
    mark(quality_.largest_angle, fmt::format("largest {:.1f}", quality_.largest_angle), "end", 14.0, "#ffb3c0");
    return std::move(svg_);
  }

 private:
  template <typename... Arguments>
  void emit(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(svg_), format, std::forward<Arguments>(arguments)...);
  }
  void text(double x, double y, const std::string& said, const char* anchor, int size, const char* colour) {
    emit("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\" text-anchor=\"{}\" fill=\"{}\">{}</text>\n", x, y, size,
         anchor, colour, escape_markup(said));
  }
  static double height_of(double share) { return chart_top + chart_height * (1.0 - share); }
  static double place_of(double degrees) { return chart_left + chart_width * degrees / 180.0; }

  void mark(double degrees, const std::string& said, const char* anchor, double down, const char* colour) {
    const double x = place_of(degrees);
    emit("<path d=\"M{:.1f} {:.1f}V{:.1f}\" stroke=\"{}\" stroke-dasharray=\"3 3\"/>\n", x, chart_top,
         chart_top + chart_height, colour);
    const double aside = std::string(anchor) == "start" ? 4.0 : (std::string(anchor) == "end" ? -4.0 : 0.0);
    text(x + aside, chart_top + down, said, anchor, 11, colour);
  }

  void lines_of_text() {
    double y = chart_top - 92.0;
    const auto line = [&](const std::string& said) {
      text(chart_left, y, said, "start", 13, "#cfd8df");
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

  const MeshQuality& quality_;
  std::string svg_;
};

}  // namespace

std::string mesh_picture(const TetrahedralMesh& mesh, const MeshQuality& quality,
                         const std::optional<NeedlePath>& path, const TissueLibrary& library,
                         const std::string& title) {
  const MeshBox box = box_of(mesh);
  const Vec3 size = around_mesh * (box.high - box.low), middle = 0.5 * (box.low + box.high);
  std::vector<SlicePanel> panels = {
      panel(mesh, plane_through(path, middle, size.y(), size.z()), path,
            path ? "the mesh, cut along the planned path" : "the mesh, sagittal through its middle")};
  if (path) {
    const double side = std::max(smallest_view, beyond_path * path->length());
    const Vec3 centre = 0.5 * (path->entry + path->target);
    panels.push_back(panel(mesh, plane_through(path, centre, side, side), path, "closer"));
  }
  const SlicesDrawn slices = draw_slices(panels, library, title, mesh_panel_height);
  const std::string chart = Chart(quality).draw();
  return svg_document(
      slices.width + chart_left + chart_width + 8.0, slices.height,
      fmt::format("{}<g transform=\"translate({:.1f} 0)\">\n{}</g>\n", slices.svg, slices.width - 14.0, chart),
      mesh_background);
}

}  // namespace bodkin
