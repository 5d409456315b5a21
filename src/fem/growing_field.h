#pragma once

#include <array>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <span>
#include <stop_token>
#include <thread>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "fem/display_field.h"
#include "fem/node_forces.h"

namespace bodkin::fem {

// A display field for a needle that may enter anywhere: the columns of nodes that the needle pushes and the field
// lacks are computed on a separate thread, a few at a time, beginning with the nodes pushed now, and stored in the
// field's spare places; those not needed for longest are replaced. Until then the display omits the effect of these
// nodes (left_out).
//
// Nodes held by something else, a probe, do not move in the display, as in the tick: with u = S f the displacement
// without holding, they get the forces f_c = -S_hh^-1 u_h.
//
// All functions belong to one thread.
class GrowingField {
 public:
  // mm/N: 3 rows for each of the field's points, 3 columns for each of these nodes of the mesh. Called on the field's
  // thread.
  using Columns = std::function<Eigen::MatrixXf(std::span<const std::uint32_t> nodes)>;

  // Only the columns of `field`.
  explicit GrowingField(DisplayField field);
  // `node_points`: the field's last points are these nodes of the mesh. Only they can be held.
  GrowingField(DisplayField field, Columns columns, std::span<const std::uint32_t> node_points = {});
  ~GrowingField();
  GrowingField(const GrowingField&) = delete;
  GrowingField& operator=(const GrowingField&) = delete;

  std::size_t points() const noexcept { return field_.points(); }
  // From now on those of these nodes that are points are held.
  void hold(std::span<const std::uint32_t> nodes);
  // mm, 3 x points() values, all of them written.
  void evaluate(const NodeForces& forces, std::span<float> displacements);
  // N, the sum of the forces on nodes without columns.
  double left_out(const NodeForces& forces) const noexcept { return field_.left_out(forces); }

 private:
  enum class Request : std::uint8_t { none, asked, found, failed };

  void run(const std::stop_token& stop);
  void take_found();
  void need(std::uint32_t node);
  void ask();
  void hold_still(std::span<float> displacements);
  bool solve_held();

  DisplayField field_;
  Columns columns_;                      // may be empty
  std::vector<std::uint32_t> place_of_;  // by node of the mesh: its point, or none
  std::vector<std::uint64_t> needed_;    // by spare place: round in which it was last needed
  std::vector<std::uint32_t> spare_of_;  // by node: its spare place, or none
  std::uint64_t round_ = 0;              // calls of evaluate()
  std::vector<std::uint32_t> missing_;   // in this round
  std::vector<std::uint32_t> held_;
  Eigen::LLT<Eigen::MatrixXd> held_factor_;  // of S_hh; empty until it is needed
  NodeForces of_holder_;                     // f_c
  std::vector<float> by_holder_;             // mm, of the points
  std::mutex lock_;                          // guards the next three members
  std::condition_variable_any changed_;
  Request request_ = Request::none;
  std::vector<std::uint32_t> asked_;  // nodes
  Eigen::MatrixXf found_;
  std::jthread thread_;  // the last member: it uses the others
};

}  // namespace bodkin::fem
