// The numbers of the force model, changed while a needle is in the body.
#include "station/adjustable_tick.h"

#include "session/replay.h"
#include "station/station.h"
#include "tests/io/scratch_folder.h"
#include "tests/session/slab_case.h"
#include <gtest/gtest.h>

#include "core/error.h"
#include "forces/model_settings.h"
#include "haptics/drivers/simulated.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::session;
using namespace bodkin::station;
namespace {

simulation::TickRecord record_of(std::uint64_t tick, std::optional<forces::EventKind> what = {}) {
  simulation::TickRecord record;
  record.tick = tick;
  if (what) record.output.events.push({*what, tissue::skin, 0.0, 0.0});
  return record;
}

std::uint64_t first_tick(const InsertionInputs& inputs) {
  const auto first = inputs.first();
  return first ? first->tick : 0;
}

// The initial state of a tick that processes them: the breath before the first one.
TEST(InsertionInputs, keep_the_breath_before_them) {
  InsertionInputs inputs;
  anatomy::BreathState breath;
  for (std::uint64_t tick = 0; tick < 5000; ++tick) {
    simulation::TickRecord record = record_of(tick);
    breath.phase = tick + 1;
    record.output.breath = breath;
    inputs.keep(record);
    ASSERT_EQ(inputs.first()->breath.phase, inputs.first()->tick) << "after so many ticks";
  }
  EXPECT_GT(first_tick(inputs), 4000U);
}

TEST(InsertionInputs, keeps_an_insertion_from_a_moment_before_the_skin) {
  InsertionInputs inputs;
  std::uint64_t tick = 0;
  EXPECT_FALSE(inputs.first().has_value());
  for (; tick < 5000; ++tick) inputs.keep(record_of(tick));
  EXPECT_GE(first_tick(inputs), 4700U) << "outside the last moment is enough";
  inputs.keep(record_of(tick++, forces::EventKind::contact));
  EXPECT_EQ(first_tick(inputs), 4900U);
  for (; tick < 9000; ++tick) inputs.keep(record_of(tick));
  EXPECT_EQ(first_tick(inputs), 4900U) << "the whole insertion";
  EXPECT_EQ(inputs.from(8990, 100).size(), 10U);
  inputs.keep(record_of(tick++, forces::EventKind::withdrawn));
  EXPECT_GE(first_tick(inputs), 8700U);
  EXPECT_FALSE(inputs.is_incomplete());
}

TEST(InsertionInputs, says_that_ticks_of_an_insertion_are_missing_until_it_is_over) {
  InsertionInputs inputs;
  inputs.keep(record_of(0, forces::EventKind::contact));
  inputs.keep(record_of(2));
  EXPECT_TRUE(inputs.is_incomplete());
  inputs.keep(record_of(3, forces::EventKind::withdrawn));
  EXPECT_FALSE(inputs.is_incomplete());
}

class ChangedNumbersTest : public ::testing::Test {
 protected:
  ChangedNumbersTest() : patient_(slab_case({{tissue::skin, 2.0}, {tissue::fat, 12.0}, {tissue::muscle, 36.0}})) {
    patient_.description.device.peak_force = 9.0;
    folder_.write("case.xml", "<case/>");
  }
  StationOptions options() const {
    StationOptions options;
    options.patient = patient_;
    options.case_folder = folder_.path();
    // Slowly in to 15 mm, so that there is time to change a number.
    options.device = {&haptics::simulated_driver(), "", "speed_mm_s=20 start_mm=5 depth_mm=15 wait_s=0.7"};
    options.output = folder_.path() / "session.bodkin";
    options.longest = 30.0;
    return options;
  }
  // The patient's tissues with a stiffer muscle and a skin that grips so many times as much.
  std::vector<TissueProperties> tissues(double times) const {
    std::vector<TissueProperties> all = forces::model_settings(patient_).tissues;
    for (TissueProperties& one : all) {
      if (one.id == tissue::muscle) one.layered.stiffness *= times;
      if (one.id != tissue::skin) continue;
      one.layered.static_friction *= times;
      one.layered.dynamic_friction *= times;
    }
    return all;
  }
  void expect_that_changes_are_felt_and_replay();
  Session recorded() const { return read_session(folder_.path() / "session.bodkin"); }

  ScratchFolder folder_;
  Case patient_;
};

struct Silent : StationObserver {};

void ChangedNumbersTest::expect_that_changes_are_felt_and_replay() {
  Silent observer;
  Station station(options(), observer);
  station.start();
  std::uint32_t felt = 0;
  int ordered = 0;
  while (!station.ended()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    const StationStatus& status = station.update();
    felt = status.needle.changes;
    const double depth = status.needle.output.depth;
    if (depth > 4.0 * (ordered + 1) && ordered < 3)
      station.change_numbers(patient_.description.haptics, tissues(2.0 + ordered++));
  }
  station.finish();
  EXPECT_GE(ordered, 1);
  EXPECT_GE(felt, 1U);
  const Session session = recorded();
  ASSERT_EQ(session.changes.size(), felt);
  for (const NumberChange& change : session.changes) {
    EXPECT_LT(change.from_tick, change.tick);
    EXPECT_GT(session.ticks[change.tick].output.depth, 1.0) << "in the body";
    EXPECT_LT(session.ticks[change.from_tick].output.depth, 0.5) << "from before the skin on";
    EXPECT_GE(change.tissues.size(), 3U) << "two changed, and air";
  }
  Case patient = station.patient();
  const ReplayResult replayed = replay_session(session, patient, {}, nullptr);
  EXPECT_FALSE(replayed.difference.has_value()) << replayed.difference->field << " at " << replayed.difference->tick;
  EXPECT_EQ(replayed.ticks, session.ticks.size());
  // Without the changes the force differs: the needle did feel them.
  Session without = session;
  without.changes.clear();
  const ReplayResult differs = replay_session(without, patient, {}, nullptr);
  ASSERT_TRUE(differs.difference.has_value());
  EXPECT_GE(differs.difference->tick, session.changes.front().tick);
}

TEST_F(ChangedNumbersTest, are_felt_within_an_insertion_and_the_recording_replays_to_the_bit) {
  expect_that_changes_are_felt_and_replay();
}

// The tick that takes over breathes on where the one before was, though it has not gone through all that was before.
TEST_F(ChangedNumbersTest, are_felt_so_while_the_patient_breathes) {
  anatomy::Breathing& breathing = patient_.description.breathing.emplace();
  breathing.rate = 37.0;
  breathing.motion = Vec3(4.0, 0.0, 0.5);
  breathing.centre = patient_.description.procedure.path->target;
  expect_that_changes_are_felt_and_replay();
}

TEST_F(ChangedNumbersTest, are_felt_so_where_the_forces_follow_from_the_needle) {
  patient_.description.haptics.mechanics = anatomy::Mechanics::physical;
  expect_that_changes_are_felt_and_replay();
}

TEST_F(ChangedNumbersTest, of_another_model_or_rate_wait_for_the_next_attempt) {
  Silent observer;
  Station station(options(), observer);
  station.start();
  HapticSettings other = patient_.description.haptics;
  other.rate = 2000.0;
  station.change_numbers(other, tissues(1.0));
  EXPECT_EQ(station.update().message, "another rate takes effect from the next attempt on");
  other = patient_.description.haptics;
  other.resistance = TrackingWallSettings{};
  station.change_numbers(other, tissues(1.0));
  std::string said;
  for (int i = 0; i < 20000 && said.find("another force model") == std::string::npos; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    said = station.update().message;
  }
  EXPECT_EQ(said, "another force model takes effect from the next attempt on");
  station.end();
  station.finish();
  EXPECT_TRUE(recorded().changes.empty());
}

TEST_F(ChangedNumbersTest, come_back_from_the_session_file_as_they_were) {
  NumberChange change{7, 3, patient_.description.haptics, changed_tissues(tissues(1.7), patient_.library)};
  ASSERT_GE(change.tissues.size(), 3U);
  NumberChange read;
  read_texts(texts_of(change), "a test", read);
  EXPECT_EQ(texts_of(read).tissues, texts_of(change).tissues);
  EXPECT_EQ(texts_of(read).haptics, texts_of(change).haptics);
  Case patient = patient_;
  apply(read, patient);
  EXPECT_EQ(patient.library.find(tissue::muscle)->layered.stiffness,
            1.7 * patient_.library.find(tissue::muscle)->layered.stiffness);
  EXPECT_EQ(patient.library.tissues().size(), patient_.library.tissues().size());
  EXPECT_TRUE(changed_tissues(patient_.library.tissues(), patient_.library).empty());
}

}  // namespace
}  // namespace bodkin
