#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>

// `bodkin camera calibrate` as a user runs it; tests/tracking/camera_calibration_test.cpp measures it.

#ifdef BODKIN_HAS_TRACKING

namespace bodkin_test {
namespace {

using testing::HasSubstr;

class CameraCalibrate : public BodkinCommand {};

TEST_F(CameraCalibrate, says_what_is_missing) {
  EXPECT_THAT(bodkin("camera calibrate nothing").errors, HasSubstr("there is nothing of that name"));
  const Outcome none = bodkin("camera calibrate /dev/no_camera");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.errors, HasSubstr("no such camera"));
  ASSERT_EQ(bodkin("--quiet scene render footage --frames 1 --width 320 --height 240").exit_code, 0);
  const Outcome no_board = bodkin("camera calibrate footage");
  EXPECT_EQ(no_board.exit_code, 2);
  EXPECT_THAT(no_board.errors, HasSubstr("camera board"));
}

}  // namespace
}  // namespace bodkin_test

#endif
