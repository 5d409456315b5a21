#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/geometry.h"
#include "core/simd.h"

namespace bodkin::fem {

// The rotation R that is nearest to a matrix F, |F - R| least: the rotational part of a deformation, F = R S with S
// symmetric. It is that of the polar decomposition, but never a reflection: for an inverted element (det F < 0) the
// smallest principal stretch in S is negative, so that the element is driven back through its flattest side. If
// several rotations are nearest (F of rank 1, or evenly inverted) it is one of them.
//
// Computed as the quaternion that is the eigenvector to the largest eigenvalue of a symmetric 4 x 4 matrix (Horn, J.
// Opt. Soc. Am. A 4, 629, 1987), by Jacobi rotations, which find it for any F. Exact, and slow: some microseconds. An
// F that is not finite gives the identity.
Eigen::Quaterniond nearest_rotation(const Mat3& matrix) noexcept;

// Quaternions, one per lane, not necessarily of length 1.
struct LaneQuaternion {
  Lanes w, x, y, z;
};

BODKIN_LANES_INLINE void rotation_of(const LaneQuaternion& q, LaneMatrix& rotation) {
  const Lanes two = 2.0 / (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  rotation.column[0] = {1.0 - two * (q.y * q.y + q.z * q.z), two * (q.x * q.y + q.w * q.z),
                        two * (q.x * q.z - q.w * q.y)};
  rotation.column[1] = {two * (q.x * q.y - q.w * q.z), 1.0 - two * (q.x * q.x + q.z * q.z),
                        two * (q.y * q.z + q.w * q.x)};
  rotation.column[2] = {two * (q.x * q.z + q.w * q.y), two * (q.y * q.z - q.w * q.x),
                        1.0 - two * (q.x * q.x + q.y * q.y)};
}

// As above for four matrices, from rotations that are near already (those of the previous step), by Newton's method
// on tr(R^T F): with A = R^T F and Y = tr(A) 1 - sym(A), R turns by Y^-1 axial(A - A^T). Where Y is positive definite
// and the turn vanishes, R is the nearest rotation; the error falls with the third power of the turn, so two turns
// suffice from step to step. `settled`: all bits of a lane that converged; for the others call nearest_rotation().
BODKIN_LANES_INLINE void turn_to_nearest(const LaneMatrix& matrix, LaneQuaternion& q, LaneMatrix& rotation,
                                         LaneMask& settled) {
  constexpr int most_turns = 6;
  constexpr double small_turn = 1e-10;  // squared, radians
  constexpr double least_minor = 1e-9;  // of Y, by its trace: not a Newton step below it
  rotation_of(q, rotation);
  settled = LaneMask{};
  for (int turn = 0; turn < most_turns; ++turn) {
    LaneMatrix a;
    multiply_transposed_lanes(rotation, matrix, a);
    const LaneVector axial{a.column[1].z - a.column[2].y, a.column[2].x - a.column[0].z,
                           a.column[0].y - a.column[1].x};
    const Lanes trace = a.column[0].x + a.column[1].y + a.column[2].z;
    const Lanes xy = -0.5 * (a.column[0].y + a.column[1].x), xz = -0.5 * (a.column[0].z + a.column[2].x),
                yz = -0.5 * (a.column[1].z + a.column[2].y);
    LaneMatrix y;
    y.column[0] = {trace - a.column[0].x, xy, xz};
    y.column[1] = {xy, trace - a.column[1].y, yz};
    y.column[2] = {xz, yz, trace - a.column[2].z};
    LaneMatrix adjoint;
    cross_lanes(y.column[1], y.column[2], adjoint.column[0]);
    cross_lanes(y.column[2], y.column[0], adjoint.column[1]);
    cross_lanes(y.column[0], y.column[1], adjoint.column[2]);
    Lanes determinant;
    dot_lanes(y.column[0], adjoint.column[0], determinant);
    const LaneMask definite = (y.column[0].x > least_minor * trace) &
                              (adjoint.column[2].z > least_minor * trace * trace) &
                              (determinant > least_minor * trace * trace * trace) & (trace > 0.0);
    LaneVector w;
    multiply_lanes(adjoint, axial, w);
    const Lanes half = definite ? 0.5 / determinant : Lanes{};
    w.x = definite ? half * w.x : Lanes{};
    w.y = definite ? half * w.y : Lanes{};
    w.z = definite ? half * w.z : Lanes{};
    // q := q (1, w / 2), then normalised approximately.
    LaneQuaternion next{q.w - q.x * w.x - q.y * w.y - q.z * w.z, q.x + q.w * w.x + q.y * w.z - q.z * w.y,
                        q.y + q.w * w.y + q.z * w.x - q.x * w.z, q.z + q.w * w.z + q.x * w.y - q.y * w.x};
    const Lanes shorten = 2.0 / (1.0 + next.w * next.w + next.x * next.x + next.y * next.y + next.z * next.z);
    q = {shorten * next.w, shorten * next.x, shorten * next.y, shorten * next.z};
    rotation_of(q, rotation);
    settled = definite & (w.x * w.x + w.y * w.y + w.z * w.z < 0.25 * small_turn);
    if ((settled[0] & settled[1] & settled[2] & settled[3]) != 0) return;
  }
}

}  // namespace bodkin::fem
