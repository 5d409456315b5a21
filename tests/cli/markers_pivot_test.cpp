#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>

// `bodkin markers pivot` as a user runs it; tests/tracking/pivot_calibration_test.cpp measures it.

#ifdef BODKIN_HAS_TRACKING

namespace bodkin_test {
namespace {

using testing::HasSubstr;

class MarkersPivot : public BodkinCommand {};

TEST_F(MarkersPivot, needs_a_body_that_is_tilted_often_enough) {
  ASSERT_EQ(bodkin("--quiet scene render footage --frames 1 --width 640 --height 480").exit_code, 0);
  const Outcome few = bodkin("markers pivot footage --body needle -o new.json");
  EXPECT_EQ(few.exit_code, 2);
  EXPECT_THAT(few.errors, HasSubstr("at least 20 are needed"));
  EXPECT_THAT(bodkin("markers pivot footage --body spoon -o new.json").errors, HasSubstr("no body of that name"));
}

}  // namespace
}  // namespace bodkin_test

#endif
