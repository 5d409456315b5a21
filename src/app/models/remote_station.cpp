#include "app/models/remote_station.h"

#include <algorithm>
#include <array>
#include <deque>
#include <mutex>
#include <utility>

#include "link/contents.h"
#include "link/needle_state.h"
#include "link/skin_sheet.h"
#include "session/tick_codec.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "io/digest.h"
#include "io/xml_writer.h"

namespace bodkin::app {

namespace {

using nlohmann::json;
using Values = std::vector<std::pair<std::string, std::string>>;
constexpr std::size_t force_columns = 6;

std::string text_in(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

double number_in(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? found->get<double>() : 0.0;
}

bool flag_in(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_boolean() && found->get<bool>();
}

std::optional<haptics::GuardState> guard_of(const std::string& text) {
  using haptics::GuardState;
  for (const GuardState each :
       {GuardState::disarmed, GuardState::ramping, GuardState::active, GuardState::holding, GuardState::faulted}) {
    if (haptics::text_of(each) == text) return each;
  }
  return std::nullopt;
}

haptics::GuardReason reason_of(const std::string& text) {
  for (int i = 0; i < static_cast<int>(haptics::GuardReason::count_of_reasons); ++i) {
    const auto each = static_cast<haptics::GuardReason>(i);
    if (haptics::text_of(each) == text) return each;
  }
  return haptics::GuardReason::none;
}

std::optional<training::Grade> grade_of(const std::string& text) {
  using training::Grade;
  for (const Grade each : {Grade::pass, Grade::borderline, Grade::fail, Grade::dangerous}) {
    if (training::name_of(each) == text) return each;
  }
  return std::nullopt;
}

AttemptResult result_in(const json& score, double time_in_body) {
  AttemptResult result;
  result.verdict = grade_of(text_in(score, "verdict"));
  result.reached = flag_in(score, "reached");
  result.headline = text_in(score, "headline");
  if (const auto findings = score.find("findings"); findings != score.end() && findings->is_array()) {
    for (const json& each : *findings) result.remarks.push_back(text_in(each, "sentence"));
  }
  result.deepest = number_in(score, "deepest_mm");
  result.peak_force = number_in(score, "peak_force_N");
  result.target_distance = number_in(score, "final_distance_mm");
  result.bone_contacts = static_cast<int>(number_in(score, "bone_contacts"));
  result.time_in_body = time_in_body;
  return result;
}

}  // namespace

struct RemoteStation::Shared {
  Shared(const link::ClientSettings& server, std::shared_ptr<const OpenCase> patient_here, bool starts)
      : patient(std::move(patient_here)),
        starts_left(starts ? 2 : 0),
        sheet(patient->patient),
        client(server, {.message = [this](const link::Message& message) { take(message); },
                        .connected = [this](link::Client&) { begin(); }}) {}

  // A new connection: data of an older one are not current.
  void begin() {
    const std::lock_guard lock(mutex);
    fresh = {};
    is_known = deforms = false;
    skin.clear();
  }

  void take(const link::Message& message) noexcept {
    try {
      const std::lock_guard lock(mutex);
      if (message.type == "TRANSFORM" && message.device == "NeedleTipToReference") {
        fresh.needle.needle = link::read_transform(message.content);
        has_pose = true;
      } else if (message.type == "TRANSFORM" && message.device == "ProbeToReference") {
        probe = link::read_transform(message.content);
      } else if (message.type == "NDARRAY" && message.device == "NeedleState") {
        take_state(link::read_needle_state(message.content));
      } else if (message.type == "NDARRAY" && message.device == "Force") {
        take_forces(link::read_array(message.content));
      } else if (message.type == "IMAGE" && message.device == "Image_Reference") {
        take_picture(link::read_image(message.content));
      } else if (message.type == "POLYDATA" && message.device == "Skin") {
        skin = link::read_surface_points(message.content);
      } else if (message.type == "STRING") {
        take_text(message.device, link::read_string(message.content));
      }
    } catch (const std::exception&) {
      return;  // an unreadable message is ignored; the next one corrects it
    }
  }

  void take_state(const link::NeedleState& state) {
    simulation::TickOutput& output = fresh.needle.output;
    fresh.time = state.time;
    output.depth = state.depth;
    output.velocity = state.velocity;
    output.requested.force = state.requested;
    output.applied.force = state.applied;
    output.resistance = state.resistance;
    output.constraint = state.constraint;
    output.energy = state.energy;
    output.tissue = state.tissue;
    output.in_contact = state.in_contact;
    output.drawn_in = state.drawn_in;
    output.diagnostics = {};
    const std::size_t count = std::min(state.diagnostics.size(), output.diagnostics.size());
    std::copy_n(state.diagnostics.begin(), count, output.diagnostics.begin());
    fresh.servo.limits = state.limits;
    fresh.timings.ticks = state.ticks;
    fresh.timings.overruns = state.late_ticks;
    fresh.timings.recent_success = state.recent_success;
    fresh.needle.ticks = std::max<std::uint64_t>(state.ticks, 1);
    has_state = true;
    if (state.in_contact && state.depth > 0.0 && state.time > last_time && last_time > 0.0)
      time_in_body += state.time - last_time;
    last_time = state.time;
  }

  void take_forces(const link::NumberArray& rows) {
    if (rows.size.size() != 2 || rows.size[1] != force_columns) return;
    for (std::size_t at = 0; at + force_columns <= rows.values.size(); at += force_columns) {
      if (samples.size() >= StationUpdate::most_samples) return;
      const double* const row = &rows.values[at];
      const auto tissue = row[5] >= 0.0 && row[5] <= 255.0 ? static_cast<anatomy::TissueId>(row[5]) : 0;
      samples.push_back({row[0], row[1], row[2], row[3], row[4], static_cast<anatomy::TissueId>(tissue)});
    }
  }

  void take_picture(link::GreyImage image) {
    auto picture = std::make_shared<station::LiveImage>();
    picture->number = ++pictures;
    picture->frame.width = image.width;
    picture->frame.height = image.height;
    picture->frame.pixel = image.pixel;
    picture->frame.pixels = std::move(image.pixels);
    picture->frame.contact = 1.0;
    picture->setup.probe = probe.value_or(image.pose);
    picture->frame.corner = picture->setup.probe.inverse() * image.pose.translation();
    picture->needle = fresh.needle.needle;
    fresh.ultrasound = std::move(picture);
  }

  void take_text(const std::string& device, const std::string& text) {
    if (device.starts_with("ACK_")) return take_reply(text);
    const json object = json::parse(text, nullptr, false);
    if (!object.is_object()) return;
    if (device == "Case") return take_case(object);
    if (device == "Score") {
      score = result_in(object, time_in_body);
      return;
    }
    if (device == "Event") return take_event(object);
    if (device != "State") return;
    const std::string guard = text_in(object, "guard");
    waits = guard == "waiting";
    fresh.servo.state = guard_of(guard).value_or(haptics::GuardState::disarmed);
    fresh.servo.fault = reason_of(text_in(object, "fault"));
    fresh.servo.frozen = flag_in(object, "held");
    fresh.servo.clutched = flag_in(object, "clutched");
    fresh.message = text_in(object, "message");
    trouble = text_in(object, "trouble");
    const double hand = number_in(object, "other_hand");
    if (hand >= 0.0 && hand <= 255.0)
      fresh.needle.other = simulation::OtherHand::from_byte(static_cast<unsigned>(hand)).value_or(fresh.needle.other);
    if (waits) has_state = has_pose = false;
    if (waits && starts_left == 2) start();
  }

  // First the station's own case, then the case of this name in its folder of cases.
  void start() {
    const bool is_first = starts_left-- == 2;
    const Values no_name, by_name = {{"Case", patient->folder.filename().string()}};
    send("StartProcedure", is_first ? no_name : by_name);
  }

  void take_reply(const std::string& text) {
    if (text.find("Status=\"SUCCESS\"") != std::string::npos) return;
    if (waits && starts_left == 1) start();
  }

  void take_case(const json& about) {
    if (here.empty()) here = io::volume_digest(patient->patient.tissues);
    if (const std::string there = text_in(about, "tissues_digest"); there != here) {
      wrong_patient = fmt::format(
          "the station at {} has another patient ('{}') than {}; open the case that it has, a copy of its folder",
          client.place(), text_in(about, "case"), patient->folder.string());
      return;
    }
    is_known = true;
    deforms = flag_in(about, "deformable_body");
    const auto columns = about.find("needle_state_columns");
    if (columns == about.end() || !columns->is_array()) return;
    names.clear();
    for (std::size_t i = link::needle_state_fixed_columns; i < columns->size(); ++i)
      names.push_back((*columns)[i].is_string() ? (*columns)[i].get<std::string>() : std::string());
  }

  void take_event(const json& object) {
    const std::optional<forces::EventKind> kind = session::event_kind_of(text_in(object, "event"));
    if (!kind) return;
    session::SessionEvent event;
    event.tick = static_cast<std::uint64_t>(std::max(0.0, number_in(object, "tick")));
    event.event = {*kind, static_cast<anatomy::TissueId>(std::clamp(number_in(object, "tissue_id"), 0.0, 255.0)),
                   number_in(object, "depth_mm"), number_in(object, "value")};
    events.push_back(event);
  }

  void send(const std::string& name, const Values& values) {
    io::XmlWriter xml;
    xml.open("Command");
    xml.attribute("Name", name);
    for (const auto& [key, value] : values) xml.attribute(key, value);
    xml.close();
    const std::string number = fmt::format("CMD_{}", ++commands);
    client.send({"STRING", number, link::time_now(), link::string_content(xml.finish())});
  }

  std::mutex mutex;  // guards the state shared with the client
  std::shared_ptr<const OpenCase> patient;
  int starts_left;            // ways of asking for a session not yet tried
  std::string here;           // fingerprint of the patient's tissues
  std::string wrong_patient;  // why they are not the station's
  bool is_known = false;      // the station has announced this patient
  bool waits = false;         // no session runs there
  std::string trouble;        // why the last requested session did not run there
  bool has_state = false, has_pose = false;
  StationUpdate fresh;
  std::vector<station::HandSample> samples;
  std::vector<session::SessionEvent> events;
  std::deque<std::string> names;  // of the diagnostics
  std::optional<Pose> probe;
  link::SkinSheet sheet;     // at rest
  bool deforms = false;      // the station's body is a deformable one
  std::vector<Vec3> skin;    // where the points of the sheet are now
  std::vector<Vec3> points;  // that are followed
  std::optional<AttemptResult> score;
  std::uint64_t pictures = 0, commands = 0;
  double last_time = 0.0, time_in_body = 0.0;
  link::Client client;  // last: its thread ends first
};

RemoteStation::RemoteStation(const link::ClientSettings& server, std::shared_ptr<const OpenCase> patient, bool starts)
    : shared_(std::make_unique<Shared>(server, std::move(patient), starts)) {}

RemoteStation::~RemoteStation() = default;

void RemoteStation::command(station::StationCommand command) {
  using station::StationCommand;
  switch (command) {
    case StationCommand::arm:
      return shared_->send("Arm", {});
    case StationCommand::disarm:
      return shared_->send("Disarm", {});
    case StationCommand::toggle_hold:
      return shared_->send("Freeze", {});
    case StationCommand::toggle_clutch:
      return shared_->send("Clutch", {});
    case StationCommand::press_plunger:
      return shared_->send("Plunger", {{"On", "true"}});
    case StationCommand::release_plunger:
      return shared_->send("Plunger", {{"On", "false"}});
    case StationCommand::turn_finger:
      return shared_->send("Finger", {});
    case StationCommand::turn_stylet:
      return shared_->send("Stylet", {});
    case StationCommand::turn_manometer:
      return shared_->send("Manometer", {});
    case StationCommand::turn_breath:
      return shared_->send("HoldBreath", {});
    case StationCommand::end:
      return end();
  }
}

void RemoteStation::set_scan_setup(const station::ScanSetup& setup) {
  shared_->send("SetUsParameter", {{"DepthMm", fmt::format("{}", setup.settings.depth)},
                                   {"GainDb", fmt::format("{}", setup.settings.gain)},
                                   {"FrequencyMhz", fmt::format("{}", setup.settings.frequency)},
                                   {"FocusMm", fmt::format("{}", setup.settings.focus)}});
}

void RemoteStation::follow_points(std::vector<Vec3> points) {
  const std::lock_guard lock(shared_->mutex);
  shared_->points = std::move(points);
}

void RemoteStation::end() {
  shared_->send("StopRecording", {});
}

void RemoteStation::poll(StationUpdate& news) {
  using Phase = StationUpdate::Phase;
  Shared& shared = *shared_;
  const link::ClientStatus status = shared.client.status();
  const bool is_connected = status.state == link::ClientState::connected;
  const std::lock_guard lock(shared.mutex);
  const Phase before = news.phase;
  const auto results = std::move(news.result);
  news = shared.fresh;
  news.phase = before;
  news.result = results;
  news.device = shared.client.place();
  news.samples = std::exchange(shared.samples, {});
  news.events = std::exchange(shared.events, {});
  // A rigid body gets the dimple of its force model, as in a session of this program.
  if (shared.deforms && !shared.skin.empty() && !shared.points.empty())
    news.displacements = shared.sheet.displacements_at(shared.points, shared.skin);
  news.diagnostic_names.clear();
  for (const std::string& name : shared.names) news.diagnostic_names.push_back({name, name});
  if (!is_connected) {
    news.connection = status.sentence.empty() ? fmt::format("Connecting to {}", news.device)
                                              : fmt::format("Not connected: {}. Trying again", status.sentence);
  }
  const bool runs = is_connected && shared.is_known && shared.has_state && shared.has_pose;
  if (!runs) {  // outdated data are not shown
    news.needle.ticks = 0;
    news.needle.output.in_contact = false;
  }
  if (!shared.wrong_patient.empty()) {
    news.phase = Phase::failed;
    news.error = shared.wrong_patient;
  } else if (shared.score) {
    news.result = shared.score;
    news.phase = Phase::finished;
  } else if (runs) {
    news.phase = Phase::running;
  } else if (before != Phase::running) {
    news.phase = Phase::preparing;
    news.stage =
        !is_connected ? news.connection
        : shared.waits && !shared.trouble.empty()
            ? fmt::format("{} waits, because the last session could not be started: {}", news.device, shared.trouble)
        : shared.waits ? fmt::format("{} waits for a session to be started there", news.device)
                       : fmt::format("{} prepares", news.device);
  } else if (shared.waits) {
    news.phase = Phase::finishing;
  }
}

}  // namespace bodkin::app
