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

// The limits that a case takes from the device that is held: the models are then made for it, and the recording says
// so. What is not known of the device stays as it is in `limits`.
anatomy::DeviceLimits limits_of(const haptics::DeviceAbilities& device, anatomy::DeviceLimits limits);

// The patient lies prone in front of the operator, head away from him; the path's entry is 30 mm below the middle of
// the workspace, so that there is room above the skin.
haptics::WorkspaceSettings workspace_about(const anatomy::NeedlePath& path);

// What every tick leaves for an observer who draws curves.
struct HandSample {
  double time = 0.0;                                // s of the session
  double depth = 0.0;                               // mm along the needle's line
  double force = 0.0;                               // N that the models ask for, its size
  double resistance = 0.0;                          // N along the needle
  double constraint = 0.0;                          // N across it, its size
  anatomy::TissueId tissue = anatomy::tissue::air;  // at the tip
};

// The newest tick, for an observer.
struct HandSnapshot {
  std::uint64_t ticks = 0;
  Pose needle = Pose::Identity();
  Vec3 needle_ahead = Vec3::Zero();  // mm, see BodyPort
  simulation::TickOutput output;     // without events
  bool past_points = false;          // the needle is past the contact points of its line: the force is not valid
  simulation::OtherHand other;       // of that tick
  std::uint32_t changes = 0;         // of the force models' numbers so far
  bool unseen = false;               // a tracked hand is not seen: the needle rests where it was
};

// A person's hand on a device performs a procedure on a patient, and every tick is recorded. The constructor opens
// the recording; the force begins when the servo is armed (ServoTick::command).
class HandSession {
 public:
  // `patient` has the device's limits already (limits_of), and so has `header`. `second`: to a second hand, which
  // learns of the needle through it and is recorded; may be null. Throws InputError and SystemError.
  HandSession(std::shared_ptr<const anatomy::Case> patient, const session::SessionHeader& header,
              const std::filesystem::path& output, bool overwrite, haptics::DevicePort port,
              const haptics::DeviceAbilities& device, const haptics::ServoSettings& settings,
              std::shared_ptr<session::SecondLink> second = nullptr);
  ~HandSession();
  HandSession(const HandSession&) = delete;
  HandSession& operator=(const HandSession&) = delete;

  // No tissue holds the needle, for the device renders no force: it moves as an AxialNeedle; before start().
  void guide_along_axis();
  // Every tick passes it the forces on the deformable body; before start().
  void show_on(std::shared_ptr<simulation::DisplayThread> display);
  // Every tick passes it these forces and the needle as it lies in the body; before start().
  void show_on(std::shared_ptr<ScanThread> scan);
  void start();
  haptics::DeviceServo& servo() noexcept { return *servo_; }
  // One observer's thread: the newest snapshot, unchanged until the next call.
  const HandSnapshot& snapshot() noexcept;
  // The same thread: the ticks, and the needle's events, since the last call; valid until the next one. Two seconds
  // are kept; what comes while nobody looks is lost.
  std::span<const HandSample> take_samples();
  std::span<const session::SessionEvent> take_events();
  // Of HandSnapshot::output; they live as long as this.
  std::span<const forces::DiagnosticName> diagnostic_names() const noexcept;
  // The body moves by itself, in the time of the ticks, and takes the needle along; before start().
  void move_with(std::shared_ptr<fem::BodyThread> body);
  // The deformable body of the tick, for the observer's thread; null for a rigid one.
  simulation::BodyPort* body() noexcept;
  // The recording cannot be written; finish() says why.
  bool failed() const noexcept;
  // Any thread: the thumb on the plunger of the case's syringe from the next tick on. A second hand on the plunger is
  // the thumb, whatever this says.
  void set_thumb(simulation::Thumb thumb) noexcept;
  // One thread: what the other hand does from the next tick on, the other way than now.
  void turn(bool simulation::OtherHand::*what) noexcept;

  // Any thread: of the ultrasound machine that the header names, into the recording; times of samples rise strictly.
  void note(const session::ScanSample& sample);
  void note(session::ScannedPart part);

  // The observer's thread: other numbers for the force models, felt within a moment and recorded; what was ordered
  // before and has not begun to act is dropped. Throws InputError for numbers with which the session cannot go on:
  // another rate, a model that publishes others, a deformable body.
  void change_numbers(const anatomy::HapticSettings& haptics, const std::vector<anatomy::TissueProperties>& tissues);
  // The observer's thread: why numbers that were ordered are not felt, once; empty: nothing to say.
  std::string take_refusal();

  // Zero force, the end of the loop, and the recording closed. False: the device did not let itself be stopped.
  // Throws what went wrong with the recording.
  bool finish();
  // Ticks that the disk was too slow for; after finish().
  std::uint64_t records_lost() const noexcept;

 private:
  struct Shared;

  std::shared_ptr<Shared> shared_;  // with a loop that may have to be left behind
  std::unique_ptr<haptics::DeviceServo> servo_;
  std::vector<HandSample> samples_;  // the observer's
  std::vector<session::SessionEvent> events_;
};

}  // namespace bodkin::station
