#include "app/frame_clock.h"

#include <QTest>
#include <algorithm>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

namespace bodkin::app {
namespace {

// Frames/s where every fourth frame is held up for 30 ms, which is longer than a frame; and nothing after the end.
double rate_with_hold_ups() {
  FrameClock clock;
  int frames = 0;
  QObject::connect(&clock, &FrameClock::frame, [&frames] {
    if (++frames % 4 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(30));
  });
  const auto begin = std::chrono::steady_clock::now();
  clock.start();
  QTest::qWait(1500);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  clock.stop();
  EXPECT_EQ(clock.rate(), 60);
  const int so_far = frames;
  QTest::qWait(60);
  EXPECT_EQ(frames, so_far) << "a stopped clock draws nothing";
  return so_far / seconds;
}

// A timer that drops what it missed gives four frames in 3 x 16 + 32 ms: 50 a second.
TEST(FrameClock, frames_that_come_late_are_made_up_for) {
  double best = 0.0;
  for (int i = 0; i < 4 && best < 55.0; ++i)
    best = std::max(best, rate_with_hold_ups());  // others use the machine, too
  EXPECT_GT(best, 55.0);
  EXPECT_LT(best, 66.0);
}

TEST(FrameClock, after_a_long_halt_two_frames_are_made_up_for_and_no_more) {
  FrameClock clock;
  int frames = 0;
  QObject::connect(&clock, &FrameClock::frame, [&frames] {
    if (++frames == 5) std::this_thread::sleep_for(std::chrono::milliseconds(500));
  });
  clock.start();
  ASSERT_TRUE(QTest::qWaitFor([&frames] { return frames >= 5; }, 2000));
  const int before = frames;
  QTest::qWait(100);
  EXPECT_LE(frames - before, 11) << "6 in 100 ms, and a few";
}

}  // namespace
}  // namespace bodkin::app
