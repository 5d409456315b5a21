#include "simulation/operator_thresholds.h"

#include <string>

#include "tests/one_tick.h"
#include "tests/simulation/slab_patient.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "forces/needle_law.h"
#include "io/tissue_library_file.h"
#include "simulation/closed_loop.h"

namespace bodkin {

namespace {

constexpr double slab_flavum = 3.0;  // N, at which the flavum of slab_patient() gives way

OperatorScript waiting_for(const OperatorCondition& condition) {
  OperatorScript script;
  script.name = "feeler";
  OperatorPhase in;
  in.name = "in";
  in.speed = 5.0;
  in.until = {condition};
  script.phases = {in};
  return script;
}

OperatorCondition share_of(const std::string& tissue, std::optional<double> drop, std::optional<double> force) {
  OperatorCondition condition;
  condition.share_of = tissue;
  condition.drop_share = drop;
  condition.force_above_share = force;
  return condition;
}

OperatorCondition known_to(const OperatorCondition& condition, const Case& patient) {
  return for_patient(waiting_for(condition), patient).phases[0].until[0];
}

TEST(OperatorThresholds, are_shares_of_the_force_at_which_the_tissue_gives_way) {
  const OperatorCondition known = known_to(share_of("flavum", 0.5, 1.5), slab_patient());
  EXPECT_DOUBLE_EQ(known.force_drop.value(), 0.5 * slab_flavum);
  EXPECT_DOUBLE_EQ(known.force_above.value(), 1.5 * slab_flavum);
  EXPECT_FALSE(known.has_share());
  EXPECT_TRUE(known.has_force_condition());
}

TEST(OperatorThresholds, are_the_larger_of_share_and_newtons) {
  OperatorCondition both = share_of("flavum", 0.5, 0.5);
  both.force_drop = 1.4;
  both.force_above = 1.6;
  const OperatorCondition known = known_to(both, slab_patient());
  EXPECT_DOUBLE_EQ(known.force_drop.value(), 1.5);
  EXPECT_DOUBLE_EQ(known.force_above.value(), 1.6);
}

TEST(OperatorThresholds, are_no_more_than_the_device_renders) {
  Case patient = slab_patient();
  patient.description.device.peak_force = 4.0;
  EXPECT_DOUBLE_EQ(known_to(share_of("flavum", {}, 2.0), patient).force_above.value(), 3.8) << "not 6 N";
  OperatorCondition both = share_of("flavum", {}, 2.0);
  both.force_above = 5.0;
  EXPECT_DOUBLE_EQ(known_to(both, patient).force_above.value(), 5.0) << "whoever says newtons means them";
}

TEST(OperatorThresholds, follow_the_needle_where_the_tissues_are_described) {
  Case patient;
  patient.library = io::default_tissue_library();
  const OperatorCondition condition = share_of("ligamentum_flavum", 0.625, {});
  EXPECT_DOUBLE_EQ(known_to(condition, patient).force_drop.value(), 2.0) << "tables, 3.2 N";
  patient.description.haptics.mechanics = Mechanics::physical;
  const PhysicalTissue& flavum = patient.library.find(tissue::ligamentum_flavum)->physical;
  for (const int gauge : {18, 22, 25}) {
    patient.description.needle.gauge = gauge;
    patient.description.needle.outer_diameter = gauge_size(gauge)->outer_diameter;
    EXPECT_NEAR(known_to(condition, patient).force_drop.value(),
                0.625 * forces::puncture_force(flavum, patient.description.needle), 1e-12)
        << gauge;
  }
}

// Muscle gives way at 0.5 N: the drop is felt as soon as the share is that small.
TEST(OperatorThresholds, are_known_to_the_hand_in_the_patient) {
  const Case patient = slab_patient();
  const NeedlePath line{{0.0, 0.0, 0.0}, {0.0, 0.0, 42.0}};
  const auto stops_at = [&](double share) {
    OperatorScript script = waiting_for(share_of("flavum", share, {}));
    script.aim_position = script.aim_angle = 0.0;
    ClosedLoop loop(patient, script, line, 1);
    TickRecord record;
    for (int tick = 0; tick < 20000 && !loop.finished(); ++tick) loop.step(record);
    return record.output.depth;
  };
  EXPECT_GT(stops_at(0.6), 32.0);
  EXPECT_LT(stops_at(0.1), 20.0);
}

TEST(OperatorThresholds, without_a_tissue_that_gives_way_are_refused) {
  const auto refusal = [](const std::string& tissue) -> std::string {
    try {
      known_to(share_of(tissue, 0.5, {}), slab_patient());
    } catch (const InputError& error) {
      return error.what();
    }
    return "it was accepted";
  };
  for (const char* tissue : {"jelly", "fat", "bone"})
    EXPECT_THAT(refusal(tissue), ::testing::AllOf(::testing::HasSubstr("operator 'feeler': phase 'in'"),
                                                  ::testing::HasSubstr("'" + std::string(tissue) + "' gives way")));
  const NeedlePath line{{0.0, 0.0, 0.0}, {0.0, 0.0, 42.0}};
  EXPECT_THROW(Operator(waiting_for(share_of("flavum", 0.5, {})), line, 1, one_tick), InputError)
      << "nobody has said how much that is";
  EXPECT_THROW(check(waiting_for(share_of("", 0.5, {})), "mine"), InputError);
  EXPECT_THROW(check(waiting_for(share_of("flavum", {}, {})), "mine"), InputError);
  EXPECT_THROW(check(waiting_for(share_of("flavum", 1e-4, {})), "mine"), InputError);
}

}  // namespace
}  // namespace bodkin
