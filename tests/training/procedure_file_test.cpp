#include "training/procedure_file.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "io/tissue_library_file.h"

namespace bodkin {

using namespace bodkin::training;
namespace {

using ::testing::HasSubstr;

std::string document(const std::string& inside, const std::string& attributes = "") {
  return "<procedure version=\"1\" name=\"own\" title=\"Own\"" + attributes + ">\n<description>d</description>\n" +
         inside + "</procedure>\n";
}

std::string refusal(const std::string& text) {
  try {
    parse_procedure(text, "own.xml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

const std::string goal = "<goal by=\"near_target\"/>\n";

TEST(ProcedureFile, those_that_come_with_bodkin_are_sound) {
  std::set<std::string> names;
  for (const std::string& name : shipped_procedures()) {
    const training::Procedure procedure = find_procedure(name);
    names.insert(procedure.name);
    EXPECT_EQ(procedure.name, name);
    EXPECT_FALSE(procedure.title.empty() || procedure.description.empty() || procedure.steps.empty()) << name;
    for (const Forbidden& each : procedure.forbidden) {
      EXPECT_FALSE(each.title.empty() || each.consequence.empty()) << name;
      if (!each.tissue.empty()) {
        EXPECT_NE(io::default_tissue_library().find(each.tissue), nullptr) << name << ' ' << each.tissue;
      }
    }
    const auto forbids = [&](const char* tissue) {
      return std::any_of(procedure.forbidden.begin(), procedure.forbidden.end(), [&](const Forbidden& each) {
        return each.tissue == tissue && each.grade == Grade::dangerous;
      });
    };
    for (const char* tissue : {"spinal_cord", "nerve", "vessel", "lung"})
      EXPECT_TRUE(forbids(tissue)) << name << ' ' << tissue;
  }
  for (const char* name : {"lumbar_puncture", "epidural", "spinal_anaesthesia", "ct_guided_biopsy", "joint_injection",
                           "ultrasound_guided_injection", "ultrasound_guided_nerve_block", "acupuncture"})
    EXPECT_TRUE(names.contains(name)) << name;
}

TEST(ProcedureFile, everything_that_it_says_is_read) {
  const training::Procedure procedure = parse_procedure(
      document(
          "<step title=\"Go\" tissue=\"fat\">  in\n steps </step>\n<goal by=\"rest\" tissue=\"fat\"/>\n"
          "<forbidden structure=\"colon\" title=\"bowel\" grade=\"fail\" margin_mm=\"2\" consequence=\"c\"/>\n"
          "<rule metric=\"insertions\" pass_from=\"1\" pass_to=\"2\" borderline_to=\"4\" beyond=\"dangerous\"/>\n",
          " levels=\"L3_L4 L4_L5\" thickest_gauge=\"18\" thinnest_gauge=\"22\""),
      "own.xml");
  EXPECT_EQ(procedure.description, "d");
  EXPECT_EQ(procedure.levels, "L3_L4 L4_L5");
  EXPECT_EQ(procedure.thickest_gauge, 18);
  EXPECT_EQ(procedure.steps.at(0).text, "in steps");
  EXPECT_EQ(procedure.goals.at(0).by, GoalKind::rest);
  EXPECT_EQ(procedure.forbidden.at(0).margin, 2.0);
  EXPECT_EQ(procedure.forbidden.at(0).grade, Grade::fail);
  const Rule& rule = procedure.rules.at(0);
  EXPECT_EQ(rule.grade_of(1.0), Grade::pass);
  EXPECT_EQ(rule.grade_of(3.0), Grade::borderline);
  EXPECT_EQ(rule.grade_of(5.0), Grade::dangerous);
  EXPECT_EQ(rule.grade_of(0.0), Grade::borderline);  // borderline has no lower bound
  EXPECT_EQ(rule.grade_of(std::nan("")), Grade::dangerous);
}

TEST(ProcedureFile, refuses_what_it_does_not_know_with_the_line) {
  EXPECT_THAT(refusal(document("<goal by=\"near_target\"/>\n<rule metric=\"swiftness\"/>\n")),
              HasSubstr("own.xml, line 4: rule metric is 'swiftness', expected a metric of docs/metrics.md"));
  EXPECT_THAT(refusal(document("<step title=\"t\" event=\"sneeze\"/>\n" + goal)),
              HasSubstr("line 3: step event is 'sneeze', expected an event of docs/session-format.md"));
  EXPECT_THAT(refusal(document("<goal by=\"luck\"/>\n")), HasSubstr("line 3: goal by is 'luck', expected"));
  EXPECT_THAT(refusal(document("")), HasSubstr("goal"));
  EXPECT_THAT(refusal(document("<goal by=\"rest\"/>\n")), HasSubstr("expected one with rest and touch alone"));
  EXPECT_THAT(refusal(document("<goal by=\"event\" tissue=\"fat\"/>\n")), HasSubstr("tissue"));
  EXPECT_THAT(refusal(document(goal + "<forbidden/>\n")), HasSubstr("expected either a tissue or a structure"));
  EXPECT_THAT(refusal(document(goal + "<forbidden tissue=\"nerve\" grade=\"pass\"/>\n")),
              HasSubstr("grade is 'pass'"));
  EXPECT_THAT(refusal(document(goal + "<rule metric=\"insertions\" pass_to=\"5\" borderline_to=\"4\"/>\n")),
              HasSubstr("pass_to is 5, expected at most the borderline_to of 4"));
  EXPECT_THAT(refusal(document(goal, " thickest_gauge=\"25\" thinnest_gauge=\"20\"")),
              HasSubstr("thickest_gauge is greater than thinnest_gauge"));
  EXPECT_THAT(refusal("<case/>"), HasSubstr("own.xml"));
}

TEST(ProcedureFile, a_name_that_is_none_is_refused_with_those_that_are) {
  try {
    find_procedure("appendectomy");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("there is no procedure 'appendectomy', expected one of acupuncture, ct_guided_biopsy"));
  }
}

}  // namespace
}  // namespace bodkin
