#include "fem/solid/display_columns.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "fem/solid/available_memory.h"

namespace bodkin::fem {

namespace {

constexpr std::size_t nodes_at_once = 16;  // 48 right-hand sides: enough for the solver's matrix products

}  // namespace

std::size_t display_bytes(std::size_t points, std::size_t nodes) noexcept {
  return 9 * points * nodes * sizeof(float);
}

DisplayField display_columns(const ElasticBody& body, std::span<const PointInMesh> points,
                             const std::vector<std::uint32_t>& nodes, const Progress& progress) {
  const std::vector<std::uint32_t>& corridor = body.corridor();
  if (points.empty() || nodes.empty()) {
    throw InputError(fmt::format("display field: {} points and {} nodes of the corridor, expected some of each",
                                 points.size(), nodes.size()));
  }
  std::vector<Eigen::Index> rows;  // of the corridor's forces
  for (const std::uint32_t node : nodes) {
    const auto place = std::find(corridor.begin(), corridor.end(), node);
    if (place == corridor.end()) {
      throw InputError(fmt::format("display field: node {} of the mesh is not one of the {} of the corridor", node,
                                   corridor.size()));
    }
    rows.push_back(3 * (place - corridor.begin()));
  }
  const std::size_t bytes = display_bytes(points.size(), nodes.size());
  if (bytes > available_memory()) {
    throw InputError(
        fmt::format("the display field of {} points by {} nodes takes {} MB, and {} MB are left; show fewer "
                    "points, or fewer nodes of the corridor",
                    points.size(), nodes.size(), bytes >> 20U, available_memory() >> 20U));
  }
  DisplayField field(points.size(), nodes, body.mesh_nodes());
  Eigen::VectorXf column(3 * static_cast<Eigen::Index>(points.size()));
  for (std::size_t from = 0; from < nodes.size(); from += nodes_at_once) {
    if (progress)
      progress("preparing the picture of the body", static_cast<double>(from) / static_cast<double>(nodes.size()));
    const std::size_t count = std::min(nodes_at_once, nodes.size() - from);
    Eigen::MatrixXd forces =
        Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(corridor.size()), 3 * static_cast<Eigen::Index>(count));
    for (std::size_t i = 0; i < count; ++i)
      forces.block<3, 3>(rows[from + i], 3 * static_cast<Eigen::Index>(i)).setIdentity();
    const Eigen::MatrixXd moved = body.displacement_by_corridor(forces);
    for (Eigen::Index i = 0; i < moved.cols(); ++i) {
      for (std::size_t p = 0; p < points.size(); ++p) {
        Vec3 here = Vec3::Zero();
        for (std::size_t corner = 0; corner < 4; ++corner)
          here += points[p].weights[corner] * moved.col(i).segment<3>(3 * Eigen::Index{points[p].nodes[corner]});
        column.segment<3>(3 * static_cast<Eigen::Index>(p)) = here.cast<float>();
      }
      field.set_column(3 * from + static_cast<std::size_t>(i), {column.data(), 3 * points.size()});
    }
  }
  return field;
}

}  // namespace bodkin::fem
