// A needle enters where no points of the deformable body were prepared in advance.
#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

#include "patient/prepared_body.h"
#include "session/replay.h"
#include "tests/station/block_of_tissue.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "fem/solid/contact_body.h"
#include "fem/solid/patient_body.h"
#include "io/tissue_library_file.h"
#include "simulation/haptic_tick.h"
#include "simulation/needle_in_body.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
using namespace bodkin::forces;
using namespace bodkin::io;
using namespace bodkin::patient;
using namespace bodkin::session;
using namespace bodkin::simulation;
namespace {

using ::testing::HasSubstr;

// A straight motion in and out again at 50 mm/s; `depth`: mm.
struct Insertion {
  Vec3 entry, direction;
  double depth = 25.0;
};

const Vec3 aslant = Vec3(0.3, 0.0, 1.0).normalized();

// Two insertions at unprepared places, the second obliquely through the hole of the first.
const std::vector<Insertion> through_one_hole = {{Vec3(40.0, 30.0, 0.0), Vec3::UnitZ()},
                                                 {Vec3(40.2, 30.0, 0.0), aslant}};

enum class Points {
  never,     // nothing computes them
  any_time,  // the loop is much faster than the clock
  in_time    // the hand waits for them outside
};

Session session_on_own_lines(const BlockOfTissue& block, Points points, const std::vector<Insertion>& insertions) {
  Session session;
  session.header.path = *block.patient.description.procedure.path;
  session.header.haptics = block.patient.description.haptics;
  session.header.dt = 0.001;
  HapticTick tick(block.patient);
  const std::shared_ptr<ContactLine> line = tick.body()->stream_points(simulation::BodyPort::PointTiming::as_known);
  std::shared_ptr<const ContactBody> kept = block.whole;
  std::unique_ptr<ContactStream> stream;
  const auto patient = std::make_shared<const Case>(block.patient);
  if (points != Points::never)
    stream = contact_stream(*block.body, patient, session.header.path.length(), kept, line);
  std::size_t real_time_calls = 0;
  const auto step = [&](const Insertion& insertion, double way) {
    real_time_calls +=
        record_tick(tick, needle_pose(insertion.entry + way * insertion.direction, insertion.direction), session);
    if (points == Points::in_time && !session.ticks.back().output.in_contact)
      line->wait_for(ContactLine::most_points);
  };
  for (const Insertion& insertion : insertions) {
    for (double way = -5.0; way < insertion.depth; way += 0.05) step(insertion, way);
    for (double way = insertion.depth; way > -5.0; way -= 0.05) step(insertion, way);
  }
  EXPECT_EQ(real_time_calls, 0U) << "the tick took memory or a lock";
  return session;
}

std::vector<double> values_of(const Session& session, EventKind kind) {
  std::vector<double> values;
  for (const SessionEvent& event : session.events) {
    if (event.event.kind == kind) values.push_back(event.event.value);
  }
  return values;
}

int punctures_of(const Session& session, TissueId tissue) {
  return static_cast<int>(
      std::count_if(session.events.begin(), session.events.end(), [tissue](const SessionEvent& event) {
        return event.event.kind == EventKind::puncture && event.event.tissue == tissue;
      }));
}

TEST(OwnLines, a_needle_enters_where_nothing_was_prepared) {
  const BlockOfTissue block = block_of_tissue();
  const Session session = session_on_own_lines(block, Points::in_time, through_one_hole);
  ASSERT_FALSE(session.ticks.empty());
  EXPECT_EQ(values_of(session, EventKind::line_taken), std::vector<double>{BodyPort::own_line});
  EXPECT_TRUE(values_of(session, EventKind::points_late).empty());
  EXPECT_TRUE(values_of(session, EventKind::points_passed).empty());
  EXPECT_EQ(punctures_of(session, tissue::skin), 1);  // the second insertion finds the hole
  double greatest = 0.0;
  for (const TickRecord& record : session.ticks) greatest = std::max(greatest, record.output.resistance);
  EXPECT_GT(greatest, 1.4);
  expect_replay(session, block);
}

TEST(OwnLines, a_session_whose_points_come_at_any_time_replays_to_the_bit) {
  const BlockOfTissue block = block_of_tissue();
  const Session session = session_on_own_lines(block, Points::any_time, through_one_hole);
  ASSERT_FALSE(session.ticks.empty());
  expect_replay(session, block);
  EXPECT_THROW(replay_session(session, block.patient), InputError);  // without the body
}

// A left needle acts both live and in the replay, and its effect is noticeable.
TEST(OwnLines, beside_a_needle_that_was_left_replay_to_the_bit) {
  BlockOfTissue block = block_of_tissue();
  const std::vector<Insertion> one = {{Vec3(40.0, 30.0, 0.0), Vec3::UnitZ()}};
  const Session without = session_on_own_lines(block, Points::in_time, one);
  block.patient.left_needles = {{Vec3(41.0, 30.0, 0.0), Vec3(41.0, 30.0, 14.0)},
                                {Vec3(40.0, 28.0, 0.0), Vec3(40.0, 29.0, 9.0)}};
  const Session session = session_on_own_lines(block, Points::in_time, one);
  ASSERT_EQ(session.ticks.size(), without.ticks.size());
  double apart = 0.0;
  for (std::size_t i = 0; i < session.ticks.size(); ++i)
    apart = std::max(apart, std::abs(session.ticks[i].output.resistance - without.ticks[i].output.resistance));
  EXPECT_GT(apart, 0.01);
  expect_replay(session, block);
  block.patient.left_needles.pop_back();
  EXPECT_TRUE(replay_session(session, block.patient, {}, block.body.get()).difference.has_value());
}

TEST(OwnLines, share_their_holes_with_prepared_lines) {
  const BlockOfTissue block = block_of_tissue();
  const Vec3 planned = block.patient.description.procedure.path->entry;
  const Insertion prepared{planned, Vec3::UnitZ(), 15.0};
  const Insertion beside{planned + Vec3(1.7, 0.0, 0.0), Vec3::UnitZ(), 15.0};
  const Insertion through_hole{planned, Vec3(-0.3, 0.2, 1.0).normalized(), 15.0};
  const auto skins_of = [&](const std::vector<Insertion>& insertions) {
    const Session session = session_on_own_lines(block, Points::in_time, insertions);
    expect_replay(session, block);
    return punctures_of(session, tissue::skin);
  };
  EXPECT_EQ(skins_of({prepared, through_hole, prepared}), 1);
  EXPECT_EQ(skins_of({through_hole, prepared, through_hole}), 1);
  EXPECT_EQ(skins_of({beside, prepared, beside}), 2);
}

// The surface is felt at once, with the compliance that it has on the planned path.
TEST(OwnLines, are_felt_before_their_points_are_there) {
  const BlockOfTissue block = block_of_tissue();
  const Session session = session_on_own_lines(
      block, Points::never, {{Vec3(40.0, 30.0, 0.0), aslant, 3.0}, {Vec3(40.0, 30.0, 0.0), aslant, 3.0}});
  ASSERT_FALSE(session.ticks.empty());
  EXPECT_EQ(values_of(session, EventKind::points_late).size(), 2U);  // once in each insertion
  EXPECT_EQ(punctures_of(session, tissue::skin), 0);
  const Mat3 surface = block.patient.prepared.body->compliance.topLeftCorner<3, 3>();
  const double compliance = aslant.dot(surface * aslant);
  int felt = 0;
  for (const TickRecord& record : session.ticks) {
    if (!record.output.in_contact) continue;
    const double depth = (record.input.needle.translation() - Vec3(40.0, 30.0, 0.0)).dot(aslant);
    EXPECT_NEAR(record.output.resistance, std::min(1.5, depth / compliance), 1e-6);
    ++felt;
  }
  EXPECT_GT(felt, 200);
  expect_replay(session, block);
}

TEST(OwnLines, a_session_in_another_corridor_of_nodes_is_refused_in_a_sentence) {
  const BlockOfTissue block = block_of_tissue();
  Session session = session_on_own_lines(block, Points::in_time, {{Vec3(15.0, 30.0, 0.0), Vec3::UnitZ(), 3.0}});
  session.events.push_back({120, {EventKind::line_taken, tissue::skin, 0.1, 100.0}});
  try {
    replay_session(session, block.patient, {}, block.body.get());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("at 0.120 s its needle took another corridor of mesh nodes"));
  }
}

}  // namespace
}  // namespace bodkin
