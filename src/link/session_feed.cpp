#include "link/session_feed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "link/contents.h"
#include "link/needle_state.h"
#include "session/tick_codec.h"
#include "station/station.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/settings_check.h"
#include "io/digest.h"

namespace bodkin::link {

namespace {

constexpr std::size_t force_columns = 6;
constexpr double visible_motion = 0.05;  // mm

// LPS to RAS.
Vec3 in_ras(const Vec3& vector) {
  return {-vector.x(), -vector.y(), vector.z()};
}

// The tissues that the planned path meets, for a side view: JSON of [title, colour, depth of its beginning in mm], to
// slightly behind the target.
nlohmann::ordered_json layers_of(const anatomy::Case& patient, const anatomy::NeedlePath& path) {
  constexpr double step = 0.25, beyond = 15.0;  // mm
  nlohmann::ordered_json layers = nlohmann::ordered_json::array();
  std::optional<anatomy::TissueId> before;
  for (double depth = 0.0; depth <= path.length() + beyond; depth += step) {
    const auto here = anatomy::nearest<anatomy::TissueId>(patient.tissues, path.entry + depth * path.direction(),
                                                          anatomy::tissue::air);
    if (here == before) continue;
    before = here;
    const anatomy::TissueProperties* tissue = patient.library.find(here);
    layers.push_back(
        {patient.library.title(here), fmt::format("#{:06x}", tissue == nullptr ? 0U : tissue->colour), depth});
  }
  return layers;
}

// In tissue that has been pushed ahead.
Pose needle_in_body(const station::HandSnapshot& needle) {
  Pose pose = needle.needle;
  pose.translation() -= needle.coupling_offset;
  return pose;
}

}  // namespace

SessionFeed::SessionFeed(Server& server, station::StationObserver& screen,
                         const std::optional<station::UltrasoundChoice>& ultrasound, double rate,
                         std::vector<WatchedStep> steps, std::optional<forces::ModelSettings> models)
    : server_(server),
      screen_(screen),
      rate_(rate),
      steps_(std::move(steps)),
      commands_(ultrasound, std::move(models)) {
  constexpr double highest_rate = 240.0;
  check_range("", "rate", rate, {1.0, highest_rate}, "Hz");
}

std::vector<Vec3> SessionFeed::prepare(const anatomy::Case& patient, const fem::BodyDescription* body) {
  tissues_ = io::volume_digest(patient.tissues);
  deforms_ = body != nullptr;
  skin_ = SkinSheet(patient);
  std::vector<Vec3> points = screen_.prepare(patient, body);
  screen_points_ = points.size();
  if (body != nullptr) points.insert(points.end(), skin_.rest().begin(), skin_.rest().end());
  return points;
}

std::chrono::milliseconds SessionFeed::interval() const {
  return std::min(screen_.interval(), std::chrono::milliseconds(static_cast<int>(1000.0 / rate_)));
}

void SessionFeed::update(station::Station& station, const station::StationStatus& status) {
  if (!std::exchange(has_begun_, true)) commands_.begin(station);
  const std::span<const float> moved = status.displacements;
  const std::size_t of_screen = std::min(moved.size(), 3 * screen_points_);
  if (of_screen == moved.size()) {
    screen_.update(station, status);
  } else {
    station::StationStatus seen = status;
    seen.displacements = moved.first(of_screen);
    screen_.update(station, seen);
  }
  contact_.update(status.needle.output, status.events);
  const double now = time_now();
  if (const ServerCounts counts = server_.counts(); counts.accepted != greeted_) {
    greeted_ = counts.accepted;
    state_.clear();
    greet(station.patient(), status.diagnostic_names, now);
  }
  const anatomy::TissueLibrary& library = station.patient().library;
  send_poses(status, now);
  send_forces(status, now);
  send_skin(status, moved.subspan(of_screen), now);
  send_events(status, library, now);
  steps_.update(status.samples, status.events, library);
  send_state(status, library, now);
  if (status.ultrasound != nullptr && status.ultrasound->number != picture_) send_picture(*status.ultrasound, now);
  answer(station, status, now);
  for (const std::string& sentence : server_.take_notes()) screen_.note(sentence);
}

// The constant data: the patient and the plan.
void SessionFeed::greet(const anatomy::Case& patient, std::span<const forces::DiagnosticName> diagnostics,
                        double now) {
  const anatomy::CaseDescription& about = patient.description;
  nlohmann::ordered_json json;
  json["case"] = about.name;
  json["procedure"] = about.procedure.name;
  json["needle"] = {{"gauge", about.needle.gauge},
                    {"outer_diameter_mm", about.needle.outer_diameter},
                    {"length_mm", about.needle.length},
                    {"tip", anatomy::to_string(about.needle.tip)}};
  json["rate_hz"] = about.haptics.rate;
  json["tissues_digest"] = tissues_;
  json["deformable_body"] = deforms_;
  json["needle_state_columns"] = needle_state_columns(diagnostics);
  json["force_columns"] = {"time_s", "depth_mm", "force_N", "resistance_N", "constraint_N", "tissue"};
  if (about.procedure.path) {
    json["path_mm"] = about.procedure.path->length();
    json["layers"] = layers_of(patient, *about.procedure.path);
  }
  server_.publish({"STRING", "Case", now, string_content(json.dump())}, false);
  if (!skin_.empty())
    server_.publish({"POLYDATA", "Skin", now, surface_content(skin_.rest(), skin_.triangles(), {})}, true);
  if (!about.procedure.path) return;
  const anatomy::NeedlePath& path = *about.procedure.path;
  const std::array<NamedPoint, 2> points = {
      {{.name = "entry", .group = "plan", .colour = {46, 230, 197, 255}, .place = path.entry, .radius = 2.0},
       {.name = "target", .group = "plan", .colour = {46, 230, 197, 255}, .place = path.target, .radius = 4.0}}};
  server_.publish({"POINT", "Plan", now, points_content(points)}, false);
  const std::array<Vec3, 2> line = {path.entry, path.target};
  const std::array<int, 2> order = {0, 1};
  server_.publish({"POLYDATA", "PlannedPath", now, surface_content(line, {}, order)}, false);
}

void SessionFeed::send_poses(const station::StationStatus& status, double now) {
  std::vector<TrackedTool> tools = {{"NeedleTipToReference", needle_in_body(status.needle)}};
  if (status.ultrasound != nullptr) tools.push_back({"ProbeToReference", status.ultrasound->setup.probe});
  for (const TrackedTool& tool : tools)
    server_.publish({"TRANSFORM", tool.name, now, transform_content(tool.pose)}, true);
  server_.publish_tracking({"TDATA", "Bodkin", now, tracking_content(tools)});
  server_.publish(
      {"NDARRAY", "NeedleState", now, needle_state_content(needle_state(status, status.diagnostic_names.size()))},
      true);
}

// Every tick of the servo, in batches.
void SessionFeed::send_forces(const station::StationStatus& status, double now) {
  if (status.samples.empty()) return;
  std::vector<double> rows;
  rows.reserve(force_columns * status.samples.size());
  for (const station::HandSample& sample : status.samples) {
    rows.insert(rows.end(), {sample.time, sample.depth, sample.force, sample.resistance, sample.constraint,
                             static_cast<double>(sample.tissue)});
  }
  server_.publish({"NDARRAY", "Force", now, array_content(rows, force_columns)}, false);
  const Vec3 force = in_ras(status.needle.output.applied.force);
  server_.publish({"SENSOR", "ForceOnHand", now, sensor_content({force.data(), 3}, SensorUnit::newton)}, true);
  server_.publish(
      {"SENSOR", "EnergyOfHand", now, sensor_content({&status.needle.output.energy, 1}, SensorUnit::millijoule)},
      true);
}

// While the needle moves the sheet.
void SessionFeed::send_skin(const station::StationStatus& status, std::span<const float> displacements, double now) {
  if (skin_.empty()) return;
  const double dimple = contact_.skin_dimple(status.needle.output, status.diagnostic_names);
  const bool deforms = !displacements.empty() && contact_.is_touching();
  if (!deforms && std::abs(dimple - dimple_) < visible_motion) return;
  dimple_ = dimple;
  const std::vector<Vec3> points = skin_.moved(needle_in_body(status.needle), dimple, displacements);
  server_.publish({"POLYDATA", "Skin", now, surface_content(points, skin_.triangles(), {})}, true);
}

void SessionFeed::send_events(const station::StationStatus& status, const anatomy::TissueLibrary& library,
                              double now) {
  for (const session::SessionEvent& event : status.events) {
    nlohmann::ordered_json json;
    json["tick"] = event.tick;
    json["event"] = session::event_kind_name(event.event.kind);
    json["tissue"] = library.title(event.event.tissue);
    json["tissue_id"] = event.event.tissue;
    json["depth_mm"] = event.event.depth;
    json["value"] = event.event.value;
    server_.publish({"STRING", "Event", now, string_content(json.dump())}, false);
  }
}

// The text of a screen, after each change.
void SessionFeed::send_state(const station::StationStatus& status, const anatomy::TissueLibrary& library,
                             double now) {
  const haptics::ServoSnapshot& servo = status.servo;
  nlohmann::ordered_json json;
  json["guard"] = haptics::text_of(servo.state);
  json["fault"] = servo.state == haptics::GuardState::faulted ? haptics::text_of(servo.fault) : std::string_view();
  json["held"] = servo.frozen;
  json["clutched"] = servo.clutched;
  json["tissue"] = library.title(status.needle.output.tissue);
  json["in_contact"] = status.needle.output.in_contact;
  json["step"] = steps_.title();
  json["step_number"] = steps_.number();
  json["steps"] = steps_.count();
  json["message"] = status.message;
  json["other_hand"] = status.needle.other.byte();
  std::string text = json.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  if (text == state_) return;
  state_ = std::move(text);
  server_.publish({"STRING", "State", now, string_content(state_)}, true);
}

void SessionFeed::send_picture(const station::LiveImage& picture, double now) {
  picture_ = picture.number;
  const imaging::UltrasoundFrame& frame = picture.frame;
  if (frame.width < 1 || frame.height < 1) return;
  server_.publish({"IMAGE", "Image_Reference", now,
                   image_content(frame.pixels, frame.width, frame.height, frame.pixel,
                                 frame.image_to_patient(picture.setup.probe))},
                  true);
}

// Answers requests for images: the list of the available ones, or one of them.
bool SessionFeed::is_query(const Received& received, const anatomy::Case& patient, double now) {
  const std::string& type = received.message.type;
  if (type == "GET_IMGMETA") {
    const ListedImage ct{
        .name = patient.description.name, .device = "CT", .modality = "CT", .size = patient.ct.grid.size};
    server_.send(received.client, {"IMGMETA", received.message.device, now, image_list_content({&ct, 1})});
    return true;
  }
  if (type != "GET_IMAGE" || received.message.device != "CT") return false;
  if (!ct_) ct_.emplace(patient.ct);
  waiting_for_ct_.push_back(received.client);
  return true;
}

void SessionFeed::answer(station::Station& station, const station::StationStatus& status, double now) {
  for (const Received& received : server_.take()) {
    bool success = false;
    std::string sentence;
    try {
      if (is_query(received, station.patient(), now)) continue;
      const std::optional<Command> command = command_of(received.message);
      if (!command) continue;  // a message without meaning here
      SessionCommands::Answer answer = commands_.apply(*command, station, status);
      if (answer.besides) server_.send(received.client, *answer.besides);
      sentence = std::move(answer.sentence);
      success = true;
    } catch (const InputError& error) {
      sentence = error.what();
    }
    server_.send(received.client, reply_to(received.message, success, sentence, now));
  }
  if (waiting_for_ct_.empty() || !ct_->proceed()) return;
  for (const std::uint64_t client : waiting_for_ct_) server_.send_shared(client, "IMAGE CT", ct_->packed());
  waiting_for_ct_.clear();
}

}  // namespace bodkin::link
