#pragma once

#include "core/geometry.h"
#include "haptics/bodkin_driver.h"

namespace bodkin::haptics {

// A vendor's axes, unit of length and unit of torque, and the transform into the operator's frame (X right, Y away, Z
// up; mm, N mm). Forces are N everywhere.
struct VendorFrame {
  Mat3 to_operator;          // M: the vendor's axes in the operator's frame
  Mat3 tool;                 // the tool of Bodkin (third axis hub to tip) in the vendor's tool
  double length = 1.0;       // mm per unit
  double torque = 1.0;       // N mm per unit
  Vec3 centre{0.0, 0.0, 0};  // of the usable workspace, in the vendor's axes and unit

  // position_operator = length M (p - centre)
  void put_position(const Vec3& vendor, bodkin_state& state) const noexcept {
    Eigen::Map<Vec3>(state.position) = length * (to_operator * (vendor - centre));
  }
  void put_velocity(const Vec3& vendor, bodkin_state& state) const noexcept {
    Eigen::Map<Vec3>(state.velocity) = length * (to_operator * vendor);
  }
  // R_operator = M R_vendor T
  void put_rotation(const Mat3& vendor, bodkin_state& state) const noexcept {
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(state.rotation) = to_operator * vendor * tool;
  }
  // The command, in the vendor's units, for the hand to feel `force` (operator's frame).
  Vec3 force_of(const bodkin_command& command) const noexcept {
    return to_operator.transpose() * Eigen::Map<const Vec3>(command.force);
  }
  Vec3 torque_of(const bodkin_command& command) const noexcept {
    return to_operator.transpose() * Eigen::Map<const Vec3>(command.torque) / torque;
  }
};

inline Mat3 rows(const Vec3& x, const Vec3& y, const Vec3& z) {
  Mat3 matrix;
  matrix << x.transpose(), y.transpose(), z.transpose();
  return matrix;
}

// X right, Y up, Z towards the operator (OpenHaptics, spnav): (x, -z, y). The stylus points along its own -Z.
inline VendorFrame y_up_frame() {
  return {.to_operator = rows(Vec3::UnitX(), -Vec3::UnitZ(), Vec3::UnitY()),
          .tool = Vec3(1.0, -1.0, -1.0).asDiagonal().toDenseMatrix()};
}

// X towards the operator, Y right, Z up (Force Dimension, Haption): (y, -x, z). The tool points along its own -X:
// away from the operator when the handle is in its middle position.
inline VendorFrame x_near_frame() {
  return {.to_operator = rows(Vec3::UnitY(), -Vec3::UnitX(), Vec3::UnitZ()),
          .tool = rows(-Vec3::UnitZ(), Vec3::UnitX(), -Vec3::UnitY())};
}

// The frame of a vendor that uses m and N m.
inline VendorFrame metres(VendorFrame frame) {
  frame.length = frame.torque = 1000.0;
  return frame;
}

// A state at the workspace's centre, tool away from the operator, with nothing else set.
bodkin_state blank_state() noexcept;

}  // namespace bodkin::haptics
