// Whole procedures in the window, by mouse and keys: the finger that feels the skin, stylet, manometer and syringe.
#include <QPushButton>
#include <QTest>
#include <algorithm>
#include <functional>
#include <numeric>
#include <string>

#include "app/pages/practise.h"
#include "session/session_file.h"
#include "session/tick_codec.h"
#include "tests/app/window_fixture.h"

namespace bodkin::app {
namespace {

class WholeProcedure : public WindowFixture {
 protected:
  Practice& practice() { return window_->practice(); }
  const Frame& frame() { return practice().frame(); }
  static bool wait(const std::function<bool()>& what, int seconds) { return QTest::qWaitFor(what, seconds * 1000); }
  void begin(const char* procedure) {
    window_->practise_procedure(QLatin1String(procedure));
    ASSERT_TRUE(wait([&] { return practice().state() == State::ready || !practice().failure().empty(); }, 180));
    ASSERT_EQ(practice().failure(), "");
    QObject::connect(&window_->clock(), &FrameClock::frame, window_.get(), [this] {
      for (const session::SessionEvent& event : frame().events) seen_.push_back(event.event.kind);
    });
  }
  QWidget* focus() { return window_->focusWidget() != nullptr ? window_->focusWidget() : window_.get(); }
  void key(Qt::Key which) { QTest::keyClick(focus(), which); }
  // Holds a key of the needle until a condition holds.
  bool hold(Qt::Key which, bool slowly, const std::function<bool()>& until, int seconds) {
    const Qt::KeyboardModifiers with = slowly ? Qt::ShiftModifier : Qt::NoModifier;
    QTest::keyPress(focus(), which, with);
    const bool came = wait(until, seconds);
    QTest::keyRelease(focus(), which, with);
    return came;
  }
  long count(forces::EventKind kind) const { return std::count(seen_.begin(), seen_.end(), kind); }
  std::string told() const {
    std::string all;
    for (const forces::EventKind kind : seen_) all += std::string(session::event_kind_name(kind)) + " ";
    return all;
  }
  // The pointer is over the skin until the tip hovers there: a needle on its way out does not follow it.
  void aim(const SkinPoint& skin) {
    ASSERT_TRUE(wait(
        [&] {
          practice().aim(skin);
          return (frame().needle.translation() - skin.point).norm() < 3.0;
        },
        60));
  }
  bool is_above() { return practice().state() == State::ready || practice().state() == State::aiming; }
  // The finger's place, `cranial` mm from the planned entry along the back.
  void feel(double cranial) {
    const OpenCase& patient = *practice().patient();
    const anatomy::NeedlePath plan = *patient.description().procedure.path;
    const Vec3 from = plan.entry + cranial * Vec3::UnitZ() - 40.0 * plan.direction();
    const std::optional<SkinPoint> skin = skin_on_ray(patient.patient.tissues, from, plan.direction(), 100.0);
    ASSERT_TRUE(skin.has_value());
    const long before = count(forces::EventKind::palpated);
    aim(*skin);
    ASSERT_TRUE(hold(
        Qt::Key_PageDown, false, [&] { return count(forces::EventKind::palpated) > before; }, 60))
        << told();
    key(Qt::Key_W);
    key(Qt::Key_H);
    EXPECT_TRUE(frame().other_hand.finger) << "a finger that presses is no needle yet";
    ASSERT_TRUE(wait([&] { return is_above() && !frame().other_hand.finger_presses; }, 60));
  }
  void expect_verdict(training::Grade grade) {
    ASSERT_TRUE(wait([&] { return practice().result().has_value(); }, 60));
    const AttemptResult& result = *practice().result();
    std::string words = result.headline;
    for (const std::string& each : result.remarks) words += "\n" + each;
    ASSERT_TRUE(result.verdict.has_value()) << words;
    EXPECT_EQ(*result.verdict, grade) << words << "\n" << told();
  }

  std::vector<forces::EventKind> seen_;
};

TEST_F(WholeProcedure, a_lumbar_puncture_with_finger_stylet_and_manometer_passes) {
  begin("lumbar_puncture");
  ASSERT_TRUE(find<QPushButton>("practise.finger")->isVisible());
  EXPECT_FALSE(find<QPushButton>("practise.plunger")->isVisible());
  click("practise.finger");
  ASSERT_TRUE(wait([&] { return frame().other_hand.finger; }, 60)) << frame().hint;
  feel(16.0);
  feel(0.0);
  click("practise.finger");
  ASSERT_TRUE(wait([&] { return !frame().other_hand.finger; }, 60)) << frame().hint;

  const OpenCase& patient = *practice().patient();
  const anatomy::NeedlePath plan = *patient.description().procedure.path;
  aim({plan.entry, -plan.direction()});
  ASSERT_TRUE(hold(
      Qt::Key_PageDown, false, [&] { return frame().depth > 0.6 * plan.length(); }, 60))
      << frame().depth << " mm, " << frame().place << ", " << frame().hint << "; " << told();
  ASSERT_TRUE(hold(
      Qt::Key_PageDown, true, [&] { return frame().tissue == anatomy::tissue::cerebrospinal_fluid; }, 90));
  EXPECT_EQ(count(forces::EventKind::fluid_returned), 0) << "the stylet is in";
  key(Qt::Key_S);
  ASSERT_TRUE(wait([&] { return count(forces::EventKind::fluid_returned) == 1; }, 60));
  click("practise.manometer");
  ASSERT_TRUE(wait([&] { return count(forces::EventKind::pressure_read) == 1; }, 60)) << told();
  EXPECT_TRUE(find<QPushButton>("practise.manometer")->text().contains(QStringLiteral("mm")));
  key(Qt::Key_R);  // the fluid drips now
  ASSERT_TRUE(wait([&] { return count(forces::EventKind::fluid_collected) >= 3; }, 90)) << told();
  key(Qt::Key_R);
  ASSERT_TRUE(wait([&] { return count(forces::EventKind::pressure_read) == 2; }, 60)) << told();
  click("practise.stylet");
  ASSERT_TRUE(wait([&] { return count(forces::EventKind::stylet_in) == 1; }, 60));
  key(Qt::Key_W);
  ASSERT_TRUE(wait([&] { return is_above() && frame().depth <= 0.0; }, 60));
  key(Qt::Key_E);
  expect_verdict(training::Grade::pass);
}

TEST_F(WholeProcedure, an_epidural_with_the_thumb_on_the_plunger_passes) {
  begin("epidural");
  ASSERT_TRUE(find<QPushButton>("practise.plunger")->isVisible());
  EXPECT_FALSE(find<QPushButton>("practise.stylet")->isVisible());
  const anatomy::NeedlePath plan = *practice().patient()->description().procedure.path;
  ASSERT_TRUE(hold(
      Qt::Key_PageDown, false, [&] { return frame().depth > 0.6 * plan.length(); }, 60));
  // The tip pushes the ligament, which this needle penetrates in one jump.
  const auto pushes_ligament = [&] {
    const Vec3 ahead = frame().touched + 0.5 * needle_axis(frame().needle);
    return frame().pushed > 0.0 &&
           anatomy::nearest<anatomy::TissueId>(practice().patient()->patient.tissues, ahead, anatomy::tissue::air) ==
               anatomy::tissue::ligamentum_flavum;
  };
  ASSERT_TRUE(hold(Qt::Key_PageDown, true, pushes_ligament, 90));
  QTest::mousePress(find("practise.plunger"), Qt::LeftButton);
  ASSERT_TRUE(wait([&] { return frame().other_hand.plunger; }, 60));
  ASSERT_TRUE(hold(
      Qt::Key_PageDown, true, [&] { return count(forces::EventKind::pressure_lost) > 0; }, 60))
      << told();
  // A millimetre more, so that the whole bevel is through.
  const double lost = frame().depth;
  ASSERT_TRUE(hold(
      Qt::Key_PageDown, true, [&] { return frame().depth > lost + 0.8; }, 60))
      << told();
  QTest::mouseRelease(find("practise.plunger"), Qt::LeftButton);
  EXPECT_TRUE(wait([&] { return !frame().other_hand.plunger; }, 60));
  // The key does the same while it is held.
  QTest::keyPress(window_->focusWidget(), Qt::Key_B);
  EXPECT_TRUE(wait([&] { return frame().other_hand.plunger; }, 60));
  QTest::keyRelease(window_->focusWidget(), Qt::Key_B);
  EXPECT_TRUE(wait([&] { return !frame().other_hand.plunger; }, 60));
  // The needle rests.
  ASSERT_TRUE(wait([this, since = frame().ticks] { return frame().ticks > since + 2500; }, 60));
  EXPECT_EQ(frame().tissue, anatomy::tissue::epidural_fat) << frame().place;
  key(Qt::Key_E);
  expect_verdict(training::Grade::pass);
}

// Too deep: the window reports what a hub would show, and the verdict is never better.
TEST_F(WholeProcedure, an_epidural_needle_through_the_dura_is_a_wet_tap) {
  begin("epidural");
  ASSERT_TRUE(hold(
      Qt::Key_PageDown, false, [&] { return count(forces::EventKind::fluid_returned) > 0; }, 90))
      << told();
  EXPECT_TRUE(wait([&] { return frame().hint == "Fluid comes back through the needle: the dura is open."; }, 60))
      << frame().hint;
  key(Qt::Key_R);
  EXPECT_TRUE(wait([&] { return frame().hint.starts_with("The syringe is on the needle"); }, 60)) << frame().hint;
  key(Qt::Key_E);
  expect_verdict(training::Grade::fail);
  EXPECT_EQ(practice().result()->headline, "Failed: the tip entered the dural sac");
}

TEST_F(WholeProcedure, the_syringe_is_filled_with_air_above_the_skin_alone) {
  begin("epidural");
  ASSERT_FALSE(frame().other_hand.air);
  click("practise.air");
  ASSERT_TRUE(wait([&] { return practice().state() == State::ready && frame().other_hand.air; }, 60))
      << practice().failure();
  EXPECT_TRUE(find<QPushButton>("practise.air")->isChecked());
  ASSERT_TRUE(hold(
      Qt::Key_PageDown, false, [&] { return frame().depth > 6.0; }, 60));
  click("practise.air");
  EXPECT_NE(practice().advance(frame().clock).hint.find("Withdraw the needle"), std::string::npos);
  EXPECT_TRUE(frame().other_hand.air);
  // The session stores the felt forces.
  key(Qt::Key_E);
  ASSERT_TRUE(wait([&] { return practice().result().has_value(); }, 60));
  const session::Session saved = session::read_session(practice().result()->session);
  ASSERT_TRUE(saved.header.haptics.parts.syringe.has_value());
  EXPECT_EQ(saved.header.haptics.parts.syringe->filling, anatomy::SyringeFilling::air);
}

TEST_F(WholeProcedure, a_patient_without_the_parts_has_no_such_buttons_and_says_why) {
  begin("needle_insertion");
  EXPECT_FALSE(find("practise.finger")->isVisible());
  EXPECT_FALSE(find("practise.manometer")->isVisible());
  key(Qt::Key_H);
  EXPECT_TRUE(wait([&] { return frame().hint == "This patient has no skin to feel with a finger."; }, 60));
}

}  // namespace
}  // namespace bodkin::app
