#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>

// `bodkin markers calibrate` as a user runs it; tests/tracking/body_calibration_test.cpp measures it.

#ifdef BODKIN_HAS_TRACKING

namespace bodkin_test {
namespace {

using testing::HasSubstr;

class MarkersCalibrate : public BodkinCommand {};

TEST_F(MarkersCalibrate, too_few_pictures_and_unknown_bodies_are_refused) {
  ASSERT_EQ(bodkin("--quiet scene render footage --frames 1 --width 320 --height 240").exit_code, 0);
  const Outcome few = bodkin("markers calibrate footage --body needle -o new.json");
  EXPECT_EQ(few.exit_code, 2) << few.text();
  EXPECT_THAT(few.errors, HasSubstr("of body \"needle\" was seen"));
  EXPECT_THAT(bodkin("markers calibrate footage --body spoon -o new.json").errors, HasSubstr("no body of that name"));
  EXPECT_THAT(bodkin("markers calibrate footage --body needle").errors, HasSubstr("--output is missing"));
}

}  // namespace
}  // namespace bodkin_test

#endif
