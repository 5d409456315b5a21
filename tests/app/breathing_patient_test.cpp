// A patient who breathes in the window: the picture moves, the needle is carried along, and the breath is held on
// request.
#include <QPushButton>
#include <algorithm>
#include <filesystem>

#include "app/pages/practise.h"
#include "tests/app/window_fixture.h"

#include "io/case_folder.h"

namespace bodkin::app {
namespace {

class BreathingPatient : public WindowFixture {
 protected:
  // The built-in patient, whose tissue about the target moves.
  void open_breathing() {
    ASSERT_TRUE(start());
    const std::filesystem::path from = window_->practice().patient()->folder;
    const std::filesystem::path folder = from.parent_path() / "breathes";
    std::filesystem::remove_all(folder);
    std::filesystem::copy(from, folder, std::filesystem::copy_options::recursive);
    anatomy::CaseDescription description = io::read_case_description(folder);
    path_ = *description.procedure.path;
    breathing_.rate = 20.0;
    breathing_.motion = Vec3(0.0, -2.0, -9.0);
    breathing_.centre = path_.entry;
    breathing_.radius = 70.0;
    description.breathing = breathing_;
    io::write_case_description(description, folder);
    window_->practice().leave();
    window_->open(folder);
    ASSERT_TRUE(wait(State::ready, 120)) << window_->practice().failure();
  }
  View3d& view() { return window_->findChild<PractisePage*>()->view3d(); }

  anatomy::NeedlePath path_;
  anatomy::Breathing breathing_;
};

TEST_F(BreathingPatient, is_drawn_moving_and_holds_the_breath_when_asked) {
  open_breathing();
  auto* const button = find<QPushButton>("practise.breath");
  EXPECT_TRUE(button->isVisible());
  EXPECT_FALSE(button->isChecked());
  ASSERT_TRUE(wait([&] { return view().is_ready(); }, 60));
  double most = 0.0, apart = 0.0;
  const anatomy::BreathField field(breathing_);
  const auto connection = QObject::connect(&window_->clock(), &FrameClock::frame, window_.get(), [&] {
    most = std::max(most, frame().drawn_in);
    if (!frame().plan) return;
    apart = std::max(apart, (frame().plan->entry - path_.entry - field.moved(path_.entry, frame().drawn_in)).norm());
    apart =
        std::max(apart, (frame().plan->target - path_.target - field.moved(path_.target, frame().drawn_in)).norm());
  });
  ASSERT_TRUE(wait([&] { return most > 0.9; }, 60));
  EXPECT_LT(apart, 1e-9) << "path and target move with the tissue";
  const Vec3 ring = path_.entry;
  const auto skin = [&] {
    const auto place = view().scene()->projection().place(ring);
    return view().scene()->skin_at(place->x, place->y)->point;
  };
  const Vec3 drawn_in = skin();
  // On the key, the patient breathes out and holds.
  view().setFocus();
  key(Qt::Key_Z);
  EXPECT_TRUE(wait([&] { return button->isChecked(); }, 60));
  ASSERT_TRUE(wait([&] { return frame().drawn_in == 0.0; }, 60));
  for (int i = 0; i < 20; ++i) {
    QTest::qWait(50);
    ASSERT_EQ(frame().drawn_in, 0.0);
  }
  EXPECT_TRUE(wait([&] { return (skin() - drawn_in).norm() > 0.5; }, 60)) << "the drawn skin has moved";

  // A resting needle in tissue: as the patient breathes its depth changes.
  const auto push = [&](double depth) {
    QTest::keyPress(window_->focusWidget(), Qt::Key_PageDown);
    const bool came = wait([&] { return frame().depth > depth; }, 60);
    QTest::keyRelease(window_->focusWidget(), Qt::Key_PageDown);
    return came;
  };
  ASSERT_TRUE(push(15.0));
  ASSERT_TRUE(settle());
  const double held = frame().depth;
  QTest::qWait(500);
  EXPECT_NEAR(frame().depth, held, 0.3);
  double low = held, high = held;
  const Vec3 hand = frame().needle.translation();
  QObject::connect(&window_->clock(), &FrameClock::frame, window_.get(), [&] {
    low = std::min(low, frame().depth);
    high = std::max(high, frame().depth);
  });
  click("practise.breath");
  EXPECT_TRUE(wait([&] { return high - low > 0.5; }, 60)) << "2 mm to the front lets the needle out";
  EXPECT_LT((frame().needle.translation() - hand).norm(), 3.0);
  QObject::disconnect(connection);
  click("practise.breath");
  ASSERT_TRUE(wait([&] { return frame().drawn_in == 0.0 && frame().other_hand.holds_breath; }, 60));

  // A needle left in the tissue moves with it.
  key(Qt::Key_Space, Qt::ShiftModifier);
  ASSERT_TRUE(wait(State::ready, 60));
  ASSERT_EQ(window_->practice().left_needles().size(), 1U);
  const anatomy::NeedlePath left = window_->practice().left_needles().front();
  ASSERT_TRUE(wait([&] { return frame().drawn_in > 0.6; }, 60)) << "another attempt, another breath";
  ASSERT_EQ(frame().left_needles.size(), 1U);
  // It is straight: its distance from the tissue is bounded by the tissue's deviation from a line.
  const Pose shown = frame().left_needles.front().pose;
  const auto now = [&](const Vec3& rest) { return Vec3(rest + field.moved(rest, frame().drawn_in)); };
  const Vec3 tip = shown.translation(), entry = tip - left.length() * needle_axis(shown);
  EXPECT_LT((tip - now(left.target)).norm(), 0.5);
  EXPECT_LT((entry - now(left.entry)).norm(), 0.5);
  EXPECT_GT((tip - left.target).norm(), 2.0);
  const Vec3 ends = now(left.target) - now(left.entry);
  EXPECT_LT(std::acos(std::min(1.0, needle_axis(shown).dot(ends.normalized()))), 0.5 * degree);
  EXPECT_GT(std::acos(std::min(1.0, needle_axis(shown).dot(left.direction()))), 1.0 * degree) << "it has turned";
}

TEST_F(BreathingPatient, one_who_does_not_has_no_button_and_says_so) {
  ASSERT_TRUE(start());
  EXPECT_FALSE(find<QPushButton>("practise.breath")->isVisible());
  window_->practice().turn(station::StationCommand::turn_breath);
  EXPECT_TRUE(wait([&] { return frame().hint.find("does not breathe") != std::string::npos; }, 60)) << frame().hint;
}

}  // namespace
}  // namespace bodkin::app
