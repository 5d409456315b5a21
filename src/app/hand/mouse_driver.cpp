#include "app/hand/mouse_driver.h"

#include <cstdint>
#include <mutex>
#include <utility>

#include "haptics/drivers/driver_adapter.h"
#include "haptics/drivers/driver_settings.h"
#include "haptics/drivers/vendor_frame.h"

namespace bodkin::app {

namespace {

constexpr double device_rate = 1000.0;  // Hz
constexpr double strongest = 15.0;      // N that this hand can feel
constexpr double stiffest = 3.0;        // N/mm that it renders stably, having no motor

// A driver's functions receive only texts, so the window and the device exchange data here.
struct Meeting {
  std::mutex lock;
  std::weak_ptr<MouseFeed> feed;
};

Meeting& meeting() {
  static Meeting one;
  return one;
}

class MouseDevice : public haptics::OpenDevice {
 public:
  explicit MouseDevice(std::shared_ptr<MouseFeed> feed) : feed_(std::move(feed)), hand_(1.0 / device_rate) {
    hand_.start(feed_->goals.read());
  }

  void start(bodkin_tick, void*) override { hand_.start(feed_->goals.read()); }
  void stop() override {}
  std::string explain() override { return {}; }

  int exchange(const bodkin_command& command, bodkin_state& state) noexcept override {
    const haptics::WorkspaceSettings& space = feed_->workspace;
    const HandGoal& goal = feed_->goals.read();
    const Vec3 force = space.rotation * Eigen::Map<const Vec3>(command.force);
    const Pose& needle = hand_.step(goal, force);
    feed_->reports.write(hand_.report());
    const Mat3 to_operator = space.rotation.transpose();
    state = haptics::blank_state();
    Eigen::Map<Vec3>(state.position) = to_operator * (needle.translation() - space.centre);
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(state.rotation) = to_operator * needle.linear();
    Eigen::Map<Vec3>(state.velocity) = to_operator * hand_.velocity();
    if (goal.ended) state.buttons = BODKIN_BUTTON_END;
    return BODKIN_OK;
  }

 private:
  std::shared_ptr<MouseFeed> feed_;
  MouseHand hand_;
};

struct Mouse {
  static constexpr const char* name = "mouse";
  static constexpr const char* summary = "the mouse in the window of bodkin-app";

  static void list(const char* text, const haptics::DeviceSink& found) {
    const haptics::DriverSettings none(text, {});
    found("", "the mouse of this window");
  }

  static std::unique_ptr<haptics::OpenDevice> open(const std::string&, const char* text,
                                                   bodkin_abilities& abilities) {
    const haptics::DriverSettings none(text, {});
    std::shared_ptr<MouseFeed> feed;
    {
      const std::lock_guard lock(meeting().lock);
      feed = meeting().feed.lock();
    }
    if (feed == nullptr) throw haptics::DriverFailure(BODKIN_NOT_CONNECTED, "no window is open that has the mouse");
    haptics::copy_text("mouse", abilities.name, BODKIN_TEXT);
    abilities.peak_force = strongest;
    abilities.continuous_force = strongest;
    abilities.stiffness = stiffest;
    abilities.rate = device_rate;
    abilities.measures_rotation = 1;
    return std::make_unique<MouseDevice>(std::move(feed));
  }
};

}  // namespace

void connect_mouse(const std::shared_ptr<MouseFeed>& feed) {
  const std::lock_guard lock(meeting().lock);
  meeting().feed = feed;
}

const bodkin_driver& mouse_driver() noexcept {
  static constexpr bodkin_driver driver = haptics::driver_of<Mouse>();
  return driver;
}

}  // namespace bodkin::app
