#include "training/score.h"

#include <algorithm>
#include <cmath>

#include "tests/training/written_session.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "training/procedure_file.h"
#include "training/sentences.h"

namespace bodkin {

using namespace bodkin::forces;
using namespace bodkin::training;
namespace {

using ::testing::HasSubstr;

const training::Procedure& lumbar() {
  static const training::Procedure procedure = find_procedure("lumbar_puncture");
  return procedure;
}

Score score_of(WrittenSession& written, const training::Procedure& procedure = lumbar(),
               const PatientVolumes& volumes = {}) {
  return score(written.session(), written_description(), procedure, volumes);
}

std::string sentences(const Score& score) {
  std::string all;
  for (const Finding& each : score.findings) all += each.sentence + "\n";
  return all;
}

TEST(Score, a_puncture_without_fault_passes) {
  for (WrittenSession written : {good_puncture(), withdrawn(good_puncture())}) {
    const Score result = score_of(written);
    EXPECT_EQ(result.verdict, Grade::pass) << sentences(result);
    EXPECT_TRUE(result.reached);
    EXPECT_EQ(result.headline, "Passed: the tip came to rest in the cerebrospinal fluid");
    EXPECT_TRUE(result.harms.empty());
    EXPECT_EQ(result.final_tip->tissue, tissue::cerebrospinal_fluid);
    EXPECT_NEAR(result.final_tip->depth, 50.0, 0.02);
    EXPECT_THAT(sentences(result), HasSubstr("You crossed the ligamentum flavum at 40.0 mm and stopped 1.0 mm"));
  }
}

TEST(Score, every_step_is_found_with_its_time_and_depth) {
  WrittenSession written = withdrawn(good_puncture());
  // The needle touched the skin earlier and came off again: that was no withdrawal.
  written.session().events.insert(written.session().events.begin(),
                                  {100, {EventKind::withdrawn, tissue::air, 0.0, 0.0}});
  const Score result = score_of(written);
  ASSERT_EQ(result.steps.size(), lumbar().steps.size());
  for (const StepResult& step : result.steps) {
    if (step.title == "Cross the ligamentum flavum") {
      EXPECT_NEAR(*step.depth, 36.0, 0.02);
    }
    if (step.title == "Withdraw") {
      EXPECT_GT(*step.time, 15.0);
    }
    if (step.title == "Let fluid return") {
      EXPECT_FALSE(step.time.has_value());
    }
  }
}

// The tip jumps through the ligament between two ticks: only its event shows the crossing.
TEST(Score, a_ligament_that_the_tip_jumps_through_was_crossed) {
  WrittenSession written;
  written.to(0, 500, WrittenSession::air).event(EventKind::contact, tissue::skin);
  written.to(5, 1000, {true, tissue::skin, 1.0}).event(EventKind::puncture, tissue::skin, 1.3);
  written.to(42, 6000, {true, tissue::interspinous_ligament, 5.0});
  const double jumped = written.session().ticks.size() * written.session().header.dt;
  written.event(EventKind::tissue_entered, tissue::ligamentum_flavum);
  written.event(EventKind::loss_of_resistance, tissue::epidural_fat, 4.5);
  written.to(43, 200, {true, tissue::epidural_fat, 0.5}).rest(1000, {true, tissue::epidural_fat, 0.2});
  bool found = false;
  for (const StepResult& step : score_of(written).steps) {
    if (step.title != "Cross the ligamentum flavum") continue;
    found = true;
    ASSERT_TRUE(step.time.has_value());
    EXPECT_NEAR(*step.time, jumped, 0.01);
    EXPECT_NEAR(*step.depth, 42.0, 0.1);
  }
  EXPECT_TRUE(found);
}

TEST(Score, one_tick_in_a_nerve_is_dangerous_whatever_else_was_reached) {
  const std::size_t count = good_puncture().session().ticks.size();
  Random random(5);
  for (int trial = 0; trial < 40; ++trial) {
    WrittenSession written = good_puncture();
    const auto at = static_cast<std::size_t>(random.uniform(600.0, static_cast<double>(count) - 1.0));
    written.session().ticks[at].output.tissue = tissue::nerve;
    const Score result = score_of(written);
    EXPECT_EQ(result.verdict, Grade::dangerous) << at;
    EXPECT_EQ(result.headline, "Dangerous: the tip entered a nerve root");
    ASSERT_EQ(result.harms.size(), 1U);
    EXPECT_NEAR(result.harms[0].time_inside, 0.001, 1e-9);
  }
}

TEST(Score, whatever_a_procedure_forbids_is_found_in_it) {
  for (const std::string& name : shipped_procedures()) {
    const training::Procedure procedure = find_procedure(name);
    for (const Forbidden& each : procedure.forbidden) {
      if (each.tissue.empty()) continue;
      WrittenSession written = good_puncture();
      const auto& tissues = written.session().header.tissues;
      const auto id = std::find_if(tissues.begin(), tissues.end(),
                                   [&](const session::TissueName& tissue) { return tissue.name == each.tissue; });
      ASSERT_NE(id, tissues.end()) << name << " forbids " << each.tissue;
      written.session().ticks[4000].output.tissue = id->id;
      const Score result = score_of(written, procedure);
      EXPECT_GE(result.verdict, each.grade) << name << ' ' << each.tissue;
      EXPECT_THAT(sentences(result), HasSubstr("entered " + each.title));
    }
  }
}

TEST(Score, coming_to_rest_past_the_aim_is_not_reaching_it) {
  WrittenSession written = good_puncture();  // rests in the fluid, but then continues
  written.to(62, 1500, {true, tissue::cancellous_bone, 4.0}).rest(1000, {true, tissue::cancellous_bone, 2.0});
  const Score result = score_of(written);
  EXPECT_FALSE(result.reached);
  EXPECT_EQ(result.verdict, Grade::fail);
  EXPECT_EQ(result.final_tip->tissue, tissue::cancellous_bone);
  EXPECT_THAT(sentences(result), HasSubstr("12.0 mm too deep"));
  EXPECT_THAT(result.headline, HasSubstr("the aim was not reached"));
}

TEST(Score, a_hand_that_trembles_can_rest) {
  WrittenSession written = good_puncture();
  const Vec3 still = written.session().ticks.back().input.needle.translation();
  written.session().ticks.resize(written.session().ticks.size() - 1000);  // without the final rest
  for (int i = 0; i < 2000; ++i) {
    const double t = 0.001 * i;
    const Vec3 tremor(0.2 * std::sin(56.0 * t), 0.15 * std::sin(63.0 * t + 1.0), 0.2 * std::sin(70.0 * t));
    written.add(still + tremor, {true, tissue::cerebrospinal_fluid, 0.1});
  }
  const Score result = score_of(written);
  EXPECT_TRUE(result.final_tip->is_rest);
  EXPECT_TRUE(result.reached);
  EXPECT_NEAR(result.final_tip->depth, 50.0, 0.05);
}

TEST(Score, the_event_that_defines_success_reaches_the_aim_too) {
  WrittenSession written;
  written.to(0, 500, WrittenSession::air).to(50, 5000, {true, tissue::fat, 1.0});  // in motion to the end
  EXPECT_FALSE(score_of(written).reached);
  written.event(EventKind::fluid_returned, tissue::cerebrospinal_fluid, 3.0);
  EXPECT_TRUE(score_of(written).reached);
}

TEST(Score, a_rest_before_the_skin_is_pierced_is_no_final_position) {
  WrittenSession written;
  written.to(-3, 500, WrittenSession::air).rest(2000, WrittenSession::air);
  written.to(30, 2000, {true, tissue::fat, 1.0}).to(-8, 2000, {true, tissue::fat, 0.0});
  written.to(-20, 500, WrittenSession::air).rest(2000, WrittenSession::air);
  const Score result = score_of(written);
  EXPECT_FALSE(result.final_tip->is_rest);
  EXPECT_NEAR(result.final_tip->depth, 30.0, 1e-9);
}

TEST(Score, a_needle_that_never_touched_has_failed) {
  WrittenSession written;
  written.rest(2000, WrittenSession::air);
  const Score result = score_of(written);
  EXPECT_EQ(result.verdict, Grade::fail);
  EXPECT_EQ(result.headline, "Failed: the needle never touched the body");
  EXPECT_FALSE(result.final_tip.has_value());
}

TEST(Score, overshoot_after_the_loss_of_resistance_is_told_with_depth_way_and_speed) {
  WrittenSession written;
  written.to(0, 500, WrittenSession::air).to(40, 4000, {true, tissue::ligamentum_flavum, 3.0});
  written.event(EventKind::loss_of_resistance, tissue::epidural_fat, 2.0);
  written.to(46.2, 200, {true, tissue::epidural_fat, 0.3}).rest(600, {true, tissue::epidural_fat, 0.1});
  written.to(50, 2000, {true, tissue::cerebrospinal_fluid, 0.1});
  written.rest(1000, {true, tissue::cerebrospinal_fluid, 0.1});
  const Score result = score_of(written);
  EXPECT_NEAR(result.find("loss_overshoot_mm")->value, 6.2, 1e-6);
  EXPECT_NEAR(result.find("loss_speed_mm_per_s")->value, 31.0, 1e-6);
  EXPECT_NEAR(result.find("loss_reaction_s")->value, 0.22, 0.003);  // 0.2 s and the 20 ms needed for the speed
  EXPECT_EQ(result.find("loss_overshoot_mm")->grade, Grade::fail);
  EXPECT_THAT(sentences(result), HasSubstr("You crossed the ligamentum flavum at 40.0 mm and went 6.2 mm further "
                                           "before you stopped, at up to 31 mm/s"));
}

// An epidural whose tip rests in the epidural space, with a given passage through the ligament and its end.
WrittenSession epidural(int ticks_in_ligament, bool is_felt, int ticks_of_yield = 400) {
  WrittenSession written;
  written.to(0, 500, WrittenSession::air).event(EventKind::contact, tissue::skin);
  written.to(36, 8000, {true, tissue::interspinous_ligament, 1.5});
  written.to(40, ticks_in_ligament, {true, tissue::ligamentum_flavum, 3.0});
  if (is_felt) written.event(EventKind::loss_of_resistance, tissue::epidural_fat, 2.0);
  written.to(40.5, ticks_of_yield, {true, tissue::epidural_fat, 0.3});
  return written.rest(3000, {true, tissue::epidural_fat, 0.1});
}

Score epidural_score(WrittenSession written) {
  return score_of(written, find_procedure("epidural"));
}

TEST(Score, an_epidural_that_nobody_felt_is_no_pass) {
  EXPECT_EQ(epidural_score(epidural(2000, true)).verdict, Grade::pass);
  const Score unfelt = epidural_score(epidural(2000, false));
  EXPECT_TRUE(unfelt.reached);
  EXPECT_EQ(unfelt.verdict, Grade::borderline);
  EXPECT_THAT(sentences(unfelt), HasSubstr("There was no loss of resistance"));
  WrittenSession by_syringe = epidural(2000, false);
  by_syringe.event(EventKind::pressure_lost, tissue::epidural_fat, 0.01);
  EXPECT_EQ(epidural_score(by_syringe).verdict, Grade::pass);
}

// The hand's speed before the ligament yields is judged; the half millimetre of the sudden advance is not.
TEST(Score, speed_in_the_ligament_is_judged_and_its_sudden_yield_is_not) {
  const Score springs = epidural_score(epidural(2000, true, 60));  // 0.5 mm at 8.3 mm/s
  EXPECT_NEAR(springs.find("loss_speed_mm_per_s")->value, 8.33, 0.1);
  EXPECT_NEAR(springs.find("loss_approach_mm_per_s")->value, 2.0, 0.1);
  EXPECT_EQ(springs.verdict, Grade::pass);
  const Score fast = epidural_score(epidural(200, true));
  EXPECT_NEAR(fast.find("loss_approach_mm_per_s")->value, 20.0, 0.2);
  EXPECT_EQ(fast.verdict, Grade::fail);
  EXPECT_THAT(sentences(fast), HasSubstr("Slow down as soon as you feel the ligamentum flavum"));
}

// The technique required by acupuncture must be shown, and at the depth of the point.
TEST(Score, acupuncture_without_its_technique_is_no_pass) {
  const training::Procedure procedure = find_procedure("acupuncture");
  const auto needled = [](int thrusts, double depth, double twirl_deg) {
    WrittenSession written;
    written.to(0, 500, WrittenSession::air).event(EventKind::contact, tissue::skin).to(depth, 3000, {});
    for (int n = 0; n < thrusts; ++n) written.to(depth - 5.0, 1000, {}).to(depth, 1000, {});
    auto& ticks = written.session().ticks;
    for (std::size_t i = 3600; i < ticks.size(); ++i) {
      const double angle =
          0.5 * twirl_deg * degree * std::sin(2.0 * EIGEN_PI * 0.001 * static_cast<double>(i - 3600));
      ticks[i].input.needle.rotate(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
    }
    written.to(50, 800, {}).rest(1000, {});
    return written;
  };
  WrittenSession whole = needled(4, 50.0, 180.0), still = needled(0, 50.0, 0.0), shallow = needled(4, 44.0, 180.0);
  const Score passed = score_of(whole, procedure);
  EXPECT_EQ(passed.verdict, Grade::pass) << sentences(passed);
  const Score nothing = score_of(still, procedure);
  EXPECT_EQ(nothing.verdict, Grade::borderline);
  EXPECT_THAT(sentences(nothing), HasSubstr("You did not lift and thrust the needle.\n"));
  EXPECT_THAT(sentences(nothing), HasSubstr("You did not twirl the needle.\n"));
  const Score short_of_it = score_of(shallow, procedure);
  EXPECT_EQ(short_of_it.verdict, Grade::borderline) << sentences(short_of_it);
  EXPECT_THAT(sentences(short_of_it), HasSubstr("Let each thrust end at the depth of the point."));
}

TEST(Score, the_verdict_is_the_worst_finding) {
  Random random(11);
  for (int trial = 0; trial < 60; ++trial) {
    WrittenSession written = good_puncture();
    for (int change = 0; change < 3; ++change) {
      const auto at = static_cast<std::size_t>(random.uniform(0.0, 15000.0)) % written.session().ticks.size();
      written.session().ticks[at].output.tissue = static_cast<TissueId>(random.uniform(0.0, tissue::count));
    }
    if (random.uniform() < 0.3) written.session().finished = false;
    const Score result = score_of(written);
    Grade worst = Grade::pass;
    for (const Finding& each : result.findings) worst = worse(worst, each.grade);
    EXPECT_EQ(result.verdict, worst);
    for (const Harm& each : result.harms) EXPECT_GE(result.verdict, each.grade);
    if (!result.reached) {
      EXPECT_GE(result.verdict, Grade::fail);
    }
    EXPECT_TRUE(std::is_sorted(result.findings.begin(), result.findings.end(),
                               [](const Finding& a, const Finding& b) { return a.grade > b.grade; }));
  }
}

TEST(Score, an_epidural_that_pierces_the_dura_fails) {
  WrittenSession written = good_puncture();
  const Score result = score_of(written, find_procedure("epidural"));
  EXPECT_EQ(result.verdict, Grade::fail);
  EXPECT_EQ(result.headline, "Failed: the tip entered the dural sac");
}

TEST(Score, a_recording_with_a_hole_in_the_body_is_no_pass) {
  WrittenSession written = good_puncture();
  auto& ticks = written.session().ticks;
  ticks.erase(ticks.begin() + 4000, ticks.begin() + 4050);
  const Score result = score_of(written);
  EXPECT_EQ(result.verdict, Grade::borderline);
  EXPECT_THAT(sentences(result), HasSubstr("0.050 s of the recording are missing"));
}

TEST(Score, the_entry_must_be_at_a_level_that_the_procedure_allows) {
  WrittenSession written = good_puncture();
  CaseDescription description = written_description();
  description.landmarks = {{"L3_L4_skin", Vec3(0, 0, 0)}, {"L1_L2_skin", Vec3(0, 0, 70)}, {"L1_L2", Vec3(0, 0, 1)}};
  Score result = score(written.session(), description, lumbar());
  EXPECT_EQ(result.level, "L3_L4");
  EXPECT_EQ(result.verdict, Grade::pass);
  std::swap(description.landmarks[0].position, description.landmarks[1].position);
  result = score(written.session(), description, lumbar());
  EXPECT_EQ(result.level, "L1_L2");
  EXPECT_EQ(result.verdict, Grade::fail);
  EXPECT_THAT(sentences(result), HasSubstr("You entered at L1/L2, expected L2/L3 L3/L4 L4/L5 L5/S1."));
}

TEST(Score, refuses_a_session_without_ticks_and_a_tissue_that_nobody_knows) {
  WrittenSession written = good_puncture();
  training::Procedure procedure = lumbar();
  procedure.forbidden.push_back({.tissue = "nervee"});
  EXPECT_THROW(score_of(written, procedure), InputError);
  written.session().ticks.clear();
  EXPECT_THROW(score_of(written), InputError);
}

// Two interspaces 40 mm apart on a back along z; the written path enters at the origin.
TEST(Score, the_interspace_that_was_felt_is_told_and_compared_with_the_one_that_was_entered) {
  CaseDescription description = written_description();
  description.landmarks = {{"L4_L5_skin", Vec3(0, 0, -2)}, {"L3_L4_skin", Vec3(0, 0, 38)}};
  for (const double where : {0.0, 39.0}) {
    WrittenSession written;
    written.session().header.haptics.parts.fingertip.emplace();
    written.go(Vec3(0, -3, where), 500, WrittenSession::air).event(EventKind::palpated, tissue::skin, 0.1);
    written.go(Vec3(0, 10, 0), 300, WrittenSession::air);
    written.go(Vec3(4, 0, 0), 300, WrittenSession::air).go(Vec3(4, -50, 0), 3000, {true, tissue::fat, 1.0});
    const Score result = score(written.session(), description, lumbar());
    EXPECT_EQ(result.level, "L4_L5");
    EXPECT_EQ(result.find("felt_places")->value, 1.0);
    EXPECT_NEAR(result.find("entry_to_midline_mm")->value, 4.0, 1e-3);
    EXPECT_NEAR(result.find("entry_to_interspace_mm")->value, 2.0, 1e-3);
    EXPECT_THAT(sentences(result), HasSubstr(where == 0.0 ? "You felt L4/L5 before you entered."
                                                          : "You felt L3/L4 last, but entered at L4/L5."));
  }
}

}  // namespace
}  // namespace bodkin
