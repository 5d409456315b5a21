#include <algorithm>
#include <tuple>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

namespace fs = std::filesystem;
using ::testing::_;
using ::testing::DoubleNear;
using ::testing::FieldsAre;
using ::testing::Gt;
using ::testing::HasSubstr;

class ProfileCommand : public PatientCommand {};

TEST_F(ProfileCommand, writes_table_and_plot_of_the_planned_path) {
  const fs::path base = folder_ / "planned";
  const Outcome said = bodkin("-q profile " + patient() + " -o " + base.string());
  ASSERT_EQ(said.exit_code, 0) << said.errors;
  EXPECT_THAT(said.output, HasSubstr("ligamentum flavum"));
  EXPECT_THAT(said.output, HasSubstr("skin gives way"));
  EXPECT_THAT(said.output, HasSubstr("the end of the path was reached at "));
  EXPECT_THAT(content_of(base.string() + ".csv"), HasSubstr("time_s,depth_mm,velocity_mm_s,resistance_N"));
  EXPECT_THAT(content_of(base.string() + ".svg"), HasSubstr("interspinous ligament"));
}

TEST_F(ProfileCommand, takes_a_path_with_negative_numbers_and_tells_in_json) {
  const fs::path base = folder_ / "other";
  const Outcome planned = bodkin("-q --json profile " + patient() + " -o " + base.string());
  ASSERT_EQ(planned.exit_code, 0) << planned.errors;
  const auto entry = nlohmann::json::parse(planned.output).at("entry_mm");
  const auto target = nlohmann::json::parse(planned.output).at("target_mm");
  const auto text = [](const nlohmann::json& point, double aside) {
    return std::to_string(point[0].get<double>() - 8.0 + aside) + "," + std::to_string(point[1].get<double>()) + "," +
           std::to_string(point[2].get<double>());
  };
  const Outcome said = bodkin("-q --json profile " + patient() + " --entry " + text(entry, 0) + " --target " +
                              text(target, 0) + " --speed 5 --withdraw -o " + base.string());
  ASSERT_EQ(said.exit_code, 0) << said.errors;
  const auto result = nlohmann::json::parse(said.output);
  EXPECT_NEAR(result.at("entry_mm")[0].get<double>(), entry[0].get<double>() - 8.0, 1e-5);
  EXPECT_EQ(result.at("speed_mm_s"), 5.0);
  EXPECT_GT(result.at("tissues").size(), 2U);
}

TEST_F(ProfileCommand, moves_as_it_is_told_and_draws_tip_and_wall_over_time) {
  const fs::path base = folder_ / "motion";
  const std::string command = "-q --json profile " + patient() + " -o " + base.string() + " --motion ";
  const auto duration = [&](const std::string& motion) {
    const Outcome said = bodkin(command + "'" + motion + "' --resistance tracking_wall");
    EXPECT_EQ(said.exit_code, 0) << said.errors;
    return nlohmann::json::parse(said.output).at("duration_s").get<double>();
  };
  // Differences, because the way through the air depends on the CT's skin: 5 s of rest; 15 mm back at 20 mm/s and in
  // again at 5 mm/s.
  const double straight = duration("25 at 10, out at 20");
  EXPECT_NEAR(duration("25 at 10, hold 5, out at 20") - straight, 5.0, 0.005);
  EXPECT_NEAR(duration("25 at 10, 10 at 20, 25 at 5, out at 20") - straight, 0.75 + 3.0, 0.005);
  duration("25 at 10, hold 2, 10 at 20, 40 at 5, hold 1, out at 20");
  EXPECT_THAT(content_of(base.string() + ".svg"), HasSubstr("depth below the skin, mm"));
  EXPECT_THAT(content_of(base.string() + ".svg"), HasSubstr("time, s"));
  EXPECT_THAT(bodkin(command + "'25, wait 2'").text(), HasSubstr("--motion: step 2 is 'wait 2', expected DEPTH"));
  EXPECT_THAT(bodkin(command + "25 --pause 1").text(),
              HasSubstr("--motion already states every step; leave out --pause"));
}

TEST_F(ProfileCommand, takes_other_force_models_than_the_case) {
  const fs::path base = folder_ / "models";
  const auto peak = [&](const std::string& options) {
    const Outcome said = bodkin("-q --json profile " + patient() + " " + options + " -o " + base.string());
    EXPECT_EQ(said.exit_code, 0) << said.text();
    const auto result = nlohmann::json::parse(said.text());
    double highest = 0.0;
    for (const auto& tissue : result.at("tissues"))
      highest = std::max(highest, tissue.at("peak_force_N").get<double>());
    return std::tuple(highest, result.at("resistance").get<std::string>(),
                      result.at("constraint").get<std::string>());
  };
  EXPECT_THAT(peak(""), FieldsAre(Gt(1.0), "layered", "line_spring"));
  const std::string wall = "--resistance 'tracking_wall limit_N=1.5; layer from_mm=0 force_N=";
  EXPECT_THAT(peak(wall + "0.4' --constraint pivot"), FieldsAre(DoubleNear(0.4, 0.02), "tracking_wall", "pivot"));
  EXPECT_THAT(content_of(base.string() + ".svg"), HasSubstr("tracking_wall"));
  EXPECT_THAT(peak(wall + "0.8'"), FieldsAre(DoubleNear(0.8, 0.02), _, "line_spring"));
  EXPECT_THAT(peak(wall + "4'"), FieldsAre(DoubleNear(1.5, 0.02), _, _)) << "the ceiling that was given";
  EXPECT_THAT(peak(wall + "0.4' --part shaft_friction"), FieldsAre(Gt(0.5), _, _));
}

TEST_F(ProfileCommand, refuses_force_models_in_one_sentence_that_names_the_option) {
  const fs::path base = folder_ / "refused_models";
  const auto refused = [&](const std::string& options) {
    const Outcome said = bodkin("-q profile " + patient() + " " + options + " -o " + base.string());
    EXPECT_EQ(said.exit_code, 2) << options << ": " << said.text();
    EXPECT_FALSE(fs::exists(base.string() + ".csv"));
    return said.text();
  };
  EXPECT_EQ(refused("--resistance 'tracking_wall catch_up_s=0'"),
            "bodkin: --resistance: tracking_wall catch_up_s is '0', expected a number of at least 0.001, or INF\n");
  EXPECT_EQ(
      refused("--constraint spring"),
      "bodkin: --constraint: there is no constraint 'spring', expected line_spring, pivot, rail, beam or none\n");
  EXPECT_EQ(refused("--part 'relaxation share=2'"),
            "bodkin: --part: relaxation share is '2', expected a number from 0 to 1\n");
  EXPECT_THAT(refused("--part relaxation"), HasSubstr("relaxation does not go with layered"));
  EXPECT_THAT(refused("--resistance 'spring_damper_wall stiffness_N_per_mm=2'"),
              HasSubstr("spring_damper_wall: stiffness is 2 N/mm, but the device (generic) renders at most 1 N/mm"));
}

TEST_F(ProfileCommand, says_in_its_result_that_bone_stopped_the_needle) {
  const auto landmarks = nlohmann::json::parse(bodkin("-q --json case show patient -o p.svg").output).at("landmarks");
  const auto target = landmarks.at("L3_L4");
  // Level from behind through the lower half of the spinous process above the interspace.
  const double z = target[2].get<double>() + 14.0;
  const auto point = [&](double y) {
    return std::to_string(target[0].get<double>()) + "," + std::to_string(y) + "," + std::to_string(z);
  };
  const auto skin = landmarks.at("L3_L4_skin");
  const Outcome said = bodkin("-q profile patient --entry=" + point(skin[1].get<double>()) +
                              " --target=" + point(target[1].get<double>()) + " -o bone");
  ASSERT_EQ(said.exit_code, 0) << said.errors;
  EXPECT_THAT(said.output, ::testing::ContainsRegex("\nstopped by (cortical|cancellous) bone at "));
  EXPECT_THAT(said.output, HasSubstr("before the end of the path"));
}

TEST_F(ProfileCommand, refuses_bad_paths_in_one_sentence_and_leaves_no_file) {
  const fs::path base = folder_ / "refused";
  for (const char* arguments : {"--entry 0,1 --target 0,0,0", "--entry nan,0,0 --target 0,0,0", "--entry 9000,0,0",
                                "--speed 0", "--speed -4", "--speed 1e9", "--entry 0,0,0 --target 0,0,0"}) {
    const Outcome said = bodkin("-q profile " + patient() + " " + arguments + " -o " + base.string());
    EXPECT_EQ(said.exit_code, 2) << arguments << ": " << said.errors;
    EXPECT_THAT(said.errors, ::testing::StartsWith("bodkin: ")) << arguments;
    EXPECT_EQ(std::count(said.errors.begin(), said.errors.end(), '\n'), 1) << said.errors;
  }
  EXPECT_EQ(bodkin("-q profile /no/such/case -o " + base.string()).exit_code, 2);
  EXPECT_FALSE(fs::exists(base.string() + ".csv"));
  EXPECT_FALSE(fs::exists(base.string() + ".svg"));
}

}  // namespace
}  // namespace bodkin_test
