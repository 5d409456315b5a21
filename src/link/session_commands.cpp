#include "link/session_commands.h"

#include <tuple>

#include "link/contents.h"
#include "link/model_parameters.h"
#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::link {

namespace {

// On="true" of a command, or the opposite of `now`.
bool wanted(const Command& command, bool now) {
  const auto found = command.values.find("On");
  if (found == command.values.end()) return !now;
  if (found->second == "true" || found->second == "1") return true;
  if (found->second == "false" || found->second == "0") return false;
  throw InputError(
      fmt::format("On of the command {} is '{}', expected true or false", command.name, found->second.substr(0, 40)));
}

// PLUS sets the gain in percent of the machine's range.
Range gain_range() {
  using imaging::UltrasoundSettings;
  Range range;
  const auto look_at = [&range](const auto& parameter) {
    if (parameter.member == &UltrasoundSettings::gain) range = parameter.range;
  };
  for_each_item(UltrasoundSettings::parameters(), look_at);
  return range;
}

double gain_of_percent(double percent) {
  const Range range = gain_range();
  return range.low + 0.01 * percent * (range.high - range.low);
}

double percent_of_gain(double gain) {
  const Range range = gain_range();
  return 100.0 * (gain - range.low) / (range.high - range.low);
}

}  // namespace

void SessionCommands::begin(station::Station& station) {
  if (models_) apply_models(station);
}

bool SessionCommands::apply_models(station::Station& station) const {
  if (anatomy::body_of(station.patient().description.haptics.resistance) != nullptr) return false;
  station.change_numbers(models_->haptics, models_->tissues);
  return true;
}

SessionCommands::Answer SessionCommands::apply(const Command& command, station::Station& station,
                                               const station::StationStatus& status) {
  const std::string& name = command.name;
  if (name == "StopRecording")
    return station.command(station::StationCommand::end), Answer{"the session ends and is saved", {}};
  if (name == "Reset") {
    again_ = true;
    station.command(station::StationCommand::end);
    return {"the session ends, is saved, and begins again", {}};
  }
  if (name == "RequestChannelIds") return {"Bodkin", {}};
  if (name == "RequestDeviceIds")
    return {ultrasound_ ? "NeedleTipToReference,ProbeToReference,Image_Reference,CT" : "NeedleTipToReference,CT", {}};
  if (name == "StartProcedure" || name == "StartRecording" || name == "LoadCase")
    throw InputError("a session runs already and is recorded; StopRecording ends it, Reset begins it again");
  if (name == "GetModelParameters") return report_parameters(command, station);
  if (name == "SetModelParameter") {
    forces::ModelSettings changed = models_ ? *models_ : forces::model_settings(station.patient());
    std::string sentence = set_parameter(changed, command);
    models_ = std::move(changed);
    sentence += apply_models(station) ? "" : " from Reset on: a deformable body keeps what it was prepared with";
    return {std::move(sentence), {}};
  }
  if (name == "SetUsParameter" || name == "GetUsParameter")
    return {apply_to_ultrasound(command, station, status), {}};
  return {apply_to_needle(command, station, status), {}};
}

std::string SessionCommands::apply_to_needle(const Command& command, station::Station& station,
                                             const station::StationStatus& status) {
  using station::StationCommand;
  const haptics::ServoSnapshot& servo = status.servo;
  if (command.name == "Freeze") {
    const bool on = wanted(command, servo.frozen);
    if (on != servo.frozen) station.command(StationCommand::toggle_hold);
    return on ? "the needle is held" : "the needle follows the hand";
  }
  if (command.name == "Clutch") {
    const bool on = wanted(command, servo.clutched);
    if (on != servo.clutched) station.command(StationCommand::toggle_clutch);
    return on ? "the hand is free" : "the needle follows the hand";
  }
  if (command.name == "Arm") return station.command(StationCommand::arm), "the force is armed";
  if (command.name == "Disarm") return station.command(StationCommand::disarm), "the force fades";
  if (command.name == "Plunger") {
    const bool on = wanted(command, status.plunger_pressed);
    station.command(on ? StationCommand::press_plunger : StationCommand::release_plunger);
    return on ? "the thumb is on the plunger" : "the thumb is off the plunger";
  }
  if (command.name == "Finger")
    return station.command(StationCommand::turn_finger), "the finger takes the place of the needle, or gives it back";
  if (command.name == "Stylet")
    return station.command(StationCommand::turn_stylet), "the stylet comes out of the needle, or goes back";
  if (command.name == "Manometer")
    return station.command(StationCommand::turn_manometer), "the manometer is connected, or taken off";
  if (command.name == "HoldBreath") {
    const bool on = wanted(command, status.needle.other.breath_held);
    if (on != status.needle.other.breath_held) station.command(StationCommand::turn_breath);
    return on ? "the patient is asked to hold the breath" : "the patient breathes again";
  }
  throw InputError(fmt::format(
      "the command {} is not known; expected Freeze, Clutch, Plunger, Finger, Stylet, Manometer, HoldBreath, Arm, "
      "Disarm, StopRecording, Reset, RequestChannelIds, RequestDeviceIds, GetModelParameters, SetModelParameter, "
      "SetUsParameter or GetUsParameter",
      command.name));
}

std::string SessionCommands::apply_to_ultrasound(const Command& command, station::Station& station,
                                                 const station::StationStatus& status) {
  if (!ultrasound_ || status.ultrasound == nullptr)
    throw InputError("this session has no ultrasound; start bodkin serve with --ultrasound PROBE");
  station::ScanSetup setup = setup_.value_or(status.ultrasound->setup);
  setup.probe = status.ultrasound->setup.probe;
  if (command.name == "GetUsParameter") {
    return fmt::format("DepthMm={:g},GainDb={:g},GainPercent={:g},FrequencyMhz={:g},FocusMm={:g}",
                       setup.settings.depth, setup.settings.gain, percent_of_gain(setup.settings.gain),
                       setup.settings.frequency, setup.settings.focus);
  }
  for (const auto& [name, value] : command.values) {
    if (name == "DepthMm")
      setup.settings.depth = command.number(name);
    else if (name == "GainDb")
      setup.settings.gain = command.number(name);
    else if (name == "GainPercent")
      setup.settings.gain = gain_of_percent(command.number(name));
    else if (name == "FrequencyMhz")
      setup.settings.frequency = command.number(name);
    else if (name == "FocusMm")
      setup.settings.focus = command.number(name);
    else if (name != "UsDeviceId")
      throw InputError(
          fmt::format("{} is not a setting of the ultrasound; expected DepthMm, GainDb, GainPercent, FrequencyMhz or "
                      "FocusMm",
                      name.substr(0, 40)));
  }
  imaging::check(setup.settings, ultrasound_->probe);
  station.set_scan_setup(setup);
  setup_ = setup;
  return "the ultrasound is set";
}

// A STRING has at most 65,535 bytes, so one part of the model at a time.
SessionCommands::Answer SessionCommands::report_parameters(const Command& command, const station::Station& station) {
  const auto part = command.values.find("Part");
  const std::string text = parameters_json(models_ ? *models_ : forces::model_settings(station.patient()),
                                           part == command.values.end() ? "resistance" : part->second);
  return {"they are in the STRING ModelParameters",
          Message{"STRING", "ModelParameters", time_now(), string_content(text)}};
}

}  // namespace bodkin::link
