#include "cli/perform_screen.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "station/station.h"
#include <fmt/format.h>

#include "anatomy/breathing.h"
#include "cli/terminal_keys.h"
#include "training/planning_rules.h"
#include "training/procedure_file.h"

namespace bodkin::cli {

namespace {

// "plunger 35.2 kPa 6.21 N", "probe 2.10 N".
std::string text_of_second(const station::SecondStatus& second) {
  if (second.role == session::SecondRole::probe) return fmt::format("probe {:5.2f} N", second.sample.force);
  return fmt::format("plunger {:5.1f} kPa {:5.2f} N", 1000.0 * second.sample.pressure, second.sample.force);
}

// The line of the terminal.
std::string text_of_status(const station::StationStatus& status, const anatomy::TissueLibrary& library) {
  const haptics::ServoSnapshot& servo = status.servo;
  const simulation::TickOutput& now = status.needle.output;
  const double force = now.requested.force.norm();
  const auto bar = static_cast<std::size_t>(std::clamp(std::lround(2.0 * force), 0L, 20L));
  const char* const hold = servo.frozen ? ", held" : servo.clutched ? ", clutch" : "";
  const char* const sight = status.needle.unseen ? ", NOT SEEN" : "";
  const char* const place = status.needle.past_points ? ", PAST THE POINTS OF ITS LINE, draw back" : "";
  std::string text = fmt::format("{}{}{}  {:5.1f} mm  {:5.2f} N [{:<20}] {}{}", haptics::text_of(servo.state), hold,
                                 sight, now.depth, force, std::string(bar, '='), library.title(now.tissue), place);
  if (status.plunger_pressed) text += "  plunger pressed";
  if (status.needle.other.finger) text += "  finger";
  if (status.needle.other.breath_held) text += now.drawn_in > 0.0 ? "  breathing out" : "  breath held";
  for (std::size_t i = 0; i < status.diagnostic_names.size(); ++i) {
    if (status.diagnostic_names[i].name == "csf_height_mm")
      text += fmt::format("  {:4.1f} cm", 0.1 * now.diagnostics[i]);
    if (status.diagnostic_names[i].name == "csf_collected_mm3")
      text += fmt::format(" {:4.1f} mL", 0.001 * now.diagnostics[i]);
  }
  if (status.second) text += "  " + text_of_second(*status.second);
  return text;
}

void apply_key(char key, station::Station& station, bool plunger_pressed) {
  if (key == ' ') station.command(station::StationCommand::toggle_hold);
  if (key == 'c') station.command(station::StationCommand::toggle_clutch);
  if (key == 'a') station.command(station::StationCommand::arm);
  if (key == 'd') station.command(station::StationCommand::disarm);
  if (key == 'b')
    station.command(plunger_pressed ? station::StationCommand::release_plunger
                                    : station::StationCommand::press_plunger);
  if (key == 'f') station.command(station::StationCommand::turn_finger);
  if (key == 's') station.command(station::StationCommand::turn_stylet);
  if (key == 'm') station.command(station::StationCommand::turn_manometer);
  if (key == 'h') station.command(station::StationCommand::turn_breath);
  if (key == 'q') station.command(station::StationCommand::end);
}

}  // namespace

PerformScreen::PerformScreen(Console& console, double longest)
    : console_(console), line_(console.progress()), longest_(longest) {}

void PerformScreen::note(const std::string& sentence) {
  console_.clear_bar();
  console_.note(sentence);
}

void PerformScreen::end_as_practised(const anatomy::Case& patient) {
  const training::Procedure procedure = training::procedure_of_case(patient.description.procedure.name);
  ending_ = training::completing_tissue(procedure);
  const std::optional<anatomy::NeedlePath>& plan = patient.description.procedure.path;
  taken_out_ = {procedure, patient, plan ? std::optional(plan->target) : std::nullopt};
}

void PerformScreen::follow_completion(station::Station& station, const station::StationStatus& status) {
  if (ending_.empty()) return;
  const anatomy::TissueProperties* const tissue = station.patient().library.find(ending_);
  if (tissue == nullptr || !contact_.has_punctured()) return;
  const auto entered = std::find_if(status.events.begin(), status.events.end(), [tissue](const auto& each) {
    return each.event.kind == forces::EventKind::tissue_entered && each.event.tissue == tissue->id;
  });
  if (entered == status.events.end()) return;
  ending_.clear();
  note(fmt::format("the tip touched the {} {:.1f} mm below the skin: the attempt is complete", tissue->title,
                   entered->event.depth));
  station.end();
}

void PerformScreen::follow_taken_out(station::Station& station, const station::StationStatus& status) {
  if (has_ended_) return;
  const simulation::TickOutput& now = status.needle.output;
  const bool has_needle = !status.needle.other.finger;
  Vec3 tip = status.needle.needle.translation() - status.needle.coupling_offset;
  if (const auto& breathing = station.patient().description.breathing)
    tip = anatomy::BreathField(*breathing).material(tip, now.drawn_in);
  taken_out_.follow({.time = status.time,
                     .is_inside = contact_.has_punctured() && has_needle,
                     .is_outside = !contact_.is_touching() && has_needle && !status.needle.unseen,
                     .tissue = contact_.is_touching() ? now.tissue : anatomy::tissue::air,
                     .tip = tip,
                     .events = status.events});
  if (taken_out_.remaining() != 0.0) return;
  has_ended_ = true;
  note("the needle was taken out: the attempt is complete");
  station.end();
}

void PerformScreen::update(station::Station& station, const station::StationStatus& status) {
  contact_.update(status.needle.output, status.events);
  follow_completion(station, status);
  follow_taken_out(station, status);
  while (const std::optional<char> key = keys_ == nullptr ? std::nullopt : keys_->next())
    apply_key(*key, station, status.plunger_pressed);
  if (!line_) return;
  std::string text = text_of_status(status, station.patient().library);
  if (const std::optional<double> left = taken_out_.remaining())
    text += fmt::format("  OUT, ends in {:.0f} s", std::ceil(*left));
  line_(text, status.time / longest_);
}

}  // namespace bodkin::cli
