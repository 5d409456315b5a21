// The probe in the hand, without an attempt.
#include <QApplication>
#include <QLabel>
#include <QTest>
#include <QWheelEvent>
#include <fstream>

#include "app/main_window.h"
#include "app/models/data_folder.h"
#include "app/pages/ultrasound.h"
#include <gtest/gtest.h>

namespace bodkin::app {
namespace {

class ScanWindow : public testing::Test {
 protected:
  void open(station::UltrasoundRequest request) {
    request.lines = 64;
    request.samples = 128;
    window_.resize(1280, 720);
    window_.show();
    CaseModel cases(data_folder());
    window_.scan(cases.built_in_folder(), request, data_folder() / "snap");
    ASSERT_TRUE(QTest::qWaitFor([&] { return view().scan() != nullptr && !view().scan()->screen().empty(); }, 120000))
        << window_.findChild<QLabel*>("ultrasound.line")->text().toStdString();
  }
  const UltrasoundView& view() { return *window_.findChild<UltrasoundView*>("ultrasound.view"); }
  void key(int code, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(window_.focusWidget(), static_cast<Qt::Key>(code), modifiers);
  }

  MainWindow window_{data_folder()};
};

void make_built_in_patient() {
  CaseModel cases(data_folder());
  if (std::filesystem::exists(cases.built_in_folder() / "case.xml")) return;
  cases.open_built_in();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !cases.status().is_busy; }, 120000));
}

TEST_F(ScanWindow, every_key_of_the_machine_does_its_work) {
  make_built_in_patient();
  ASSERT_NO_FATAL_FAILURE(open({}));
  EXPECT_TRUE(view().shows_ct());
  EXPECT_EQ(window_.practice().state(), State::no_case) << "no attempt, no session";
  const station::LiveScan& scan = *view().scan();
  const imaging::UltrasoundSettings before = scan.settings();
  key(Qt::Key_D);
  EXPECT_EQ(scan.settings().depth, before.depth + 10.0);
  key(Qt::Key_G, Qt::ShiftModifier);
  EXPECT_EQ(scan.settings().gain, before.gain - 2.0);
  key(Qt::Key_R);
  EXPECT_EQ(scan.settings().dynamic_range, before.dynamic_range + 5.0);
  key(Qt::Key_O);
  EXPECT_EQ(scan.settings().focus, before.focus + 5.0);
  key(Qt::Key_Q);
  EXPECT_GT(scan.settings().frequency, 0.0);
  key(Qt::Key_T);
  EXPECT_TRUE(scan.sliders_shown());
  key(Qt::Key_3);
  EXPECT_EQ(scan.settings().sliders[2], 2.0);
  key(Qt::Key_0);
  EXPECT_EQ(scan.settings().sliders[2], 0.0);
  // Space freezes, because no needle is held.
  key(Qt::Key_Space);
  EXPECT_TRUE(scan.screen().frozen());
  key(Qt::Key_F);
  EXPECT_FALSE(scan.screen().frozen());
  key(Qt::Key_N);
  ASSERT_TRUE(scan.needle().has_value());
  const double depth = scan.needle_depth();
  QTest::keyPress(window_.focusWidget(), Qt::Key_PageDown);
  EXPECT_TRUE(QTest::qWaitFor([&] { return scan.needle_depth() > depth + 1.0; }, 60000));
  QTest::keyRelease(window_.focusWidget(), Qt::Key_PageDown);
  key(Qt::Key_H);
  EXPECT_TRUE(scan.help());
  key(Qt::Key_Escape);
  EXPECT_FALSE(scan.help()) << "Escape closes the list first";
}

TEST_F(ScanWindow, the_picture_follows_the_probe_and_the_needle) {
  make_built_in_patient();
  station::UltrasoundRequest request;
  request.needle = true;
  request.needle_depth = 30.0;
  ASSERT_NO_FATAL_FAILURE(open(request));
  const station::LiveScan& scan = *view().scan();
  EXPECT_NEAR(scan.needle_depth(), 30.0, 1e-9);
  const auto shows_where_the_probe_is = [&] {
    return scan.screen().moment().pose.matrix() == scan.pose().matrix() &&
           scan.screen().moment().needle == scan.needle_words();
  };
  ASSERT_TRUE(QTest::qWaitFor(shows_where_the_probe_is, 60000));
  const Pose before = scan.pose();
  QTest::keyPress(window_.focusWidget(), Qt::Key_Up);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !scan.pose().isApprox(before, 1e-6); }, 60000));
  QTest::keyRelease(window_.focusWidget(), Qt::Key_Up);
  EXPECT_TRUE(QTest::qWaitFor(shows_where_the_probe_is, 60000));
}

TEST_F(ScanWindow, s_saves_the_picture_under_the_next_free_name) {
  make_built_in_patient();
  ASSERT_NO_FATAL_FAILURE(open({}));
  std::ofstream(data_folder() / "snap-1.png") << "taken";
  key(Qt::Key_S);
  EXPECT_TRUE(QTest::qWaitFor([] { return std::filesystem::exists(data_folder() / "snap-2.png"); }, 60000));
  EXPECT_NE(view().scan()->message().find("snap-2.png"), std::string::npos) << view().scan()->message();
}

TEST_F(ScanWindow, a_probe_that_there_is_not_is_one_sentence_in_the_page) {
  make_built_in_patient();
  window_.show();
  CaseModel cases(data_folder());
  station::UltrasoundRequest request;
  request.probe = "X9-9";
  window_.scan(cases.built_in_folder(), request, {});
  auto* const line = window_.findChild<QLabel*>("ultrasound.line");
  EXPECT_TRUE(QTest::qWaitFor([&] { return line->text().contains("X9-9"); }, 60000)) << line->text().toStdString();
}

}  // namespace
}  // namespace bodkin::app
