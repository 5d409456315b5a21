// The body in the workspace of the device: steps that can be undone, and the moving mode of the window.
#include "app/models/body_place.h"

#include <QApplication>
#include <QMouseEvent>
#include <QPushButton>
#include <QTest>

#include "app/pages/practise.h"
#include "tests/app/window_fixture.h"

namespace bodkin::app {
namespace {

TEST(BodyMover, takes_steps_back_one_by_one_and_all_at_once) {
  BodyMover mover;
  const BodyPlace usual{Vec3(1.0, 2.0, 3.0), Mat3::Identity()};
  mover.begin(usual);
  EXPECT_FALSE(mover.undo());
  const BodyPlace first{Vec3(5.0, 2.0, 3.0), Mat3::Identity()}, second{Vec3(9.0, 2.0, 3.0), Mat3::Identity()};
  mover.begin_step();
  mover.place({Vec3(4.0, 2.0, 3.0), Mat3::Identity()});  // on the way
  mover.place(first);
  mover.begin_step();
  mover.begin_step();  // taken and let go
  mover.place(second);
  EXPECT_TRUE(mover.is_moved());
  EXPECT_TRUE(mover.undo());
  EXPECT_EQ(mover.now(), first);
  mover.reset();
  EXPECT_FALSE(mover.is_moved());
  EXPECT_TRUE(mover.undo());
  EXPECT_EQ(mover.now(), first);
  EXPECT_TRUE(mover.undo());
  EXPECT_EQ(mover.now(), usual);
  EXPECT_FALSE(mover.undo());
}

class MovingWindow : public WindowFixture {
 protected:
  View3d& view() { return window_->practise_page().view3d(); }
  void drag(Qt::MouseButton button, const QPoint& from, const QPoint& to) {
    QTest::mousePress(&view(), button, {}, from);
    for (int i = 1; i <= 5; ++i) {
      QMouseEvent move(QEvent::MouseMove, from + (to - from) * i / 5, Qt::NoButton, button, Qt::NoModifier);
      QApplication::sendEvent(&view(), &move);
      QTest::qWait(30);  // a frame
    }
    QTest::mouseRelease(&view(), button, {}, to);
  }
};

TEST_F(MovingWindow, turns_and_moves_the_body_about_a_workspace_that_stays_on_the_screen) {
  click("start.begin");
  Practice& practice = window_->practice();
  ASSERT_TRUE(QTest::qWaitFor([&] { return practice.state() == State::ready && view().is_ready(); }, 180000))
      << practice.failure();
  const BodyPlace usual = practice.body_place();
  const OpenCase& patient = *practice.patient();
  EXPECT_EQ(usual, usual_place(*patient.description().procedure.path));
  click("practise.move");
  // New widgets are beside the existing ones, and cover nothing.
  const auto* const reset = window_->findChild<QPushButton*>(QStringLiteral("practise.move.reset"));
  for (const char* other : {"practise.move", "practise.move.undo"}) {
    const auto* const button = window_->findChild<QPushButton*>(QLatin1String(other));
    EXPECT_EQ(button->y(), reset->y()) << other;
    EXPECT_FALSE(button->geometry().intersects(reset->geometry())) << other;
  }
  ASSERT_TRUE(view().workspace().has_value());
  const auto middle_on_screen = [&] {
    const scene::Camera camera = view().camera();
    return Vec3(camera.axes().transpose() * (practice.body_place().middle - camera.eye));
  };
  const auto axes_on_screen = [&] {
    return Mat3(view().camera().axes().transpose() * practice.body_place().rotation);
  };
  const Vec3 middle = middle_on_screen();
  const Mat3 axes = axes_on_screen();
  drag(Qt::LeftButton, {300, 300}, {400, 330});
  const BodyPlace turned = practice.body_place();
  EXPECT_EQ(turned.middle, usual.middle);
  EXPECT_GT(Eigen::AngleAxisd(Mat3(turned.rotation * usual.rotation.transpose())).angle(), 20.0 * degree);
  EXPECT_LT((turned.rotation.transpose() * turned.rotation - Mat3::Identity()).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((middle_on_screen() - middle).norm(), 1e-6);
  EXPECT_LT((axes_on_screen() - axes).cwiseAbs().maxCoeff(), 1e-6);
  drag(Qt::RightButton, {300, 300}, {360, 300});
  EXPECT_GT((practice.body_place().middle - turned.middle).norm(), 1.0);
  EXPECT_LT((middle_on_screen() - middle).norm(), 1e-6);
  EXPECT_EQ(practice.state(), State::ready) << "nothing was put down";
  click("practise.move.undo");
  EXPECT_EQ(practice.body_place(), turned);
  click("practise.move.reset");
  EXPECT_EQ(practice.body_place(), usual);
  EXPECT_LT((middle_on_screen() - middle).norm(), 1e-6);
  // With the needle in the body it stays.
  click("practise.move");
  EXPECT_FALSE(view().workspace().has_value());
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        practice.push(1.0, false);
        return practice.state() == State::in_tissue;
      },
      60000));
  click("practise.move");
  EXPECT_FALSE(view().workspace().has_value());
  practice.place_body(turned);
  EXPECT_EQ(practice.body_place(), usual);
}

}  // namespace
}  // namespace bodkin::app
