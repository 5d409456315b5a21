#pragma once

#include <QTest>
#include <QWidget>
#include <functional>
#include <memory>

#include "app/main_window.h"
#include "app/models/data_folder.h"
#include <gtest/gtest.h>

namespace bodkin::app {

// The main window, open at its start screen, and what a hand does to its widgets.
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
