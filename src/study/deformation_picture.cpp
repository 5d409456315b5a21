#include "study/deformation_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "fem/solid/points_in_mesh.h"
#include "imaging/slice_picture.h"
#include "imaging/warped_slice.h"

namespace bodkin::study {

namespace {

constexpr double side = 70.0;           // mm of the patient that are shown
constexpr double pixels_across = 560;   // of each slice
constexpr double warp_spacing = 1.0;    // mm
constexpr double panel_height = 460.0;  // px

// mm, of every node of the mesh.
Eigen::MatrixXd displacement(const fem::BodyDescription& body, const fem::NodeForces& forces,
                             const Progress& progress) {
  const fem::ElasticBody elastic(body, fem::plan_body(body, progress), {}, progress);
  Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(elastic.mesh_nodes()), 1);
  for (std::size_t i = 0; i < forces.count; ++i) {
    const fem::NodeForce& here = forces.nodes[i];
    for (std::size_t axis = 0; axis < 3; ++axis)
      loads(3 * Eigen::Index{here.node} + static_cast<Eigen::Index>(axis)) += static_cast<double>(here.force[axis]);
  }
  return elastic.displacement(loads);
}

std::vector<float> moved_points(const fem::BodyDescription& body, const std::vector<Vec3>& points,
                                const Eigen::MatrixXd& moved) {
  std::vector<float> displacements;
  displacements.reserve(3 * points.size());
  for (const fem::PointInMesh& place : fem::find_points(body.mesh, points)) {
    Vec3 here = Vec3::Zero();
    for (std::size_t corner = 0; corner < 4; ++corner)
      here += place.weights[corner] * moved.col(0).segment<3>(3 * Eigen::Index{place.nodes[corner]});
    for (Eigen::Index axis = 0; axis < 3; ++axis) displacements.push_back(static_cast<float>(here[axis]));
  }
  return displacements;
}

std::string title_of(const DeformedState& moment, double most) {
  std::string title = fmt::format("{:.2f} N at {:.1f} mm; tissue moved {:.1f} mm", moment.resistance,
                                  moment.depth - moment.ahead, most);
  if (moment.ahead > 0.1) title += fmt::format(", the hand {:.1f} mm ahead", moment.ahead);
  return title;
}

}  // namespace

std::vector<float> displacements_at(const fem::BodyDescription& body, const fem::NodeForces& forces,
                                    const std::vector<Vec3>& points, const Progress& progress) {
  return moved_points(body, points, displacement(body, forces, progress));
}

imaging::Canvas deformation_picture(const anatomy::Case& patient, const fem::BodyDescription& body,
                                    const DeformedState& moment, const Progress& progress) {
  const anatomy::NeedlePath& path = patient.prepared.path;
  const Vec3 tip = moment.needle.translation(), along = needle_axis(moment.needle);
  const imaging::SlicePlane plane =
      imaging::sagittal_plane_along(path, tip - 0.25 * side * along, side, side, side / pixels_across);
  const imaging::SlicePlane grid = imaging::warp_grid(plane, warp_spacing);
  const std::vector<float> displacements = displacements_at(body, moment.forces, imaging::points_of(grid), progress);
  double most = 0.0;
  for (std::size_t i = 0; i + 2 < displacements.size(); i += 3)
    most =
        std::max(most, static_cast<double>(std::hypot(displacements[i], displacements[i + 1], displacements[i + 2])));
  const std::vector<Vec3> needle = {tip - std::max(moment.depth - moment.ahead + 25.0, 40.0) * along, tip};
  std::vector<imaging::SlicePanel> panels;
  panels.push_back({imaging::cut(plane, patient.ct, patient.tissues), "at rest", path, {}});
  panels.push_back({imaging::cut_deformed(plane, patient.ct, patient.tissues, grid, displacements),
                    title_of(moment, most),
                    {},
                    needle});
  return imaging::slice_picture(panels, patient.library, patient.description.name, panel_height);
}

}  // namespace bodkin::study
