#include "session/operator_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/error.h"

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
}

}  // namespace
}  // namespace bodkin
