#include "training/thresholds.h"

#include <map>
#include <set>

#include "tests/training/page_table.h"
#include "tests/training/written_session.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/settings_tree.h"
#include "training/expert_table.h"
#include "training/procedure_file.h"
#include "training/score.h"

namespace bodkin {

using namespace bodkin::training;
namespace {

using ::testing::HasSubstr;

// A procedure whose file states only this threshold.
training::Procedure procedure_with(const std::string& thresholds) {
  return parse_procedure(
      "<procedure version=\"1\" name=\"own\" title=\"Own\">\n<description>d</description>\n<goal "
      "by=\"near_target\"/>\n"
      "<forbidden tissue=\"nerve\"/>\n" +
          thresholds + "</procedure>\n",
      "own.xml");
}
training::Procedure procedure_with(std::string_view name, double value) {
  return procedure_with(fmt::format("<thresholds {}=\"{}\"/>\n", name, value));
}

constexpr WrittenSession::Touch fat{true, tissue::fat, 1.0};

WrittenSession at_the_skin() {
  WrittenSession written;
  written.to(0, 500, WrittenSession::air);
  return written;
}

// Twice into the body; `away` mm outside and `ticks` ticks between the insertions.
WrittenSession twice(double away, int ticks) {
  WrittenSession written = at_the_skin();
  written.to(20, 400, fat).to(0, 400, fat).to(-away, ticks / 2, WrittenSession::air);
  written.to(0, ticks / 2, WrittenSession::air).to(30, 600, fat);
  return written;
}

WrittenSession then_to_the_target(WrittenSession written) {
  written.to(50, 800, fat).to(0, 1000, fat).to(-10, 500, WrittenSession::air);
  return written;
}

WrittenSession redirected(double back, double turn_deg) {
  const Vec3 other = Eigen::AngleAxisd(turn_deg * degree, Vec3::UnitX()) * -Vec3::UnitY();
  WrittenSession written = at_the_skin();
  written.to(30, 600, fat).to(30.0 - back, 300, fat);
  written.go(Vec3(0, back - 30.0, 0), 300, fat, other).go(Vec3(0, -40, 0), 600, fat, other);
  return written;
}

// Advances slowly, rests, moves on at `speed` mm/s for `ticks`, and rests.
WrittenSession burst(double speed, int ticks) {
  WrittenSession written = at_the_skin();
  written.to(10, 5000, fat).rest(1000, fat);
  written.to(10 + 0.001 * speed * ticks, ticks, fat).rest(1000, fat);
  return written;
}

// Turns about the needle's own axis at `rate` deg/s; `to_and_fro`: reversing every half second.
WrittenSession turning(double rate, int ticks, bool to_and_fro = false) {
  WrittenSession written = at_the_skin();
  written.to(10, 5000, fat).rest(to_and_fro ? 500 : 1000, fat);
  double angle = 0.0;
  const auto add_tick = [&] {
    written.add(Vec3(0, -10, 0), fat);
    Pose& needle = written.session().ticks.back().input.needle;
    needle.linear() = needle.linear() * Eigen::AngleAxisd(angle * degree, Vec3::UnitZ()).toRotationMatrix();
  };
  for (int i = 0; i < ticks; ++i) {
    angle += 0.001 * rate * (to_and_fro && (i / 500) % 2 == 1 ? -1.0 : 1.0);
    add_tick();
  }
  for (int i = 0; i < 1000; ++i) add_tick();
  return written;
}

WrittenSession lifting(double amplitude) {
  WrittenSession written = at_the_skin();
  written.to(20, 2000, fat);
  for (int i = 0; i < 6; ++i) written.to(20 - amplitude, 500, fat).to(20, 500, fat);
  return written;
}

WrittenSession beside_slice(double away) {
  WrittenSession written;
  written.to(0, 100, WrittenSession::air).to(40, 4000, fat);
  written.session().header.second = session::SecondHeader{session::SecondRole::probe, "{}"};
  for (int i = 0; i < 400; ++i) {
    session::SecondSample sample;
    sample.time = 0.01 * i;
    sample.position = Vec3(20, 0, away);  // the slice lies in x and y
    sample.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(EIGEN_PI / 2, Vec3::UnitX()));
    written.session().second.push_back(sample);
  }
  return written;
}

// With a probe that shows the target; the needle enters next to the plan and is turned to meet the target.
WrittenSession guided(double beside) {
  WrittenSession written = beside_slice(0.0);
  written.session().ticks.clear();
  const Vec3 entry(beside, 0, 0), axis = (Vec3(0, -50, 0) - entry).normalized();
  written.go(entry - 20.0 * axis, 500, WrittenSession::air, axis).go(entry, 500, WrittenSession::air, axis);
  written.go(Vec3(0, -50, 0), 3000, fat, axis);
  return written;
}

WrittenSession into_a_nerve_twice(double between) {
  WrittenSession written = at_the_skin();
  written.to(20, 400, fat).to(22, 100, {true, tissue::nerve, 1.0}).to(22 + between, 200, fat);
  written.to(23 + between, 100, {true, tissue::nerve, 1.0}).to(30 + between, 400, fat);
  return written;
}

WrittenSession slow_after_loss() {
  WrittenSession written = at_the_skin();
  written.to(20, 400, fat).to(22, 1000, fat).event(forces::EventKind::loss_of_resistance, tissue::epidural_fat, 2.0);
  written.to(24, 1000, fat).rest(500, fat);  // at 2 mm/s throughout
  return written;
}

struct Expectation {
  std::string_view threshold;
  double value;  // stated by the procedure
  WrittenSession session;
  std::string_view metric;  // or "entries", into the nerve
  double usually, then;     // absent: not measured in this session
  double tolerance = 1e-9;
};
constexpr double absent = -1000.0;

double measured(WrittenSession& written, const training::Procedure& procedure, std::string_view metric) {
  const Score result = score(written.session(), written_description(), procedure);
  if (metric == "entries") return result.harms.at(0).entries;
  const MetricResult* const found = result.find(metric);
  return found == nullptr ? absent : found->value;
}

// Each on a session by hand, whose numbers lie between the default and the procedure's value.
TEST(Thresholds, each_moves_what_it_says_and_old_sessions_are_measured_with_it) {
  std::vector<Expectation> all = {
      {"outside_s", 0.8, twice(2.0, 600), "insertions", 2, 1},
      {"outside_mm", 9.0, twice(8.0, 200), "insertions", 2, 1},
      {"rest_s", 1.0, then_to_the_target(at_the_skin().to(30, 600, fat).rest(700, fat)), "final_distance_mm", 20, 0,
       0.1},
      {"rest_mm_per_s", 3.0, then_to_the_target(at_the_skin().to(30, 600, fat).to(32, 1000, fat)),
       "final_distance_mm", 0, 19, 0.2},
      {"same_rest_mm", 3.0,
       then_to_the_target(at_the_skin().to(30, 600, fat).rest(1000, fat).to(28, 50, fat).rest(1000, fat)),
       "final_distance_mm", 20, 22, 0.1},
      {"stop_mm_per_s", 3.0, slow_after_loss(), "loss_overshoot_mm", 2, 0, 0.01},
      {"retreat_mm", 3.0, redirected(4.0, 6.0), "redirections", 0, 1},
      {"redirection_deg", 1.0, redirected(8.0, 2.0), "redirections", 0, 1},
      {"reentry_mm", 3.0, into_a_nerve_twice(2.0), "entries", 2, 1},
      {"action_mm_per_s", 8.0, at_the_skin().to(35, 5000, fat), "in_action_percent", 100, 0, 2.0},
      {"action_deg_per_s", 20.0, turning(15.0, 6000), "in_action_percent", 50, 0, 8.0},
      {"action_s", 0.5, burst(100.0, 300), "translational_actions", 1, 0},
      {"quick_mm_per_s", 30.0, burst(40.0, 500), "translational_actions", 0, 1},
      {"quick_deg_per_s", 30.0, turning(40.0, 600), "rotational_actions", 0, 1},
      {"lift_mm", 3.0, lifting(2.0), "lift_thrust_mm", 2, absent, 0.1},
      {"twirl_deg", 30.0, turning(40.0, 5000, true), "twirl_deg", 20, absent, 0.5},
      {"tip_in_slice_mm", 4.0, beside_slice(3.0), "tip_in_slice_percent", 0, 100},
      {"target_in_slice_mm", 7.0, beside_slice(6.0), "target_in_slice_percent", 0, 100},
      // An entry 9 mm from the planned one tilts the needle by 10.2 deg, one 12 mm away by 13.5 deg.
      {"guide_deg", 8.0, guided(9.0), "guide_steps_percent", 100, 75},
      {"guide_mm", 14.0, guided(12.0), "guide_steps_percent", 75, 100}};
  const training::Procedure usual = procedure_with("");
  std::set<std::string_view> covered;
  for (Expectation& each : all) {
    covered.insert(each.threshold);
    EXPECT_NEAR(measured(each.session, usual, each.metric), each.usually, each.tolerance) << each.threshold;
    EXPECT_NEAR(measured(each.session, procedure_with(each.threshold, each.value), each.metric), each.then,
                each.tolerance)
        << each.threshold;
  }
  for_each_parameter(
      [&](const auto& parameter, double) { EXPECT_TRUE(covered.contains(parameter.name)) << parameter.name; },
      Thresholds());
}

// The schema agrees with the table of parameters.
TEST(Thresholds, a_procedure_file_states_what_the_table_allows_and_no_more) {
  EXPECT_EQ(procedure_with("<thresholds/>\n").thresholds, Thresholds());
  for_each_parameter(
      [](const auto& parameter, double) {
        for (const double end : {parameter.range.low, parameter.range.high}) {
          Thresholds expected;
          parameter.of(expected) = end;
          EXPECT_EQ(procedure_with(parameter.name, end).thresholds, expected) << parameter.name;
        }
        for (const double beyond : {parameter.range.low - 0.01, parameter.range.high + 0.01}) {
          try {
            procedure_with(parameter.name, beyond);
            ADD_FAILURE() << parameter.name << " is accepted with " << beyond;
          } catch (const InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr(fmt::format("own.xml, line 5: thresholds {} is", parameter.name)));
          }
        }
      },
      Thresholds());
}

TEST(Thresholds, a_score_tells_those_that_are_not_the_default) {
  WrittenSession written = good_puncture();
  const auto told = [&](const training::Procedure& procedure) {
    std::string text;
    for (const Finding& each : score(written.session(), written_description(), procedure).findings)
      if (each.subject == "thresholds") text += each.sentence;
    return text;
  };
  EXPECT_EQ(told(procedure_with("<thresholds rest_s=\"0.5\"/>\n")), "");
  EXPECT_EQ(told(procedure_with("<thresholds retreat_mm=\"7\" rest_s=\"0.75\"/>\n")),
            "Measured with thresholds of the procedure's own: rest_s 0.75, retreat_mm 7.");
}

// The shipped experts were measured with the default.
TEST(Thresholds, numbers_that_mean_something_else_are_not_compared_with_experts) {
  training::Procedure procedure = find_shipped_procedure("epidural");
  EXPECT_TRUE(experts_of(procedure).has_value());
  procedure.thresholds.rest_time = 1.0;
  EXPECT_FALSE(experts_of(procedure).has_value());
}

TEST(Thresholds, the_page_describes_every_one) {
  std::string table = "| threshold | what it decides | range | default, origin |\n|---|---|---|---|\n";
  for_each_parameter(
      [&](const auto& parameter, double value) {
        table += fmt::format("| `{}` | {} | {} | {}, {} |\n", parameter.name, parameter.description,
                             range_words(parameter.range, parameter.unit), value, value_text(parameter.origin));
      },
      Thresholds());
  expect_table_on_page("metrics.md", "| threshold |", table);
}

}  // namespace
}  // namespace bodkin
