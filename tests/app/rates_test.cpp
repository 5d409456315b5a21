// The two rates of a trainer: the picture at more than 30 Hz, the force at 1 kHz, while the needle moves.
#include <QEvent>
#include <algorithm>
#include <ctime>

#include "app/pages/practise.h"
#include "tests/app/window_fixture.h"

namespace bodkin::app {
namespace {

// How often a widget was really painted.
class PaintCount : public QObject {
 public:
  explicit PaintCount(QObject& widget) { widget.installEventFilter(this); }
  int count() const { return count_; }

 protected:
  bool eventFilter(QObject* /*widget*/, QEvent* event) override {
    count_ += event->type() == QEvent::Paint ? 1 : 0;
    return false;
  }

 private:
  int count_ = 0;
};

double processor_time() {  // s, of all threads
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

class Rates : public WindowFixture {};

// Other programs hold up this one, so that pictures are counted by the processor time that they cost, which does not
// depend on them: a machine that does nothing else draws at least so many in a second.
TEST_F(Rates, a_picture_takes_less_than_a_thirtieth_of_a_second_and_the_force_comes_at_1_khz) {
  ASSERT_TRUE(start()) << window_->practice().failure();
  Practice& practice = window_->practice();
  ASSERT_TRUE(wait(
      [&] {
        practice.push(1.0, false);
        return frame().depth > 10.0;
      },
      60));
  ASSERT_TRUE(wait([&] { return window_->practise_page().view3d().is_ready(); }, 60));
  const PaintCount view3d(*find("practise.view3d")), slice(*find("practise.slice.sagittal"));
  double direction = 1.0;
  QObject::connect(&window_->clock(), &FrameClock::frame, window_.get(), [&] {
    if (frame().depth > 20.0) direction = -1.0;
    if (frame().depth < 10.0) direction = 1.0;
    practice.push(direction, true);
  });
  QTest::qWait(500);
  const double began = frame().time;  // s of the station
  const std::uint64_t ticks_before = frame().ticks;
  double cheapest = 1e9;  // s of processor time for one picture, with all that goes on meanwhile
  int frames = 0, pictures = 0;
  for (int second = 0; second < 20 && (second < 3 || cheapest >= 1.0 / 30.0); ++second) {
    const std::uint64_t frames_before = frame().number;
    const int before_3d = view3d.count(), before_slice = slice.count();
    const double spent_before = processor_time();
    QTest::qWait(1000);
    const int drawn = std::min(view3d.count() - before_3d, slice.count() - before_slice);
    frames += static_cast<int>(frame().number - frames_before);
    pictures += drawn;
    if (drawn > 0) cheapest = std::min(cheapest, (processor_time() - spent_before) / drawn);
  }
  EXPECT_LT(cheapest, 1.0 / 30.0) << "s";
  EXPECT_GT(2 * pictures, frames) << "in 3-D and in a slice; frames that come late may share a picture";
  const double rate = static_cast<double>(frame().ticks - ticks_before) / (frame().time - began);
  EXPECT_NEAR(rate, 1000.0, 30.0) << "ticks/s";
}

}  // namespace
}  // namespace bodkin::app
