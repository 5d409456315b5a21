#include "simulation/closed_loop.h"

#include "tests/simulation/real_time_guard.h"
#include "tests/simulation/slab_patient.h"
#include <gtest/gtest.h>

#include "core/single_producer_ring.h"
#include "haptics/deadline_clock.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::haptics;
using namespace bodkin::simulation;
namespace {

const NeedlePath slab_path{{0, 0, 0}, {0, 0, 40}};

OperatorCondition switch_after(double time, int next) {
  OperatorCondition condition;
  condition.time = time;
  condition.next = next;
  return condition;
}

// Advances by steps until a puncture, holds, aims again and advances once more, repeatedly.
OperatorScript restless() {
  OperatorScript script;
  script.name = "restless";
  script.hand.tremor = 0.05;
  script.hand.tremor_angle = 0.002;
  script.unsteadiness = 0.3;
  script.wander = 0.2;
  script.wander_angle = 0.005;
  script.start_distance = 5.0;
  OperatorPhase in{.name = "in", .speed = 15.0, .step = 5.0, .pause = 0.1};
  OperatorCondition gave_way;
  gave_way.force_drop = 1.5;
  gave_way.next = 1;
  OperatorCondition hard;
  hard.force_above = 4.5;
  hard.hardness_above = 0.2;
  hard.next = 1;
  in.until = {gave_way, hard, switch_after(5.0, 1)};
  OperatorPhase hold{.name = "hold", .until = {switch_after(0.3, 2)}};
  OperatorPhase out{.name = "out", .speed = -40.0};
  OperatorCondition outside;
  outside.depth_below = -8.0;
  outside.next = 3;
  out.until = {outside, switch_after(5.0, 3)};
  OperatorPhase again{.name = "again", .aim_again = true, .until = {switch_after(0.2, 0)}};
  script.phases = {in, hold, out, again};
  return script;
}

TEST(ClosedLoop, the_hand_feels_the_tissue_and_the_tissue_stops_the_hand) {
  const Case patient = slab_patient();
  OperatorScript script;
  script.name = "steady";
  script.aim_position = 0.0;
  script.aim_angle = 0.0;
  script.start_distance = 5.0;
  script.phases = {{.name = "in", .speed = 10.0, .until = {switch_after(60.0, OperatorCondition::end)}}};
  ClosedLoop loop(patient, script, slab_path, 1);
  TickRecord record;
  // Bone begins at 44 mm and renders 1 N/mm, the hand has 2 N/mm: it lags ever more behind the intention.
  for (int tick = 0; tick < 5500; ++tick) loop.step(record);
  const double intended = -5.0 + 10.0 * 5.5;
  EXPECT_EQ(record.tick, 5499u);
  EXPECT_EQ(record.output.tissue, tissue::cortical_bone);
  EXPECT_LT(record.input.needle.translation().z(), intended - 1.0);
  const double axial = -record.output.applied.force.z();
  EXPECT_GT(axial, 2.0);
  // near balance of spring and force: the motion is slow
  EXPECT_NEAR(script.hand.stiffness * (intended - record.input.needle.translation().z()), axial, 0.5);
}

TEST(ClosedLoop, a_whole_attempt_allocates_nothing_and_locks_nothing) {
  if (!RealTimeGuard::available()) GTEST_SKIP() << "a sanitizer owns malloc and the locks in this build";
  const Case patient = slab_patient();
  ClosedLoop loop(patient, restless(), slab_path, 2);
  SingleProducerRing<TickRecord> ring(64);
  DeadlineClock clock(1e-6);
  TickRecord record;
  int phases = 0, last = -1;
  std::size_t heap = 0, locks = 0;
  clock.start();
  {
    const RealTimeGuard guard;
    for (int tick = 0; tick < 40000; ++tick) {
      if (tick % 1000 == 0) clock.wait();
      loop.step(record);
      ring.push(record);
      ring.pop(record);
      if (loop.phase() != last) ++phases;
      last = loop.phase();
    }
    heap = RealTimeGuard::heap_calls();
    locks = RealTimeGuard::lock_calls();
  }
  EXPECT_EQ(heap, 0u);
  EXPECT_EQ(locks, 0u);
  EXPECT_GT(phases, 8) << "all phases were gone through";
}

}  // namespace
}  // namespace bodkin
