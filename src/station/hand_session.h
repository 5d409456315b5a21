#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "session/second_link.h"
#include "session/session_file.h"
#include "station/scan_thread.h"

#include "fem/moving/body_thread.h"
#include "haptics/device_servo.h"
#include "simulation/body_port.h"
#include "simulation/display_thread.h"

namespace bodkin::station {

// The limits that a case takes from the device in use: the models are then created for it, and the recording says so.
// Unknown values stay as in `limits`.
anatomy::DeviceLimits limits_of(const haptics::DeviceAbilities& device, anatomy::DeviceLimits limits);

// The patient lies prone in front of the operator, head away from the operator; the path's entry is 30 mm below the
// middle of the workspace, to leave room above the skin.
haptics::WorkspaceSettings workspace_about(const anatomy::NeedlePath& path);

// A sample of every tick, for an observer that draws curves.
struct HandSample {
  double time = 0.0;                                // s of the session
  double depth = 0.0;                               // mm along the needle's line
  double force = 0.0;                               // N requested by the models, magnitude
  double resistance = 0.0;                          // N along the needle
  double constraint = 0.0;                          // N across it, magnitude
  anatomy::TissueId tissue = anatomy::tissue::air;  // at the tip
};

// The newest tick, for an observer.
struct HandSnapshot {
  std::uint64_t ticks = 0;
  Pose needle = Pose::Identity();
  Vec3 coupling_offset = Vec3::Zero();  // mm, see BodyPort
  simulation::TickOutput output;        // without events
  bool past_points = false;             // the needle is past the contact points of its line: the force is not valid
  simulation::OtherHand other;          // of that tick
  std::uint32_t changes = 0;            // number of changes of the force models' numbers so far
  bool unseen = false;                  // a tracked hand is not seen: the needle rests at its last position
};

// A person performs a procedure on a patient with a device, and every tick is recorded. The constructor opens the
// recording; the force begins when the servo is armed (ServoTick::command).
class HandSession {
 public:
  // `patient` and `header` must already have the device's limits (limits_of). `second`: link to a second hand, which
  // receives the needle's state through it and is recorded; may be null. Throws InputError and SystemError.
  HandSession(std::shared_ptr<const anatomy::Case> patient, const session::SessionHeader& header,
              const std::filesystem::path& output, bool overwrite, haptics::DevicePort port,
              const haptics::DeviceAbilities& device, const haptics::ServoSettings& settings,
              std::shared_ptr<session::SecondLink> second = nullptr);
  ~HandSession();
  HandSession(const HandSession&) = delete;
  HandSession& operator=(const HandSession&) = delete;

  // The device renders no force, so no tissue holds the needle: it moves as an AxialNeedle; before start().
  void guide_along_axis();
  // Every tick passes the forces on the deformable body to `display`; before start().
  void show_on(std::shared_ptr<simulation::DisplayThread> display);
  // Every tick passes these forces and the pose of the needle in the body to `scan`; before start().
  void show_on(std::shared_ptr<ScanThread> scan);
  void start();
  haptics::DeviceServo& servo() noexcept { return *servo_; }
  // One observer's thread: the newest snapshot, unchanged until the next call.
  const HandSnapshot& snapshot() noexcept;
  // The same thread: the ticks, and the needle's events, since the last call; valid until the next one. At most two
  // seconds are kept; older ones are lost.
  std::span<const HandSample> take_samples();
  std::span<const session::SessionEvent> take_events();
  // Of HandSnapshot::output; valid as long as this object.
  std::span<const forces::DiagnosticName> diagnostic_names() const noexcept;
  // The body moves on its own, in the time of the ticks, and carries the needle; before start().
  void move_with(std::shared_ptr<fem::BodyThread> body);
  // The deformable body of the tick, for the observer's thread; null for a rigid one.
  simulation::BodyPort* body() noexcept;
  // Whether the recording cannot be written; finish() says why.
  bool failed() const noexcept;
  // Any thread: the thumb on the plunger of the case's syringe from the next tick on. A second hand on the plunger
  // takes precedence.
  void set_thumb(simulation::Thumb thumb) noexcept;
  // One thread: toggles an action of the other hand, from the next tick on.
  void turn(bool simulation::OtherHand::*what) noexcept;

  // Any thread: records a sample of the ultrasound machine named in the header; times must ascend strictly.
  void note(const session::ScanSample& sample);
  void note(session::ScannedPart part);

  // The observer's thread: changes the force models' numbers; the change is felt shortly afterwards and recorded. An
  // earlier change that has not taken effect is dropped. Throws InputError for numbers with which the session cannot
  // continue: another rate, other diagnostics, a deformable body.
  void change_numbers(const anatomy::HapticSettings& haptics, const std::vector<anatomy::TissueProperties>& tissues);
  // The observer's thread: why changed numbers did not take effect, once; empty: nothing to report.
  std::string take_refusal();

  // Zero force, end of the loop, and the recording closed. False: the device could not be stopped. Throws the error
  // of a failed recording.
  bool finish();
  // Ticks lost because the disk was too slow; after finish().
  std::uint64_t records_lost() const noexcept;

 private:
  struct Shared;

  std::shared_ptr<Shared> shared_;  // shared with a loop that may have to be abandoned
  std::unique_ptr<haptics::DeviceServo> servo_;
  std::vector<HandSample> samples_;  // used by the observer
  std::vector<session::SessionEvent> events_;
};

}  // namespace bodkin::station
