#include "app/models/probe_outline.h"

#include <algorithm>

#include "imaging/ultrasound_screen/scan_field.h"

namespace bodkin::app {

namespace {

constexpr std::uint32_t picture_colour = 0x4DA3FF, head_colour = 0x9AA7B6;
constexpr double picture_width = 2.0, head_width = 1.5;  // pixels
constexpr double half_thickness = 6.0;                   // mm, of the head
constexpr double shoulder = 14.0, back = 46.0;           // mm behind the face
constexpr double neck = 0.45;                            // of the face's width
constexpr double least_half = 8.0;                       // mm

}  // namespace

std::vector<scene::Trail> probe_outline(const anatomy::UltrasoundProbe& probe, double depth, const Pose& pose) {
  const std::vector<Eigen::Vector2d> field = imaging::field_of_view(probe, depth);
  scene::Trail border{{}, picture_colour, picture_width};
  for (const Eigen::Vector2d& corner : field) border.points.push_back(pose * Vec3(corner.x(), corner.y(), 0.0));
  border.points.push_back(border.points.front());
  const double half = std::max(least_half, 0.5 * probe.aperture()), face = field.front().y();
  const auto side = [&](double z) {
    scene::Trail line{{}, head_colour, head_width};
    for (const auto& [x, y] : {std::pair{-half, face}, std::pair{-half, face - shoulder},
                               std::pair{-neck * half, face - back}, std::pair{neck * half, face - back},
                               std::pair{half, face - shoulder}, std::pair{half, face}, std::pair{-half, face}})
      line.points.push_back(pose * Vec3(x, y, z));
    return line;
  };
  std::vector<scene::Trail> lines = {std::move(border), side(-half_thickness), side(half_thickness)};
  const std::size_t corners = lines[1].points.size() - 1;
  for (std::size_t i = 0; i < corners; ++i)
    lines.push_back({{lines[1].points[i], lines[2].points[i]}, head_colour, head_width});
  return lines;
}

}  // namespace bodkin::app
