#include "station/station_checks.h"

#include <variant>

#include "station/body_supervisor.h"
#include "station/hand_session.h"
#include "station/probe_contact.h"
#include "station/recorded_hand.h"
#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::station {

namespace {
constexpr double widest_redirection = 30.0 * degree;  // rad by which a needle may leave the planned direction
}  // namespace

anatomy::NeedlePath path_of(const StationOptions& options) {
  if (options.path) return *options.path;
  if (const std::optional<anatomy::NeedlePath>& planned = options.patient.description.procedure.path) return *planned;
  throw InputError(fmt::format(
      "{}: the case has no planned path, so there is no place to put the hand; make the case with --entry "
      "and --target",
      options.case_folder.string()));
}

std::optional<anatomy::BreathField> breath_of(const anatomy::Case& patient) {
  if (!patient.description.breathing) return {};
  return anatomy::BreathField(*patient.description.breathing);
}

void check_moving_body(const StationOptions& options) {
  if (!options.moving_body) return;
  if (!options.second || options.second->role != session::SecondRole::probe) {
    throw InputError(
        "--body is 'moving', which a probe presses, but no second device holds one; add --second DEVICE --second-as "
        "probe");
  }
  const anatomy::ResistanceSettings& resistance = options.patient.description.haptics.resistance;
  if (std::holds_alternative<anatomy::EmbeddedNeedleSettings>(resistance)) return;
  throw InputError(
      fmt::format("--body is 'moving', which only the resistance embedded_needle feels, but the resistance is {}; "
                  "add --resistance embedded_needle",
                  anatomy::name_of(resistance)));
}

fem::BodySolverSettings moving_settings(const StationOptions& options) {
  fem::BodySolverSettings settings;
  settings.motion.dt = body_step_time;
  settings.probe = *options.moving_body;
  settings.left_needles = options.left_needles;
  return settings;
}

anatomy::DeviceLimits limits_with(const DeviceChoice& choice, const haptics::DeviceAbilities& device,
                                  const anatomy::DeviceLimits& of_case) {
  if (!choice.is_recorded()) return limits_of(device, of_case);
  return read_recorded_hand(choice.identity).limits.value_or(of_case);
}

Pose first_probe(const UltrasoundChoice& choice, const anatomy::Case& patient) {
  try {
    return hold_probe(choice, patient).pose();
  } catch (const InputError& refused) {
    throw InputError(fmt::format("--ultrasound: {}", refused.what()));
  }
}

std::string remaining_stiffness(const haptics::StableStiffness& stiffness) {
  const bool encoder = stiffness.by_encoder.minCoeff() < stiffness.by_delay;
  const Vec3& axis = stiffness.axis;
  const bool alike = axis.maxCoeff() - axis.minCoeff() < 0.01 * axis.maxCoeff();
  return fmt::format("{} leave{} {}", encoder ? "delay and encoder" : "the delay", encoder ? "" : "s",
                     alike ? fmt::format("{:.2g} N/mm along each axis", axis.x())
                           : fmt::format("{:.2g} N/mm to the right, {:.2g} away from you and {:.2g} upwards",
                                         axis.x(), axis.y(), axis.z()));
}

std::string stiffness_sentence(const haptics::StableStiffness& stiffness) {
  const bool encoder = stiffness.by_encoder.minCoeff() < stiffness.by_delay;
  return fmt::format("of the published {:.2g} N/mm {}: {}", stiffness.published, remaining_stiffness(stiffness),
                     encoder
                         ? "the encoder's counts allow no more with the friction that was measured"
                         : fmt::format("a force reaches the hand {:.1f} ms after its tick", 1e3 * stiffness.delay));
}

anatomy::DeviceLimits with_stiffness(const haptics::StableStiffness& stiffness,
                                     const haptics::WorkspaceSettings& workspace, const anatomy::NeedlePath& path,
                                     anatomy::DeviceLimits limits) {
  if (!(stiffness.weakest() > 0.0)) return limits;
  limits.stiffness = stiffness.along(workspace.rotation.transpose() * path.direction(), widest_redirection);
  limits.lateral_stiffness = stiffness.weakest() < limits.stiffness ? stiffness.weakest() : 0.0;
  return limits;
}

}  // namespace bodkin::station
