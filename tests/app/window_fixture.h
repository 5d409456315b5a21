#pragma once

#include <QTest>
#include <QWidget>
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

  std::unique_ptr<MainWindow> window_;
};

}  // namespace bodkin::app
