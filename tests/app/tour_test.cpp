// The two-minute tour, the palette of commands, and what the window remembers.
#include "app/pages/tour.h"

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QSplitter>
#include <QTest>

#include "app/main_window.h"
#include "app/models/data_folder.h"
#include "app/pages/palette.h"
#include "app/pages/practise.h"
#include <gtest/gtest.h>

namespace bodkin::app {
namespace {

using Step = TourSteps::Step;

Frame frame_in(State state, anatomy::TissueId tissue = anatomy::tissue::air) {
  Frame frame;
  frame.state = state;
  frame.tissue = tissue;
  return frame;
}

TEST(TourSteps, each_step_ends_when_it_is_done) {
  TourSteps steps;
  steps.see(frame_in(State::ready));
  EXPECT_EQ(steps.step(), Step::look);
  steps.looked();
  EXPECT_EQ(steps.step(), Step::aim);
  steps.see(frame_in(State::aiming));
  EXPECT_EQ(steps.step(), Step::aim);
  steps.see(frame_in(State::touching));
  EXPECT_EQ(steps.step(), Step::push);
  steps.see(frame_in(State::touching));
  EXPECT_EQ(steps.step(), Step::push);
  steps.see(frame_in(State::in_tissue, anatomy::tissue::skin));
  EXPECT_EQ(steps.step(), Step::read);
  steps.see(frame_in(State::in_tissue, anatomy::tissue::skin));
  EXPECT_EQ(steps.step(), Step::read);
  steps.see(frame_in(State::in_tissue, anatomy::tissue::fat));
  EXPECT_EQ(steps.step(), Step::done);
}

class TourWindow : public testing::Test {
 protected:
  void SetUp() override {
    window_.resize(1280, 720);
    window_.show();
  }
  template <typename Widget = QWidget>
  Widget* find(const char* name) {
    auto* const found = window_.findChild<Widget*>(QLatin1String(name));
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  void key(int code, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QWidget* const focus = window_.focusWidget();
    QTest::keyClick(focus != nullptr ? focus : &window_, static_cast<Qt::Key>(code), modifiers);
  }

  MainWindow window_{data_folder()};
};

TEST_F(TourWindow, is_walked_through_by_doing_what_it_says) {
  QTest::mouseClick(find("start.tour"), Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window_.practice().state() == State::ready; }, 120000));
  auto& tour = *find<Tour>("tour");
  ASSERT_TRUE(QTest::qWaitFor([&] { return tour.isVisible(); }, 60000));
  EXPECT_EQ(tour.steps().step(), Step::look);
  QTest::keyClick(find("practise.view3d"), Qt::Key_Left);
  EXPECT_EQ(tour.steps().step(), Step::aim);
  // The balloon about the ring does not cover it.
  ASSERT_TRUE(QTest::qWaitFor([&] { return find<QLabel>("tour.title")->text() == "Aim"; }, 60000));
  ASSERT_TRUE(QTest::qWaitFor([&] { return tour.ring(window_.practice().frame()).has_value(); }, 60000));
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        const std::optional<QPoint> ring = tour.ring(window_.practice().frame());
        return ring && !tour.geometry().contains(*ring);
      },
      60000));
  window_.practice().push(1.0, false);
  ASSERT_TRUE(QTest::qWaitFor([&] { return tour.steps().step() == Step::push; }, 60000));
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        if (tour.steps().step() != Step::done) window_.practice().push(1.0, false);
        return tour.steps().step() == Step::done;
      },
      60000));
  QTest::mouseClick(find("tour.leave"), Qt::LeftButton);
  EXPECT_FALSE(tour.isVisible());
  EXPECT_FALSE(tour.is_running());
}

TEST_F(TourWindow, the_palette_finds_a_command_by_the_beginnings_of_its_words) {
  EXPECT_TRUE(matches_query(QStringLiteral("save a picture of the window"), QStringLiteral("pic win")));
  EXPECT_FALSE(matches_query(QStringLiteral("save a picture of the window"), QStringLiteral("pic door")));
  key(Qt::Key_K, Qt::ControlModifier);
  auto* const words = find<QLineEdit>("palette.words");
  ASSERT_TRUE(words->isVisible());
  const int all = find<QListWidget>("palette.list")->count();
  EXPECT_GT(all, 8);
  QTest::keyClicks(words, QStringLiteral("sou on"));
  EXPECT_EQ(find<QListWidget>("palette.list")->count(), 1);
  const bool was_on = window_.sounds().is_on();
  QTest::keyClick(words, Qt::Key_Return);
  EXPECT_FALSE(words->isVisible());
  EXPECT_NE(window_.sounds().is_on(), was_on);
  EXPECT_EQ(Sounds().is_on(), window_.sounds().is_on()) << "it is remembered";
  key(Qt::Key_M, Qt::ControlModifier);
  EXPECT_EQ(window_.sounds().is_on(), was_on);
}

TEST_F(TourWindow, splitters_are_where_they_were_left) {
  ASSERT_NE(find<QSplitter>("practise.columns"), nullptr);
  window_.show_page(PageId::practise);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window_.practice().state() == State::ready; }, 120000));
  auto* const columns = find<QSplitter>("practise.columns");
  columns->setSizes({700, 576, 0});
  const QList<int> left = columns->sizes();
  window_.close();
  MainWindow next(data_folder());
  next.resize(1280, 720);
  next.show();
  next.show_page(PageId::practise);
  ASSERT_TRUE(QTest::qWaitFor([&] { return next.practice().state() == State::ready; }, 120000));
  auto* const again = next.findChild<QSplitter*>("practise.columns");
  EXPECT_NEAR(again->sizes()[0], left[0], 3);
  QTest::mouseDClick(again->handle(1), Qt::LeftButton);
  EXPECT_GT(again->sizes()[0], left[0] + 50) << "a double click takes them back";
}

}  // namespace
}  // namespace bodkin::app
