#include "app/frame_clock.h"

#include <QTest>
#include <algorithm>
#include <chrono>

#include <gtest/gtest.h>

namespace bodkin::app {
namespace {

using namespace std::chrono_literals;
using Time = std::chrono::steady_clock::time_point;

constexpr std::chrono::milliseconds interval = 16ms;

// Frames drawn for `span` from a given time on an idle machine, each taking the time of `takes`.
template <typename Takes>
int frames_drawn(Time from, std::chrono::milliseconds span, Takes takes) {
  Time now = from, due = from;
  int frames = 0;
  while (now < from + span) {
    due = next_due(due, now, interval);
    now = std::max(now + takes(++frames), due);
  }
  return frames;
}

// Every fourth is delayed by 30 ms. A timer that drops missed frames gives four frames in 3 x 16 + 32 ms: 50 a
// second.
TEST(FrameClock, frames_that_come_late_are_made_up_for) {
  const auto takes = [](int frame) { return frame % 4 == 0 ? 30ms : 0ms; };
  EXPECT_NEAR(frames_drawn(Time(), 10'000ms, takes), 625, 2);
}

TEST(FrameClock, after_a_long_halt_two_frames_are_made_up_for_and_no_more) {
  Time due = Time() + 80ms, now = Time() + 580ms;
  int at_once = 0;
  for (due = next_due(due, now, interval); due <= now; due = next_due(due, now, interval)) ++at_once;
  EXPECT_EQ(at_once, 3) << "the one that is due, and two";
  EXPECT_EQ(due, now + interval);
}

TEST(FrameClock, draws_until_it_is_stopped) {
  FrameClock clock;
  int frames = 0;
  QObject::connect(&clock, &FrameClock::frame, [&frames] { ++frames; });
  clock.start();
  EXPECT_TRUE(QTest::qWaitFor([&frames] { return frames >= 5; }, 60000));
  clock.stop();
  const int so_far = frames;
  QTest::qWait(60);
  EXPECT_EQ(frames, so_far);
}

}  // namespace
}  // namespace bodkin::app
