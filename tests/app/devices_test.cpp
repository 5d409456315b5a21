// The page of devices in a window, with drivers that need no hardware.
#include "app/pages/devices.h"

#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <QTest>
#include <filesystem>
#include <functional>

#include "app/main_window.h"
#include "app/models/data_folder.h"
#include <gtest/gtest.h>

#include "io/calibrations_file.h"

namespace bodkin::app {
namespace {

TEST(DeviceRows, a_missing_library_is_told_with_what_mends_it_and_cannot_be_opened) {
  station::DriverAnswer answer;
  answer.driver = answer.name = "force_dimension";
  answer.summary = "omega, delta, sigma";
  answer.fault = haptics::DeviceFault::not_installed;
  answer.sentence = "libdrd.so was not found; install the SDK";
  const std::vector<DeviceRow> rows = rows_of(answer);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].lamp, DeviceRow::Lamp::trouble);
  EXPECT_EQ(rows[0].sentence, answer.sentence);
  EXPECT_FALSE(rows[0].can_open());
}

TEST(DeviceRows, each_device_that_is_found_is_a_row_and_none_at_all_is_one_too) {
  station::DriverAnswer answer;
  answer.driver = answer.name = "example";
  EXPECT_EQ(rows_of(answer)[0].lamp, DeviceRow::Lamp::off);
  answer.devices = {{"0", "Left"}, {"1", "Right"}};
  const std::vector<DeviceRow> rows = rows_of(answer);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[1].identity, "1");
  EXPECT_TRUE(rows[1].can_open());
}

class Devices : public testing::Test {
 protected:
  void SetUp() override {
    QSettings().clear();
    window_ = std::make_unique<MainWindow>(data_folder());
    window_->resize(1280, 720);
    window_->show();
    page_ = window_->findChild<DevicesPage*>(QStringLiteral("devices"));
    window_->show_page(PageId::devices);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !page_->is_looking(); }, 60000));
    QTest::qWait(100);
  }
  // Chooses the device of a driver.
  void choose(const std::string& driver) {
    for (std::size_t i = 0; i < page_->rows().size(); ++i) {
      if (page_->rows()[i].driver == driver) return page_->select(static_cast<int>(i));
    }
    FAIL() << driver << " is not in the list";
  }
  void click(const char* name) {
    QTest::mouseClick(window_->findChild<QPushButton*>(QLatin1String(name)), Qt::LeftButton);
  }
  QString text(const char* name) { return window_->findChild<QLabel*>(QLatin1String(name))->text(); }
  bool wait(const std::function<bool()>& until) { return QTest::qWaitFor(until, 60000); }

  std::unique_ptr<MainWindow> window_;
  DevicesPage* page_ = nullptr;
};

TEST_F(Devices, lists_the_mouse_every_driver_and_what_is_missing) {
  ASSERT_GE(page_->rows().size(), 4U);
  EXPECT_TRUE(page_->rows()[0].is_mouse());
  choose("simulated");
  EXPECT_TRUE(window_->findChild<QPushButton*>(QStringLiteral("devices.check"))->isEnabled());
  choose("force_dimension");  // whose library is not installed here
  EXPECT_FALSE(text("devices.sentence").isEmpty());
  EXPECT_FALSE(window_->findChild<QPushButton*>(QStringLiteral("devices.use"))->isEnabled());
}

TEST_F(Devices, a_check_shows_the_hand_without_force_and_can_be_cancelled) {
  choose("simulated");
  click("devices.check");
  ASSERT_TRUE(wait([&] { return page_->work().status().is_open && page_->work().status().fraction > 0.01; }));
  EXPECT_TRUE(window_->findChild<QPushButton*>(QStringLiteral("devices.cancel"))->isVisible());
  EXPECT_EQ(page_->work().status().force, 0.0);
  click("devices.cancel");
  ASSERT_TRUE(wait([&] { return !page_->work().status().is_busy; }));
  EXPECT_TRUE(wait([&] { return !text("devices.verdict").isEmpty(); }));
}

TEST_F(Devices, the_calibration_leads_through_its_steps_and_keeps_nothing_when_it_is_cancelled) {
  choose("simulated");
  click("devices.calibrate");
  ASSERT_TRUE(wait([&] { return !page_->work().status().steps.empty(); }));
  EXPECT_TRUE(wait([&] { return text("devices.steps").contains(QStringLiteral("workspace")); }));
  EXPECT_FALSE(text("devices.task").isEmpty());
  click("devices.cancel");
  ASSERT_TRUE(wait([&] { return !page_->work().status().is_busy; }));
  EXPECT_FALSE(std::filesystem::exists(*io::calibrations_file()));
}

TEST_F(Devices, the_device_that_is_used_is_remembered_and_the_mouse_comes_back) {
  choose("simulated");
  click("devices.use");
  ASSERT_TRUE(window_->practice().device().has_value());
  EXPECT_TRUE(window_->practice().device()->choice.is_simulated());
  window_.reset();
  window_ = std::make_unique<MainWindow>(data_folder());
  EXPECT_TRUE(window_->practice().device().has_value());
  page_ = window_->findChild<DevicesPage*>(QStringLiteral("devices"));
  emit page_->use_requested({}, {});
  EXPECT_FALSE(window_->practice().device().has_value());
}

}  // namespace
}  // namespace bodkin::app
