#include "tracking/tool_driver.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "tracking/footage_scene.h"
#include "tracking/registration_file.h"
#include "tracking/tool_camera.h"
#include "tracking/tool_motion.h"
#include <fmt/format.h>

#include "core/error.h"
#include "core/parse_numbers.h"
#include "haptics/drivers/driver_adapter.h"
#include "haptics/drivers/driver_settings.h"
#include "haptics/drivers/vendor_frame.h"
#include "haptics/tick_clock.h"

namespace bodkin::tracking {

namespace {

using haptics::DriverFailure;
using haptics::DriverSettings;

constexpr double tip_noise = 0.1;  // mm, of a tracked tip at rest: the analogue of an encoder's count

struct ToolSettings {
  FootageFiles files;
  std::filesystem::path registration;
  std::string tool = "needle";
  std::optional<anatomy::NeedlePath> path;
  Vec3 middle = Vec3::Zero();  // LPS mm, of the operator's frame
  double rate = 1000.0;        // Hz
  double first_pose = 10.0;    // s
};

ToolSettings tool_settings(const std::string& identity, const char* words) {
  const DriverSettings given(
      words, {"camera", "bodies", "registration", "body", "pictures_per_s", "rate_Hz", "first_pose_s", "entry_mm",
              "target_mm", "patient_x_mm", "patient_y_mm", "patient_z_mm"});
  constexpr double farthest = 1e4;  // mm
  ToolSettings settings;
  settings.files = {identity, given.text("camera", ""), given.text("bodies", ""),
                    given.number("pictures_per_s", 30.0, 1.0, 1000.0)};
  settings.registration = given.text("registration", "");
  settings.tool = given.text("body", settings.tool);
  settings.rate = given.number("rate_Hz", settings.rate, 200.0, 4000.0);
  settings.first_pose = given.number("first_pose_s", settings.first_pose, 0.1, 15.0);
  // The session defines the patient's place (station::settings_about).
  settings.middle = {given.number("patient_x_mm", 0.0, -farthest, farthest),
                     given.number("patient_y_mm", 0.0, -farthest, farthest),
                     given.number("patient_z_mm", 0.0, -farthest, farthest)};
  const std::string entry = given.text("entry_mm", ""), target = given.text("target_mm", "");
  try {
    if (!entry.empty() || !target.empty())
      settings.path = anatomy::NeedlePath{parse_point(entry, "the setting entry_mm"),
                                          parse_point(target, "the setting target_mm")};
  } catch (const InputError& error) {
    throw DriverFailure(BODKIN_BAD_SETTINGS, error.what());
  }
  return settings;
}

// Cameras that this program's drivers hold open, each by its key.
struct OpenCameras {
  std::mutex lock;
  std::vector<std::pair<std::string, std::weak_ptr<ToolCamera>>> all;
};

OpenCameras& open_cameras() {
  static OpenCameras cameras;
  return cameras;
}

// Settings for opening a camera, and the place of its mannequin.
std::string key_of(const ToolSettings& settings) {
  const auto whole = [](const std::filesystem::path& file) {
    std::error_code code;
    return file.empty() ? std::string() : std::filesystem::weakly_canonical(file, code).string();
  };
  std::string key = fmt::format("{}|{}|{}|{}", whole(settings.files.source), whole(settings.files.camera),
                                whole(settings.files.bodies), whole(settings.registration));
  if (!settings.registration.empty() || !settings.path) return key;
  for (const Vec3& point : {settings.path->entry, settings.path->target})
    key += fmt::format("|{:.3f},{:.3f},{:.3f}", point.x(), point.y(), point.z());
  return key;
}

Similarity place_of(const ToolSettings& settings) {
  if (!settings.registration.empty()) return read_registration(settings.registration).fixed_from_moving;
  return placed_along(settings.path.value_or(anatomy::NeedlePath{Vec3::Zero(), -Vec3::UnitY()}), scene_skin());
}

// Its sightings may come from a window that shows the same images; then there is no camera.
struct ToolSource {
  std::shared_ptr<ToolCamera> camera;
  std::shared_ptr<ToolSightings> sightings;
};

ToolSource open_source_of(const ToolSettings& settings, bool anew) {
  const std::string key = key_of(settings);
  const std::lock_guard guard(open_cameras().lock);
  if (std::shared_ptr<ToolSightings> shown = announced(settings.files.source)) return {nullptr, std::move(shown)};
  std::erase_if(open_cameras().all, [](const auto& each) { return each.second.expired(); });
  for (const auto& [name, held] : open_cameras().all) {
    if (anew || name != key) continue;
    if (std::shared_ptr<ToolCamera> camera = held.lock()) return {camera, camera->sightings()};
  }
  const Similarity place = place_of(settings);
  auto camera = std::make_shared<ToolCamera>(open_footage_files(settings.files), place, settings.files.source);
  open_cameras().all.emplace_back(key, camera);
  return {camera, camera->sightings()};
}

class TrackedTool : public haptics::OpenDevice {
 public:
  explicit TrackedTool(ToolSettings settings) : settings_(std::move(settings)) {
    open(false);
    wait_for_first_pose();
  }

  void start(bodkin_tick, void*) override {
    if (started_ && !feed_->live()) {
      feed_.reset();
      source_ = {};
      open(true);
      wait_for_first_pose();
    }
    started_ = true;
    // Footage from its beginning; a camera from now on.
    feed_ = source_.sightings->follow(settings_.tool);
    motion_.start(first_.pose, begin_);
    last_ = 0.0;
  }
  void stop() override {}

  int exchange(const bodkin_command&, bodkin_state& state) noexcept override {
    constexpr double longest_step = 0.1;  // s
    const double now = haptics::monotonic_seconds();
    const double elapsed = last_ > 0.0 ? std::min(now - last_, longest_step) : 0.0;
    last_ = now;
    const ToolMotion::Place& place = motion_.step(*feed_, now, elapsed);
    seen_.store(place.seen, std::memory_order_relaxed);
    state = haptics::blank_state();
    Eigen::Map<Vec3>(state.position) = to_operator_ * (place.pose.translation() - settings_.middle);
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(state.rotation) = to_operator_ * place.pose.linear();
    state.buttons = (place.seen ? 0U : BODKIN_BUTTON_UNSEEN) | (place.over ? BODKIN_BUTTON_END : 0U);
    return feed_->failed() ? BODKIN_COMMUNICATION_LOST : BODKIN_OK;
  }

  // In normal operation, the remarks about the images.
  std::string explain() override {
    return seen_.load(std::memory_order_relaxed) && !feed_->failed() ? feed_->note() : feed_->trouble();
  }

 private:
  void open(bool anew) {
    try {
      source_ = open_source_of(settings_, anew);
      feed_ = source_.sightings->follow(settings_.tool);
    } catch (const InputError& error) {
      throw DriverFailure(BODKIN_BAD_SETTINGS, error.what());
    } catch (const SystemError& error) {
      throw DriverFailure(BODKIN_NOT_CONNECTED, error.what());
    }
  }

  void wait_for_first_pose() {
    using Clock = std::chrono::steady_clock;
    std::size_t pictures = 0;
    for (const auto begin = Clock::now();;) {
      const bool ended = feed_->ended();
      while (feed_->next(first_)) {
        if (pictures++ == 0) begin_ = first_.time;
        if (first_.unseen == UnknownPlace::no) return;
      }
      const bool late = feed_->live() && Clock::now() - begin > std::chrono::duration<double>(settings_.first_pose);
      const bool none = !feed_->live() && pictures >= ToolFeed::capacity;
      if (feed_->failed()) throw DriverFailure(BODKIN_NOT_CONNECTED, feed_->trouble());
      if (ended || late || none) {
        throw DriverFailure(BODKIN_NOT_CONNECTED,
                            fmt::format("{}: the {} was not seen in {} pictures: {}", settings_.files.source,
                                        settings_.tool, pictures, pictures == 0 ? "none came" : feed_->trouble()));
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }

  ToolSettings settings_;
  // Right, away and up for an operator who stands at the feet of a prone patient (station/hand_session.h).
  Mat3 to_operator_ = haptics::rows(-Vec3::UnitX(), Vec3::UnitZ(), Vec3::UnitY());
  ToolSource source_;
  std::shared_ptr<ToolFeed> feed_;
  ToolSighting first_;
  double begin_ = 0.0;  // s, of footage
  ToolMotion motion_;
  std::atomic<bool> seen_{true};  // by the exchange before; first_ was
  double last_ = 0.0;             // s, monotonic, of the exchange before
  bool started_ = false;
};

struct Tracked {
  static constexpr const char* name = "tracked";
  static constexpr const char* summary = "a real needle or probe with markers, seen by a camera; no force";

  static void list(const char* text, const haptics::DeviceSink& found) {
    tool_settings({}, text);
    found("SOURCE", "a camera (/dev/video0), a video or a folder of pictures that you name");
  }

  static std::unique_ptr<haptics::OpenDevice> open(const std::string& identity, const char* text,
                                                   bodkin_abilities& abilities) {
    const ToolSettings settings = tool_settings(identity, text);
    if (identity.empty()) {
      throw DriverFailure(BODKIN_BAD_SETTINGS,
                          "no pictures are named; expected a camera, a video or a folder, as tracked:/dev/video0");
    }
    auto device = std::make_unique<TrackedTool>(settings);
    haptics::copy_text("tracked " + settings.tool, abilities.name, BODKIN_TEXT);
    abilities.rate = settings.rate;
    abilities.measures_rotation = 1;
    abilities.resolution = tip_noise;
    return device;
  }
};

}  // namespace

const bodkin_driver& tool_driver() noexcept {
  static constexpr bodkin_driver driver = haptics::driver_of<Tracked>();
  return driver;
}

}  // namespace bodkin::tracking
