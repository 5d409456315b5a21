// The window, driven as a person would: from the first start to the needle in tissue and the saved session.
#include "app/main_window.h"

#include <QAbstractButton>
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QTest>
#include <QWheelEvent>
#include <chrono>
#include <functional>

#include "app/models/data_folder.h"
#include "app/models/warnings.h"
#include "app/pages/practise.h"
#include "app/pages/review.h"
#include "session/session_file.h"
#include "tests/app/window_fixture.h"
#include <gtest/gtest.h>

namespace bodkin::app {
namespace {

class Window : public WindowFixture {
 protected:
  // Notches inwards, over a slice.
  void push(int notches) {
    QWidget* const slice = find("practise.slice.sagittal");
    const QPoint at = slice->rect().center();
    for (int i = 0; i < notches; ++i) {
      QWheelEvent event(at, slice->mapToGlobal(at), {}, {0, -120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                        false);
      QApplication::sendEvent(slice, &event);
      QTest::qWait(5);
    }
  }
  // Pushes until the tip has this depth, however long the machine takes.
  void push_to(double depth) {
    EXPECT_TRUE(wait(
        [&] {
          if (frame().depth < depth) push(1);
          return frame().depth >= depth;
        },
        60));
  }
};

TEST_F(Window, from_the_start_to_the_needle_in_tissue_and_the_saved_session) {
  ASSERT_TRUE(start()) << window_->practice().failure();
  push(1);
  ASSERT_TRUE(wait(State::touching, 60)) << name_of(window_->practice().state());
  EXPECT_TRUE(frame().has_needle);
  push_to(12.0);
  ASSERT_EQ(window_->practice().state(), State::in_tissue);
  EXPECT_FALSE(frame().place.empty());
  const anatomy::Case& patient = window_->practice().patient()->patient;
  // The frame's tissue is the voxel at its tip.
  const Vec3 tip = frame().needle.translation();
  bool near = false;
  for (const double along : {-0.6, 0.0, 0.6}) {
    near = near || anatomy::nearest(patient.tissues, Vec3(tip + along * needle_axis(frame().needle)),
                                    anatomy::tissue::air) == frame().tissue;
  }
  EXPECT_TRUE(near) << frame().place;
  // The hand is ahead of the needle by the resistance.
  ASSERT_TRUE(settle());
  const double ahead = (frame().hand.translation() - frame().needle.translation()).dot(needle_axis(frame().needle));
  EXPECT_NEAR(ahead, frame().resistance / MouseHand::stiffness, 0.3);
  const double deepest = frame().depth;
  key(Qt::Key_E);
  ASSERT_EQ(window_->practice().state(), State::ended);
  ASSERT_TRUE(wait([&] { return window_->practice().result().has_value(); }, 60));
  const AttemptResult& result = *window_->practice().result();
  EXPECT_NEAR(result.deepest, deepest, 0.5);
  const session::Session saved = session::read_session(result.session);
  EXPECT_TRUE(saved.finished);
  EXPECT_EQ(saved.ticks.size(), result.run.ticks);
  EXPECT_TRUE(wait([&] { return find<QLabel>("results.headline")->text().toStdString() == result.headline; }, 60));
}

TEST_F(Window, the_results_lead_to_the_review_of_the_attempt) {
  ASSERT_TRUE(start()) << window_->practice().failure();
  push_to(20.0);
  key(Qt::Key_E);
  ASSERT_TRUE(wait([&] { return window_->practice().result().has_value(); }, 60));
  ASSERT_TRUE(wait([&] { return find("results.review")->isVisible(); }, 60));
  click("results.review");
  auto* page = find<ReviewPage>("review");
  ASSERT_TRUE(wait([&] { return !page->is_busy() && page->recording() != nullptr; }, 60));
  const std::shared_ptr<const Recording> recording = page->recording();
  EXPECT_EQ(recording->file(), window_->practice().result()->session);
  EXPECT_TRUE(recording->note().empty()) << recording->note();  // the patient is there, and the same
  EXPECT_EQ(recording->patient(), window_->practice().patient());
  ASSERT_TRUE(recording->score().has_value()) << recording->not_judged();
  EXPECT_EQ(recording->score()->headline, window_->practice().result()->headline);
  // The named place at the tip is the patient's structure there.
  const std::size_t deep = recording->index_at(recording->end());
  page->seek(recording->time(deep));
  ASSERT_TRUE(wait([&] { return std::abs(page->frame().time - recording->time(deep)) < 0.0011; }, 60));
  const simulation::TickRecord& there = recording->session().ticks[deep];
  const Frame& frame = page->frame();
  EXPECT_EQ(frame.place, place_name(recording->patient()->patient, frame.touched, needle_axis(there.input.needle),
                                    there.output.tissue));
  EXPECT_LE((frame.touched - there.input.needle.translation()).norm(), there.output.depth) << "it has been pushed";
  EXPECT_NEAR(page->frame().depth, recording->session().ticks[deep].output.depth, 1e-12);
}

TEST_F(Window, moving_the_pointer_moves_no_needle_in_tissue) {
  ASSERT_TRUE(start()) << window_->practice().failure();
  push_to(10.0);
  ASSERT_TRUE(settle());
  const Vec3 before = frame().needle.translation();
  for (int x = 50; x < 700; x += 50) {
    QTest::mouseMove(find("practise.view3d"), QPoint(x, 250));
    QTest::qWait(20);
  }
  EXPECT_NEAR((frame().needle.translation() - before).norm(), 0.0, 0.1);
}

TEST_F(Window, space_holds_the_needle_and_escape_pauses) {
  ASSERT_TRUE(start()) << window_->practice().failure();
  push_to(8.0);
  key(Qt::Key_Space);
  EXPECT_EQ(window_->practice().state(), State::held);
  ASSERT_TRUE(settle());
  const double depth = frame().depth;
  push(10);
  ASSERT_TRUE(settle());
  EXPECT_NEAR(frame().depth, depth, 0.3);
  key(Qt::Key_Space);
  EXPECT_TRUE(needle_is_down(window_->practice().state()));
  key(Qt::Key_Escape);
  EXPECT_EQ(window_->practice().state(), State::paused);
  EXPECT_TRUE(wait([&] { return find("pause.resume")->isVisible(); }, 60));
  click("pause.resume");
  EXPECT_TRUE(needle_is_down(window_->practice().state()));
}

TEST_F(Window, bone_holds_the_needle_and_says_so_within_two_frames) {
  ASSERT_TRUE(start()) << window_->practice().failure();
  // From the side of the spine onto the lamina: parallel to the plan, 12 mm to the patient's left of it.
  const OpenCase& patient = *window_->practice().patient();
  const anatomy::NeedlePath plan = *patient.description().procedure.path;
  const Vec3 from = plan.entry + 12.0 * Vec3::UnitX() - 30.0 * plan.direction();
  const std::optional<SkinPoint> skin = skin_on_ray(patient.patient.tissues, from, plan.direction(), 80.0);
  ASSERT_TRUE(skin.has_value());
  window_->practice().aim(*skin);
  window_->practice().put_down();
  ASSERT_TRUE(wait(State::touching, 60));
  std::uint64_t met = 0, said = 0;
  const QMetaObject::Connection watch = QObject::connect(&window_->clock(), &FrameClock::frame, [&] {
    for (const session::SessionEvent& event : frame().events) {
      if (event.event.kind == forces::EventKind::bone_contact && met == 0) met = frame().number;
    }
    if (frame().warning && said == 0) said = frame().number;
  });
  ASSERT_TRUE(wait(
      [&] {
        if (said == 0 || met == 0) push(1);
        return said != 0 && met != 0;  // the place may be named before the tip knocks on it
      },
      60));
  QObject::disconnect(watch);
  ASSERT_GT(met, 0U);
  EXPECT_LE(said, met + 2);
  EXPECT_EQ(window_->practice().state(), State::warning);
  const double depth = frame().depth;
  push(20);
  ASSERT_TRUE(settle());
  EXPECT_LT(frame().depth, depth + 6.0);  // the hand continues, the needle hardly
  EXPECT_GT((frame().hand.translation() - frame().needle.translation()).norm(), 2.0);
}

TEST_F(Window, a_needle_that_is_left_stays_in_the_body_while_another_goes_in) {
  ASSERT_TRUE(start()) << window_->practice().failure();
  key(Qt::Key_Space, Qt::ShiftModifier);
  EXPECT_TRUE(window_->practice().left_needles().empty()) << "it is not in the body yet";
  push_to(15.0);
  ASSERT_TRUE(settle());
  const Pose first = frame().needle;
  key(Qt::Key_Space, Qt::ShiftModifier);
  ASSERT_TRUE(wait(State::ready, 60)) << window_->practice().failure();
  ASSERT_EQ(frame().left_needles.size(), 1U);
  EXPECT_LT((frame().left_needles[0].pose.translation() - first.translation()).norm(), 0.1);
  // It is drawn: pixels of the 3-D view change once it is removed.
  const QImage with = find("practise.view3d")->grab().toImage();
  push_to(10.0);
  ASSERT_TRUE(settle());
  key(Qt::Key_Space, Qt::ShiftModifier);
  ASSERT_TRUE(wait(State::ready, 60)) << window_->practice().failure();
  EXPECT_EQ(frame().left_needles.size(), 2U);
  key(Qt::Key_W, Qt::ShiftModifier);
  key(Qt::Key_W, Qt::ShiftModifier);
  EXPECT_TRUE(window_->practice().left_needles().empty());
  EXPECT_TRUE(wait([&] { return find("practise.view3d")->grab().toImage() != with; }, 60));
}

TEST_F(Window, a_key_that_is_held_is_let_go_when_the_window_is_left) {
  ASSERT_TRUE(start()) << window_->practice().failure();
  push_to(2.0);
  QWidget* const focus = window_->focusWidget();
  ASSERT_NE(focus, nullptr);
  QTest::keyPress(focus, Qt::Key_PageDown);
  ASSERT_TRUE(wait([&] { return frame().depth > 4.0; }, 60));
  QEvent left(QEvent::WindowDeactivate);
  QApplication::sendEvent(window_.get(), &left);
  EXPECT_TRUE(settle()) << "it goes on";
}

TEST_F(Window, again_saves_the_attempt_and_begins_another_on_the_same_patient) {
  ASSERT_TRUE(start()) << window_->practice().failure();
  const auto patient = window_->practice().patient();
  push_to(5.0);
  click("practise.again");
  ASSERT_TRUE(wait(State::ready, 60)) << window_->practice().failure();
  EXPECT_EQ(window_->practice().patient(), patient);
  EXPECT_TRUE(wait([&] { return frame().depth == 0.0 && frame().time_in_body == 0.0; }, 60));
}

TEST_F(Window, a_folder_that_is_no_patient_gives_a_sentence_and_the_start_page) {
  window_->open("/no/such/folder");
  ASSERT_TRUE(wait(State::no_case, 60));
  EXPECT_TRUE(
      wait([&] { return find<QLabel>("start.line")->text().contains(QStringLiteral("/no/such/folder")); }, 60));
}

TEST_F(Window, every_button_has_a_name_a_tool_tip_and_an_accessible_name) {
  for (const QAbstractButton* button : window_->findChildren<QAbstractButton*>()) {
    // Qt's own: the cross that clears a line, the corner of a table.
    if (qobject_cast<QLineEdit*>(button->parent()) != nullptr ||
        qobject_cast<QTableView*>(button->parent()) != nullptr)
      continue;
    const std::string what = button->text().toStdString() + " in " + button->parent()->objectName().toStdString();
    EXPECT_FALSE(button->objectName().isEmpty()) << what;
    EXPECT_FALSE(button->toolTip().isEmpty()) << what;
    EXPECT_FALSE(button->accessibleName().isEmpty() && button->text().isEmpty()) << what;
  }
}

}  // namespace
}  // namespace bodkin::app
