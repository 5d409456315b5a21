// A device that disconnects during an attempt: no force, a sentence, and continuation with the device or the mouse.
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <atomic>
#include <filesystem>
#include <set>

#include "session/session_file.h"
#include "tests/app/window_fixture.h"
#include <gmock/gmock.h>

#include "haptics/drivers/driver_adapter.h"
#include "haptics/drivers/simulated.h"

namespace bodkin::app {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::atomic<bool> is_pulled_out{false};

// The simulated hand, which can be unplugged.
const bodkin_driver& loose_plug() {
  static const bodkin_driver driver = [] {
    bodkin_driver made = haptics::simulated_driver();
    made.name = "loose_plug";
    made.open = [](const char* identity, const char* settings, void** handle, bodkin_abilities* abilities,
                   char* message) -> int {
      if (!is_pulled_out) return haptics::simulated_driver().open(identity, settings, handle, abilities, message);
      haptics::copy_text("the plug is out", message, BODKIN_MESSAGE);
      return BODKIN_NOT_CONNECTED;
    };
    made.exchange = [](void* handle, const bodkin_command* command, bodkin_state* state) -> int {
      if (is_pulled_out) return BODKIN_NOT_CONNECTED;
      return haptics::simulated_driver().exchange(handle, command, state);
    };
    return made;
  }();
  return driver;
}

class LostDevice : public WindowFixture {
 protected:
  void SetUp() override {
    is_pulled_out = false;
    WindowFixture::SetUp();
    window_->practice().set_device(
        PracticeDevice{{&loose_plug(), "", "speed_mm_s=10 start_mm=10 wait_s=600"}, "Loose plug"});
  }
  QString text(const char* name) { return find<QLabel>(name)->text(); }
  bool push_and_pull_out() {
    if (!wait([&] { return frame().depth > 5.0; }, 60)) return false;
    is_pulled_out = true;
    return wait(State::device_lost, 10);
  }
};

TEST_F(LostDevice, is_said_and_the_attempt_goes_on_with_the_mouse_without_losing_the_session) {
  const std::set<fs::path> before = sessions();
  ASSERT_TRUE(start()) << window_->practice().failure();
  ASSERT_TRUE(push_and_pull_out()) << name_of(window_->practice().state()) << ", " << frame().depth << " mm";
  ASSERT_TRUE(wait([&] { return find("pause")->isVisible(); }, 10));
  EXPECT_EQ(text("pause.title"), QStringLiteral("The device was disconnected"));
  EXPECT_THAT(text("pause.reason").toStdString(), HasSubstr("What was recorded is safe"));
  EXPECT_TRUE(find("pause.mouse")->isVisible());
  click("pause.mouse");
  ASSERT_TRUE(wait(State::ready, 60)) << window_->practice().failure();
  EXPECT_FALSE(window_->practice().device());
  EXPECT_FALSE(find("pause")->isVisible());
  std::set<fs::path> made;
  for (const fs::path& file : sessions())
    if (!before.contains(file)) made.insert(file);
  ASSERT_EQ(made.size(), 2U) << "the attempt before and the one with the mouse";
  double deepest = 0.0;
  for (const fs::path& file : made) {
    const session::Session kept = session::read_session(file);
    for (const auto& tick : kept.ticks) deepest = std::max(deepest, tick.output.depth);
  }
  EXPECT_GT(deepest, 4.9);
}

TEST_F(LostDevice, is_opened_again_as_soon_as_it_is_back_and_until_then_a_sentence_says_what_to_do) {
  ASSERT_TRUE(start()) << window_->practice().failure();
  ASSERT_TRUE(push_and_pull_out()) << name_of(window_->practice().state()) << ", " << frame().depth << " mm";
  click("pause.resume");  // Reconnect, but the plug is still out
  ASSERT_TRUE(wait([&] { return !window_->practice().failure().empty(); }, 60));
  EXPECT_THAT(window_->practice().failure(), HasSubstr("the plug is out"));
  EXPECT_THAT(window_->practice().failure(), HasSubstr("choose the mouse on the page Devices"));
  EXPECT_TRUE(wait([&] { return text("start.line").contains(QStringLiteral("the plug is out")); }, 60));
  is_pulled_out = false;
  ASSERT_TRUE(start()) << window_->practice().failure();
  EXPECT_TRUE(wait([&] { return frame().depth > 2.0; }, 60));
}

}  // namespace
}  // namespace bodkin::app
