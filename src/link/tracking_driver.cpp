#include "link/tracking_driver.h"

#include <atomic>
#include <chrono>
#include <mutex>
#include <string>
#include <thread>

#include "link/client.h"
#include "link/contents.h"
#include "link/tracked_tool.h"
#include <fmt/format.h>

#include "core/error.h"
#include "core/latest_value.h"
#include "haptics/drivers/driver_adapter.h"
#include "haptics/drivers/driver_settings.h"
#include "haptics/drivers/vendor_frame.h"
#include "haptics/tick_clock.h"

namespace bodkin::link {

namespace {

using haptics::DriverFailure;
using haptics::DriverSettings;

struct TrackingSettings {
  ClientSettings server;
  std::string tool = "NeedleTipToReference";
  std::string
      reference;  // to which the tool is taken, in the same tracker's frame: "ReferenceToTracker"; empty: none
  TrackedPlacement placement;
  double rate = 1000.0;        // Hz
  double patience = 0.5;       // s without a pose; 0: for ever
  double first_pose = 5.0;     // s to wait for when the device is opened
  std::uint32_t interval = 0;  // ms between requested TDATA; 0: none requested
};

std::optional<Mat3> axes_of_tracker(const std::string& text) {
  Mat3 axes = Mat3::Zero();
  std::size_t at = 0;
  for (int row = 0; row < 3; ++row) {
    if (row > 0 && (at >= text.size() || text[at++] != ',')) return std::nullopt;
    const bool negative = at < text.size() && text[at] == '-';
    at += negative ? 1 : 0;
    if (at >= text.size() || text[at] < 'x' || text[at] > 'z') return std::nullopt;
    axes(row, text[at++] - 'x') = negative ? -1.0 : 1.0;
  }
  if (at != text.size() || axes.determinant() < 0.5) return std::nullopt;
  return axes;
}

TrackingSettings tracking_settings(const std::string& identity, const char* words) {
  const DriverSettings given(
      words, {"reference", "frame", "axes", "points", "middle_x_mm", "middle_y_mm", "middle_z_mm", "patient_x_mm",
              "patient_y_mm", "patient_z_mm", "rate_Hz", "patience_ms", "first_pose_s", "tdata_ms"});
  constexpr double farthest = 1e4;  // mm
  TrackingSettings settings;
  const std::size_t slash = identity.find('/');
  try {
    const std::string server = identity.substr(0, slash);
    if (!server.empty()) settings.server = parse_server(server, "the tracker");
  } catch (const InputError& error) {
    throw DriverFailure(BODKIN_BAD_SETTINGS, error.what());
  }
  if (slash != std::string::npos) settings.tool = identity.substr(slash + 1);
  if (settings.tool.empty() || settings.tool.size() > 20) {
    throw DriverFailure(BODKIN_BAD_SETTINGS,
                        fmt::format("the tool is '{}', expected a name of 1 to 20 letters, as in "
                                    "openigtlink:localhost:18944/NeedleTipToReference",
                                    settings.tool.substr(0, 60)));
  }
  settings.reference = given.text("reference", "");
  if (settings.reference.size() > 20 || settings.reference == settings.tool) {
    throw DriverFailure(BODKIN_BAD_SETTINGS,
                        fmt::format("the setting reference is '{}', expected another tool of at most 20 letters, as "
                                    "ReferenceToTracker of a tracked mannequin",
                                    settings.reference.substr(0, 60)));
  }
  const std::string frame = given.text("frame", "patient");
  if (frame != "patient" && frame != "hand") {
    throw DriverFailure(BODKIN_BAD_SETTINGS,
                        fmt::format("the setting frame is '{}', expected patient (the reference is the patient's CT) "
                                    "or hand (the tracker's own axes)",
                                    frame));
  }
  settings.placement.frame = frame == "hand" ? TrackedFrame::hand : TrackedFrame::patient;
  const std::string axes = given.text("axes", "x,y,z"), points = given.text("points", "z");
  const auto own_axes = axes_of_tracker(axes);
  if (!own_axes) {
    throw DriverFailure(BODKIN_BAD_SETTINGS,
                        fmt::format("the setting axes is '{}', expected each of x, y and z once with its sign, not "
                                    "mirrored, as in x,-z,y: what goes to the right, away and up",
                                    axes));
  }
  const auto tool = tool_along(points);
  if (!tool) {
    throw DriverFailure(
        BODKIN_BAD_SETTINGS,
        fmt::format("the setting points is '{}', expected x, y, z, -x, -y or -z: the tool's axis from hub to tip",
                    points));
  }
  settings.placement.axes = *own_axes;
  settings.placement.tool = *tool;
  // The session defines the patient's middle (station::settings_about), the user the tracker's.
  const std::string whose = frame == "hand" ? "middle" : "patient";
  settings.placement.middle.x() = given.number(whose + "_x_mm", 0.0, -farthest, farthest);
  settings.placement.middle.y() = given.number(whose + "_y_mm", 0.0, -farthest, farthest);
  settings.placement.middle.z() = given.number(whose + "_z_mm", 0.0, -farthest, farthest);
  settings.rate = given.number("rate_Hz", 1000.0, 200.0, 4000.0);
  settings.patience = 1e-3 * given.number("patience_ms", 500.0, 0.0, 60000.0);
  settings.first_pose = given.number("first_pose_s", 5.0, 0.1, 15.0);
  settings.interval = static_cast<std::uint32_t>(given.number("tdata_ms", 0.0, 0.0, 1000.0));
  if (settings.patience > 0.0) {
    constexpr std::chrono::milliseconds least{2000};
    const auto twice = std::chrono::milliseconds(static_cast<int>(2e3 * settings.patience));
    settings.server.silence = std::max(least, twice);
  }
  return settings;
}

// Asks a tracker for TDATA: ms between two, and the name of the coordinates.
Message tracking_request(std::uint32_t interval) {
  constexpr std::size_t coordinates = 32;
  ByteWriter writer;
  writer.u32(interval);
  writer.field("Reference", coordinates);
  return {"STT_TDATA", "", time_now(), writer.take()};
}

class TrackingDevice : public haptics::OpenDevice {
 public:
  explicit TrackingDevice(const TrackingSettings& settings)
      : settings_(settings),
        client_(settings.server, {.message = [this](const Message& message) { take(message); },
                                  .connected =
                                      [this](Client& client) {
                                        if (settings_.interval > 0) client.send(tracking_request(settings_.interval));
                                      }}) {}

  // Throws DriverFailure if none arrived in time.
  void wait_for_first_pose() {
    using Clock = std::chrono::steady_clock;
    for (const auto begin = Clock::now(); poses_.load() == 0;) {
      if (Clock::now() - begin > std::chrono::duration<double>(settings_.first_pose))
        throw DriverFailure(BODKIN_NOT_CONNECTED, trouble());
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }

  void start(bodkin_tick, void*) override { seen_ = 0; }
  void stop() override {}

  int exchange(const bodkin_command&, bodkin_state& state) noexcept override {
    const double now = haptics::monotonic_seconds();
    const Reading& reading = readings_.read();
    if (reading.number != seen_) {
      if (seen_ == 0)
        motion_.begin(reading.pose, reading.time);
      else
        motion_.take(reading.pose, reading.time);
      seen_ = reading.number;
    }
    const Pose pose = motion_.at(now);
    state = haptics::blank_state();
    Eigen::Map<Vec3>(state.position) = pose.translation();
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(state.rotation) = pose.linear();
    const bool lost = settings_.patience > 0.0 && now - reading.time > settings_.patience;
    return lost ? BODKIN_COMMUNICATION_LOST : BODKIN_OK;
  }

  std::string explain() override {
    return client_.status().state == ClientState::connected ? trouble()
                                                            : trouble() + " (it is tried again every second)";
  }

 private:
  struct Reading {
    Pose pose = Pose::Identity();  // operator's frame
    double time = 0.0;             // s, monotonic, of its arrival
    std::uint64_t number = 0;
  };

  void take(const Message& message) noexcept {
    try {
      const double now = haptics::monotonic_seconds();
      if (!settings_.reference.empty()) {
        if (const std::optional<Pose> found = pose_of_tool(message, settings_.reference)) {
          reference_ = found;
          reference_time_ = now;
        }
      }
      std::optional<Pose> pose = pose_of_tool(message, settings_.tool);
      if (!pose) return;
      if (!settings_.reference.empty()) {
        if (!reference_ || (settings_.patience > 0.0 && now - reference_time_ > settings_.patience)) return;
        // Both arrive with the tracker's axes turned to LPS, which their quotient undoes.
        pose = turn_axes(reference_->inverse() * *pose);
      }
      const std::uint64_t number = poses_.load() + 1;
      readings_.write({settings_.placement.to_operator(*pose), now, number});
      poses_.store(number);
    } catch (const std::exception& error) {
      const std::lock_guard lock(mutex_);
      refused_ = error.what();
    }
  }

  std::string trouble() const {
    const ClientStatus status = client_.status();
    if (status.state != ClientState::connected)
      return status.sentence.empty() ? client_.place() + " does not answer" : status.sentence;
    const std::lock_guard lock(mutex_);
    if (!refused_.empty()) return refused_;
    return fmt::format("{} is connected but sends no {}{}: is the tool in sight, and is that its name?",
                       client_.place(), settings_.tool,
                       settings_.reference.empty() ? "" : " with " + settings_.reference);
  }

  TrackingSettings settings_;
  LatestValue<Reading> readings_;
  std::atomic<std::uint64_t> poses_{0};
  std::optional<Pose> reference_;  // of the client's thread
  double reference_time_ = 0.0;    // s, monotonic, of its arrival
  TrackedMotion motion_;
  std::uint64_t seen_ = 0;
  mutable std::mutex mutex_;
  std::string refused_;  // the last message that was no pose
  Client client_;        // last: its thread ends first
};

struct Tracking {
  static constexpr const char* name = "openigtlink";
  static constexpr const char* summary = "a tool of PLUS, 3D Slicer or another tracking server; no force";

  static void list(const char* text, const haptics::DeviceSink& found) {
    tracking_settings({}, text);
    found("HOST:PORT/TOOL", "any tool of a server that you name: localhost:18944/NeedleTipToReference");
  }

  static std::unique_ptr<haptics::OpenDevice> open(const std::string& identity, const char* text,
                                                   bodkin_abilities& abilities) {
    const TrackingSettings settings = tracking_settings(identity, text);
    auto device = std::make_unique<TrackingDevice>(settings);
    device->wait_for_first_pose();
    haptics::copy_text("tracked " + settings.tool, abilities.name, BODKIN_TEXT);
    abilities.rate = settings.rate;
    abilities.measures_rotation = 1;
    return device;
  }
};

}  // namespace

const bodkin_driver& tracking_driver() noexcept {
  static constexpr bodkin_driver driver = haptics::driver_of<Tracking>();
  return driver;
}

}  // namespace bodkin::link
