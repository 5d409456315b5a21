// Numbers of the contact with a deformable body, changed while a needle is in it.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "session/replay.h"
#include "station/adjustable_tick.h"
#include "tests/station/block_of_tissue.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "simulation/contact_settings.h"
#include "simulation/haptic_tick.h"

namespace bodkin {

using namespace bodkin::forces;
using namespace bodkin::session;
using namespace bodkin::simulation;
namespace {

// The patient's tissues, of which muscle grips the shaft so many times as much.
std::vector<TissueProperties> gripping(const Case& patient, double times) {
  std::vector<TissueProperties> tissues = patient.library.tissues();
  for (TissueProperties& one : tissues) {
    if (one.id == tissue::muscle) one.deformable.friction *= times;
  }
  return tissues;
}

Case with_tissues(Case patient, const std::vector<TissueProperties>& tissues) {
  patient.library = TissueLibrary(tissues);
  return patient;
}

Pose on_path(double depth) {
  return needle_pose(Vec3(15.0, 30.0, depth), Vec3::UnitZ());
}

// Down the planned path to 20 mm at 20 mm/s and on to 25 mm at 10 mm/s; at 20 mm the skin grips twice as much.
struct ChangedWithin {
  Session session;
  double jump = 0.0;  // N, the largest change of the force in a tick after the change
  double end = 0.0;   // N along the needle
};

ChangedWithin changed_within(const BlockOfTissue& block) {
  ChangedWithin made;
  Session& session = made.session;
  session.header.path = *block.patient.description.procedure.path;
  session.header.haptics = block.patient.description.haptics;
  session.header.dt = 0.001;
  HapticTick tick(block.patient);
  station::AdjustableTick adjustable(std::make_shared<const Case>(block.patient), tick);
  double before = 0.0;
  const auto step = [&](double depth) {
    TickRecord record;
    record.tick = session.ticks.size();
    record.input.needle = on_path(depth);
    record.output = adjustable.step(record.tick, record.input);
    for (const Event& event : record.output.events) session.events.push_back({record.tick, event});
    record.output.events.clear();
    session.ticks.push_back(record);
    if (adjustable.applied_changes() > 0)
      made.jump = std::max(made.jump, std::abs(record.output.resistance - before));
    before = record.output.resistance;
  };
  for (double depth = -3.0; depth < 20.0; depth += 0.02) step(depth);
  adjustable.request_change(block.patient.description.haptics, gripping(block.patient, 2.0),
                            [&](NumberChange change) { session.changes.push_back(std::move(change)); });
  for (int wait = 0; wait < 60000 && adjustable.applied_changes() == 0; ++wait) {
    step(20.0);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  for (double depth = 20.0; depth < 25.0; depth += 0.01) step(depth);
  adjustable.stop();
  made.end = before;
  return made;
}

double pushed_to(const Case& patient, double depth) {
  HapticTick tick(patient);
  double force = 0.0;
  for (double at = -3.0; at < depth; at += 0.01) force = tick.step({on_path(at)}).resistance;
  return force;
}

TEST(ContactChange, is_felt_as_if_the_tissue_had_always_gripped_so_and_without_a_jump) {
  const BlockOfTissue block = block_of_tissue();
  const ChangedWithin made = changed_within(block);
  ASSERT_EQ(made.session.changes.size(), 1U);
  const double once = pushed_to(block.patient, 25.0);
  const double twice = pushed_to(with_tissues(block.patient, gripping(block.patient, 2.0)), 25.0);
  EXPECT_GT(twice, 1.2 * once) << "the two can be told apart";
  EXPECT_NEAR(made.end, twice, 0.02 * twice) << "a shaft that slides rubs as its tissue does";
  EXPECT_LT(made.jump, 0.1 * (twice - once) + 0.02) << "the friction goes over in 100 ticks";
}

TEST(ContactChange, replays_to_the_bit) {
  const BlockOfTissue block = block_of_tissue();
  const Session session = changed_within(block).session;
  ASSERT_EQ(session.changes.size(), 1U);
  EXPECT_EQ(session.changes.front().from_tick, session.changes.front().tick) << "what was before stays as it was";
  const ReplayResult same = replay_session(session, block.patient, {}, block.body.get());
  EXPECT_FALSE(same.difference) << same.difference->field << " at tick " << same.difference->tick;
  EXPECT_EQ(same.ticks, session.ticks.size());
  Session without = session;
  without.changes.clear();
  const ReplayResult differs = replay_session(without, block.patient, {}, block.body.get());
  ASSERT_TRUE(differs.difference.has_value());
  EXPECT_GE(differs.difference->tick, session.changes.front().tick);
}

TEST(ContactChange, what_the_body_is_prepared_with_is_refused_in_a_sentence) {
  const BlockOfTissue block = block_of_tissue();
  HapticTick tick(block.patient);
  station::AdjustableTick adjustable(std::make_shared<const Case>(block.patient), tick);
  std::vector<TissueProperties> stiffer = block.patient.library.tissues();
  for (TissueProperties& one : stiffer) one.deformable.young *= 2.0;
  try {
    adjustable.request_change(block.patient.description.haptics, stiffer, {});
    FAIL() << "the body was prepared with another modulus";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("from the next attempt on"));
  }
}

TEST(ContactSettings, tell_what_acts_at_once_from_what_is_prepared) {
  const Case patient = block_of_tissue().patient;
  const HapticSettings& before = patient.description.haptics;
  const std::vector<TissueProperties> tissues = patient.library.tissues();
  HapticSettings after = before;
  EXPECT_TRUE(differ_in_contact_alone(before, tissues, after, tissues));
  auto& shaft = std::get<EmbeddedNeedleSettings>(after.resistance);
  shaft.puncture_time = 0.1;
  shaft.capture_radius = 2.0;
  EXPECT_TRUE(differ_in_contact_alone(before, tissues, after, gripping(patient, 3.0)));
  shaft.tip_radius = 2.0;
  EXPECT_FALSE(differ_in_contact_alone(before, tissues, after, tissues)) << "the contact points are made with it";
  after = before;
  std::get<EmbeddedNeedleSettings>(after.resistance).body.stiffness_scale = 3.0;
  EXPECT_FALSE(differ_in_contact_alone(before, tissues, after, tissues));
  after = before;
  after.resistance = ClosestNodeSettings{};
  EXPECT_FALSE(differ_in_contact_alone(before, tissues, after, tissues));
  after = before;
  after.constraint = LineSpringSettings{};
  EXPECT_FALSE(differ_in_contact_alone(before, tissues, after, tissues));
  EXPECT_EQ(contact_numbers(patient).capture_radius, 1.5);
  Case rigid = patient;
  rigid.description.haptics.resistance = LayeredSettings{};
  EXPECT_THROW(contact_numbers(rigid), InputError);
}

}  // namespace
}  // namespace bodkin
