#include "station/recorded_hand.h"

#include <vector>

#include "station/hand_session.h"
#include "tests/session/session_samples.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptics/device_port.h"
#include "haptics/workspace_map.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::haptics;
using namespace bodkin::session;
using namespace bodkin::simulation;
using namespace bodkin::station;
namespace {

using ::testing::HasSubstr;

// Three ticks of a needle near an entry at (10, 80, -30), with one lost between the second and the third.
class RecordedHandTest : public ::testing::Test {
 protected:
  RecordedHandTest() {
    header_ = sample_header();
    header_.path = {{10.0, 80.0, -30.0}, {10.0, 20.0, -30.0}};
    tips_ = {{10.0, 110.0, -30.0}, {12.0, 105.0, -27.0}, {9.0, 80.0, -30.0}};
  }
  void record(const std::vector<std::uint64_t>& ticks, double dt = 0.001) {
    header_.dt = dt;
    SessionWriter writer(file_.path(), header_, true);
    for (std::size_t i = 0; i < ticks.size(); ++i) {
      TickRecord one;
      one.tick = ticks[i];
      one.input.needle = needle_pose(tips_[i], Vec3(0.1, -1.0, 0.3));
      writer.append(one);
    }
    writer.commit();
  }
  std::string refusal(const std::string& identity, const std::string& settings = "") {
    try {
      const DevicePort port(recorded_driver(), identity, settings);
    } catch (const InputError& error) {
      return error.what();
    }
    ADD_FAILURE() << "opened";
    return {};
  }

  ScratchSession file_;
  SessionHeader header_;
  std::vector<Vec3> tips_;
};

TEST_F(RecordedHandTest, comes_back_in_the_operators_frame) {
  record({0, 1, 2});
  const RecordedHand hand = read_recorded_hand(file_.path());
  ASSERT_EQ(hand.poses.size(), 3u);
  EXPECT_EQ(hand.rate, 1000.0);
  // Prone, head away: right is -X, away +Z, up +Y; the entry is 30 mm below the middle.
  EXPECT_TRUE(hand.poses[0].translation().isZero(1e-9));
  EXPECT_TRUE(hand.poses[1].translation().isApprox(Vec3(-2.0, 3.0, -5.0), 1e-9));
  EXPECT_TRUE(hand.poses[2].translation().isApprox(Vec3(1.0, 0.0, -30.0), 1e-9));
  EXPECT_TRUE(needle_axis(hand.poses[0]).isApprox(Vec3(-0.1, 0.3, -1.0).normalized(), 1e-9));
}

TEST_F(RecordedHandTest, gives_the_needle_as_it_was_through_the_workspace_of_a_performance) {
  record({0, 1, 2});
  DevicePort port(recorded_driver(), file_.path().string(), "");
  EXPECT_EQ(port.abilities().peak_force, 0.0);
  EXPECT_EQ(port.abilities().rate, 1000.0);
  port.start();
  WorkspaceMap map(workspace_about(header_.path));
  DeviceState state;
  for (const Vec3& tip : tips_) {
    port.exchange({Vec3(0.0, 0.0, 5.0), Vec3::Zero()}, state);
    EXPECT_FALSE(state.ended());
    const Pose& needle = map.step(state.hand, 0.001);
    EXPECT_NEAR((needle.translation() - tip).norm(), 0.0, 1e-9);
    EXPECT_TRUE(needle.linear().isApprox(needle_pose(tip, Vec3(0.1, -1.0, 0.3)).linear(), 1e-9));
  }
  for (int after = 0; after < 3; ++after) {
    port.exchange({}, state);
    EXPECT_TRUE(state.ended());
    EXPECT_EQ(state.fault, DeviceFault::none);
    EXPECT_NEAR((map.step(state.hand, 0.001).translation() - tips_.back()).norm(), 0.0, 1e-9);
  }
}

TEST_F(RecordedHandTest, waits_where_ticks_were_lost_and_refuses_when_too_many_were) {
  record({5, 6, 9});
  const RecordedHand hand = read_recorded_hand(file_.path());
  ASSERT_EQ(hand.poses.size(), 5u);
  EXPECT_EQ(hand.poses[3].translation(), hand.poses[1].translation());
  EXPECT_NE(hand.poses[4].translation(), hand.poses[3].translation());
  record({0, 1, 5000});
  EXPECT_THAT(refusal(file_.path().string()), HasSubstr("lacks 4998 ticks in a row"));
}

TEST_F(RecordedHandTest, knows_rate_and_device_of_the_recording) {
  header_.device = DeviceLimits{.profile = "Touch", .peak_force = 3.3};
  record({0, 1}, 0.0005);
  const RecordedHand hand = read_recorded_hand(file_.path());
  EXPECT_EQ(hand.rate, 2000.0);
  ASSERT_TRUE(hand.limits.has_value());
  EXPECT_EQ(hand.limits->peak_force, 3.3);
}

TEST_F(RecordedHandTest, is_refused_in_one_sentence_when_there_is_none) {
  EXPECT_THAT(refusal(""), HasSubstr("expected recorded:FILE.bodkin"));
  EXPECT_THAT(refusal("/no/such.bodkin"), HasSubstr("/no/such.bodkin"));
  record({});
  EXPECT_THAT(refusal(file_.path().string()), HasSubstr("has no tick"));
  record({0, 1});
  EXPECT_THAT(refusal(file_.path().string(), "speed=2"), HasSubstr("there is no setting 'speed', expected none"));
  std::ofstream(file_.path(), std::ios::binary) << "no session at all, and long enough to be looked at";
  EXPECT_THAT(refusal(file_.path().string()), HasSubstr("not a session file"));
}

}  // namespace
}  // namespace bodkin
