#include <filesystem>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

// `bodkin case synthesize body` as a user runs it.

namespace bodkin_test {
namespace {

using testing::HasSubstr;

class CaseSynthesizeBody : public BodkinCommand {};

TEST_F(CaseSynthesizeBody, a_block_about_a_point_is_a_sound_case_that_can_be_needled) {
  const Outcome made = bodkin("-q case synthesize body shin --point ST36 --width 80 --spacing 2");
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  EXPECT_EQ(bodkin("case check shin").exit_code, 0);
  const Outcome profile = bodkin("--json profile shin");
  EXPECT_EQ(profile.exit_code, 0) << profile.errors;
  EXPECT_THAT(text_of("shin/case.xml"), HasSubstr("acupuncture"));
}

TEST_F(CaseSynthesizeBody, what_cannot_be_is_refused_and_leaves_nothing) {
  for (const char* wrong :
       {"--point ST99", "--sex neither", "--point ST36 --spacing 5", "--spacing 1", "--height 2 --weight 45"}) {
    const Outcome outcome = bodkin(std::string("case synthesize body refused ") + wrong);
    EXPECT_EQ(outcome.exit_code, 2) << wrong;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "refused")) << wrong;
  }
}

}  // namespace
}  // namespace bodkin_test
