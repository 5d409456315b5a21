#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "imaging/png_file.h"

namespace bodkin_test {
namespace {

using ::testing::HasSubstr;

class CaseShow : public PatientCommand {};

TEST_F(CaseShow, prints_what_is_in_a_case_and_writes_its_picture) {
  const auto file = folder_ / "show.png";
  const Outcome said = bodkin("-q case show " + patient() + " -o " + file.string());
  ASSERT_EQ(said.exit_code, 0) << said.errors;
  for (const char* text : {"axes LPS", "HU", "ligamentum flavum", "mL", "vertebrae_L3", "L3_L4", "needle",
                           "lumbar_puncture", "layered, line_spring", "path", "show.png", "kidney_left (critical)",
                           "liver (critical)", "aorta (critical)"}) {
    EXPECT_THAT(said.output, HasSubstr(text));
  }
  const ::bodkin::imaging::ImageRgb picture = ::bodkin::imaging::decode_png(content_of(file), "show.png");
  EXPECT_GT(picture.width, 1000);
  EXPECT_GT(picture.height, 500);
}

TEST_F(CaseShow, tells_the_same_in_json) {
  const auto file = folder_ / "show.svg";
  const Outcome said = bodkin("-q --json case show " + patient() + " -o " + file.string());
  ASSERT_EQ(said.exit_code, 0) << said.errors;
  const auto result = nlohmann::json::parse(said.output);
  EXPECT_EQ(result.at("ct").at("axes"), "LPS");
  EXPECT_GT(result.at("tissues_ml").at("fat").get<double>(), 100.0);
  EXPECT_GT(result.at("procedure").at("path").at("length_mm").get<double>(), 20.0);
  EXPECT_EQ(result.at("resistance").at("model"), "layered");
  EXPECT_EQ(result.at("resistance").at("settings"), "layered law=cubic strict=false layer_mm=0.5");
  EXPECT_EQ(result.at("resistance").at("values").at("layer_mm"), 0.5);
  EXPECT_EQ(result.at("resistance").at("values").at("strict"), false);
  EXPECT_EQ(result.at("constraint").at("model"), "line_spring");
  EXPECT_EQ(result.at("needle").at("tip"), "quincke");
  EXPECT_GT(result.at("device").at("peak_force_N").get<double>(), 0.0);
  EXPECT_GT(result.at("tissues").at("skin").at("layered").at("viscoelastic").at("break_force_N").get<double>(), 0.0);
  EXPECT_TRUE(result.at("parts").empty());
  EXPECT_EQ(result.at("picture"), file.string());
  EXPECT_THAT(content_of(file), HasSubstr("planned path"));
}

TEST_F(CaseShow, refuses_a_folder_without_a_case_and_a_picture_of_another_kind) {
  EXPECT_EQ(bodkin("-q case show " + folder_.string()).exit_code, 2);
  const Outcome said = bodkin("-q case show " + patient() + " -o picture.jpg");
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_THAT(said.errors, HasSubstr("expected .png or .svg"));
}

}  // namespace
}  // namespace bodkin_test
