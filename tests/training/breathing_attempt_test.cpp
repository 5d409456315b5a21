// An attempt on a breathing patient is judged by the tip's place in the tissue, and the hand by its actual motion.
#include <cmath>
#include <numbers>

#include "tests/training/written_session.h"
#include <gtest/gtest.h>

#include "training/attempt.h"

namespace bodkin {

using namespace bodkin::training;
namespace {

anatomy::CaseDescription breathing_case() {
  anatomy::CaseDescription description;
  anatomy::Breathing breathing;
  breathing.rate = 15.0;  // a period of 4 s
  breathing.pause = 1;
  breathing.centre = Vec3(0.0, -50.0, 0.0);
  breathing.motion = Vec3(0.0, 0.0, -12.0);
  breathing.radius = 60.0;
  description.breathing = breathing;
  return description;
}

// With breath drawn in at 6 s, the lesion lies 12 mm lower, and a needle that goes there is in it.
TEST(BreathingAttempt, a_needle_that_meets_the_moved_target_is_at_the_target) {
  WrittenSession written;
  written.to(0, 1000, WrittenSession::air);
  written.go(Vec3(0.0, -20.0, -6.0), 1000, {true, tissue::fat, 1.0});
  written.go(Vec3(0.0, -50.0, -12.0), 3500, {true, tissue::fat, 1.0}).rest(900, {true, tissue::organ, 0.5});
  const anatomy::CaseDescription description = breathing_case();
  const Attempt attempt(written.session(), description);
  ASSERT_TRUE(attempt.final_tip.has_value());
  const std::size_t at = 6000 - 1;  // tick 5999 is the 6000th
  EXPECT_NEAR((attempt.tip[at] - Vec3(0.0, -50.0, 0.0)).norm(), 0.0, 1e-5);
  EXPECT_EQ(attempt.hand[at], Vec3(0.0, -50.0, -12.0));
  EXPECT_NEAR(attempt.now(Vec3(0.0, -50.0, 0.0), at).z(), -12.0, 1e-5);
  // With the breath held, the same needle is 12 mm off.
  for (simulation::TickRecord& record : written.session().ticks) record.input.other.breath_held = true;
  const Attempt held(written.session(), description);
  EXPECT_EQ(held.tip[at], Vec3(0.0, -50.0, -12.0));
}

TEST(BreathingAttempt, ticks_that_were_lost_count) {
  WrittenSession written;
  written.to(0, 500, WrittenSession::air).to(30, 5000, {true, tissue::fat, 1.0});
  const anatomy::CaseDescription description = breathing_case();
  const Attempt whole(written.session(), description);
  auto& ticks = written.session().ticks;
  ticks.erase(ticks.begin() + 2000, ticks.begin() + 3000);
  const Attempt with_gap(written.session(), description);
  EXPECT_EQ(with_gap.tip[4000], whole.tip[5000]);
  EXPECT_EQ(with_gap.tip[1999], whole.tip[1999]);
}

// None of these numbers belongs to the tissue: the hand is still.
TEST(BreathingAttempt, a_hand_that_is_still_rests) {
  WrittenSession written;
  written.to(0, 500, WrittenSession::air).to(30, 1500, {true, tissue::fat, 1.0}).rest(5000, {true, tissue::fat, 1.0});
  const Attempt attempt(written.session(), breathing_case());
  ASSERT_EQ(attempt.rests.size(), 1U);
  EXPECT_GT(attempt.rests.front().last - attempt.rests.front().first, 4000U);
}

}  // namespace
}  // namespace bodkin
