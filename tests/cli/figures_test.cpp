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

}  // namespace
}  // namespace bodkin_test
