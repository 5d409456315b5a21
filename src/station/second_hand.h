#pragma once

#include <memory>

#include "session/second_link.h"
#include "session/second_sample.h"

#include "anatomy/case.h"
#include "fem/moving/body_thread.h"
#include "haptics/device_servo.h"

namespace bodkin::station {

// The workspace of the second hand: for the plunger in the operator's own frame; for the probe in the patient as for
// the needle (workspace_about), but with the middle of its workspace 60 mm to the operator's left, so that two
// devices side by side do not collide.
haptics::WorkspaceSettings second_workspace(session::SecondRole role, const anatomy::NeedlePath& path);

// A second device with its own servo, guard and thread (or vendor's loop), in addition to the one that holds the
// needle. It feels the plunger of the needle's syringe, or an ultrasound probe on the skin. A failure ends only its
// own force. Its input from the needle, and its recorded samples, pass through a SecondLink.
class SecondHand {
 public:
  // `settings.workspace` is that of second_workspace(). `pressed`: the body that a probe presses; null for a probe on
  // the skin at rest (ProbeContact), and for a plunger. Throws InputError for a device or a tissue library that make
  // the model impossible.
  SecondHand(session::SecondRole role, haptics::DevicePort port, const haptics::DeviceAbilities& device,
             const haptics::ServoSettings& settings, std::shared_ptr<const anatomy::Case> patient,
             std::shared_ptr<session::SecondLink> link, std::shared_ptr<fem::BodyThread> pressed = nullptr);
  ~SecondHand();
  SecondHand(const SecondHand&) = delete;
  SecondHand& operator=(const SecondHand&) = delete;

  // Throws as DeviceServo::start.
  void start();
  // Zero force and end of the loop. False: the device could not be stopped.
  bool stop() noexcept;

  // One thread: arms or disarms, in order with queued commands.
  void arm() noexcept;
  void disarm() noexcept;

  session::SecondRole role() const noexcept;
  haptics::DeviceServo& servo() noexcept { return *servo_; }
  // One observer's thread: the newest sample, unchanged until the next call.
  const session::SecondSample& snapshot() noexcept;
  // The same thread: the pose of the tool, third axis out of its tip (patient, LPS, for a probe); for a probe held
  // back by a body that it presses, its pose in the body.
  const Pose& tool() noexcept;

 private:
  struct Shared;

  std::shared_ptr<Shared> shared_;  // shared with a loop that may have to be abandoned
  std::unique_ptr<haptics::DeviceServo> servo_;
};

}  // namespace bodkin::station
