#include <cmath>
#include <filesystem>
#include <fstream>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class FitCommand : public BodkinCommand {
 protected:
  static std::string file(const std::string& name, const std::string& text) {
    write(name, text);
    return (folder_ / name).string();
  }
  // 0.5 N/mm up to 1 N, a plateau to 10 mm, at 10 mm/s.
  std::string ramp(const std::string& header = "time_s,depth_mm,force_N", double force = 1.0) const {
    std::string text = header + "\n";
    for (int i = 0; i <= 100; ++i) {
      const double depth = 0.1 * i;
      text += std::to_string(0.01 * i) + "," + std::to_string(depth) + "," +
              std::to_string(force * std::min(0.5 * depth, 1.0)) + "\n";
    }
    return file("ramp.csv", text);
  }
  std::string base() const {
    return (folder_ / ::testing::UnitTest::GetInstance()->current_test_info()->name()).string();
  }
};

TEST_F(FitCommand, prints_parameters_and_writes_picture_and_xml) {
  const Outcome said = bodkin("-q fit tracking_wall " + ramp() + " -o " + base());
  ASSERT_EQ(said.exit_code, 0) << said.text();
  EXPECT_THAT(said.text(), HasSubstr("stiffness"));
  EXPECT_THAT(said.text(), HasSubstr("R^2 1.0000"));
  EXPECT_THAT(said.text(), HasSubstr("kept: the data do not depend on it"));
  EXPECT_THAT(content_of(base() + ".svg"), HasSubstr("ramp.csv, tracking_wall"));
  EXPECT_THAT(content_of(base() + ".xml"), HasSubstr("<tracking_wall stiffness_N_per_mm="));
}

TEST_F(FitCommand, tells_in_json_and_obeys_its_options) {
  const Outcome said =
      bodkin("-q --json fit tracking_wall " + ramp() +
             " --fix catch_up=0.2 --start stiffness=3 --bounds force=0.1:5 --from 0.5 --to 8 -o " + base());
  ASSERT_EQ(said.exit_code, 0) << said.text();
  const auto result = nlohmann::json::parse(said.text());
  EXPECT_EQ(result.at("model"), "tracking_wall");
  EXPECT_EQ(result.at("samples"), 76);
  EXPECT_GT(result.at("r_squared").get<double>(), 0.9999);
  const auto& parameters = result.at("parameters");
  EXPECT_NEAR(parameters[0].at("value").get<double>(), 0.5, 1e-3);
  EXPECT_NEAR(parameters[1].at("value").get<double>(), 1.0, 1e-3);
  EXPECT_EQ(parameters[2].at("status"), "kept");
  EXPECT_EQ(parameters[2].at("value"), 0.2);
}

TEST_F(FitCommand, refuses_in_one_sentence_and_writes_nothing) {
  const std::string curve = ramp();
  const std::string none = base() + "_refused";  // the folder is that of all tests
  const std::vector<std::string> wrong = {
      "tracking_wal " + curve,
      "tracking_wall /no/such/file.csv",
      "tracking_wall " + curve + " --fix stiffness",
      "tracking_wall " + curve + " --fix stiffness=abc",
      "tracking_wall " + curve + " --fix =1",
      "tracking_wall " + curve + " --bounds force=1",
      "tracking_wall " + curve + " --bounds force=2:1",
      "tracking_wall " + curve + " --free weight",
      "tracking_wall " + curve + " --from 9 --to 9.2",
      "tracking_wall " + curve + " --speed -1",
      "tracking_wall " + file("empty.csv", ""),
      "tracking_wall " + file("few.csv", "depth_mm,force_N\n1,1\n2,2\n"),
      "layered " + file("no_time.csv", "depth_mm,force_N\n1,1\n2,1\n3,1\n4,1\n5,1\n6,1\n7,1\n8,1\n9,1\n10,1\n11,1\n"),
  };
  for (const std::string& arguments : wrong) {
    const Outcome said = bodkin("-q fit " + arguments + " -o " + none);
    EXPECT_EQ(said.exit_code, 2) << arguments << ": " << said.text();
    EXPECT_THAT(said.text(), ::testing::StartsWith("bodkin: ")) << arguments;
    EXPECT_EQ(lines_of(said.text()), 1) << said.text();
  }
  EXPECT_THAT(bodkin("-q fit tracking_wall " + ramp("time_s,depth_mm,force_mN") + " -o " + none).text(),
              HasSubstr("force_N"));
  EXPECT_THAT(bodkin("-q fit tracking_wall " + ramp("time_s,depth_mm,force_N", 1000.0) + " -o " + none).text(),
              HasSubstr("millinewtons"));
  EXPECT_FALSE(fs::exists(none + ".svg"));
  EXPECT_FALSE(fs::exists(none + ".xml"));
}

TEST_F(FitCommand, compares_the_models_of_a_stack) {
  const std::string curve = file("two.csv", [] {
    std::string text = "time_s,depth_mm,force_N\n";  // two plateaus, of 1 and 2 N
    for (int i = 0; i <= 160; ++i) {
      const double depth = 0.1 * i;
      text += std::to_string(0.01 * i) + "," + std::to_string(depth) + "," +
              std::to_string(depth < 8.0 ? std::min(0.5 * depth, 1.0) : std::min(1.0 + 0.5 * (depth - 8.0), 2.0)) +
              "\n";
    }
    return text;
  }());
  const Outcome said = bodkin("-q fit all " + curve + " --layers 0,8 -o " + base());
  ASSERT_EQ(said.exit_code, 0) << said.text();
  EXPECT_THAT(said.text(), HasSubstr("The best, tracking_wall"));
  EXPECT_THAT(said.text(), HasSubstr("fitted as one tissue, without layers: "));
  const Outcome stack = bodkin("-q --json fit layered " + curve + " --layers 0,8 -o " + base());
  ASSERT_EQ(stack.exit_code, 0) << stack.text();
  EXPECT_EQ(nlohmann::json::parse(stack.text()).at("parameters")[1].at("name"), "stiffness_2");
  EXPECT_EQ(bodkin("-q fit all " + curve + " --layers 0,8,8 -o " + base()).exit_code, 2);
  EXPECT_EQ(bodkin("-q fit layered " + curve + " --layers 0,8.05 -o " + base()).exit_code, 2);
}

TEST_F(FitCommand, explains_itself_with_examples) {
  const Outcome said = bodkin("fit --help");
  EXPECT_EQ(said.exit_code, 0);
  EXPECT_THAT(said.text(), HasSubstr("Examples:"));
  EXPECT_THAT(said.text(), HasSubstr("three_component"));
}

}  // namespace
}  // namespace bodkin_test
