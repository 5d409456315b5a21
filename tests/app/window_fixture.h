#pragma once

#include <QTest>
#include <QWidget>
#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <system_error>

#include "app/main_window.h"
#include "app/models/data_folder.h"
#include <gtest/gtest.h>

namespace bodkin::app {

// The main window, open at its start screen, and user actions on its widgets.
class WindowFixture : public testing::Test {
 protected:
  void SetUp() override { open_window(); }
  void open_window() {
    window_ = std::make_unique<MainWindow>(data_folder());
    window_->resize(1280, 720);
    window_->show();
  }
  template <typename Widget = QWidget>
  Widget* find(const char* name) {
    auto* const found = window_->findChild<Widget*>(QLatin1String(name));
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  void click(const char* name) { QTest::mouseClick(find(name), Qt::LeftButton); }
  void key(int code, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QWidget* const focus = window_->focusWidget();
    QTest::keyClick(focus != nullptr ? focus : window_.get(), static_cast<Qt::Key>(code), modifiers);
  }
  static bool wait(const std::function<bool()>& until, int seconds) { return QTest::qWaitFor(until, 1000 * seconds); }
  bool wait(State state, int seconds) {
    return wait([&] { return window_->practice().state() == state; }, seconds);
  }
  const Frame& frame() { return window_->practice().frame(); }
  // Waits until the hand rests.
  bool settle() {
    Vec3 last = Vec3::Constant(1e9);
    int frames = 0;
    std::uint64_t seen = 0;
    return wait(
        [&] {
          if (frame().number == seen) return false;
          seen = frame().number;
          const Vec3 hand = frame().hand.translation();
          frames = (hand - last).norm() < 0.01 ? frames + 1 : 0;
          last = hand;
          return frames >= 10;
        },
        60);
  }
  // The stored sessions, without the log of a running one.
  static std::set<std::filesystem::path> sessions() {
    std::set<std::filesystem::path> files;
    std::error_code none_yet;
    for (const auto& entry : std::filesystem::directory_iterator(data_folder() / "sessions", none_yet))
      if (entry.path().extension() == ".bodkin") files.insert(entry.path());
    return files;
  }
  // An attempt on the patient that comes with Bodkin.
  bool start() {
    click("start.begin");
    const auto decided = [&] {
      return window_->practice().state() == State::ready || !window_->practice().failure().empty();
    };
    return wait(decided, 120) && window_->practice().failure().empty();
  }

  std::unique_ptr<MainWindow> window_;
};

}  // namespace bodkin::app
