#include <filesystem>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

// `bodkin case synthesize phantom` as a user runs it.

namespace bodkin_test {
namespace {

using testing::HasSubstr;

class CaseSynthesizePhantom : public BodkinCommand {};

TEST_F(CaseSynthesizePhantom, of_a_published_experiment_is_a_sound_case_that_can_be_needled) {
  const Outcome made = bodkin("-q case synthesize phantom layers --experiment alamilla_2018_fig_5");
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  EXPECT_EQ(bodkin("case check layers").exit_code, 0);
  const Outcome profile = bodkin("--json profile layers");
  EXPECT_EQ(profile.exit_code, 0) << profile.errors;
}

TEST_F(CaseSynthesizePhantom, of_an_experiment_that_there_is_not_names_those_that_are) {
  const Outcome said = bodkin("-q case synthesize phantom lost --experiment alamilla_2018_fig_99");
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_THAT(said.errors, HasSubstr("alamilla_2018_fig_9"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "lost"));
}

}  // namespace
}  // namespace bodkin_test
