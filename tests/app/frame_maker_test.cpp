#include "app/frame_maker.h"

#include <gtest/gtest.h>

namespace bodkin::app {
namespace {

// A frame in sixty of a second, so 0.02 mm are 1.2 mm/s, at which a needle is often advanced.
TEST(FrameMaker, a_needle_that_creeps_is_drawn_again) {
  FrameMaker maker;
  maker.begin(nullptr, std::nullopt);
  Frame frame;
  frame.has_needle = true;
  maker.changes(frame);
  int needle = 0, crosshair = 0, dimple = 0;
  Pose drawn = frame.needle;
  for (int i = 0; i < 100; ++i) {
    frame.needle.translation().y() += 0.02;
    frame.hand = frame.needle;
    frame.crosshair = frame.needle.translation();
    frame.dimple.depth += 0.01;
    const Changes changes = maker.changes(frame);
    if (changes.needle) drawn = frame.needle;
    needle += changes.needle ? 1 : 0;
    crosshair += changes.crosshair ? 1 : 0;
    dimple += changes.dimple ? 1 : 0;
    ASSERT_LE((drawn.translation() - frame.needle.translation()).norm(), 0.05 + 1e-9) << "frame " << i;
  }
  EXPECT_GE(needle, 33);
  EXPECT_GE(crosshair, 33);
  EXPECT_GE(dimple, 33);
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(maker.changes(frame).dimple) << "nothing has moved since";
}

}  // namespace
}  // namespace bodkin::app
