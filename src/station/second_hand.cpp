#include "station/second_hand.h"

#include <optional>
#include <utility>
#include <variant>

#include "station/hand_session.h"
#include "station/plunger.h"
#include "station/probe_contact.h"
#include "station/probe_reaction.h"

#include "haptics/guard_settings.h"

namespace bodkin::station {

namespace {

constexpr double to_the_left = 60.0;      // mm from the needle's workspace to the probe's
constexpr double sample_interval = 0.01;  // s
constexpr double rounding = 1e-9;         // s

using SecondModel = std::variant<Plunger, ProbeContact, ProbeReaction>;

SecondModel model_for(session::SecondRole role, const anatomy::Case& patient, const haptics::DeviceAbilities& device,
                      double dt, bool is_pressed) {
  const haptics::GuardSettings stable = haptics::guard_settings(device, 1.0 / dt);
  if (role == session::SecondRole::plunger) return Plunger(patient.library, dt, stable.stiffness, stable.damping);
  if (is_pressed) return ProbeReaction(dt, stable.stiffness);
  return ProbeContact(patient.tissues, dt, device.resolution, stable.stiffness, stable.damping);
}

}  // namespace

haptics::WorkspaceSettings second_workspace(session::SecondRole role, const anatomy::NeedlePath& path) {
  if (role == session::SecondRole::plunger) return {};
  haptics::WorkspaceSettings workspace = workspace_about(path);
  workspace.centre -= to_the_left * workspace.rotation.col(0);
  return workspace;
}

struct SecondHand::Shared {
  Shared(session::SecondRole wanted, std::shared_ptr<const anatomy::Case> from,
         const haptics::DeviceAbilities& device, double dt, std::shared_ptr<session::SecondLink> through,
         std::shared_ptr<fem::BodyThread> body)
      : role(wanted),
        patient(std::move(from)),
        link(std::move(through)),
        pressed(std::move(body)),
        model(model_for(role, *patient, device, dt, pressed != nullptr)) {}

  haptics::Control step(const haptics::ControlInput& input) noexcept {
    const session::NeedleSnapshot& needle = link->needle.read();
    session::SecondSample now;
    now.time = needle.time;
    now.position = input.needle.translation();
    now.rotation = Eigen::Quaterniond(input.needle.linear()).normalized();
    haptics::Control control;
    Pose tool = input.needle;
    const bool armed = input.guard != haptics::GuardState::disarmed && input.guard != haptics::GuardState::faulted;
    if (Plunger* const plunger = std::get_if<Plunger>(&model)) {
      control.wrench.force = plunger->step(now.position, needle.tissue, armed);
      now.force = plunger->force();
      now.pressure = plunger->pressure();
      now.volume = plunger->volume();
      link->thumb_force.store(now.force, std::memory_order_relaxed);
    } else if (ProbeContact* const probe = std::get_if<ProbeContact>(&model)) {
      control.wrench.force = probe->step(input.needle);
      now.force = probe->force();
    } else if (ProbeReaction* const reaction = std::get_if<ProbeReaction>(&model)) {
      // A hand without force feedback does not press the body.
      const bool presses = armed && !pressed->failed();
      control.wrench.force = reaction->step(input.needle, pressed->reading(), presses);
      pressed->move_probe(presses ? std::optional<Pose>(reaction->probe()) : std::nullopt);
      if (presses) tool = reaction->probe();
      now.force = reaction->force();
    }
    samples.write(now);
    tools.write(tool);
    // In the needle's time, so that samples and ticks share one clock and no two samples have the same time.
    if (needle.time >= next_sample - rounding) {
      next_sample = needle.time + sample_interval;
      if (!link->samples.push(now)) link->lost.fetch_add(1, std::memory_order_relaxed);
    }
    return control;
  }

  session::SecondRole role;
  std::shared_ptr<const anatomy::Case> patient;
  std::shared_ptr<session::SecondLink> link;
  std::shared_ptr<fem::BodyThread> pressed;  // may be null
  SecondModel model;
  double next_sample = 0.0;  // s of the session
  LatestValue<session::SecondSample> samples;
  LatestValue<Pose> tools{Pose::Identity()};
};

SecondHand::SecondHand(session::SecondRole role, haptics::DevicePort port, const haptics::DeviceAbilities& device,
                       const haptics::ServoSettings& settings, std::shared_ptr<const anatomy::Case> patient,
                       std::shared_ptr<session::SecondLink> link, std::shared_ptr<fem::BodyThread> pressed)
    : shared_(std::make_shared<Shared>(role, std::move(patient), device, 1.0 / settings.rate, std::move(link),
                                       std::move(pressed))),
      servo_(std::make_unique<haptics::DeviceServo>(
          std::move(port), device, settings,
          [shared = shared_](const haptics::ControlInput& input) { return shared->step(input); })) {}

SecondHand::~SecondHand() = default;

void SecondHand::start() {
  servo_->start();
}

bool SecondHand::stop() noexcept {
  return servo_->stop();
}

void SecondHand::arm() noexcept {
  haptics::ServoCommand command;
  command.kind = haptics::ServoCommand::Kind::arm;
  servo_->tick().command(command);
}

void SecondHand::disarm() noexcept {
  servo_->tick().disarm();
}

session::SecondRole SecondHand::role() const noexcept {
  return shared_->role;
}

const session::SecondSample& SecondHand::snapshot() noexcept {
  return shared_->samples.read();
}

const Pose& SecondHand::tool() noexcept {
  return shared_->tools.read();
}

}  // namespace bodkin::station
