// A needle that turns inside the deformable body meets the tissue that is ahead of it after the turn.
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "patient/prepared_body.h"
#include "tests/station/block_of_tissue.h"
#include <gtest/gtest.h>

#include "simulation/haptic_tick.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
using namespace bodkin::forces;
using namespace bodkin::patient;
using namespace bodkin::session;
using namespace bodkin::simulation;
namespace {

constexpr double wall = 18.0;      // mm, depth of the bone and the ligament next to it, 3 mm thick
constexpr double turned_at = 6.0;  // mm deep

// The planned path runs at x = 15. Bone ends 3 mm from a needle that enters at `x`.
BlockOfTissue block_with_bone(double x = 30.0) {
  BlockOfTissue block = block_of_tissue();
  TissueVolume& tissues = block.patient.tissues;
  for (int k = 20; k < 80; ++k) {
    const double depth = k - 19.5;
    if (depth < wall || depth > wall + 3.0) continue;
    for (int j = 0; j < 60; ++j)
      for (int i = 0; i < 60; ++i)
        tissues.at(i, j, k) = i + 0.5 < x + 3.0 ? tissue::cortical_bone : tissue::ligamentum_flavum;
  }
  return block;
}

// In at `x`, straight down to `turned_at`; there the hand tilts the needle by `tilt` (rad) about its hole in the
// skin, then advances to `deepest` and withdraws.
std::vector<Pose> way(double x, double tilt, double deepest) {
  std::vector<Pose> poses;
  const Vec3 hole(x, 30.0, 0.0);
  const auto add = [&](double length, double angle) {
    const Vec3 axis(std::sin(angle), 0.0, std::cos(angle));
    poses.push_back(needle_pose(hole + length * axis, axis));
  };
  for (double length = -5.0; length < turned_at; length += 0.05) add(length, 0.0);
  for (double angle = 0.0; angle < tilt; angle += 0.005) add(turned_at, angle);
  for (double length = turned_at; length < deepest; length += 0.05) add(length, tilt);
  for (double length = deepest; length > -5.0; length -= 0.05) add(length, tilt);
  return poses;
}

Session session_of(const BlockOfTissue& block, const std::vector<Pose>& poses, BodyPort::PointTiming timing,
                   bool waits) {
  Session session;
  session.header.path = *block.patient.description.procedure.path;
  session.header.haptics = block.patient.description.haptics;
  session.header.dt = 0.001;
  HapticTick tick(block.patient);
  const std::shared_ptr<ContactLine> line = tick.body()->stream_points(timing);
  std::shared_ptr<const ContactBody> kept = block.whole;
  const auto stream = contact_stream(*block.body, std::make_shared<const Case>(block.patient),
                                     session.header.path.length(), kept, line);
  std::size_t real_time_calls = 0;
  for (const Pose& pose : poses) {
    if (waits) line->wait_for(ContactLine::most_points);
    real_time_calls += record_tick(tick, pose, session);
  }
  EXPECT_EQ(real_time_calls, 0U) << "the tick took memory or a lock";
  return session;
}

std::vector<double> depths_of(const Session& session, EventKind kind, TissueId tissue) {
  std::vector<double> depths;
  for (const SessionEvent& event : session.events)
    if (event.event.kind == kind && event.event.tissue == tissue) depths.push_back(event.event.depth);
  return depths;
}

bool has(const Session& session, EventKind kind) {
  return std::ranges::any_of(session.events, [kind](const SessionEvent& event) { return event.event.kind == kind; });
}

// Straight ahead lies bone; after the turn, ligament. On a line of the needle's own and on the planned one.
TEST(TurnedNeedle, meets_the_layers_that_lie_ahead_of_it_then) {
  constexpr double tilt = 0.5;
  const double along = wall / std::cos(tilt);
  for (const double x : {30.0, 15.0}) {
    const BlockOfTissue block = block_with_bone(x);
    const Session session = session_of(block, way(x, tilt, along + 10.0), BodyPort::PointTiming::as_known, true);
    EXPECT_FALSE(has(session, EventKind::points_passed)) << x;
    EXPECT_FALSE(has(session, EventKind::points_late)) << x;
    const std::vector<double> given = depths_of(session, EventKind::puncture, tissue::ligamentum_flavum);
    ASSERT_EQ(given.size(), 1U) << x;
    EXPECT_GT(given.front(), along - 3.0) << x;  // the tissue in which it turned lies 6 mm deep and has not turned
    EXPECT_EQ(depths_of(session, EventKind::puncture, tissue::skin).size(), 1U) << x;
    expect_replay(session, block);
  }
}

TEST(TurnedNeedle, that_goes_straight_on_meets_the_bone) {
  const BlockOfTissue block = block_with_bone();
  const Session session = session_of(block, way(30.0, 0.0, 20.0), BodyPort::PointTiming::as_known, true);
  EXPECT_TRUE(has(session, EventKind::bone_contact));
  EXPECT_FALSE(has(session, EventKind::points_passed));
  EXPECT_TRUE(depths_of(session, EventKind::puncture, tissue::ligamentum_flavum).empty());
  int lines = 0;
  for (const SessionEvent& event : session.events) lines += event.event.kind == EventKind::points_taken ? 1 : 0;
  EXPECT_EQ(lines, 1) << "it has stayed on its line";
}

// What the needle has already reached stays unchanged: the force continues smoothly, tick by tick.
TEST(TurnedNeedle, goes_on_without_a_jump_of_its_force) {
  const BlockOfTissue block = block_with_bone();
  const Session session = session_of(block, way(30.0, 0.5, 17.0), BodyPort::PointTiming::as_known, true);
  std::vector<std::uint64_t> gave_way;
  for (const SessionEvent& event : session.events)
    if (event.event.kind == EventKind::puncture) gave_way.push_back(event.tick);
  double greatest = 0.0;
  for (std::size_t i = 1; i < session.ticks.size(); ++i) {
    const bool gives_way =
        std::ranges::any_of(gave_way, [i](std::uint64_t tick) { return i >= tick && i <= tick + 60; });
    const Vec3 change = session.ticks[i].output.requested.force - session.ticks[i - 1].output.requested.force;
    if (!gives_way) greatest = std::max(greatest, change.norm());
  }
  EXPECT_LT(greatest, 0.1);
  EXPECT_GT(greatest, 0.0);
}

TEST(TurnedNeedle, replays_to_the_bit_whenever_its_points_come) {
  const BlockOfTissue block = block_with_bone();
  const std::vector<Pose> poses = way(30.0, 0.5, 30.0);
  expect_replay(session_of(block, poses, BodyPort::PointTiming::as_known, false), block);
  const Session once = session_of(block, poses, BodyPort::PointTiming::in_time, false);
  expect_replay(once, block);
  const Session waited = session_of(block, poses, BodyPort::PointTiming::as_known, true);
  ASSERT_EQ(once.ticks.size(), waited.ticks.size());
  EXPECT_EQ(depths_of(once, EventKind::puncture, tissue::ligamentum_flavum).size(), 1U);
  EXPECT_NEAR(depths_of(once, EventKind::puncture, tissue::ligamentum_flavum).front(),
              depths_of(waited, EventKind::puncture, tissue::ligamentum_flavum).front(), 0.06);
}

}  // namespace
}  // namespace bodkin
