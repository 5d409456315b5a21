#include "haptics/guard_event.h"

namespace bodkin::haptics {

std::string_view text_of(GuardState state) noexcept {
  switch (state) {
    case GuardState::disarmed:
      return "disarmed";
    case GuardState::ramping:
      return "ramping";
    case GuardState::active:
      return "active";
    case GuardState::holding:
      return "holding";
    case GuardState::faulted:
      return "faulted";
  }
  return "faulted";
}

std::string_view text_of(GuardReason reason) noexcept {
  switch (reason) {
    case GuardReason::none:
    case GuardReason::count_of_reasons:
      return "nothing";
    case GuardReason::armed:
      return "armed";
    case GuardReason::full_force:
      return "the full force is on";
    case GuardReason::disarmed:
      return "disarmed";
    case GuardReason::refused:
      return "could not be armed";
    case GuardReason::released:
      return "the dead-man's switch was released";
    case GuardReason::tick_gap:
      return "no tick came for too long";
    case GuardReason::stale:
      return "the simulation is late";
    case GuardReason::fresh_again:
      return "the simulation is back";
    case GuardReason::not_finite:
      return "the requested force is not a number";
    case GuardReason::stale_fault:
      return "the simulation has stopped answering";
    case GuardReason::controller_failed:
      return "the simulation failed";
    case GuardReason::device_fault:
      return "the device reports a fault";
    case GuardReason::bad_pose:
      return "the device reports a pose that is not a number";
    case GuardReason::jump:
      return "the device's position jumped";
    case GuardReason::too_fast:
      return "the hand moves too fast";
    case GuardReason::frozen:
      return "the device's readings do not change under force";
    case GuardReason::oscillation:
      return "the hand shakes again";
    case GuardReason::passivity:
      return "an axis returned more energy than it received";
    case GuardReason::slew:
      return "the force rose too fast";
    case GuardReason::peak:
      return "the force is more than the device's peak";
    case GuardReason::torque_peak:
      return "the torque is more than the device's peak";
    case GuardReason::thermal:
      return "the motors have reached their permitted mean load";
    case GuardReason::hot:
      return "the motors are hot";
    case GuardReason::workspace:
      return "the hand is outside the workspace";
    case GuardReason::halved:
      return "the hand shakes, the force is halved";
    case GuardReason::damping:
      return "the hand still shakes: a quarter of the force is left, with damping";
    case GuardReason::stale_decay:
      return "the simulation is late, the force fades";
    case GuardReason::moving:
      return "the hand is not at rest";
    case GuardReason::pulling:
      return "a force would act at once";
  }
  return "nothing";
}

}  // namespace bodkin::haptics
