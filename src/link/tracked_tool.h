#pragma once

#include <optional>
#include <string>

#include "link/message.h"

#include "core/geometry.h"

namespace bodkin::link {

// The pose of `tool` in a message of a tracker: a TRANSFORM of that device name, or its element in a TDATA. To the
// reference, LPS mm, made a rotation to the last bit. Nothing when the message tells nothing of it. Throws InputError
// for a message that ends too early and for a matrix that is no rotation within 1 %.
std::optional<Pose> pose_of_tool(const Message& message, const std::string& tool);

// Where the poses of a tracker are, as its user says.
enum class TrackedFrame {
  patient,  // the reference is registered: it is the patient's CT, RAS mm
  hand      // the reference is the tracker's own; the tool works about the middle of the device's workspace
};

// From a tracker's reference to the operator's frame (haptics/device.h).
struct TrackedPlacement {
  TrackedFrame frame = TrackedFrame::patient;
  Vec3 middle = Vec3::Zero();    // of the operator's frame: LPS mm in the patient, or mm in the tracker's own axes
  Mat3 axes = Mat3::Identity();  // hand: the tracker's axes in the operator's frame
  Mat3 tool = Mat3::Identity();  // Bodkin's tool, third axis hub to tip, in the tracker's

  // `lps`: as pose_of_tool() has it.
  Pose to_operator(const Pose& lps) const noexcept;
};

// "z", "-x": which axis of the tracked tool points from hub to tip, or out of a probe; the third of the result. Its
// first, a probe's marked side, is the tool's x, or the y of a tool that points along x. Empty: not one of the six.
std::optional<Mat3> tool_along(const std::string& axis);

// Between two poses that came from a tracker: what a hand did meanwhile, at a constant speed. Each pose is reached
// over the time that passed before it came (1 to 100 ms), and never faster than 900 mm/s, so that a tracker that was
// lost for a while brings no jump. For one thread; nothing here allocates.
class TrackedMotion {
 public:
  // The first pose, or the one after a new start: there at once.
  void begin(const Pose& pose, double time) noexcept;
  // A new one came. Times in s of one clock.
  void take(const Pose& pose, double time) noexcept;
  Pose at(double time) const noexcept;

 private:
  Pose from_ = Pose::Identity(), to_ = Pose::Identity();
  double taken_ = 0.0;  // s, when the last pose came
  double span_ = 0.0;   // s, over which it is reached
};

}  // namespace bodkin::link
