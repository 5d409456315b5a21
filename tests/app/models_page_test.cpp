// The wizard of the force model's numbers, in the window.
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QSlider>
#include <QTest>
#include <filesystem>
#include <optional>
#include <system_error>

#include "app/frame_clock.h"
#include "app/main_window.h"
#include "app/models/data_folder.h"
#include "app/pages/models.h"
#include <gtest/gtest.h>

namespace bodkin::app {
namespace {

class ModelsWindow : public testing::Test {
 protected:
  void SetUp() override {
    forget_drafts();
    ASSERT_TRUE(open(window_)) << window_.practice().failure();
    find<QComboBox>("models.model")->setCurrentIndex(find<QComboBox>("models.model")->findData("layered"));
    emit find<QComboBox>("models.model")->activated(find<QComboBox>("models.model")->currentIndex());
    QTest::qWait(50);
  }
  static void forget_drafts() {
    std::error_code none_yet;
    for (const auto& patient : std::filesystem::recursive_directory_iterator(data_folder(), none_yet))
      if (patient.path().filename() == "models.draft.json") std::filesystem::remove(patient.path());
  }
  static bool open(MainWindow& window) {
    window.resize(1280, 720);
    window.show();
    QTest::mouseClick(window.findChild<QWidget*>(QStringLiteral("start.models")), Qt::LeftButton);
    const auto* const page = window.findChild<ModelsPage*>("models");
    return QTest::qWaitFor([&] { return page->isVisible() && page->model() != nullptr; }, 120000);
  }
  template <typename Widget>
  Widget* find(const char* name) {
    auto* const found = window_.findChild<Widget*>(QLatin1String(name));
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  ModelsPage& page() { return *window_.findChild<ModelsPage*>("models"); }
  void key(int code, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(window_.focusWidget(), static_cast<Qt::Key>(code), modifiers);
  }

  MainWindow window_{data_folder()};
};

TEST_F(ModelsWindow, steps_by_keys_and_a_slider_change_the_curve_within_a_moment) {
  EXPECT_EQ(find<QListWidget>("models.steps")->count(), 11);
  EXPECT_EQ(find<QLabel>("models.number")->text(), "Step 1 of 11");
  find<ProfileChart>("models.chart");
  QTest::qWait(300);
  key(Qt::Key_Right);
  key(Qt::Key_Right);
  EXPECT_EQ(find<QLabel>("models.number")->text(), "Step 3 of 11");
  const double before = page().model()->value(2);
  const QImage picture = find<ProfileChart>("models.chart")->grab().toImage();
  auto* const slider = find<QSlider>("models.slider");
  slider->setValue(slider->maximum() * 9 / 10);
  const double after = page().model()->value(2);
  EXPECT_GT(after, before);
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return find<ProfileChart>("models.chart")->grab().toImage() != picture; }, 60000));
  EXPECT_NEAR(find<QDoubleSpinBox>("models.value")->value(), after, 1e-9);
  EXPECT_TRUE(find<QLabel>("models.cue")->text().startsWith("higher"));
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(page().model()->value(2), before);
  key(Qt::Key_Up, Qt::ShiftModifier);
  EXPECT_NEAR(page().model()->value(2), before + 10.0 * page().model()->steps()[2].grain, 1e-9);
}

TEST_F(ModelsWindow, what_is_practised_feels_the_new_number) {
  find<QListWidget>("models.steps")->setCurrentRow(2);
  auto* const value = find<QDoubleSpinBox>("models.value");
  value->setValue(2.5);
  ASSERT_NEAR(page().model()->value(2), 2.5, 1e-9);
  QTest::mouseClick(find<QWidget>("models.use"), Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window_.practice().state() == State::ready; }, 60000));
  EXPECT_FALSE(page().isVisible());
  // Inserts until the skin gives way, at the set force. The clock's frame comes after the window has processed it.
  std::optional<double> skin_gave_way_at;  // N
  QObject::connect(&window_.clock(), &FrameClock::frame, &window_, [&] {
    for (const session::SessionEvent& event : window_.practice().frame().events) {
      if (event.event.kind == forces::EventKind::puncture && !skin_gave_way_at) skin_gave_way_at = event.event.value;
    }
  });
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        if (!skin_gave_way_at) window_.practice().push(1.0, false);
        return window_.practice().state() == State::in_tissue && skin_gave_way_at;
      },
      60000));
  EXPECT_NEAR(skin_gave_way_at.value_or(0.0), 2.5, 0.05) << "the skin as it came gives way at 1.3 N";
}

TEST_F(ModelsWindow, what_was_changed_is_there_again_when_the_window_was_closed_and_undone_in_one_step) {
  find<QListWidget>("models.steps")->setCurrentRow(2);
  const double as_it_came = page().model()->value(2);
  find<QDoubleSpinBox>("models.value")->setValue(2.5);
  find<QListWidget>("models.steps")->setCurrentRow(5);
  find<QDoubleSpinBox>("models.value")->setValue(0.75);
  window_.close();
  MainWindow another(data_folder());
  ASSERT_TRUE(open(another)) << another.practice().failure();
  const auto* const page = another.findChild<ModelsPage*>("models");
  EXPECT_EQ(page->model()->model(), "layered");
  EXPECT_NEAR(page->model()->value(2), 2.5, 1e-9);
  EXPECT_NEAR(page->model()->value(5), 0.75, 1e-9);
  EXPECT_TRUE(another.findChild<QLabel*>("models.line")->text().contains(QStringLiteral("are restored")));
  QTest::keyClick(another.focusWidget(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_NEAR(page->model()->value(2), as_it_came, 1e-9);
  EXPECT_FALSE(page->model()->is_changed());
  another.close();  // nothing differs any more
  MainWindow last(data_folder());
  ASSERT_TRUE(open(last)) << last.practice().failure();
  EXPECT_FALSE(last.findChild<ModelsPage*>("models")->model()->can_undo());
}

}  // namespace
}  // namespace bodkin::app
