#include "report/session_summary.h"

#include <cmath>

#include "tests/session/slab_case.h"
#include <gtest/gtest.h>

#include "core/error.h"
#include "haptics/force_governor.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
using namespace bodkin::haptics;
using namespace bodkin::report;
using namespace bodkin::session;
using namespace bodkin::simulation;
namespace {

// A session written by hand: the tip goes where it is told, through tissues and forces that are told too.
class Script {
 public:
  explicit Script(const NeedlePath& path) {
    session_.header.path = path;
    session_.header.dt = 0.001;
    session_.finished = true;
  }

  struct Touch {
    bool in_contact = true;
    TissueId tissue = tissue::fat;
    double resistance = 0.0;  // N
  };

  // Moves straight to `tip` in so many ticks. Depth is measured from the planned entry along the planned axis.
  Script& go(const Vec3& tip, int ticks, const Touch& touch, const Vec3& axis = -Vec3::UnitY()) {
    const Vec3 from = session_.ticks.empty() ? tip : session_.ticks.back().input.needle.translation().eval();
    const NeedlePath& path = session_.header.path;
    for (int i = 1; i <= ticks; ++i) {
      TickRecord record;
      record.tick = session_.ticks.size();
      record.input.needle = needle_pose(from + (tip - from) * i / ticks, axis);
      record.output.depth = (record.input.needle.translation() - path.entry).dot(path.direction());
      record.output.in_contact = touch.in_contact;
      record.output.tissue = touch.in_contact ? touch.tissue : tissue::air;
      record.output.resistance = touch.in_contact ? touch.resistance : 0.0;
      record.output.applied.force = -record.output.resistance * needle_axis(record.input.needle);
      session_.ticks.push_back(record);
    }
    return *this;
  }

  Script& event(EventKind kind, TissueId id, double value) {
    session_.events.push_back({session_.ticks.back().tick, {kind, id, session_.ticks.back().output.depth, value}});
    return *this;
  }

  Session& session() { return session_; }

 private:
  Session session_;
};

constexpr Script::Touch air{false, tissue::air, 0.0};

Case body() {
  Case patient = slab_case({{tissue::fat, 60.0}});
  patient.description.procedure.path = NeedlePath{Vec3::Zero(), Vec3(0, -50, 0)};
  return patient;
}

TEST(SessionSummary, a_straight_insertion_to_the_target_is_without_fault) {
  const Case patient = body();
  Script script(*patient.description.procedure.path);
  script.go(Vec3(0, 10, 0), 1, air).go(Vec3(0, 0, 0), 1000, air);
  script.go(Vec3(0, -50, 0), 5000, {true, tissue::fat, 2.0}).go(Vec3(0, -50, 0), 1000, {true, tissue::fat, 1.0});
  const SessionSummary summary = summarise(script.session(), patient);
  EXPECT_NEAR(summary.duration, 7.0, 1e-9);
  EXPECT_NEAR(summary.time_in_body, 6.0, 1e-9);
  EXPECT_EQ(summary.insertions, 1);
  EXPECT_EQ(summary.redirections, 0);
  EXPECT_NEAR(summary.final_error.distance, 0.0, 1e-9);
  EXPECT_EQ(summary.final_tip_from, FinalTip::end_of_session);
  EXPECT_NEAR(summary.deviation_max, 0.0, 1e-9);
  EXPECT_NEAR(summary.angle_at_end, 0.0, 1e-9);
  EXPECT_NEAR(summary.path_length, 50.0, 0.2);
  EXPECT_NEAR(summary.work, 100.0, 0.1);  // 2 N over 50 mm
  EXPECT_NEAR(summary.peak_force, 2.0, 1e-12);
  ASSERT_TRUE(summary.time_to_target.has_value());
  EXPECT_NEAR(*summary.time_to_target, 4.7, 0.01);  // 47 of 50 mm at 10 mm/s: within 3 mm
  EXPECT_TRUE(judge(summary, script.session(), patient).reached);
}

TEST(SessionSummary, a_miss_is_split_into_depth_and_side) {
  const Case patient = body();
  Script script(*patient.description.procedure.path);
  script.go(Vec3(4, 0, 3), 1, air).go(Vec3(4, -42, 3), 2000, {}).go(Vec3(4, -42, 3), 1000, {});
  const SessionSummary summary = summarise(script.session(), patient);
  EXPECT_NEAR(summary.final_error.axial, -8.0, 1e-6);
  EXPECT_NEAR(summary.final_error.lateral, 5.0, 1e-6);
  EXPECT_NEAR(summary.final_error.distance, std::sqrt(64.0 + 25.0), 1e-6);
  EXPECT_NEAR(summary.deviation_max, 5.0, 1e-6);
  EXPECT_NEAR(summary.deviation_rms, 5.0, 1e-6);
  const Verdict verdict = judge(summary, script.session(), patient);
  EXPECT_FALSE(verdict.reached);
  EXPECT_NE(verdict.remarks.at(0).find("8.0 mm short of it and 5.0 mm to the side"), std::string::npos);
}

TEST(SessionSummary, drawing_back_and_turning_is_a_redirection_and_drawing_back_alone_is_none) {
  const Case patient = body();
  const Vec3 turned = Vec3(std::sin(0.1), -std::cos(0.1), 0.0);  // 5.7 degrees
  for (const bool turn : {false, true}) {
    Script script(*patient.description.procedure.path);
    script.go(Vec3(0, 5, 0), 1, air).go(Vec3(0, -30, 0), 3000, {}).go(Vec3(0, -15, 0), 1000, {});
    script.go(Vec3(0, -40, 0), 2000, {}, turn ? turned : Vec3(-Vec3::UnitY()));
    EXPECT_EQ(summarise(script.session(), patient).redirections, turn ? 1 : 0);
  }
}

TEST(SessionSummary, each_time_that_the_needle_comes_back_from_outside_is_an_insertion) {
  const Case patient = body();
  Script script(*patient.description.procedure.path);
  for (int i = 0; i < 3; ++i) script.go(Vec3(0, 8, 0), 500, air).go(Vec3(0, -20 - i, 0), 1000, {});
  script.go(Vec3(0, 8, 0), 500, air);
  const SessionSummary summary = summarise(script.session(), patient);
  EXPECT_EQ(summary.insertions, 3);
  EXPECT_NEAR(summary.deepest, 22.0, 1e-9);
  EXPECT_EQ(summary.final_tip_from, FinalTip::deepest_point);
  EXPECT_NEAR(summary.final_tip.y(), -22.0, 1e-9);  // the deepest point stands in for a rest
}

TEST(SessionSummary, a_rest_before_the_withdrawal_is_where_the_tip_ended) {
  const Case patient = body();
  Script script(*patient.description.procedure.path);
  script.go(Vec3(0, 8, 0), 1, air).go(Vec3(0, -49, 0), 2000, {}).go(Vec3(0, -46, 0), 300, {});
  script.go(Vec3(0, -46, 0), 700, {}).go(Vec3(0, 0, 0), 1000, {}).go(Vec3(0, 8, 0), 500, air);
  const SessionSummary summary = summarise(script.session(), patient);
  EXPECT_EQ(summary.final_tip_from, FinalTip::last_rest);
  EXPECT_NEAR(summary.final_error.axial, -4.0, 0.01);
}

TEST(SessionSummary, tissues_carry_their_own_time_span_and_peak) {
  Case patient = body();
  patient.description.procedure.target_tissue = "epidural_space";
  Script script(*patient.description.procedure.path);
  script.go(Vec3(0, 1, 0), 1, air).go(Vec3(0, -10, 0), 1000, {true, tissue::fat, 0.5});
  script.go(Vec3(0, -30, 0), 2000, {true, tissue::muscle, 1.5})
      .event(EventKind::bone_contact, tissue::cortical_bone, 0);
  script.go(Vec3(0, -35, 0), 500, {true, tissue::epidural_fat, 0.2})
      .event(EventKind::loss_of_resistance, tissue::epidural_fat, 1.3);
  const SessionSummary summary = summarise(script.session(), patient);
  ASSERT_EQ(summary.tissues.size(), 3U);
  EXPECT_EQ(summary.tissues[0].tissue, tissue::fat);
  EXPECT_NEAR(summary.tissues[1].time, 2.0, 1e-9);
  EXPECT_NEAR(summary.tissues[1].peak_force, 1.5, 1e-12);
  EXPECT_NEAR(summary.tissues[1].to, 30.0, 1e-9);
  EXPECT_EQ(summary.bone_contacts, 1);
  EXPECT_EQ(summary.losses_of_resistance, 1);
  ASSERT_EQ(summary.crossings.size(), 3U);
  EXPECT_NEAR(summary.crossings[1].from, 10.0, 0.02);
  const TissueProperties* aim = patient.library.find("epidural_space");
  if (aim == nullptr) aim = patient.library.find(tissue::epidural_fat);
  patient.description.procedure.target_tissue = aim->name;
  const SessionSummary aimed = summarise(script.session(), patient);
  ASSERT_TRUE(aimed.target_tissue_time.has_value());
  EXPECT_NEAR(*aimed.target_tissue_time, 3.001, 0.002);
  EXPECT_TRUE(judge(aimed, script.session(), patient).reached);
}

TEST(SessionSummary, critical_structures_are_counted_once_until_the_tip_has_travelled_outside) {
  Case patient = body();
  patient.structures = LabelVolume(patient.tissues.grid, 0);
  const Grid& grid = patient.structures.grid;
  for (int j = 0; j < grid.size[1]; ++j) {
    const double y = grid.to_patient(Vec3(0, j, 0)).y();
    if (y > -30.0 || y < -34.0) continue;
    for (int k = 0; k < grid.size[2]; ++k) {
      for (int i = 0; i < grid.size[0]; ++i) patient.structures.at(i, j, k) = 7;
    }
  }
  patient.description.structures = {{7, "aorta", "vessel", true}, {8, "kidney", "organ", true}};
  Script script(*patient.description.procedure.path);
  script.go(Vec3(0, 1, 0), 1, air).go(Vec3(0, -32, 0), 3300, {});
  script.go(Vec3(0, -29.7, 0), 230, {}).go(Vec3(0, -32, 0), 230, {});  // out by 0.3 mm and in again: the same entry
  script.go(Vec3(0, -25, 0), 700, {}).go(Vec3(0, -32, 0), 700, {});    // out by 5 mm and in again: another one
  const SessionSummary summary = summarise(script.session(), patient);
  ASSERT_EQ(summary.critical.size(), 1U);
  EXPECT_EQ(summary.critical[0].structure, "aorta");
  EXPECT_EQ(summary.critical[0].entries, 2);
  EXPECT_NEAR(summary.critical[0].depth, 30.0, 0.02);
  EXPECT_NEAR(summary.critical[0].time_inside, 0.2 + 0.2 + 0.2 + 0.2 + 0.2, 0.01);
}

TEST(SessionSummary, the_governors_work_is_counted_by_its_beginnings) {
  const Case patient = body();
  Script script(*patient.description.procedure.path);
  script.go(Vec3(0, 1, 0), 1, air).go(Vec3(0, -10, 0), 1000, {});
  for (int i = 0; i < 100; ++i) script.session().ticks[static_cast<std::size_t>(200 + i)].output.limits = 1;
  for (int i = 0; i < 50; ++i) script.session().ticks[static_cast<std::size_t>(500 + i)].output.limits = 2;
  const SessionSummary summary = summarise(script.session(), patient);
  EXPECT_EQ(summary.interventions, 2);
  EXPECT_NEAR(summary.limited_time, 0.15, 1e-9);
  ASSERT_EQ(summary.limits.size(), 2U);
  EXPECT_NEAR(summary.limits[0].time, 0.1, 1e-9);
  const std::vector<std::string> remarks = judge(summary, script.session(), patient).remarks;
  const std::string last = remarks.back();
  EXPECT_NE(last.find("twice, 0.15 s in all"), std::string::npos) << last;
  EXPECT_NE(last.find("than the hand had put in, and was damped (0.10 s)"), std::string::npos) << last;
  EXPECT_NE(last.find("grew faster than is let through (0.05 s)"), std::string::npos) << last;
}

TEST(SessionSummary, a_warning_of_stiff_tissue_is_no_limit) {
  const Case patient = body();
  Script script(*patient.description.procedure.path);
  script.go(Vec3(0, 1, 0), 1, air).go(Vec3(0, -10, 0), 1000, {});
  for (std::size_t i = 200; i < 400; ++i) script.session().ticks[i].output.limits = force_limit::stiffness;
  const SessionSummary summary = summarise(script.session(), patient);
  EXPECT_EQ(summary.interventions, 0);
  EXPECT_EQ(summary.limited_time, 0.0);
  for (const std::string& remark : judge(summary, script.session(), patient).remarks) {
    EXPECT_EQ(remark.find("than the tissue asked for"), std::string::npos) << remark;
  }
}

TEST(SessionSummary, a_needle_that_stays_outside_is_told_so_and_an_empty_session_is_refused) {
  const Case patient = body();
  Script script(*patient.description.procedure.path);
  script.go(Vec3(0, 10, 0), 100, air);
  const SessionSummary summary = summarise(script.session(), patient);
  EXPECT_EQ(summary.insertions, 0);
  EXPECT_NE(judge(summary, script.session(), patient).headline.find("never touched"), std::string::npos);
  EXPECT_THROW(summarise(Session{}, patient), InputError);
}

}  // namespace
}  // namespace bodkin
