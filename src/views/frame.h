#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "session/session_file.h"
#include "station/hand_session.h"
#include "views/states.h"

#include "anatomy/needle_path.h"
#include "anatomy/tissue.h"
#include "core/geometry.h"
#include "forces/diagnostics.h"
#include "haptics/servo_records.h"
#include "imaging/tissue_displacement.h"

namespace bodkin::views {

// The displacement of the skin by the needle, for display. The skin at `at` is displaced by `depth` along `inwards`;
// a negative depth means skin pulled up by a withdrawing needle. From there the displacement fades with the distance.
struct SkinDimple {
  Vec3 at = Vec3::Zero();        // LPS mm, on the skin at rest
  Vec3 inwards = Vec3::UnitY();  // unit
  double depth = 0.0;            // mm, from the force model
};

// Urgent information for the person, the most urgent first.
struct Warning {
  enum class Kind : std::uint8_t { nerve, vessel, organ, bone };  // by urgency
  Kind kind = Kind::bone;
  std::string title;   // "Bone: vertebra L3"
  std::string advice;  // what to do next, one sentence
};

// A needle that was left in the body when the hand took another one.
struct LeftNeedle {
  Pose pose = Pose::Identity();  // LPS
  double depth = 0.0;            // mm below the skin along its line
};

// The state of the hand that does not hold the needle, and its possibilities with this patient.
struct OtherHandState {
  bool has_finger = false, has_fluid = false, has_syringe = false;  // the patient has the part for it
  bool finger = false;                                              // palpates the skin instead of the needle
  bool finger_presses = false;                                      // it is on the skin
  bool stylet_in = false, manometer_on = false;
  bool plunger = false;       // is pressed
  bool air = false;           // fills the syringe, not saline
  bool breathes = false;      // the patient
  bool holds_breath = false;  // is asked to
};

// Everything that a view may draw at one time, plain data: a view computes no force and queries no other object. The
// spans are valid only during View::show_frame().
struct Frame {
  std::uint64_t number = 0;
  State state = State::no_case;
  double clock = 0.0;         // s since the window opened, for animation
  double time = 0.0;          // s since the attempt began
  double time_in_body = 0.0;  // s

  // The needle. `needle` is to be drawn: with its tip in the displaced tissue, or hovering over the skin where it
  // would be put down. `hand` is the hand's commanded pose, ahead of it by the resistance.
  bool has_needle = false;
  Pose needle = Pose::Identity();  // LPS
  Pose hand = Pose::Identity();
  double drawn_in = 0.0;          // inspiration, 0 to 1, of the displayed patient; in visible steps
  Vec3 in_tissue = Vec3::Zero();  // LPS mm, position after expiration of the tissue at the tip
  double depth = 0.0;             // mm along the needle's line below the skin; not more than 0 outside
  double pushed = 0.0;            // mm of the depth by which the tip has pushed the tissue; 0: unknown
  Vec3 touched = Vec3::Zero();    // LPS mm, position at rest of the touched tissue
  double velocity = 0.0;          // mm/s, inwards
  std::optional<Vec3> entry;      // LPS mm, at the skin
  anatomy::TissueId tissue = anatomy::tissue::air;  // at the tip
  std::string place;                                // its name, or the name of the structure that the tip is in
  SkinDimple dimple;
  // Displacement of the tissue, followed by slices; null: they show it at rest.
  std::shared_ptr<const imaging::TissueDisplacement> moved_tissue;
  std::span<const float> displacements;  // mm, x y z of every point requested by the scene; empty: a rigid body

  std::span<const LeftNeedle> left_needles;  // in the order in which they were left

  OtherHandState other_hand;

  // Force, N.
  double force = 0.0;           // on the needle, magnitude
  double resistance = 0.0;      // along the needle, positive pushes out
  double constraint = 0.0;      // across it, magnitude
  Vec3 applied = Vec3::Zero();  // on the hand, LPS
  double energy = 0.0;          // N mm given by the hand to the tissue
  forces::Diagnostics diagnostics{};
  std::span<const forces::DiagnosticName> diagnostic_names;
  std::span<const station::HandSample> samples;   // every tick since the last frame
  std::span<const session::SessionEvent> events;  // since the last frame

  // The plan.
  std::optional<anatomy::NeedlePath> plan;
  bool is_planning = false;                            // the plan is being made: no needle yet
  std::vector<std::pair<double, double>> plan_broken;  // mm from its entry: forbidden sections
  double target_distance = 0.0;                        // mm from the tip to the target
  double target_tolerance = 3.0;                       // mm
  double off_path = 0.0;                               // mm from the tip to the planned line
  Vec3 off_path_vector = Vec3::Zero();                 // LPS mm, from the planned line to the tip
  double off_angle = 0.0;                              // rad between the needle and the plan
  bool target_reached = false;

  // The machine.
  std::string device;
  std::optional<anatomy::DeviceLimits> device_limits;  // empty: unknown
  haptics::GuardState guard = haptics::GuardState::disarmed;
  haptics::GuardReason fault = haptics::GuardReason::none;
  std::uint32_t limits = 0;  // see HandGuard::limits
  double rate = 1000.0;      // Hz of the servo
  std::uint64_t ticks = 0;
  std::uint64_t late_ticks = 0;                    // counted every hundred ticks
  double recent_success = 1.0;                     // fraction of the last hundred ticks that were on time
  const haptics::ServoTimings* timings = nullptr;  // null: no servo runs
  const station::LiveImage* ultrasound = nullptr;  // null: none

  std::optional<Warning> warning;
  std::string message;                 // the newest sentence of station or guard
  std::span<const std::string> notes;  // from the station since the last frame
  std::string hint;                    // the next action, one sentence
  Vec3 crosshair = Vec3::Zero();       // LPS mm, of the slices
  bool follows_tip = true;             // the crosshair is the tip
};

}  // namespace bodkin::views
