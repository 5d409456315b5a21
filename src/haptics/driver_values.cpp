#include "haptics/driver_values.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace bodkin::haptics {

namespace {

constexpr double farthest = 1e4;          // mm
constexpr double crooked = 1e-3;          // of a rotation's columns: more than single precision loses
constexpr double fallback_rate = 1000.0;  // Hz
constexpr double longest_delay = 0.02;    // s

using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

double number(double value) {
  return std::isfinite(value) ? value : 0.0;
}

std::string text(const char (&bytes)[BODKIN_TEXT]) {
  return {bytes, strnlen(bytes, BODKIN_TEXT)};
}

bool is_rotation(const Mat3& matrix) noexcept {
  return matrix.allFinite() && (matrix.transpose() * matrix - Mat3::Identity()).cwiseAbs().maxCoeff() < crooked &&
         matrix.determinant() > 0.0;
}

// The rotation with the same needle axis, exact to double precision.
Mat3 straightened(const Mat3& matrix) noexcept {
  const Vec3 z = matrix.col(2).normalized();
  const Vec3 y = z.cross(matrix.col(0)).normalized();
  Mat3 result;
  result << y.cross(z), y, z;
  return result;
}

}  // namespace

DeviceFault fault_from(int result) noexcept {
  return result >= BODKIN_OK && result <= BODKIN_VENDOR_ERROR ? static_cast<DeviceFault>(result)
                                                              : DeviceFault::vendor_error;
}

DeviceAbilities abilities_from(const bodkin_abilities& abilities) {
  DeviceAbilities result;
  result.name = text(abilities.name);
  result.serial = text(abilities.serial);
  result.peak_force = std::max(0.0, number(abilities.peak_force));
  result.continuous_force = std::max(0.0, number(abilities.continuous_force));
  result.peak_torque = std::max(0.0, number(abilities.peak_torque));
  result.stiffness = std::max(0.0, number(abilities.stiffness));
  result.damping = std::max(0.0, number(abilities.damping));
  result.resolution = std::max(0.0, number(abilities.resolution));
  const double rate = number(abilities.rate);
  result.rate = rate > 0.0 ? rate : fallback_rate;
  result.delay = std::clamp(number(abilities.delay), 0.0, longest_delay);
  result.delay_source = text(abilities.delay_source);
  const Vec3 low(abilities.workspace_low), high(abilities.workspace_high);
  if (low.allFinite() && high.allFinite() && (low.array() <= high.array()).all()) {
    result.workspace_low = low;
    result.workspace_high = high;
  }
  result.measures_rotation = abilities.measures_rotation != 0;
  result.has_dead_man = abilities.has_dead_man != 0;
  result.owns_loop = abilities.owns_loop != 0;
  return result;
}

void read_state(const bodkin_state& from, DeviceState& state) noexcept {
  state.fault = fault_from(static_cast<int>(from.fault));
  state.buttons = from.buttons;
  state.held = from.held != 0;
  state.temperature = std::clamp(number(from.temperature), 0.0, 1.0);
  state.velocity = Vec3(from.velocity);
  if (!state.velocity.allFinite()) state.velocity.setConstant(std::numeric_limits<double>::quiet_NaN());

  const Vec3 position(from.position);
  const Mat3 rotation = Eigen::Map<const RowMajor>(from.rotation);
  if (position.allFinite() && position.norm() < farthest && is_rotation(rotation)) {
    state.hand.translation() = position;
    state.hand.linear() = straightened(rotation);
  } else if (state.fault == DeviceFault::none) {
    state.fault = DeviceFault::bad_data;
  }
}

bodkin_command command_from(const Wrench& wrench) noexcept {
  bodkin_command command{};
  if (!wrench.force.allFinite() || !wrench.torque.allFinite()) return command;
  Eigen::Map<Vec3>(command.force) = wrench.force;
  Eigen::Map<Vec3>(command.torque) = wrench.torque;
  return command;
}

}  // namespace bodkin::haptics
