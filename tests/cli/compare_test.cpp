#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

class CompareCommand : public PatientCommand {};

TEST_F(CompareCommand, runs_every_model_and_writes_table_and_plot) {
  const fs::path base = folder_ / "all";
  const Outcome said = bodkin("-q compare " + patient() + " --speed 40 -o " + base.string());
  ASSERT_EQ(said.exit_code, 0) << said.text();
  for (const char* name :
       {"layered ", "layered_sum", "tracking_wall ", "tracking_wall_leash", "depth_profile", "volume_proxy ",
        "volume_proxy_viscous", "three_component", "fracture", "shaft_friction"}) {
    EXPECT_THAT(said.text(), HasSubstr(name));
  }
  EXPECT_THAT(said.text(), HasSubstr("this machine"));
  EXPECT_THAT(content_of(base.string() + ".csv"),
              HasSubstr("time_s,depth_mm,layered_N,layered_tip_N,layered_shaft_N,layered_material_mm,layered_sum_N"));
  const std::string picture = content_of(base.string() + ".svg");
  EXPECT_THAT(picture, HasSubstr("interspinous ligament"));
  EXPECT_THAT(picture, HasSubstr("re-insertion"));
}

TEST_F(CompareCommand, takes_names_and_a_motion_and_tells_in_json) {
  const fs::path base = folder_ / "some";
  const Outcome said = bodkin("-q --json compare " + patient() +
                              " --models fracture,layered,fracture --constraint none --speed 20 --withdraw-speed 40 "
                              "--pause 0.5 --no-reinsert -o " +
                              base.string());
  ASSERT_EQ(said.exit_code, 0) << said.text();
  const auto result = nlohmann::json::parse(said.text());
  EXPECT_EQ(result.at("constraint"), "none");
  EXPECT_EQ(result.at("reference"), "layered");
  ASSERT_EQ(result.at("models").size(), 2U);
  const auto& fracture = result["models"][0];
  EXPECT_EQ(fracture.at("model"), "fracture");
  EXPECT_GT(fracture.at("peak").at("force_N"), 0.0);
  EXPECT_GT(fracture.at("work_N_mm").at("insertion"), 0.0);
  EXPECT_EQ(fracture.at("work_N_mm").at("re-insertion"), 0.0);
  EXPECT_EQ(result["models"][1].at("largest_difference_N"), 0.0);
  const auto& phases = result.at("phases");
  EXPECT_NEAR(phases[1].at("to_s").get<double>() - phases[1].at("from_s").get<double>(), 0.5, 0.002);
  EXPECT_EQ(phases[3].at("from_s"), phases[3].at("to_s"));
}

// Independent of the case.
TEST_F(CompareCommand, is_of_one_description_of_each_tissue_unless_the_tables_are_asked_for) {
  const fs::path of_tables = folder_ / "of_tables";
  fs::copy(patient(), of_tables, fs::copy_options::recursive);
  std::string xml = content_of(of_tables / "case.xml");
  const std::string physical = "mechanics=\"physical\"";
  ASSERT_NE(xml.find(physical), std::string::npos);
  write("of_tables/case.xml", xml.replace(xml.find(physical), physical.size(), "mechanics=\"tables\""));
  const std::string base = (folder_ / "mechanics").string();
  const std::string command =
      "compare of_tables --models layered,tracking_wall --speed 20 --no-reinsert --pause 0.1 -o " + base;
  const auto told = [&](const std::string& options) {
    const auto result = nlohmann::json::parse(bodkin("-q --json " + command + options).output);
    std::vector<std::vector<std::string>> all;
    for (const auto& model : result.at("models")) {
      all.emplace_back();
      for (const auto& event : model.at("told")) {
        const std::string text = event.at("text");
        all.back().push_back(text.substr(0, std::min(text.find(" at "), text.find(','))));
      }
    }
    return std::pair(result.at("mechanics").get<std::string>(), all);
  };
  const auto [mechanics, events] = told("");
  EXPECT_EQ(mechanics, "physical");
  EXPECT_EQ(events[0], events[1]) << "ligamentum flavum is the same for both";
  EXPECT_GT(events[0].size(), 4U);
  EXPECT_EQ(told(" --mechanics physical"), told(""));
  EXPECT_EQ(told(" --mechanics tables").first, "tables");
  EXPECT_THAT(bodkin("-q " + command).output,
              HasSubstr("Mechanics: physical, one description of each tissue for all models, for the needle 22G "
                        "quincke, 0.72 mm."));
  EXPECT_THAT(bodkin("-q " + command + " --needle 16G,90,tuohy").output, HasSubstr("16G tuohy, 1.65 mm."));
  EXPECT_THAT(bodkin("-q " + command + " --mechanics tables").output, HasSubstr("Mechanics: tables, each model"));
  EXPECT_THAT(bodkin("-q " + command + " --mechanics wood").text(), HasSubstr("expected tables or physical"));
}

// Its layers have the forces that its caption states, and no description.
TEST_F(CompareCommand, leaves_a_phantom_the_forces_of_its_experiment) {
  const std::string phantom = (folder_ / "phantom").string();
  ASSERT_EQ(bodkin("-q case synthesize phantom " + phantom + " --experiment alamilla_2018_fig_5").exit_code, 0);
  const Outcome said = bodkin("--json compare " + phantom + " --models tracking_wall --speed 20 -o " +
                              (folder_ / "of_phantom").string());
  ASSERT_EQ(said.exit_code, 0) << said.text();
  EXPECT_THAT(said.errors, HasSubstr("does not describe virtual shoulder: each model keeps its own numbers"));
  const auto result = nlohmann::json::parse(said.output);
  EXPECT_EQ(result.at("mechanics"), "physical");
  EXPECT_NEAR(result["models"][0].at("peak").at("force_N").get<double>(), 1.0, 0.02) << "of the paper";
}

TEST_F(CompareCommand, plays_any_motion_to_every_model) {
  const fs::path base = folder_ / "motion";
  const std::string command =
      "-q --json compare " + patient() + " -o " + base.string() + " --models tracking_wall,layered --motion ";
  const Outcome said = bodkin(command + "'25 at 20, hold 2, 10 at 40, 40 at 20, hold 1, out at 40'");
  ASSERT_EQ(said.exit_code, 0) << said.text();
  const auto result = nlohmann::json::parse(said.text());
  std::string phases;
  for (const auto& phase : result.at("phases")) phases += phase.at("phase").get<std::string>() + " ";
  EXPECT_EQ(phases, "insertion stop withdrawal re-insertion insertion stop withdrawal ");
  EXPECT_NEAR(result["phases"][2].at("to_mm").get<double>(), 10.0, 1e-3);
  EXPECT_LT(result["models"][0].at("peak_of_reinsertion_N").get<double>(), 0.1);
  EXPECT_GT(result["models"][0].at("closed_work_N_mm").get<double>(), 0.0);
  EXPECT_THAT(bodkin(command + "25 --no-reinsert").text(), HasSubstr("leave out --no-reinsert"));
  const auto open = nlohmann::json::parse(bodkin(command + "25").text());
  EXPECT_TRUE(open["models"][0].at("closed_work_N_mm").is_null());
}

TEST_F(CompareCommand, says_what_it_left_out_and_reports_progress_on_standard_error) {
  const fs::path base = folder_ / "left_out";
  const std::string description = content_of(fs::path(patient()) / "case.xml");
  const fs::path soft = folder_ / "soft_device";  // a device that is too soft for the proxy's 0.5 N/mm
  fs::copy(patient(), soft, fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  const auto device = description.find("<device");
  ASSERT_NE(device, std::string::npos);
  const auto end = description.find('>', device);
  std::ofstream(soft / "case.xml") << description.substr(0, device)
                                   << R"(<device profile="soft" peak_force_N="3" continuous_force_N="1" )"
                                      R"(stiffness_N_per_mm="0.4" position_resolution_mm="0.05"/>)"
                                   << description.substr(end + 1);
  const std::string command = "compare " + soft.string() + " --speed 40 --constraint none -o " + base.string();
  const Outcome said = bodkin(command + " --models volume_proxy,layered");
  ASSERT_EQ(said.exit_code, 0) << said.text();
  EXPECT_THAT(said.text(), HasSubstr("note: volume_proxy is left out: volume_proxy: stiffness is 0.5 N/mm"));
  EXPECT_THAT(said.text(), HasSubstr("Inserting with layered"));
  EXPECT_THAT(bodkin(command + " --models volume_proxy,layered").output, Not(HasSubstr("Inserting")));
  const Outcome nothing = bodkin(command + " -q --models volume_proxy");
  EXPECT_EQ(nothing.exit_code, 2);
  EXPECT_THAT(nothing.text(), HasSubstr("stiffness is 0.5 N/mm"));
}

TEST_F(CompareCommand, refuses_bad_arguments_in_one_sentence_and_leaves_no_file) {
  const fs::path base = folder_ / "refused_comparison";
  for (const char* arguments :
       {"--models jelly", "--models ''", "--constraint glue", "--speed 0", "--speed nan", "--withdraw-speed 0",
        "--pause -1", "--entry 0,1 --target 0,0,0", "--entry 9000,0,0"}) {
    const Outcome said = bodkin("-q compare " + patient() + " " + arguments + " -o " + base.string());
    EXPECT_EQ(said.exit_code, 2) << arguments << ": " << said.text();
    EXPECT_THAT(said.text(), ::testing::StartsWith("bodkin: ")) << arguments;
    EXPECT_EQ(lines_of(said.text()), 1) << said.text();
  }
  EXPECT_THAT(bodkin("-q compare " + patient() + " --models jelly").text(),
              HasSubstr("'jelly', expected 'all' or some of layered, layered_sum, spring_damper_wall"));
  EXPECT_EQ(bodkin("-q compare /no/such/case -o " + base.string()).exit_code, 2);
  EXPECT_FALSE(fs::exists(base.string() + ".csv"));
  EXPECT_FALSE(fs::exists(base.string() + ".svg"));
  EXPECT_THAT(bodkin("compare --help").text(), HasSubstr("Examples:"));
}

}  // namespace
}  // namespace bodkin_test
