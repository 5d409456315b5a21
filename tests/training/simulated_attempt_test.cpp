#include "training/simulated_attempt.h"

#include <cmath>

#include "patient/planning/needle_choice.h"
#include "session/operator_file.h"
#include "tests/training/lumbar_patient.h"
#include <gtest/gtest.h>

#include "anatomy/generic_device.h"
#include "core/random.h"
#include "simulation/closed_loop.h"
#include "training/procedure_file.h"
#include "training/score.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::training;
namespace {

Score attempt_score(const std::string& name, std::uint64_t seed, const Case& patient = lumbar_patient()) {
  const session::Session session =
      simulate_attempt(patient, session::load_operator(name), *patient.description.procedure.path, seed);
  return score(session, patient.description, find_procedure("lumbar_puncture"),
               {&patient.structures, &patient.tissues});
}

double value(const Score& score, const char* metric) {
  const MetricResult* result = score.find(metric);
  EXPECT_NE(result, nullptr) << metric;
  return result == nullptr ? 0.0 : result->value;
}

// The two shipped operators, on the synthetic patient.
TEST(SimulatedAttempt, the_expert_reaches_the_fluid_without_touching_bone_and_passes) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Score result = attempt_score("expert", seed);
    EXPECT_EQ(result.verdict, Grade::pass) << seed << ' ' << result.headline << result.findings[0].sentence;
    EXPECT_EQ(result.level, "L3_L4");
    EXPECT_EQ(value(result, "bone_contacts"), 0.0) << seed;
    EXPECT_LT(value(result, "final_distance_mm"), 5.0) << seed;
  }
}

TEST(SimulatedAttempt, novices_stray_overshoot_and_strike_bone_more_than_experts) {
  constexpr std::uint64_t people = 12;
  double deviation[2] = {}, deepest[2] = {}, bone[2] = {}, distance[2] = {}, tremor[2] = {};
  for (std::uint64_t seed = 1; seed <= people; ++seed) {
    for (const int who : {0, 1}) {
      const Score result = attempt_score(who == 0 ? "expert" : "novice", seed);
      deviation[who] += value(result, "deviation_max_mm");
      deepest[who] += value(result, "deepest_mm");
      bone[who] += value(result, "bone_contacts");
      distance[who] += value(result, "final_distance_mm");
      tremor[who] += value(result, "tremor_mm");
    }
  }
  EXPECT_GT(deviation[1], 2.0 * deviation[0]);
  EXPECT_GT(deepest[1], deepest[0] + 3.0 * people) << "3 mm deeper on average";
  EXPECT_GE(bone[1], bone[0]);
  EXPECT_GT(distance[1], 1.5 * distance[0]);
  EXPECT_GT(tremor[1], 2.0 * tremor[0]);
}

// The needle's final resting place, or the nerve root or disc that it pierced before, or the dura if it pierced that
// without resting.
TissueId place_found(const Case& patient, const char* name, std::uint64_t seed) {
  const simulation::OperatorScript script = session::load_operator(name);
  simulation::ClosedLoop loop(patient, script, *patient.description.procedure.path, seed);
  simulation::TickRecord record;
  TissueId there = tissue::air;
  for (int tick = 0; tick < 120000 && !loop.finished(); ++tick) {
    loop.step(record);
    for (const forces::Event& event : record.output.events) {
      if (event.kind != forces::EventKind::puncture) continue;
      if (event.tissue == tissue::nerve || event.tissue == tissue::disc) return event.tissue;
      if (event.tissue == tissue::dura) there = tissue::dura;
    }
    if (!loop.finished() && script.phases[static_cast<std::size_t>(loop.phase())].name == "hold")
      there = record.output.tissue;
  }
  return there;
}

// The ligamentum flavum takes 0.8 N with a 25G needle and 2.3 N with 20G; the tables state 3.2 N for every needle.
TEST(SimulatedAttempt, experts_find_their_place_with_the_forces_of_the_needle_and_novices_mostly_do_not) {
  Case patient = lumbar_patient();
  patient.description.haptics.mechanics = Mechanics::physical;
  for (const char* needle : {"20,90,quincke", "22,90,quincke", "25,90,whitacre"}) {
    patient.description.needle = patient::parse_needle(needle);
    for (std::uint64_t seed = 1; seed <= 4; ++seed)
      EXPECT_EQ(place_found(patient, "expert", seed), tissue::cerebrospinal_fluid) << needle << ", seed " << seed;
    EXPECT_EQ(attempt_score("expert", 1, patient).verdict, Grade::pass) << needle;
    constexpr std::uint64_t people = 8;
    std::uint64_t passed = 0;
    for (std::uint64_t seed = 1; seed <= people; ++seed)
      passed += attempt_score("novice", seed, patient).verdict == Grade::pass ? 1 : 0;
    EXPECT_LE(2 * passed, people) << needle;
  }
}

// 18G takes 7.6 N at the ligamentum flavum, more than the 6 N assumed for an unknown device.
TEST(SimulatedAttempt, the_expert_finds_the_epidural_space_where_the_device_is_strong_enough) {
  Case patient = lumbar_patient();
  patient.description.haptics.mechanics = Mechanics::physical;
  NeedlePath& path = *patient.description.procedure.path;
  path.target -= 7.0 * path.direction();  // in the epidural space
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    patient.description.device = {};
    patient.description.needle = patient::parse_needle("20,90,tuohy");
    EXPECT_EQ(place_found(patient, "expert_epidural", seed), tissue::epidural_fat) << seed;
    patient.description.needle = patient::parse_needle("18,90,tuohy");
    EXPECT_EQ(place_found(patient, "expert_epidural", seed), tissue::air) << seed << ": it gives up, the dura whole";
    patient.description.device = generic_device(patient.description.needle, Mechanics::physical);
    EXPECT_EQ(place_found(patient, "expert_epidural", seed), tissue::epidural_fat) << seed;
  }
}

// The table was computed by `bodkin cohort` on this patient.
TEST(SimulatedAttempt, the_experts_that_come_with_bodkin_are_like_those_that_it_makes_now) {
  const auto experts = ExpertSet::shipped("lumbar_puncture");
  ASSERT_TRUE(experts.has_value());
  EXPECT_EQ(experts->size(), 60U);
  Case patient = lumbar_patient_of(1.0);
  patient.description.haptics.mechanics = Mechanics::physical;
  for (std::uint64_t seed = 101; seed <= 104; ++seed) {
    const Score result = attempt_score("expert", seed, patient);
    for (const char* metric : {"deepest_mm", "path_length_mm", "peak_force_N", "time_in_body_s", "tremor_mm"}) {
      const auto place = experts->place(metric, value(result, metric));
      ASSERT_TRUE(place.has_value()) << metric;
      EXPECT_LT(std::abs(place->z), 8.0) << metric << ": make the table again, docs/cohorts.md says how";
    }
  }
}

// The whole procedure: finger, stylet, opening pressure, drip, closing pressure, stylet.
TEST(SimulatedAttempt, the_expert_feels_the_interspace_and_measures_the_fluid) {
  Case patient = lumbar_patient();
  patient.description.haptics.parts.fingertip.emplace();
  patient.description.haptics.parts.csf_flow =
      CsfFlowSettings{.manometer = false, .stylet = true, .pressure_volume_index = 25.0, .times_faster = 20.0};
  const auto scored = [&](const char* name) {
    const session::Session session =
        simulate_attempt(patient, session::load_operator(name), *patient.description.procedure.path, 3);
    return score(session, patient.description, find_procedure("lumbar_puncture"),
                 {&patient.structures, &patient.tissues});
  };
  const Score whole = scored("expert_lumbar_puncture");
  EXPECT_EQ(whole.verdict, Grade::pass) << whole.headline << whole.findings[0].sentence;
  EXPECT_EQ(value(whole, "felt_places"), 2.0);
  EXPECT_LT(value(whole, "felt_to_entry_mm"), 6.0);
  EXPECT_LT(value(whole, "entry_to_midline_mm"), 3.0);
  EXPECT_LT(value(whole, "entry_to_interspace_mm"), 3.0);
  EXPECT_EQ(value(whole, "insertions"), 1.0) << "a finger is no needle";
  EXPECT_NEAR(value(whole, "opening_pressure_cmH2O"), 0.98 * 14.5, 0.3) << "a little has dripped before";
  EXPECT_LT(value(whole, "pressure_settling_s"), 8.0);
  const double collected = value(whole, "collected_mL");
  EXPECT_GT(collected, 1.0);
  EXPECT_NEAR(value(whole, "closing_pressure_cmH2O"), 0.98 * 14.5 * std::pow(10.0, -collected / 25.0), 0.3);
  EXPECT_EQ(value(whole, "withdrawn_open"), 0.0);
  for (const StepResult& step : whole.steps) EXPECT_TRUE(step.time.has_value()) << step.title;

  const Score plain = scored("expert");  // neither palpates nor measures
  EXPECT_EQ(plain.verdict, Grade::borderline);
  EXPECT_EQ(value(plain, "felt_places"), 0.0);
  EXPECT_EQ(value(plain, "pressure_readings"), 0.0);
}

}  // namespace
}  // namespace bodkin
