#include "views/ultrasound_view.h"

#include <QApplication>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include "tests/views/made_up.h"
#include <gtest/gtest.h>

#include "imaging/ultrasound/probe.h"

namespace bodkin::views {
namespace {

// A view with a probe on the layered patient's back and a first image.
struct ShownScan {
  UltrasoundView view;
  Frame frame = bodkin_test::frame_at(20.0);
  station::LiveImage picture;
  station::ScanSetup setup;
  int changes = 0;

  explicit ShownScan(int width = 452, int height = 376) {
    view.resize(width, height);
    view.set_case(bodkin_test::layered_patient());
    station::UltrasoundChoice choice;
    choice.settings.depth = 60.0;
    choice.pose = imaging::probe_pose(Vec3(0, 30, 0), -Vec3::UnitY(), Vec3::UnitZ());
    view.set_scan(choice);
    QObject::connect(&view, &UltrasoundView::scan_setup_changed, [this](const station::ScanSetup& changed) {
      setup = changed;
      ++changes;
    });
    picture.number = 1;
    picture.frame.width = picture.frame.height = 100;
    picture.frame.pixel = 0.6;
    picture.frame.corner = Vec3(-29.7, 0.3, 0.0);
    picture.frame.pixels.assign(10000, 90);
    picture.setup = {*choice.pose, choice.settings};
    frame.ultrasound = &picture;
    frame.clock = 1.0;
    view.show_frame(frame, Changes::all());
    changes = 0;
  }
  void key(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(&view, static_cast<Qt::Key>(key), modifiers);
  }
};

TEST(UltrasoundView, shows_the_newest_picture) {
  ShownScan shown;
  ASSERT_NE(shown.view.scan(), nullptr);
  const auto& screen = shown.view.scan()->screen();
  ASSERT_FALSE(screen.empty());
  const Eigen::Vector2d at = screen.to_screen({0.0, 30.0});
  const auto& place = shown.view.scan()->place();
  const QImage drawn = shown.view.grab().toImage();
  const QColor pixel = drawn.pixelColor(static_cast<int>(place.x + at.x()), static_cast<int>(place.y + at.y()));
  EXPECT_NEAR(pixel.red(), 90, 3);
  EXPECT_EQ(pixel.red(), pixel.blue());
}

TEST(UltrasoundView, knobs_and_probe_are_orders_to_the_station) {
  ShownScan shown;
  shown.key(Qt::Key_D);
  EXPECT_EQ(shown.changes, 1);
  EXPECT_EQ(shown.setup.settings.depth, 70.0);
  shown.key(Qt::Key_D, Qt::ShiftModifier);
  EXPECT_EQ(shown.setup.settings.depth, 60.0);
  QWheelEvent wheel(QPointF(200, 200), QPointF(200, 200), QPoint(), QPoint(0, 120), Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  const Vec3 before = shown.view.scan()->pose().translation();
  QApplication::sendEvent(&shown.view, &wheel);
  EXPECT_NEAR((shown.view.scan()->pose().translation() - before).norm(), 0.5, 1e-9)
      << "pressed in by half a millimetre";
  EXPECT_EQ(shown.changes, 3);
}

TEST(UltrasoundView, a_new_attempt_is_told_where_the_probe_is) {
  ShownScan shown;
  shown.key(Qt::Key_D);
  EXPECT_EQ(shown.changes, 1);
  Changes changes;
  changes.attempt = true;
  shown.view.show_frame(shown.frame, changes);
  EXPECT_EQ(shown.changes, 2) << "its station begins where the choice has the probe";
  EXPECT_EQ(shown.setup.settings.depth, 70.0);
}

TEST(UltrasoundView, held_keys_move_the_probe_while_frames_come) {
  ShownScan shown;
  const Pose before = shown.view.scan()->pose();
  QTest::keyPress(&shown.view, Qt::Key_L);
  for (int i = 0; i < 10; ++i) {
    shown.frame.clock += 0.05;
    shown.view.show_frame(shown.frame, {});
  }
  QTest::keyRelease(&shown.view, Qt::Key_L);
  EXPECT_NEAR((shown.view.scan()->pose().translation() - before.translation()).norm(), 10.0, 1.0)
      << "20 mm/s for 0.5 s";
}

TEST(UltrasoundView, in_an_attempt_the_keys_of_the_needle_are_left_to_the_page) {
  ShownScan shown;
  shown.key(Qt::Key_Space);
  EXPECT_FALSE(shown.view.scan()->screen().frozen()) << "space holds the needle";
  shown.key(Qt::Key_F);
  EXPECT_TRUE(shown.view.scan()->screen().frozen());
  shown.frame.state = State::no_case;
  shown.view.show_frame(shown.frame, {});
  shown.key(Qt::Key_Space);
  EXPECT_FALSE(shown.view.scan()->screen().frozen()) << "alone, space freezes as it always did";
}

TEST(UltrasoundView, calipers_measure_what_was_clicked) {
  ShownScan shown;
  shown.key(Qt::Key_C);
  const auto& place = shown.view.scan()->place();
  const auto click = [&](double x, double y) {
    const Eigen::Vector2d at = shown.view.scan()->screen().to_screen({x, y});
    QTest::mouseClick(
        &shown.view, Qt::LeftButton, {},
        QPoint(static_cast<int>(std::lround(place.x + at.x())), static_cast<int>(std::lround(place.y + at.y()))));
  };
  click(-10.0, 20.0);
  click(20.0, 60.0 - 0.0);
  ASSERT_EQ(shown.view.scan()->screen().calipers().size(), 1U);
  EXPECT_NEAR(shown.view.scan()->screen().calipers()[0].length(), 50.0, 0.5);
}

TEST(UltrasoundView, has_the_ct_beside_it_where_there_is_room) {
  ShownScan narrow, wide(900, 400);
  EXPECT_FALSE(narrow.view.shows_ct());
  EXPECT_TRUE(wide.view.shows_ct());
  EXPECT_FALSE(wide.view.grab().isNull());
  wide.key(Qt::Key_T);
  wide.key(Qt::Key_H);
  EXPECT_TRUE(wide.view.scan()->help());
  EXPECT_FALSE(wide.view.grab().isNull());
}

TEST(UltrasoundView, without_a_scan_it_says_so) {
  UltrasoundView view;
  view.resize(300, 200);
  view.set_case(bodkin_test::layered_patient());
  view.set_scan(std::nullopt);
  view.show_frame(bodkin_test::frame_at(10.0), Changes::all());
  EXPECT_EQ(view.scan(), nullptr);
  EXPECT_FALSE(view.grab().isNull());
}

}  // namespace
}  // namespace bodkin::views
