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
#include "imaging/moved_tissue.h"

namespace bodkin::views {

// How the needle moves the skin where it goes in, for display. The skin at `at` is displaced by `depth` along
// `inwards`; a negative depth is skin that a needle on its way out pulls up. From there the displacement fades with
// the distance.
struct SkinDimple {
  Vec3 at = Vec3::Zero();        // LPS mm, on the skin at rest
  Vec3 inwards = Vec3::UnitY();  // unit
  double depth = 0.0;            // mm, as the force model has it
};

// What the person should know at once, the worst first.
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

// What the hand that does not hold the needle does, and what this patient lets it do.
struct OtherHandState {
  bool has_finger = false, has_fluid = false, has_syringe = false;  // the patient has the part for it
  bool finger = false;                                              // feels the skin in the needle's place
  bool finger_presses = false;                                      // it is on the skin
  bool stylet_in = false, manometer_on = false;
  bool plunger = false;       // is pressed
  bool air = false;           // fills the syringe, not saline
  bool breathes = false;      // the patient
  bool holds_breath = false;  // is asked to
};

// All that a view may draw of one moment, plain data: a view computes no force and asks nobody. The spans are valid
// during View::show_frame() only.
struct Frame {
  std::uint64_t number = 0;
  State state = State::no_case;
  double clock = 0.0;         // s since the window opened, for animation
  double time = 0.0;          // s since the attempt began
  double time_in_body = 0.0;  // s

  // The needle. `needle` is what is to be drawn: with its tip in the tissue as it lies there, or hovering over the
  // skin where it would be put down. `hand` is where the hand means it to be, ahead of it by the resistance.
  bool has_needle = false;
  Pose needle = Pose::Identity();  // LPS
  Pose hand = Pose::Identity();
  double drawn_in = 0.0;          // breath, 0 to 1, by which the patient is drawn; in steps that can be seen
  Vec3 in_tissue = Vec3::Zero();  // LPS mm, where what is at the tip lies when the patient has breathed out
  double depth = 0.0;             // mm along the needle's line below the skin; not more than 0 outside
  double pushed = 0.0;            // mm of the depth by which the tip has pushed what it touches; 0: none is known
  Vec3 touched = Vec3::Zero();    // LPS mm, where what it touches lies at rest
  double velocity = 0.0;          // mm/s, inwards
  std::optional<Vec3> entry;      // LPS mm, where the needle went through the skin
  anatomy::TissueId tissue = anatomy::tissue::air;  // at the tip
  std::string place;                                // its name, or the name of the structure that the tip is in
  SkinDimple dimple;
  // How tissue has moved anywhere, which slices follow; null: they show it at rest.
  std::shared_ptr<const imaging::MovedTissue> moved_tissue;
  std::span<const float> displacements;  // mm, x y z of every point that the scene asked for; empty: a rigid body

  std::span<const LeftNeedle> left_needles;  // the one that was left first stands first

  OtherHandState other_hand;

  // Force, N.
  double force = 0.0;           // that the needle meets, its size
  double resistance = 0.0;      // along the needle, positive pushes out
  double constraint = 0.0;      // across it, its size
  Vec3 applied = Vec3::Zero();  // on the hand, LPS
  double energy = 0.0;          // N mm that the hand has given to the tissue
  forces::Diagnostics diagnostics{};
  std::span<const forces::DiagnosticName> diagnostic_names;
  std::span<const station::HandSample> samples;   // every tick since the last frame
  std::span<const session::SessionEvent> events;  // since the last frame

  // The plan.
  std::optional<anatomy::NeedlePath> plan;
  bool is_planning = false;                            // the plan is being made: no needle yet
  std::vector<std::pair<double, double>> plan_broken;  // mm from its entry: stretches where it must not go
  double target_distance = 0.0;                        // mm from the tip to the target
  double target_tolerance = 3.0;                       // mm
  double off_path = 0.0;                               // mm from the tip to the planned line
  Vec3 off_path_vector = Vec3::Zero();                 // LPS mm, from the planned line to the tip
  double off_angle = 0.0;                              // rad between the needle and the plan
  bool target_reached = false;

  // The machine.
  std::string device;
  std::optional<anatomy::DeviceLimits> device_limits;  // nothing: it is not known
  haptics::GuardState guard = haptics::GuardState::disarmed;
  haptics::GuardReason fault = haptics::GuardReason::none;
  std::uint32_t limits = 0;  // see HandGuard::limits
  double rate = 1000.0;      // Hz of the servo
  std::uint64_t ticks = 0, late_ticks = 0;
  double recent_success = 1.0;                       // share of the last hundred ticks that were in time
  const haptics::ServoTimings* timings = nullptr;    // null: no servo runs
  const station::LivePicture* ultrasound = nullptr;  // null: none

  std::optional<Warning> warning;
  std::string message;                 // the newest sentence of station or guard
  std::span<const std::string> notes;  // what the station has said since the last frame
  std::string hint;                    // what to do now, one sentence
  Vec3 crosshair = Vec3::Zero();       // LPS mm, of the slices
  bool follows_tip = true;             // the crosshair is the tip
};

}  // namespace bodkin::views
