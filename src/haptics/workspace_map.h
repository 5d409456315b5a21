#pragma once

#include "core/geometry.h"

namespace bodkin::haptics {

// The placement of the hand's workspace in the patient, and of the needle in the hand.
struct WorkspaceSettings {
  Mat3 rotation = Mat3::Identity();       // operator's frame (haptics/device.h) to patient frame (LPS)
  Vec3 centre = Vec3::Zero();             // LPS mm, position of the middle of the workspace
  Vec3 hand_middle = Vec3::Zero();        // mm, operator's frame: that middle
  double scale = 1.0;                     // mm of the needle per mm of the hand; 0.1 to 10
  Mat3 tool_rotation = Mat3::Identity();  // needle to tool as the device reports it: the needle's axis is its z
  Vec3 tip_offset = Vec3::Zero();         // mm, from the device's point to the tip, in the tool's axes
  double force_scale = 1.0;               // N at the hand per N of the needle; 0.01 to 1: for weak devices, recorded
  double body_speed = 50.0;               // mm/s at most, when the body is moved
  double body_turn = 0.5;                 // rad/s
};

// Throws InputError naming the first number out of range.
void check(const WorkspaceSettings& settings);

// From the hand in the operator's frame to the needle in the patient, and from the wrench on the needle back to the
// hand.
//
//   tip = centre + R (s x + shift),   x = p - m + H o    needle axes = R H G
//   force on the hand = k R' F,       torque about p = k R' T + (H o) x (force on the hand)
//
//   p, H  position and rotation of the device's tool     m     middle of the workspace      o  tip offset
//   G     grasp of the needle (tool rotation at first)   R     rotation                     s  scale
//   k     force scale                                    F, T  wrench about the tip in the patient
//
// With s = k = 1 the work of the hand is the work of the needle, for any grasp (virtual work). Otherwise the hand
// does k / s times the needle's work, and feels k s times its stiffness. Motion between tip and hand changes only by
// rotation, scale and the grasp, so nothing here adds energy.
//
// Hold: while the needle is frozen (it stays in the tissue, the hand may leave) or the clutch is pressed (the hand
// returns to the middle of a small workspace), the needle keeps its pose in the patient, or moves with the tissue in
// which it sticks. When the last hold ends, the grasp is determined anew (shift and G), so the needle does not jump,
// wherever the hand is and however it is turned. All functions but the constructor are noexcept and allocate nothing.
class WorkspaceMap {
 public:
  explicit WorkspaceMap(const WorkspaceSettings& settings);

  // The needle for the hand of this tick. `dt`: s since the last one, by which the motion of the body advances.
  const Pose& step(const Pose& hand, double dt) noexcept;
  // The needle's wrench (LPS, about the tip) as the hand of the last step feels it: about the device's point,
  // operator's frame. Zero while the needle is held.
  Wrench felt(const Wrench& on_needle) const noexcept;

  // Takes effect at the next step.
  void freeze(bool on) noexcept { frozen_ = on; }
  void clutch(bool on) noexcept { clutched_ = on; }
  // Moves the body: `middle` (LPS mm) to the middle of the workspace, rotated by `rotation` (operator to patient). It
  // moves smoothly at body_speed and body_turn, so that no needle is torn through it. Ignored when it is not finite
  // or not a rotation.
  void move_body(const Vec3& middle, const Mat3& rotation) noexcept;

  // While the needle is held: the tissue in which it sticks carries its tip by `by`, mm (LPS), and rotates it about
  // the tip. Ignored otherwise, and when it is not finite or not a rotation.
  void carry(const Vec3& by, const Mat3& turn = Mat3::Identity()) noexcept;

  // k s: the factor by which the needle's surroundings feel stiffer than they are. A device that renders 1 N/mm
  // stably renders tissue of at most 1 / stiffness_factor() N/mm.
  double stiffness_factor() const noexcept { return settings_.force_scale * settings_.scale; }
  bool is_held() const noexcept { return frozen_ || clutched_; }
  bool is_frozen() const noexcept { return frozen_; }
  bool is_clutched() const noexcept { return clutched_; }
  bool is_body_moving() const noexcept { return body_moving_; }
  const Pose& needle() const noexcept { return needle_; }  // LPS
  const WorkspaceSettings& settings() const noexcept { return settings_; }

 private:
  Vec3 tip_of(const Pose& hand) const noexcept;
  void glide(double dt) noexcept;
  void grasp(const Pose& hand) noexcept;

  WorkspaceSettings settings_;
  Vec3 wanted_centre_;
  Mat3 wanted_rotation_;
  Mat3 grip_;                  // G
  Vec3 shift_ = Vec3::Zero();  // mm, operator's axes
  Vec3 lever_ = Vec3::Zero();  // mm, H o of the last step
  Pose needle_ = Pose::Identity();
  bool frozen_ = false;
  bool clutched_ = false;
  bool was_held_ = false;
  bool body_moving_ = false;
  bool begun_ = false;
};

}  // namespace bodkin::haptics
