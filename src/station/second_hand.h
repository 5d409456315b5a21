#pragma once

#include <memory>

#include "session/second_link.h"
#include "session/second_sample.h"

#include "anatomy/case.h"
#include "fem/moving/body_thread.h"
#include "haptics/device_servo.h"

namespace bodkin::station {

// Where the second hand works: the plunger in the operator's own frame; the probe in the patient as the needle does
// (workspace_about), but the middle of its workspace lies 60 mm to the operator's left, so that two devices that
// stand side by side do not meet.
haptics::WorkspaceSettings second_workspace(session::SecondRole role, const anatomy::NeedlePath& path);

// A second device with a servo, a guard and a thread (or a vendor's loop) of its own, in addition to the one that
// holds the needle. It feels the plunger of the needle's syringe, or an ultrasound probe on the skin. Whatever
// happens to it ends its own force only. What it knows of the needle, and what it records, passes through a
// SecondLink.
class SecondHand {
 public:
  // `settings.workspace` is that of second_workspace(). `pressed`: the body that a probe presses; null where it feels
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
  // Zero force and the end of the loop. False: the device did not let itself be stopped.
  bool stop() noexcept;

  // One thread: arms or disarms, in order with what waits.
  void arm() noexcept;
  void disarm() noexcept;

  session::SecondRole role() const noexcept;
  haptics::DeviceServo& servo() noexcept { return *servo_; }
  // One observer's thread: the newest sample, unchanged until the next call.
  const session::SecondSample& snapshot() noexcept;
  // The same thread: where the tool is, third axis out of its tip (patient, LPS, for a probe). A body that the probe
  // presses holds it back; this is where it is then.
  const Pose& tool() noexcept;

 private:
  struct Shared;

  std::shared_ptr<Shared> shared_;  // with a loop that may have to be left behind
  std::unique_ptr<haptics::DeviceServo> servo_;
};

}  // namespace bodkin::station
