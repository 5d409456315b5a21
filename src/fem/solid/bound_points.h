#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry.h"
#include "fem/contact_line.h"
#include "fem/solid/packed_factor.h"

namespace bodkin::fem {

// Points of a body that are bound by something rigid while a needle is pushed into it: the nodes held by an
// ultrasound probe do not move, and the points along a needle left in the body follow its six rigid motions, on which
// only the tissue acts. With S the compliance without them, the forces of all points solve one dense system,
//
//   u = S f + S_c f_c           the needle's own points
//   0 = S_c^T f + A f_c - R q   A: between the bound points, plus the compliance that the mesh lacks at each
//   0 = R^T f_c                 R: motions of the needles that were left; 0 at held nodes
//
// and after elimination of f_c and q it is u = S' f with S' = S - Y^T Y, Y = (1 - Z Z^T) L^-1 S_c^T, A = L L^T, Z the
// orthonormal basis of L^-1 R. S' is symmetric, so that their total energy is f^T S' f / 2, and every function for a
// needle in a body works with it unchanged. A left needle sticks to the tissue and does not bend.
//
// The same bits on every processor.
class BoundPoints {
 public:
  // Points bound together: held nodes, or one needle that was left.
  struct Group {
    std::vector<PointResponse> responses;  // of each point
    std::vector<Vec3> places;              // mm
    std::vector<Mat3> gains;               // mm/N, the compliance that the mesh lacks at each, positive semidefinite
    bool is_free = false;                  // a needle, which moves as a rigid body; otherwise all points are held
  };
  // No bound points.
  BoundPoints() = default;
  // Throws InputError when a point is held twice.
  explicit BoundPoints(std::vector<Group> groups);

  bool empty() const noexcept { return places_.empty(); }
  std::size_t points() const noexcept { return places_.size(); }
  // Y of other points: 3 columns each, 3 points() rows.
  Eigen::MatrixXd shares(std::span<const PointResponse> others) const;
  // Y_a^T Y_b of two of them, mm/N: the reduction of point a's displacement by a force on point b. taken(b, a) is its
  // transpose to the last bit.
  Mat3 taken(const Eigen::MatrixXd& shares, std::size_t a, const Eigen::MatrixXd& shares_b, std::size_t b) const;
  // N, 3 per bound point: f_c by these forces (3 per point) on the points of `shares`.
  Eigen::VectorXd forces(const Eigen::MatrixXd& shares, const Eigen::VectorXd& on_points) const;
  // As above, from the displacements (mm, 3 rows each) that the bound points would have if free, column by column.
  Eigen::MatrixXd forces_against(Eigen::MatrixXd moved) const;
  // The effect of a force on a point of `shares` on the holder of the held nodes, which is the sum of -f_c: with W =
  // L^-1 E, E their motions as one rigid body, W^T Y.
  HeldFraction on_held(const Eigen::MatrixXd& shares, std::size_t point) const;

 private:
  void add_holder(const std::vector<std::size_t>& held);
  void take_out_motions(double* columns, std::size_t count) const noexcept;

  std::vector<PointResponse> responses_;
  std::vector<Vec3> places_;
  Eigen::MatrixXd lower_;    // L
  Eigen::MatrixXd motions_;  // Z
  Eigen::MatrixXd holder_;   // W, 6 columns; empty without held nodes
};

}  // namespace bodkin::fem
