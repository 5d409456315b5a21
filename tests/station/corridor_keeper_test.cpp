// A hand goes where no corridor of the deformable body was prepared.
#include "station/corridor_keeper.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

#include "patient/prepared_body.h"
#include "session/replay.h"
#include "tests/fem/lattice_body.h"
#include "tests/simulation/real_time_guard.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "fem/solid/patient_body.h"
#include "io/tissue_library_file.h"
#include "simulation/haptic_tick.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
using namespace bodkin::forces;
using namespace bodkin::io;
using namespace bodkin::patient;
using namespace bodkin::session;
using namespace bodkin::simulation;
using namespace bodkin::station;
namespace {

using ::testing::HasSubstr;

constexpr double block_side = 60.0;  // mm

struct BlockOfTissue {
  Case patient;
  std::shared_ptr<const BodyDescription> body;
};

// A block of tissue, skin at z = 0, whose planned path runs at x = 15; the corridor reaches 8 mm.
BlockOfTissue block_of_tissue(NeedleContactKind contact = NeedleContactKind::nodes) {
  BlockOfTissue made;
  Case& patient = made.patient;
  patient.library = default_tissue_library();
  Grid grid;
  grid.size = {60, 60, 80};
  grid.origin = Vec3(0.5, 0.5, -19.5);
  patient.tissues = TissueVolume(grid, tissue::air);
  for (int k = 20; k < 80; ++k)
    for (int j = 0; j < 60; ++j)
      for (int i = 0; i < 60; ++i) patient.tissues.at(i, j, k) = k < 22 ? tissue::skin : tissue::muscle;
  patient.ct = CtVolume(grid, 40);
  patient.description.device = {"strong", 100.0, 50.0, 1e6, 100.0, 0.0};
  patient.description.haptics.constraint = NoConstraint{};
  EmbeddedNeedleSettings settings;
  settings.contact = contact;
  settings.capture_radius = 4.0;
  settings.spacing = 4.0;
  settings.body.corridor_radius = 8.0;
  settings.body.fix_cut = false;
  settings.body.fix_beyond = 55.0;
  patient.description.haptics.resistance = settings;
  patient.description.procedure.path = NeedlePath{Vec3(15.0, 30.0, 0.0), Vec3(15.0, 30.0, 30.0)};
  TetrahedralMesh mesh = kuhn_lattice(13, block_side);
  std::fill(mesh.tissues.begin(), mesh.tissues.end(), tissue::muscle);
  const NeedlePath& path = *patient.description.procedure.path;
  made.body = std::make_shared<const BodyDescription>(describe_body(mesh, patient, settings.body, path).body);
  if (contact == NeedleContactKind::points) {
    std::shared_ptr<const ContactBody> kept;
    patient.corridor = another_corridor(*made.body, patient, path, 0, kept);
    patient.corridor.aimed_at.reset();
  } else {
    patient.corridor = {std::make_shared<const CondensedBody>(condense(*made.body)), path, {}};
  }
  return made;
}

Pose needle_over_block(double x, double z) {
  return needle_pose(Vec3(x, 30.0, z), Vec3::UnitZ());
}

// What the keeper gives when it is asked until it has something; nothing after 20 s.
std::optional<PreparedCorridor> wait_for(CorridorKeeper& keeper, const Pose& needle, std::uint64_t tick) {
  for (int tries = 0; tries < 2000; ++tries) {
    CorridorKeeper::News news = keeper.update(needle, tick);
    if (news.ready) return news.ready;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return {};
}

TEST(CorridorKeeper, prepares_where_the_needle_aims_and_nothing_else_covers_its_way) {
  const BlockOfTissue block = block_of_tissue();
  CorridorKeeper keeper(std::make_shared<const Case>(block.patient), block.body, 30.0, 2);
  EXPECT_FALSE(keeper.update(needle_over_block(17.0, -10.0), 1).sentence);   // along the planned path
  EXPECT_FALSE(keeper.update(needle_over_block(45.0, 5.0), 2).sentence);     // in the body
  EXPECT_FALSE(keeper.update(needle_over_block(500.0, -10.0), 3).sentence);  // past the patient
  EXPECT_FALSE(keeper.is_preparing());
  const CorridorKeeper::News begun = keeper.update(needle_over_block(45.0, -10.0), 4);
  ASSERT_TRUE(begun.sentence);
  EXPECT_THAT(*begun.sentence, HasSubstr("wait outside"));
  EXPECT_TRUE(keeper.is_preparing());
  const std::optional<PreparedCorridor> made = wait_for(keeper, needle_over_block(20.0, -10.0), 5);
  ASSERT_TRUE(made);
  EXPECT_EQ(made->aimed_at, 4U);
  EXPECT_NEAR(made->path.entry.x(), 45.0, 1e-12);
  EXPECT_NEAR(made->path.length(), 30.0, 1e-12);
  EXPECT_FALSE(keeper.update(needle_over_block(45.0, -10.0), 6).sentence);  // there now
  ASSERT_TRUE(wait_for(keeper, needle_over_block(30.0, -10.0), 7));
  EXPECT_THAT(keeper.update(needle_over_block(58.0, -10.0), 8).sentence.value_or(""), HasSubstr("no room"));
  EXPECT_FALSE(keeper.update(needle_over_block(58.0, -10.0), 9).sentence);  // said once
}

TEST(CorridorKeeper, prepares_the_points_of_every_line_at_which_the_needle_stays_aimed) {
  const BlockOfTissue block = block_of_tissue(NeedleContactKind::points);
  CorridorKeeper keeper(std::make_shared<const Case>(block.patient), block.body, 30.0, 31);
  EXPECT_FALSE(keeper.update(needle_over_block(16.0, -10.0), 1).sentence);  // along the planned path
  for (int i = 0; i < 20; ++i) keeper.update(needle_over_block(20.0 + 1.5 * i, -10.0), 2);
  EXPECT_FALSE(keeper.is_preparing());  // the hand was on its way
  for (const double x : {18.0, 45.0, 31.0}) {
    const std::optional<PreparedCorridor> made = wait_for(keeper, needle_over_block(x, -10.0), 7);
    ASSERT_TRUE(made) << x;
    EXPECT_TRUE(made->body->has_contact_points());
    for (const Vec3& point : made->body->nodes) EXPECT_LT(std::hypot(point.x() - x, point.y() - 30.0), 1e-9);
  }
}

TEST(CorridorKeeper, is_left_at_once_while_it_prepares) {
  const BlockOfTissue block = block_of_tissue();
  const auto before = std::chrono::steady_clock::now();
  {
    CorridorKeeper keeper(std::make_shared<const Case>(block.patient), block.body, 30.0, 2);
    keeper.update(needle_over_block(45.0, -10.0), 4);
  }
  EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(10));
}

// A session of two punctures, the second where the needle aimed in tick 100, and its replay.
void expect_another_corridor_to_replay(NeedleContactKind contact) {
  BlockOfTissue block = block_of_tissue(contact);
  Session session;
  session.header.path = *block.patient.description.procedure.path;
  session.header.haptics = block.patient.description.haptics;
  session.header.dt = 0.001;
  HapticTick tick(block.patient);
  CorridorKeeper keeper(std::make_shared<const Case>(block.patient), block.body, 30.0, 2);
  double greatest = 0.0;
  const auto step = [&](const Pose& needle) {
    TickRecord record;
    record.tick = session.ticks.size();
    record.input.needle = needle;
    record.output = tick.step(record.input);
    greatest = std::max(greatest, record.output.resistance);
    for (const Event& event : record.output.events) session.events.push_back({record.tick, event});
    record.output.events.clear();
    session.ticks.push_back(record);
  };
  for (int i = 0; i <= 100; ++i) step(needle_over_block(45.0, -10.0));
  const std::optional<PreparedCorridor> made = wait_for(keeper, needle_over_block(45.0, -10.0), 100);
  ASSERT_TRUE(made);
  ASSERT_TRUE(tick.body()->add_corridor(*made));
  for (const double x : {15.0, 45.5}) {
    greatest = 0.0;
    for (double z = -10.0; z < 25.0; z += 0.1) step(needle_over_block(x, z));
    EXPECT_GT(greatest, 0.5) << x;
    for (double z = 25.0; z > -10.0; z -= 0.1) step(needle_over_block(x, z));
  }
  const auto taken = std::find_if(session.events.begin(), session.events.end(), [](const SessionEvent& event) {
    return event.event.kind == EventKind::corridor_taken;
  });
  ASSERT_NE(taken, session.events.end());
  EXPECT_EQ(taken->event.value, 100.0);
  const ReplayResult same = replay_session(session, block.patient, {}, block.body.get());
  EXPECT_FALSE(same.difference) << same.difference->field << " at tick " << same.difference->tick;
  EXPECT_EQ(same.ticks, session.ticks.size());
  EXPECT_THROW(replay_session(session, block.patient), InputError);  // without the body
}

TEST(CorridorKeeper, a_session_that_took_another_corridor_replays_to_the_bit) {
  expect_another_corridor_to_replay(NeedleContactKind::nodes);
}

TEST(CorridorKeeper, a_session_that_took_the_points_of_another_line_replays_to_the_bit) {
  expect_another_corridor_to_replay(NeedleContactKind::points);
}

// A straight way in and out again at 50 mm/s; `depth`: mm.
struct Insertion {
  Vec3 entry, direction;
  double depth = 25.0;
  bool is_planned = false;  // along the planned path, of which nothing has to be computed
};

const Vec3 aslant = Vec3(0.3, 0.0, 1.0).normalized();

// Two where nothing is prepared, the second aslant through the first one's hole.
const std::vector<Insertion> through_one_hole = {{Vec3(40.0, 30.0, 0.0), Vec3::UnitZ()},
                                                 {Vec3(40.2, 30.0, 0.0), aslant}};

enum class Points {
  never,     // nothing computes them
  any_time,  // the loop is much faster than the clock
  in_time    // the hand waits outside for them
};

Session session_on_own_lines(const BlockOfTissue& block, Points points, const std::vector<Insertion>& insertions) {
  Session session;
  session.header.path = *block.patient.description.procedure.path;
  session.header.haptics = block.patient.description.haptics;
  session.header.dt = 0.001;
  HapticTick tick(block.patient);
  const std::shared_ptr<ContactLine> line = tick.body()->stream_points(false);
  if (line == nullptr) return session;
  std::shared_ptr<const ContactBody> kept;
  std::unique_ptr<ContactStream> stream;
  const auto patient = std::make_shared<const Case>(block.patient);
  if (points != Points::never)
    stream = contact_stream(*block.body, patient, session.header.path.length(), kept, line);
  std::size_t real_time_calls = 0;
  const auto step = [&](const Insertion& insertion, double way) {
    TickRecord record;
    record.tick = session.ticks.size();
    record.input.needle = needle_pose(insertion.entry + way * insertion.direction, insertion.direction);
    {
      const RealTimeGuard guard;
      record.output = tick.step(record.input);
      real_time_calls += RealTimeGuard::heap_calls() + RealTimeGuard::lock_calls();
    }
    for (const Event& event : record.output.events) session.events.push_back({record.tick, event});
    record.output.events.clear();
    session.ticks.push_back(record);
    if (points == Points::in_time && !insertion.is_planned && !record.output.in_contact)
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

void expect_replay(const Session& session, const BlockOfTissue& block) {
  const ReplayResult same = replay_session(session, block.patient, {}, block.body.get());
  EXPECT_FALSE(same.difference) << same.difference->field << " at tick " << same.difference->tick;
  EXPECT_EQ(same.ticks, session.ticks.size());
}

TEST(OwnLines, a_needle_enters_where_nothing_was_prepared) {
  const BlockOfTissue block = block_of_tissue(NeedleContactKind::points);
  const Session session = session_on_own_lines(block, Points::in_time, through_one_hole);
  ASSERT_FALSE(session.ticks.empty());
  EXPECT_EQ(values_of(session, EventKind::corridor_taken), std::vector<double>{BodyPort::own_line});
  EXPECT_TRUE(values_of(session, EventKind::points_late).empty());
  EXPECT_TRUE(values_of(session, EventKind::corridor_left).empty());
  EXPECT_EQ(punctures_of(session, tissue::skin), 1);  // the second finds the hole
  double greatest = 0.0;
  for (const TickRecord& record : session.ticks) greatest = std::max(greatest, record.output.resistance);
  EXPECT_GT(greatest, 1.4);
  expect_replay(session, block);
}

TEST(OwnLines, a_session_whose_points_come_at_any_time_replays_to_the_bit) {
  const BlockOfTissue block = block_of_tissue(NeedleContactKind::points);
  const Session session = session_on_own_lines(block, Points::any_time, through_one_hole);
  ASSERT_FALSE(session.ticks.empty());
  expect_replay(session, block);
  EXPECT_THROW(replay_session(session, block.patient), InputError);  // without the body
}

TEST(OwnLines, share_their_holes_with_prepared_lines) {
  const BlockOfTissue block = block_of_tissue(NeedleContactKind::points);
  const Vec3 planned = block.patient.description.procedure.path->entry;
  const Insertion prepared{planned, Vec3::UnitZ(), 15.0, true};
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

// The surface is felt at once, with the compliance that it has where the path was planned.
TEST(OwnLines, are_felt_before_their_points_are_there) {
  const BlockOfTissue block = block_of_tissue(NeedleContactKind::points);
  const Session session = session_on_own_lines(
      block, Points::never, {{Vec3(40.0, 30.0, 0.0), aslant, 3.0}, {Vec3(40.0, 30.0, 0.0), aslant, 3.0}});
  ASSERT_FALSE(session.ticks.empty());
  EXPECT_EQ(values_of(session, EventKind::points_late).size(), 2U);  // once in each insertion
  EXPECT_EQ(punctures_of(session, tissue::skin), 0);
  const Mat3 surface = block.patient.corridor.body->compliance.topLeftCorner<3, 3>();
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

TEST(OwnLines, are_of_contact_points_alone) {
  const BlockOfTissue block = block_of_tissue();
  HapticTick tick(block.patient);
  EXPECT_EQ(tick.body()->stream_points(false), nullptr);
}

}  // namespace
}  // namespace bodkin
