#include "desktop/mouse_driver.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "desktop/mouse_window.h"

#include "core/error.h"
#include "haptics/drivers/driver_adapter.h"
#include "haptics/drivers/driver_settings.h"
#include "haptics/drivers/vendor_frame.h"

namespace bodkin::desktop {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double longest_step = 0.02;  // s; after a stall the needle does not jump

// A driver's functions know nothing but their words, so the window and the device meet here.
struct Meeting {
  std::mutex lock;
  std::weak_ptr<PointerFeed> feed;
};

Meeting& meeting() {
  static Meeting one;
  return one;
}

haptics::PointerSettings read(const char* text) {
  const haptics::DriverSettings settings(
      text, {"pixel_mm", "wheel_mm", "speed_mm_s", "turn_deg", "turn_deg_s", "smoothing_s", "reach_mm"});
  haptics::PointerSettings pointer;
  pointer.pixel = settings.number("pixel_mm", pointer.pixel, 0.001, 10.0);
  pointer.step = settings.number("wheel_mm", pointer.step, 0.01, 20.0);
  pointer.speed = settings.number("speed_mm_s", pointer.speed, 0.1, 200.0);
  pointer.turn = settings.number("turn_deg", pointer.turn / degree, 0.0, 5.0) * degree;
  pointer.turn_speed = settings.number("turn_deg_s", pointer.turn_speed / degree, 0.0, 180.0) * degree;
  pointer.smoothing = settings.number("smoothing_s", pointer.smoothing, 0.01, 1.0);
  pointer.reach = settings.number("reach_mm", pointer.reach, 1.0, 1000.0);
  return pointer;
}

class MouseDevice : public haptics::OpenDevice {
 public:
  MouseDevice(std::shared_ptr<PointerFeed> feed, const haptics::PointerSettings& settings)
      : feed_(std::move(feed)), settings_(settings), hand_(settings) {}

  void start(bodkin_tick, void*) override {
    hand_ = haptics::PointerHand(settings_);
    last_ = Clock::now();
  }
  void stop() override {}
  std::string explain() override { return {}; }

  int exchange(const bodkin_command&, bodkin_state& state) noexcept override {
    const haptics::PointerState& pointer = feed_->read();
    const Clock::time_point now = Clock::now();
    const double dt = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    const Pose& hand = hand_.step(pointer, std::clamp(dt, 0.0, longest_step));
    state = haptics::blank_state();
    Eigen::Map<Vec3>(state.position) = hand.translation();
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(state.rotation) = hand.linear();
    Eigen::Map<Vec3>(state.velocity) = hand_.velocity();
    if (pointer.ended) state.buttons = BODKIN_BUTTON_END;
    return BODKIN_OK;
  }

 private:
  std::shared_ptr<PointerFeed> feed_;
  haptics::PointerSettings settings_;
  haptics::PointerHand hand_;
  Clock::time_point last_;
};

struct Mouse {
  static constexpr const char* name = "mouse";
  static constexpr const char* summary = "mouse and keyboard in a window that shows the force; no force";

  static void list(const char* text, const haptics::DeviceSink& found) {
    read(text);
    const std::string obstacle = MouseWindow::obstacle();
    if (!obstacle.empty()) throw haptics::DriverFailure(BODKIN_NOT_CONNECTED, obstacle);
    found("", "the mouse and the keyboard of this screen");
  }

  static std::unique_ptr<haptics::OpenDevice> open(const std::string&, const char* text,
                                                   bodkin_abilities& abilities) {
    const haptics::PointerSettings settings = read(text);
    std::shared_ptr<PointerFeed> feed;
    {
      const std::lock_guard lock(meeting().lock);
      feed = meeting().feed.lock();
    }
    if (feed == nullptr) throw haptics::DriverFailure(BODKIN_NOT_CONNECTED, "no window is open that has the mouse");
    haptics::copy_text("mouse", abilities.name, BODKIN_TEXT);
    abilities.rate = 1000.0;
    std::fill_n(abilities.workspace_low, 3, -settings.reach);
    std::fill_n(abilities.workspace_high, 3, settings.reach);
    abilities.measures_rotation = 1;
    return std::make_unique<MouseDevice>(std::move(feed), settings);
  }
};

}  // namespace

void connect_mouse(const std::shared_ptr<PointerFeed>& feed) {
  const std::lock_guard lock(meeting().lock);
  meeting().feed = feed;
}

const bodkin_driver& mouse_driver() noexcept {
  static constexpr bodkin_driver driver = haptics::driver_of<Mouse>();
  return driver;
}

}  // namespace bodkin::desktop
