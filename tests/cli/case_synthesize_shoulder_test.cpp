#include <filesystem>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

// `bodkin case synthesize shoulder` as a user runs it.

namespace bodkin_test {
namespace {

using testing::HasSubstr;

class CaseSynthesizeShoulder : public BodkinCommand {};

TEST_F(CaseSynthesizeShoulder, is_a_sound_case_whose_joint_an_expert_reaches_and_passes) {
  const Outcome made = bodkin("-q case synthesize shoulder patient --spacing 1.5");
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  EXPECT_EQ(bodkin("case check patient").exit_code, 0);
  const Outcome shown = bodkin("case show patient -o picture.png");
  EXPECT_EQ(shown.exit_code, 0) << shown.errors;
  EXPECT_THAT(shown.output, HasSubstr("axillary_artery_right (critical)"));
  const Outcome profile = bodkin("profile patient");
  EXPECT_EQ(profile.exit_code, 0) << profile.errors;
  EXPECT_THAT(profile.output, HasSubstr("joint capsule gives way"));
  const Outcome run = bodkin("-q run patient --operator expert_to_target --seed 3 --output expert.bodkin");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const Outcome score = bodkin("--json score expert.bodkin");
  EXPECT_EQ(score.exit_code, 0) << score.output;
  const nlohmann::json judged = nlohmann::json::parse(score.output);
  EXPECT_EQ(judged["verdict"], "pass") << score.output;
}

TEST_F(CaseSynthesizeShoulder, seed_varies_everything_that_is_not_given) {
  ASSERT_EQ(bodkin("-q case synthesize shoulder drawn --vary --seed 5 --side left --spacing 2").exit_code, 0);
  const std::string drawn = text_of("drawn/case.xml");
  EXPECT_THAT(drawn, HasSubstr("Synthetic left shoulder"));
  EXPECT_THAT(drawn, HasSubstr("mechanics=\"physical\""));
  EXPECT_THAT(drawn, testing::Not(HasSubstr("55 years, 1.72 m, 76 kg")));
}

TEST_F(CaseSynthesizeShoulder, a_nerve_block_is_planned_beside_the_nerve_and_judged_as_one) {
  const Outcome made = bodkin("-q case synthesize shoulder block --target suprascapular_nerve --spacing 1.5");
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  EXPECT_THAT(text_of("block/case.xml"), HasSubstr("ultrasound_guided_nerve_block"));
  ASSERT_EQ(bodkin("-q run block --operator expert_to_target --seed 3 --output block.bodkin").exit_code, 0);
  const Outcome score = bodkin("--json score block.bodkin");
  const nlohmann::json judged = nlohmann::json::parse(score.output);
  EXPECT_EQ(judged["verdict"], "borderline") << score.output;  // `run` holds no probe: nobody saw the tip
}

TEST_F(CaseSynthesizeShoulder, the_needle_is_felt_unless_the_tables_are_asked_for) {
  const std::string command = "-q --json case synthesize shoulder felt --spacing 2 --needle 21,90,quincke";
  EXPECT_EQ(nlohmann::json::parse(bodkin(command).output).at("mechanics"), "physical");
  EXPECT_THAT(text_of("felt/case.xml"), HasSubstr("mechanics=\"physical\""));
  const Outcome tables = bodkin(command + " --overwrite --mechanics tables");
  EXPECT_EQ(nlohmann::json::parse(tables.output).at("mechanics"), "tables");
  EXPECT_THAT(text_of("felt/case.xml"), testing::Not(HasSubstr("mechanics=\"physical\"")));
}

TEST_F(CaseSynthesizeShoulder, what_cannot_be_is_refused_and_leaves_nothing) {
  for (const char* wrong : {"--side middle", "--target elbow", "--fluid 1", "--spacing 5", "--procedure none_such",
                            "--needle 22,0,quincke", "--mechanics wrong"}) {
    const Outcome outcome = bodkin(std::string("case synthesize shoulder refused ") + wrong);
    EXPECT_EQ(outcome.exit_code, 2) << wrong;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "refused")) << wrong;
  }
}

}  // namespace
}  // namespace bodkin_test
