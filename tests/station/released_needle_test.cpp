// A frozen needle in a breathing patient: it moves with the tissue, and the recording contains its positions.
#include "station/released_needle.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "session/replay.h"
#include "session/session_file.h"
#include "station/station.h"
#include "tests/io/scratch_folder.h"
#include "tests/session/slab_case.h"
#include <gtest/gtest.h>

#include "haptics/drivers/simulated.h"

namespace bodkin::station {
namespace {

// Freezes the needle at 8 mm depth and observes it until breath is drawn in.
struct FreezesNeedle : StationObserver {
  std::chrono::milliseconds interval() const override { return std::chrono::milliseconds(5); }
  void update(Station& station, const StationStatus& status) override {
    const simulation::TickOutput& now = status.needle.output;
    if (now.depth > 8.0 && !std::exchange(is_asked, true)) station.command(StationCommand::toggle_hold);
    if (!status.servo.frozen) return;
    const Vec3 tip = status.needle.needle.translation();
    if (!first) first = tip;
    if (!first_depth) first_depth = now.depth;
    farthest = std::max(farthest, (tip - *first).norm());
    change_of_depth = std::max(change_of_depth, std::abs(now.depth - *first_depth));
    if (now.drawn_in > 0.8) station.command(StationCommand::end);
  }

  bool is_asked = false;
  std::optional<Vec3> first;
  std::optional<double> first_depth;
  double farthest = 0.0, change_of_depth = 0.0;  // mm
};

TEST(ReleasedNeedle, goes_with_the_breath_when_it_is_frozen_and_the_recording_replays_to_the_bit) {
  const ScratchFolder folder;
  folder.write("case.xml", "<case/>");
  StationOptions options;
  options.patient =
      slab_case({{anatomy::tissue::skin, 2.0}, {anatomy::tissue::fat, 12.0}, {anatomy::tissue::muscle, 36.0}});
  anatomy::Breathing breathing;
  breathing.rate = 30.0;
  breathing.motion = Vec3(0.0, -4.0, -9.0);
  breathing.radius = 500.0;
  options.patient.description.breathing = breathing;
  options.case_folder = folder.path();
  options.device = {&haptics::simulated_driver(), "", "speed_mm_s=40 start_mm=10 depth_mm=12 wait_s=20"};
  options.output = folder.path() / "session.bodkin";
  options.longest = 30.0;
  const std::filesystem::path file = options.output;
  FreezesNeedle observer;
  Station station(std::move(options), observer);
  station.run();
  ASSERT_TRUE(observer.first);
  EXPECT_GT(observer.farthest, 2.0) << "out and towards the feet";
  EXPECT_LT(observer.change_of_depth, 0.1) << "in the tissue it stays where it is";
  const session::ReplayResult replay = session::replay_session(session::read_session(file), station.patient());
  EXPECT_FALSE(replay.difference.has_value());
}

Pose moved_by(const Vec3& by) {
  Pose motion = Pose::Identity();
  motion.translation() = by;
  return motion;
}

TEST(ReleasedNeedle, takes_up_its_place_anew_whenever_it_is_let_go) {
  ReleasedNeedle needle;
  const auto step = [&needle](bool is_released, const Vec3& tip, const Vec3& of_tissue) {
    const ReleasedNeedle::Step found = needle.step(is_released, moved_by(tip), moved_by(of_tissue));
    EXPECT_EQ(found.turn, Mat3::Identity());
    return found.by;
  };
  EXPECT_EQ(step(false, Vec3(1.0, 2.0, 3.0), Vec3(5.0, 0.0, 0.0)), Vec3::Zero());
  EXPECT_EQ(step(true, Vec3(1.0, 2.0, 3.0), Vec3(5.0, 0.0, 0.0)), Vec3::Zero()) << "it lies where it is";
  EXPECT_LT((step(true, Vec3(1.0, 2.0, 3.0), Vec3(5.5, 0.0, -1.0)) - Vec3(0.5, 0.0, -1.0)).norm(), 1e-12);
  EXPECT_LT(step(true, Vec3(1.5, 2.0, 2.0), Vec3(5.5, 0.0, -1.0)).norm(), 1e-12) << "it has gone there";
  EXPECT_EQ(step(false, Vec3::Zero(), Vec3(9.0, 9.0, 9.0)), Vec3::Zero());
  EXPECT_EQ(step(true, Vec3(7.0, 0.0, 0.0), Vec3(9.0, 9.0, 9.0)), Vec3::Zero());
}

TEST(ReleasedNeedle, goes_where_tissue_that_turns_takes_it) {
  ReleasedNeedle needle;
  Pose now = needle_pose(Vec3(3.0, -20.0, 8.0), Vec3(0.1, 0.2, -1.0).normalized());
  Pose before = Pose::Identity();  // motion of the tissue when the needle was let go
  before.linear() = Eigen::AngleAxisd(0.05, Vec3::UnitY()).toRotationMatrix();
  before.translation() = Vec3(1.0, 0.0, -2.0);
  const Pose first = now;
  Pose motion = before;
  for (int tick = 0; tick < 1000; ++tick) {
    motion.linear() = Eigen::AngleAxisd(0.05 + 2e-4 * tick, Vec3::UnitY()).toRotationMatrix();
    motion.translation() = Vec3(1.0, 0.0, -2.0) + 0.004 * tick * Vec3(1.0, -1.0, 0.5);
    const ReleasedNeedle::Step step = needle.step(true, now, motion);
    now.translation() += step.by;
    now.linear() = step.turn * now.linear();
  }
  const Pose expected = motion * before.inverse() * first;
  EXPECT_LT((now.matrix() - expected.matrix()).norm(), 1e-9);
}

}  // namespace
}  // namespace bodkin::station
