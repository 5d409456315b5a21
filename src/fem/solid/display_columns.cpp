#include "fem/solid/display_columns.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "fem/solid/available_memory.h"
#include "fem/solid/dense_kernels.h"

namespace bodkin::fem {

namespace {

constexpr std::size_t nodes_at_once = 16;  // 48 right-hand sides: enough for the solver's matrix products

// mm/N: displacements of the points by forces at the places where left needles hold the tissue, 3 columns each.
Eigen::MatrixXd moved_by(const LeftNeedleForces& left, const ElasticBody& body, std::span<const PointInMesh> points) {
  const std::vector<PointInMesh>& places = left.places();
  Eigen::MatrixXd found(3 * static_cast<Eigen::Index>(points.size()), 3 * static_cast<Eigen::Index>(places.size()));
  for (std::size_t from = 0; from < places.size(); from += nodes_at_once) {
    const std::size_t count = std::min(nodes_at_once, places.size() - from);
    Eigen::MatrixXd forces =
        Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(body.mesh_nodes()), 3 * static_cast<Eigen::Index>(count));
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t corner = 0; corner < 4; ++corner)
        forces.block<3, 3>(3 * Eigen::Index{places[from + i].nodes[corner]}, 3 * static_cast<Eigen::Index>(i)) +=
            places[from + i].weights[corner] * Mat3::Identity();
    found.middleCols(3 * static_cast<Eigen::Index>(from), forces.cols()) =
        at_places(points, body.displacement(forces));
  }
  return found;
}

Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  Eigen::MatrixXd found(a.rows(), b.cols());
  const auto rows = static_cast<std::size_t>(a.rows()), size = static_cast<std::size_t>(a.cols());
  multiply(rows, size, static_cast<std::size_t>(b.cols()), a.data(), rows, b.data(), size, found.data(), rows);
  return found;
}

}  // namespace

std::size_t display_bytes(std::size_t points, std::size_t nodes) noexcept {
  return 9 * points * nodes * sizeof(float);
}

DisplayField display_columns(const ElasticBody& body, std::span<const PointInMesh> points,
                             const std::vector<std::uint32_t>& nodes, const Progress& progress,
                             const LeftNeedleForces& left, std::size_t spare) {
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
  const std::size_t of_left = 9 * points.size() * left.places().size() * sizeof(double);  // while this lives
  const std::size_t bytes = display_bytes(points.size(), nodes.size() + spare) + of_left;
  if (bytes > available_memory()) {
    throw InputError(
        fmt::format("the display field of {} points by {} nodes, with {} points of left needles, takes {} MB, and {} "
                    "MB are left; show fewer points, fewer nodes of the corridor, or fewer needles",
                    points.size(), nodes.size(), left.places().size(), bytes >> 20U, available_memory() >> 20U));
  }
  DisplayField field(points.size(), nodes, body.mesh_nodes(), spare);
  const Eigen::MatrixXd by_left = left.empty() ? Eigen::MatrixXd() : moved_by(left, body, points);
  for (std::size_t from = 0; from < nodes.size(); from += nodes_at_once) {
    if (progress)
      progress("preparing the picture of the body", static_cast<double>(from) / static_cast<double>(nodes.size()));
    const std::size_t count = std::min(nodes_at_once, nodes.size() - from);
    Eigen::MatrixXd forces =
        Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(corridor.size()), 3 * static_cast<Eigen::Index>(count));
    for (std::size_t i = 0; i < count; ++i)
      forces.block<3, 3>(rows[from + i], 3 * static_cast<Eigen::Index>(i)).setIdentity();
    const Eigen::MatrixXd moved = body.displacement_by_corridor(forces);
    Eigen::MatrixXd columns = at_places(points, moved);
    if (!left.empty()) columns += product(by_left, left.against(moved));
    for (Eigen::Index i = 0; i < columns.cols(); ++i) {
      const Eigen::VectorXf column = columns.col(i).cast<float>();
      field.set_column(3 * from + static_cast<std::size_t>(i), {column.data(), 3 * points.size()});
    }
  }
  return field;
}

}  // namespace bodkin::fem
