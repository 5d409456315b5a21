#include "session/operator_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "io/tissue_library_file.h"
#include "simulation/operator_thresholds.h"

namespace bodkin {

using namespace bodkin::session;
using namespace bodkin::simulation;
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string file_with(const std::string& phases) {
  return "<operator name=\"tester\" version=\"1\"><description>d</description>"
         "<hand mass_kg=\"0.3\" stiffness_N_per_mm=\"2\" damping_N_s_per_mm=\"0.04\"/>"
         "<accuracy entry_mm=\"1\" direction_deg=\"1\"/><reaction time_s=\"0.2\"/><start distance_mm=\"30\"/>" +
         phases + "</operator>";
}

std::string refusal_of_text(const std::string& text) {
  try {
    parse_operator(text, "mine.xml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "it was accepted";
}

TEST(OperatorFile, is_read_with_its_units_turned_into_bodkins_own) {
  const OperatorScript script = parse_operator(
      file_with("<phase name=\"in\" speed_mm_per_s=\"5\" tilt_cephalad_deg=\"90e-1\"><until force_drop_N=\"1.5\" "
                "depth_above_mm=\"10\" then=\"out\"/></phase>"
                "<phase name=\"out\" speed_mm_per_s=\"-5\" twirl_deg=\"180\" twirl_Hz=\"2\" at_most=\"2\" "
                "otherwise=\"in\"><until time_s=\"1\" "
                "then=\"end\"/></phase>"),
      "mine.xml");
  EXPECT_EQ(script.name, "tester");
  EXPECT_NEAR(script.aim_angle, 0.0174532925, 1e-9);
  ASSERT_EQ(script.phases.size(), 2u);
  EXPECT_NEAR(script.phases[0].tilt, 0.157079633, 1e-9);
  EXPECT_EQ(script.phases[0].until[0].next, 1);
  EXPECT_EQ(script.phases[0].until[0].force_drop, 1.5);
  EXPECT_EQ(script.phases[0].until[0].depth_above, 10.0);
  EXPECT_FALSE(script.phases[0].until[0].time.has_value());
  EXPECT_EQ(script.phases[0].twirl, 0.0);
  EXPECT_NEAR(script.phases[1].twirl, 3.14159265, 1e-8);
  EXPECT_EQ(script.phases[1].twirl_rate, 2.0);
  EXPECT_EQ(script.phases[1].otherwise, 0);
  EXPECT_EQ(script.phases[1].until[0].next, OperatorCondition::end);
  const auto json = nlohmann::json::parse(operator_json(script));
  EXPECT_EQ(json["phases"][0]["until"][0]["then"], "out");
  EXPECT_NEAR(json["accuracy"]["direction_deg"].get<double>(), 1.0, 1e-12);
}

TEST(OperatorFile, faults_are_told_with_file_and_line) {
  const std::string stop = "<until time_s=\"1\" then=\"end\"/>";
  EXPECT_THAT(refusal_of_text("<operator"), HasSubstr("mine.xml"));
  EXPECT_THAT(refusal_of_text(file_with("")), HasSubstr("mine.xml"));
  EXPECT_THAT(refusal_of_text(file_with("<phase name=\"in\" speed_mm_per_s=\"5\"></phase>")), HasSubstr("until"));
  EXPECT_THAT(refusal_of_text(file_with("\n<phase name=\"in\" speed_mm_per_s=\"500\">" + stop + "</phase>")),
              AllOf(HasSubstr("line 2"), HasSubstr("speed_mm_per_s"), HasSubstr("500")));
  EXPECT_THAT(refusal_of_text(file_with("<phase name=\"in\" speed_mm_per_s=\"5\"><until then=\"end\"/></phase>")),
              HasSubstr("says nothing to wait for"));
  EXPECT_THAT(refusal_of_text(
                  file_with("<phase name=\"in\" speed_mm_per_s=\"5\"><until time_s=\"1\" then=\"out\"/></phase>")),
              HasSubstr("then is 'out', expected the name of a phase"));
  const std::string twice = "<phase name=\"in\" speed_mm_per_s=\"5\">" + stop + "</phase>";
  EXPECT_THAT(refusal_of_text(file_with(twice + twice)), HasSubstr("second phase 'in'"));
  EXPECT_THAT(refusal_of_text(file_with("<phase name=\"end\" speed_mm_per_s=\"5\">" + stop + "</phase>")),
              HasSubstr("called 'end'"));
  EXPECT_THROW(load_operator("/no/such/operator.xml"), InputError);
  for (const char* lacking : {"drop_share=\"0.5\"", "time_s=\"1\" share_of=\"dura\""})
    EXPECT_THAT(refusal_of_text(file_with("\n<phase name=\"in\" speed_mm_per_s=\"5\">\n<until " +
                                          std::string(lacking) + " then=\"end\"/></phase>")),
                AllOf(HasSubstr("line 3"), HasSubstr("need a tissue, share_of")));
}

// Drops and forces in N, phase by phase, that an operator waits for in a patient.
std::vector<double> thresholds_of(const OperatorScript& script) {
  std::vector<double> found;
  for (const OperatorPhase& phase : script.phases) {
    if (phase.name != "advance" && phase.name != "flavum" && phase.name != "find_dura") continue;
    for (const OperatorCondition& until : phase.until)
      for (const std::optional<double>& threshold : {until.force_drop, until.force_above})
        if (threshold) found.push_back(*threshold);
  }
  return found;
}

TEST(OperatorFile, shares_of_a_tissues_force_are_read_and_written) {
  const OperatorScript script =
      parse_operator(file_with("<phase name=\"in\" speed_mm_per_s=\"5\"><until force_above_N=\"5\" share_of=\"dura\" "
                               "drop_share=\"0.5\" force_above_share=\"3\" then=\"end\"/></phase>"),
                     "mine.xml");
  const OperatorCondition& until = script.phases[0].until[0];
  EXPECT_EQ(until.share_of, "dura");
  EXPECT_EQ(until.drop_share, 0.5);
  EXPECT_EQ(until.force_above_share, 3.0);
  EXPECT_EQ(until.force_above, 5.0);
  const auto json = nlohmann::json::parse(operator_json(script));
  EXPECT_EQ(json["phases"][0]["until"][0]["share_of"], "dura");
  EXPECT_EQ(json["phases"][0]["until"][0]["drop_share"], 0.5);
  EXPECT_EQ(json["phases"][0]["until"][0]["force_above_share"], 3.0);
}

// With the tables they are those that the operators had in newtons before there were shares.
TEST(OperatorFile, the_operators_that_come_with_bodkin_wait_for_what_the_needle_takes) {
  anatomy::Case patient;
  patient.library = io::default_tissue_library();
  const auto thresholds = [&](const char* name) { return thresholds_of(for_patient(load_operator(name), patient)); };
  const auto are = [](const std::vector<double>& expected) {
    return ::testing::Pointwise(::testing::DoubleEq(), expected);
  };
  EXPECT_THAT(thresholds("expert"), are({2.0, 5.5, 0.3, 5.5}));
  EXPECT_THAT(thresholds("expert_lumbar_puncture"), are({2.0, 5.5, 0.3, 5.5}));
  EXPECT_THAT(thresholds("expert_epidural"), are({1.7, 6.5}));
  EXPECT_THAT(thresholds("novice"), are({2.2, 5.7, 0.5, 5.7}));
  // A 22G quincke needle: 1.41 N for the ligament, 0.9 N for the dura, and bone as hard as ever.
  patient.description.haptics.mechanics = anatomy::Mechanics::physical;
  const std::vector<double> thin = thresholds("expert");
  EXPECT_NEAR(thin[0], 0.625 * 1.41, 0.005);
  EXPECT_DOUBLE_EQ(thin[1], 5.5);
  EXPECT_NEAR(thin[2], 0.45, 1e-9);
}

}  // namespace
}  // namespace bodkin
