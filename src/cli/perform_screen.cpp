#include "cli/perform_screen.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "desktop/keys.h"
#include "station/station.h"
#include <fmt/format.h>

namespace bodkin::cli {

namespace {

constexpr std::chrono::milliseconds terminal_interval{100};
constexpr std::chrono::milliseconds window_interval{4};  // the pointer of a window must not lag

desktop::WindowScene scene_of(const station::StationStatus& status, const anatomy::Case& patient) {
  const haptics::ServoSnapshot& servo = status.servo;
  const station::HandSnapshot& now = status.needle;
  const anatomy::NeedlePath& path = *patient.description.procedure.path;
  const Vec3 along = path.direction(), from_entry = servo.needle.translation() - path.entry;
  desktop::WindowScene scene;
  scene.time = status.time;
  scene.force = now.output.requested.force.norm();
  scene.depth = now.output.depth;
  scene.tissue = patient.library.title(now.output.tissue);
  scene.state = haptics::text_of(servo.state);
  scene.hold = servo.frozen ? "held" : servo.clutched ? "clutch" : "";
  scene.message =
      now.corridor_left ? "the deformable body is not prepared here: draw the needle back" : status.message;
  scene.beside = (from_entry - along * along.dot(from_entry)).norm();
  scene.angle = std::acos(std::clamp(along.dot(needle_axis(servo.needle)), -1.0, 1.0)) * 180.0 / std::numbers::pi;
  scene.needle = now.needle;
  scene.needle.translation() -= now.needle_ahead;
  scene.armed = servo.state != haptics::GuardState::disarmed;
  scene.faulted = servo.state == haptics::GuardState::faulted;
  scene.displacements = status.displacements;
  scene.ultrasound = status.ultrasound;
  scene.probe_is_held = status.probe_is_held;
  return scene;
}

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
  const char* const place = status.needle.corridor_left ? ", NOT PREPARED HERE, draw back" : "";
  std::string text = fmt::format("{}{}  {:5.1f} mm  {:5.2f} N [{:<20}] {}{}", haptics::text_of(servo.state), hold,
                                 now.depth, force, std::string(bar, '='), library.title(now.tissue), place);
  if (status.second) text += "  " + text_of_second(*status.second);
  return text;
}

void apply_key(char key, station::Station& station) {
  if (key == ' ') station.command(station::StationCommand::toggle_hold);
  if (key == 'c') station.command(station::StationCommand::toggle_clutch);
  if (key == 'a') station.command(station::StationCommand::arm);
  if (key == 'd') station.command(station::StationCommand::disarm);
  if (key == 'q') station.command(station::StationCommand::end);
}

}  // namespace

PerformScreen::PerformScreen(Console& console, std::optional<station::UltrasoundChoice> ultrasound, bool has_mouse,
                             double longest)
    : console_(console),
      line_(console.progress()),
      ultrasound_(std::move(ultrasound)),
      has_mouse_(has_mouse),
      longest_(longest) {}

PerformScreen::~PerformScreen() = default;

void PerformScreen::note(const std::string& sentence) {
  console_.clear_bar();
  console_.note(sentence);
}

std::vector<Vec3> PerformScreen::prepare(const anatomy::Case& patient, const fem::BodyDescription* body) {
  if (!has_mouse_ && !ultrasound_) return {};
  window_ = std::make_unique<desktop::MouseWindow>(patient.description.name, ultrasound_.has_value(), has_mouse_);
  if (ultrasound_) {
    window_->show_ultrasound(std::make_unique<desktop::UltrasoundPane>(patient, *ultrasound_, body != nullptr,
                                                                       desktop::MouseWindow::ultrasound_x, 0.0));
  }
  if (body == nullptr) return {};
  auto view = std::make_unique<desktop::BodyView>(patient, body->mesh);
  std::vector<Vec3> points = view->points();
  window_->show_body(std::move(view));
  return points;
}

std::chrono::milliseconds PerformScreen::interval() const {
  return window_ == nullptr ? terminal_interval : window_interval;
}

void PerformScreen::update(station::Station& station, const station::StationStatus& status) {
  while (const std::optional<char> key = keys_ == nullptr ? std::nullopt : keys_->next()) apply_key(*key, station);
  if (window_ != nullptr) {
    window_->poll();
    while (const std::optional<char> key = window_->next_key()) apply_key(*key, station);
    window_->show(scene_of(status, station.patient()));
    if (const desktop::UltrasoundPane* pane = window_->ultrasound()) station.set_scan_order(pane->order());
  }
  if (line_) line_(text_of_status(status, station.patient().library), status.time / longest_);
}

}  // namespace bodkin::cli
