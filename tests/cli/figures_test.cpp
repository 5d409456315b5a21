#include <fstream>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::string shipped(const std::string& name) {
  return BODKIN_REPOSITORY "/share/bodkin/experiments/" + name + ".xml";
}

class FiguresCommand : public BodkinCommand {};

TEST_F(FiguresCommand, draws_one_experiment_with_its_table_and_page) {
  const fs::path folder = folder_ / "figures";
  const Outcome said = bodkin("-q figures " + folder.string() + " --experiment " + shipped("alamilla_2018_fig_5"));
  ASSERT_EQ(said.exit_code, 0) << said.text();
  EXPECT_THAT(said.text(), HasSubstr("agrees"));
  EXPECT_THAT(said.text(), HasSubstr("index.html"));
  EXPECT_THAT(content_of((folder / "alamilla_2018_fig_5.svg").string()), HasSubstr("displacement, mm"));
  EXPECT_THAT(content_of((folder / "alamilla_2018_fig_5.csv").string()), HasSubstr("time_s,depth_mm"));
  EXPECT_THAT(content_of((folder / "index.html").string()), HasSubstr("<img src=\"alamilla_2018_fig_5.svg\""));
  EXPECT_THAT(content_of((folder / "index.md").string()), HasSubstr("(alamilla_2018_fig_5.svg)"));
}

TEST_F(FiguresCommand, takes_several_and_tells_in_json) {
  const fs::path folder = folder_ / "two";
  const Outcome said = bodkin("-q --json figures " + folder.string() + " --experiment " + shipped("faerber_fig_3") +
                              " --experiment " + shipped("kwon_2001_fig_8"));
  ASSERT_EQ(said.exit_code, 0) << said.text();
  const auto result = nlohmann::json::parse(said.text());
  ASSERT_EQ(result.at("figures").size(), 2U);
  for (const auto& figure : result.at("figures")) {
    EXPECT_TRUE(fs::exists(figure.at("svg").get<std::string>()));
    EXPECT_TRUE(fs::exists(figure.at("csv").get<std::string>()));
    for (const auto& value : figure.at("published")) EXPECT_TRUE(value.at("agrees").get<bool>()) << value;
  }
}

TEST_F(FiguresCommand, refuses_bad_files_in_one_sentence_and_leaves_nothing) {
  const fs::path folder = folder_ / "refused", bad = folder_ / "bad.xml";
  std::ofstream(bad) << "<experiment version=\"1\" name=\"x\" title=\"y\"/>";
  for (const std::string& files : {std::string("/no/such.xml"), bad.string(),
                                   shipped("faerber_fig_3") + " --experiment " + shipped("faerber_fig_3")}) {
    const Outcome said = bodkin("-q figures " + folder.string() + " --experiment " + files);
    EXPECT_EQ(said.exit_code, 2) << said.text();
    EXPECT_THAT(said.text(), ::testing::StartsWith("bodkin: "));
    EXPECT_EQ(lines_of(said.text()), 1) << said.text();
  }
  EXPECT_FALSE(fs::exists(folder));
  EXPECT_EQ(bodkin("figures").exit_code, 2);
}

class FiguresOnPatient : public PatientCommand {
 protected:
  // The experiment that docs/figures.md shows, on the patient of these tests.
  static std::string shown_in_docs() {
    const std::string page = content_of(BODKIN_REPOSITORY "/docs/figures.md");
    const auto named = page.find("name=\"stop_and_go\"");
    const auto from = page.rfind("<experiment", named), to = page.find("</experiment>", from);
    std::string text = page.substr(from, to + 13 - from);
    const std::string folder = "folder=\"lumbar\"";
    return text.replace(text.find(folder), folder.size(), "folder=\"patient\"");
  }
};

TEST_F(FiguresOnPatient, the_documented_motion_is_played_on_a_patient) {
  const fs::path file = folder_ / "stop_and_go.xml", folder = folder_ / "on_patient";
  std::ofstream(file) << shown_in_docs();
  const Outcome said = bodkin("-q --json figures " + folder.string() + " --experiment " + file.string());
  ASSERT_EQ(said.exit_code, 0) << said.text();
  const auto figure = nlohmann::json::parse(said.output).at("figures")[0];
  for (const auto& value : figure.at("published")) EXPECT_TRUE(value.at("agrees").get<bool>()) << value;
  EXPECT_THAT(content_of(folder / "stop_and_go.svg"), HasSubstr("interspinous ligament"));
  EXPECT_THAT(content_of(folder / "stop_and_go.csv"), HasSubstr(",interspinous_ligament\n"));
}

TEST_F(FiguresOnPatient, a_patient_that_does_not_fit_is_refused_in_one_sentence) {
  const std::string right = shown_in_docs();
  const auto refused = [&](const std::string& from, const std::string& to, const std::string& words) {
    std::string text = right;
    text.replace(text.find(from), from.size(), to);
    const fs::path file = folder_ / "wrong.xml", folder = folder_ / "not_made";
    std::ofstream(file) << text;
    const Outcome said = bodkin("-q figures " + folder.string() + " --experiment " + file.string());
    EXPECT_EQ(said.exit_code, 2) << to;
    EXPECT_EQ(lines_of(said.text()), 1) << said.text();
    EXPECT_THAT(said.text(), HasSubstr(words));
    EXPECT_FALSE(fs::exists(folder));
  };
  refused("folder=\"patient\"", "folder=\"nobody\"", "nobody");
  refused("<motion>", "<motion direction_x=\"1\">", "expected entry and target in <patient>");
  refused("<patient folder=\"patient\"/>",
          "<patient folder=\"patient\"><entry x_mm=\"0\" y_mm=\"9000\" z_mm=\"0\"/>"
          "<target x_mm=\"0\" y_mm=\"0\" z_mm=\"0\"/></patient>",
          "lies outside the volume");
  const Outcome said = bodkin("case synthesize phantom " + (folder_ / "phantom").string() + " --experiment " +
                              (folder_ / "stop_and_go.xml").string());
  EXPECT_EQ(said.exit_code, 2);
}

}  // namespace
}  // namespace bodkin_test
