#include "link/tracked_tool.h"

#include <algorithm>
#include <cmath>

#include "link/contents.h"
#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::link {

namespace {

constexpr double shortest_span = 0.001, longest_span = 0.1;  // s
constexpr double fastest = 900.0;                            // mm/s, below the 1000 at which the guard ends a force
constexpr double most_skew = 0.01;                           // of a matrix that shall be a rotation

Pose with_rotation(Pose pose, const std::string& tool) {
  const Mat3 turn = pose.linear();
  if ((turn.transpose() * turn - Mat3::Identity()).cwiseAbs().maxCoeff() > 2.0 * most_skew ||
      turn.determinant() < 0.0) {
    throw InputError(
        fmt::format("the matrix of {} is not a rotation; expected one without scale, shear or mirror", tool));
  }
  pose.linear() = Eigen::Quaterniond(turn).normalized().toRotationMatrix();
  return pose;
}

}  // namespace

std::optional<Pose> pose_of_tool(const Message& message, const std::string& tool) {
  constexpr std::size_t name_size = 20;
  if (message.type == "TRANSFORM" && message.device == tool)
    return with_rotation(read_transform(message.content), tool);
  if (message.type != "TDATA") return std::nullopt;
  ByteReader reader(message.content);
  while (reader.left() > 0) {
    const std::string name = reader.field(name_size);
    reader.u16();  // the kind of tool
    const std::span<const std::uint8_t> matrix = reader.raw(12 * sizeof(float));
    if (name == tool) return with_rotation(read_transform(matrix), tool);
  }
  return std::nullopt;
}

Pose TrackedPlacement::to_operator(const Pose& lps) const noexcept {
  Pose pose = Pose::Identity();
  if (frame == TrackedFrame::patient) {
    // Right, away and up for an operator who stands at the feet of a prone patient (station/hand_session.h).
    Mat3 to;
    to << -Vec3::UnitX().transpose(), Vec3::UnitZ().transpose(), Vec3::UnitY().transpose();
    pose.linear() = to * lps.linear() * tool;
    pose.translation() = to * (lps.translation() - middle);
    return pose;
  }
  const Pose own = turn_axes(lps);  // as sent by the tracker
  pose.linear() = axes * own.linear() * tool;
  pose.translation() = axes * (own.translation() - middle);
  return pose;
}

std::optional<Mat3> tool_along(const std::string& axis) {
  const bool negative = axis.starts_with('-');
  const std::string letter = negative ? axis.substr(1) : axis;
  if (letter.size() != 1 || letter[0] < 'x' || letter[0] > 'z') return std::nullopt;
  const int along = letter[0] - 'x';
  const double sign = negative ? -1.0 : 1.0;
  Mat3 tool = Mat3::Zero();
  tool(along == 0 ? 1 : 0, 0) = 1.0;
  tool(along, 2) = sign;
  tool.col(1) = tool.col(2).cross(tool.col(0));
  return tool;
}

void TrackedMotion::begin(const Pose& pose, double time) noexcept {
  from_ = to_ = pose;
  taken_ = time;
  span_ = 0.0;
}

void TrackedMotion::take(const Pose& pose, double time) noexcept {
  from_ = at(time);
  to_ = pose;
  const double way = (to_.translation() - from_.translation()).norm();
  span_ = std::max(std::clamp(time - taken_, shortest_span, longest_span), way / fastest);
  taken_ = time;
}

Pose TrackedMotion::at(double time) const noexcept {
  const double share = span_ > 0.0 ? std::clamp((time - taken_) / span_, 0.0, 1.0) : 1.0;
  if (share >= 1.0) return to_;
  Pose pose = Pose::Identity();
  pose.translation() = from_.translation() + share * (to_.translation() - from_.translation());
  pose.linear() = Eigen::Quaterniond(from_.linear())
                      .slerp(share, Eigen::Quaterniond(to_.linear()))
                      .normalized()
                      .toRotationMatrix();
  return pose;
}

}  // namespace bodkin::link
