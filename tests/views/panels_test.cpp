// The panels next to the view of the patient: ladder, bullseye, banner, label of the tip, numbers, bar,
// diagnostics.
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "tests/views/made_up.h"
#include "views/banner.h"
#include "views/bullseye.h"
#include "views/depth_ladder.h"
#include "views/diagnostics_dock.h"
#include "views/numbers.h"
#include "views/theme.h"
#include "views/tip_label.h"
#include "views/top_bar.h"
#include <gtest/gtest.h>

namespace bodkin::views {
namespace {

using bodkin_test::frame_at;

template <typename Panel>
void show(Panel& panel, int width, int height, const Frame& frame) {
  panel.resize(width, height);
  panel.set_case(bodkin_test::layered_patient());
  panel.show_frame(frame, Changes::all());
}

QColor colour_of(anatomy::TissueId id) {
  return tissue_colour(id, bodkin_test::layered_patient()->patient.library);
}

TEST(DepthLadder, has_the_colour_of_each_tissue_at_its_depth_and_is_darker_ahead) {
  DepthLadder ladder;
  show(ladder, 116, 370, frame_at(20.0));
  const QImage picture = ladder.grab().toImage();
  const auto at = [&](double depth) {
    return picture.pixelColor(28, static_cast<int>(std::lround(ladder.row(depth))));
  };
  EXPECT_EQ(at(8.0), colour_of(anatomy::tissue::fat));
  EXPECT_EQ(at(15.0), colour_of(anatomy::tissue::muscle));
  EXPECT_LT(at(25.0).lightness(), colour_of(anatomy::tissue::muscle).lightness()) << "not reached yet";
  EXPECT_NEAR(at(32.0).hueF(), colour_of(anatomy::tissue::ligamentum_flavum).hueF(), 0.02);
  EXPECT_GT(at(20.0).lightness(), 230) << "the tip's line";
}

TEST(DepthLadder, a_tip_that_pushes_what_it_touches_stands_where_that_lies) {
  DepthLadder ladder;
  Frame frame = frame_at(20.0);
  frame.pushed = 6.0;
  frame.tissue = anatomy::tissue::muscle;
  show(ladder, 116, 370, frame);
  const QImage picture = ladder.grab().toImage();
  const auto at = [&](double depth) {
    return picture.pixelColor(28, static_cast<int>(std::lround(ladder.row(depth))));
  };
  EXPECT_GT(at(14.0).lightness(), 230) << "the tip's line";
  EXPECT_LT(at(20.0).lightness(), colour_of(anatomy::tissue::muscle).lightness()) << "only pushed";
}

TEST(DepthLadder, before_the_skin_it_shows_the_way_that_the_needle_would_take) {
  DepthLadder ladder;
  show(ladder, 116, 370, frame_at(-10.0));
  ASSERT_FALSE(ladder.segments().empty());
  EXPECT_EQ(ladder.segments().front().tissue, anatomy::tissue::skin);
  Frame nothing;
  nothing.plan = frame_at(0.0).plan;
  ladder.show_frame(nothing, Changes::all());
  EXPECT_EQ(ladder.segments().size(), 5U) << "the plan's, without a needle";
}

TEST(DepthLadder, is_as_wide_as_the_longest_name_in_it) {
  DepthLadder ladder;
  show(ladder, 118, 370, frame_at(-10.0));
  EXPECT_EQ(ladder.sizeHint().width(), 118) << "short names have room";
  auto patient = std::make_shared<OpenCase>(*bodkin_test::layered_patient());
  std::vector<anatomy::TissueProperties> tissues = patient->patient.library.tissues();
  for (anatomy::TissueProperties& each : tissues)
    if (each.id == anatomy::tissue::fat) each.title = "a tissue with a name of some length";
  patient->patient.library = anatomy::TissueLibrary(tissues);
  ladder.set_case(patient);
  ladder.show_frame(frame_at(-10.0), Changes::all());
  const int wide = ladder.sizeHint().width();
  const int letters = QFontMetrics(font(label_size, true)).horizontalAdvance("a tissue with a name of some length");
  EXPECT_GT(wide, letters + 30) << "the bar stands beside it";
  // The last letter is drawn, and more room changes nothing.
  ladder.resize(wide, 370);
  const QImage fits = ladder.grab().toImage();
  ladder.resize(wide + 60, 370);
  EXPECT_EQ(ladder.grab().toImage().copy(42, 40, letters, 300), fits.copy(42, 40, letters, 300));
  ladder.resize(118, 370);
  EXPECT_NE(ladder.grab().toImage().copy(42, 40, 70, 300), fits.copy(42, 40, 70, 300)) << "cut with less";
  ladder.set_case(bodkin_test::layered_patient());
  ladder.show_frame(frame_at(-10.0), Changes::all());
  EXPECT_EQ(ladder.sizeHint().width(), 118);
}

TEST(DepthLadder, long_names_are_short_there) {
  EXPECT_EQ(short_title("ligamentum flavum"), "flavum");
  EXPECT_EQ(short_title("muscle"), "muscle");
}

TEST(Bullseye, the_dot_lies_where_the_needle_is_off_the_path) {
  Bullseye bullseye;
  Frame frame = frame_at(20.0);
  frame.needle.translation() += Vec3(-3.0, 0.0, 0.0);  // to the patient's right: right, seen from behind
  show(bullseye, 300, 92, frame);
  const QPointF centre = bullseye.place(Eigen::Vector2d::Zero()), dot = bullseye.place({3.0, 0.0});
  EXPECT_GT(dot.x(), centre.x() + 5.0);
  const QImage picture = bullseye.grab().toImage();
  EXPECT_EQ(picture.pixelColor(dot.toPoint()), Theme::dark().text);
  const QPointF far = bullseye.place({0.0, 300.0});
  EXPECT_GT(far.y(), 0.0) << "what is far lies on the rim";
  EXPECT_LT(far.y(), centre.y());
}

TEST(Banner, is_there_while_there_is_a_warning_and_says_when_it_was_read) {
  Banner banner;
  Frame frame = frame_at(20.0);
  show(banner, 10, 10, frame);
  EXPECT_TRUE(banner.isHidden());
  frame.warning =
      Warning{Warning::Kind::bone, "Bone: lamina of L3", "Draw back to the skin, aim lower, go in again."};
  Changes changes;
  changes.warning = true;
  banner.show_frame(frame, changes);
  EXPECT_FALSE(banner.isHidden());
  EXPECT_GT(banner.width(), 250);
  EXPECT_NE(banner.accessibleDescription().indexOf("lamina of L3"), -1);
  QSignalSpy read(&banner, &Banner::acknowledged);
  QTest::mouseClick(&banner, Qt::LeftButton);
  EXPECT_EQ(read.count(), 1);
  frame.warning.reset();
  banner.show_frame(frame, changes);
  EXPECT_TRUE(banner.isHidden());
}

TEST(TipLabel, says_where_the_tip_is) {
  TipLabel label;
  show(label, 250, 64, frame_at(20.0));
  EXPECT_EQ(label.heading(), "TIP IN");
  EXPECT_EQ(label.place(), "muscle");
  label.show_frame(frame_at(-5.0), Changes::all());
  EXPECT_EQ(label.heading(), "TIP ABOVE");
  Frame touching = frame_at(-0.0);
  touching.state = State::touching;
  label.show_frame(touching, Changes::all());
  EXPECT_EQ(label.heading(), "PRESSING ON");
  Frame bone = frame_at(20.0);
  bone.tissue = anatomy::tissue::cortical_bone;
  bone.place = "lamina of L3";
  label.show_frame(bone, Changes::all());
  EXPECT_EQ(label.heading(), "TIP ON BONE");
  EXPECT_EQ(label.place(), "lamina of L3");
}

TEST(Numbers, are_those_of_the_frame) {
  Numbers numbers;
  Frame frame = frame_at(29.0);
  frame.resistance = 2.604;
  frame.off_angle = 1.24 * degree;
  frame.time_in_body = 82.9;
  show(numbers, 296, 102, frame);
  EXPECT_EQ(numbers.text(Numbers::force), "2.60");
  EXPECT_EQ(numbers.text(Numbers::target), "11.0");
  EXPECT_EQ(numbers.text(Numbers::angle), "1.2°");
  EXPECT_EQ(numbers.text(Numbers::time), "1:22");
  frame.resistance = -0.001;
  numbers.show_frame(frame, Changes::all());
  EXPECT_EQ(numbers.text(Numbers::force), "0.00") << "no minus before nothing";
  numbers.show_frame(Frame{}, Changes::all());
  EXPECT_EQ(numbers.text(Numbers::target), "–");
}

TEST(TopBar, stages_and_chips_ask_for_their_pages) {
  TopBar bar;
  Frame frame = frame_at(20.0);
  const haptics::ServoTimings timings;
  frame.timings = &timings;
  frame.device = "Mouse";
  show(bar, 1280, TopBar::bar_height, frame);
  QTest::qWait(1);
  QSignalSpy device(&bar, &TopBar::device_page_requested);
  int chosen = -1;
  QObject::connect(&bar, &TopBar::stage_chosen, [&](Stage stage) { chosen = static_cast<int>(stage); });
  QTest::mouseClick(bar.findChild<QPushButton*>("top.stage.practise"), Qt::LeftButton);
  EXPECT_EQ(chosen, static_cast<int>(Stage::practise));
  QTest::mouseClick(bar.findChild<QPushButton*>("top.device"), Qt::LeftButton);
  EXPECT_EQ(device.count(), 1);
  auto* servo = bar.findChild<QPushButton*>("top.servo");
  EXPECT_EQ(servo->text(), "1 kHz");
  frame.recent_success = 0.9;
  frame.late_ticks = 12;
  Changes changes;
  bar.show_frame(frame, changes);
  EXPECT_NE(servo->text().indexOf("late"), -1);
  frame.guard = haptics::GuardState::faulted;
  frame.fault = haptics::GuardReason::too_fast;
  bar.show_frame(frame, changes);
  EXPECT_EQ(servo->text(), "No force");
  bar.resize(1024, TopBar::bar_height);
  bar.grab();
  EXPECT_TRUE(servo->text().isEmpty()) << "narrow windows leave the colour and shape";
  EXPECT_FALSE(servo->toolTip().isEmpty());
}

TEST(TopBar, every_button_has_a_name_and_says_what_it_does) {
  TopBar bar;
  for (const QPushButton* button : bar.findChildren<QPushButton*>()) {
    EXPECT_FALSE(button->objectName().isEmpty()) << qPrintable(button->text());
    EXPECT_FALSE(button->toolTip().isEmpty()) << qPrintable(button->objectName());
    EXPECT_FALSE(button->accessibleName().isEmpty()) << qPrintable(button->objectName());
  }
}

TEST(DiagnosticsDock, tells_what_the_device_can_do_and_what_the_station_says) {
  DiagnosticsDock dock;
  Frame frame = frame_at(20.0);
  show(dock, 300, 640, frame);
  const QImage before = dock.grab().toImage();
  const std::vector<std::string> notes = {"the force stays below 1.5 N, because the system may hold up the servo"};
  frame.notes = notes;
  frame.device_limits.emplace();
  frame.clock += 1.0;
  dock.show_frame(frame, Changes::all());
  const QImage after = dock.grab().toImage();
  // Only at the bottom.
  EXPECT_NE(after.copy(0, 500, 300, 140), before.copy(0, 500, 300, 140));
  EXPECT_EQ(after.copy(0, 0, 300, 300), before.copy(0, 0, 300, 300));
}

TEST(DiagnosticsDock, knows_how_far_the_wall_is_ahead) {
  DiagnosticsDock dock;
  Frame frame = frame_at(20.0);
  const std::array<forces::DiagnosticName, 2> names = {
      {{"wall_mm", "position W of the wall"}, {"stored_N_mm", "energy"}}};
  frame.diagnostic_names = names;
  frame.diagnostics[0] = 21.5;
  frame.diagnostics[1] = 0.7;
  haptics::ServoTimings timings;
  timings.ticks = 1000;
  for (int i = 0; i < 1000; ++i) {
    timings.compute.record(20e-6);
    timings.lateness.record(60e-6);
  }
  frame.timings = &timings;
  frame.guard = haptics::GuardState::active;
  show(dock, 300, 520, frame);
  ASSERT_TRUE(dock.wall_distance());
  EXPECT_NEAR(*dock.wall_distance(), 1.5, 1e-12);
  EXPECT_EQ(dock.log().lines().size(), 1U);
  EXPECT_FALSE(dock.grab().isNull());
  frame.diagnostic_names = {};
  dock.show_frame(frame, Changes::all());
  EXPECT_FALSE(dock.wall_distance());
}

}  // namespace
}  // namespace bodkin::views
