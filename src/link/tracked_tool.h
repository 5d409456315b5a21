#pragma once

#include <optional>
#include <string>

#include "link/message.h"

#include "core/geometry.h"

namespace bodkin::link {

// The pose of `tool` in a message of a tracker: a TRANSFORM of that device name, or its element in a TDATA. To the
// reference, LPS mm, normalised to an exact rotation. Empty when the message does not contain it. Throws InputError
// for a truncated message and for a matrix that is not a rotation within 1 %.
std::optional<Pose> pose_of_tool(const Message& message, const std::string& tool);

// The frame of a tracker's poses, as stated by its user.
enum class TrackedFrame {
  patient,  // the reference is registered: it is the patient's CT, RAS mm
  hand      // the reference is the tracker's own; the tool is used about the middle of the device's workspace
};

// From a tracker's reference to the operator's frame (haptics/device.h).
struct TrackedPlacement {
  TrackedFrame frame = TrackedFrame::patient;
  Vec3 middle = Vec3::Zero();    // of the operator's frame: LPS mm in the patient, or mm in the tracker's own axes
  Mat3 axes = Mat3::Identity();  // hand: the tracker's axes in the operator's frame
  Mat3 tool = Mat3::Identity();  // Bodkin's tool, third axis hub to tip, in the tracker's

  // `lps`: as from pose_of_tool().
  Pose to_operator(const Pose& lps) const noexcept;
};

// "z", "-x": the axis of the tracked tool that points from hub to tip, or out of a probe; the third of the result.
// Its first, towards a probe's orientation marker, is the tool's x, or the y of a tool that points along x. Empty:
// not one of the six.
std::optional<Mat3> tool_along(const std::string& axis);

// The motion of a hand between two poses from a tracker, at a constant speed. Each pose is reached over the time
// since the previous one (1 to 100 ms), and never faster than 900 mm/s, so that a tracker that was lost for a while
// causes no jump. For one thread; nothing here allocates.
class TrackedMotion {
 public:
  // The first pose, or the one after a restart: takes effect at once.
  void begin(const Pose& pose, double time) noexcept;
  // A new pose. Times in s of one clock.
  void take(const Pose& pose, double time) noexcept;
  Pose at(double time) const noexcept;

 private:
  Pose from_ = Pose::Identity(), to_ = Pose::Identity();
  double taken_ = 0.0;  // s, arrival of the last pose
  double span_ = 0.0;   // s, duration of the motion to it
};

}  // namespace bodkin::link
