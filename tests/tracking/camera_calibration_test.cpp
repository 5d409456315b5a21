// Lens, tone curve and blur of a rendered camera are recovered from images of the board.
#include "tracking/camera_calibration.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tracking/calibration_texts.h"
#include "tracking/footage.h"
#include "tracking/tracker.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin::tracking {
namespace {

using testing::HasSubstr;

CameraModel true_camera() {
  CameraModel camera = footage_camera(640, 480);
  camera.tone = {1.8, 0.3};
  camera.blur = 0.9;
  return camera;
}

// The board in front of the camera, tilted and moved by `n` from 0 to 11.
Pose board_place(int n) {
  const double round = 2.0 * 3.14159265 * n / 12.0;
  Pose pose = Pose::Identity();
  pose.linear() = (Eigen::AngleAxisd(n == 0 ? 0.0 : 0.6, Vec3(std::cos(round), std::sin(round), 0.0)) *
                   Eigen::AngleAxisd(0.4 * std::sin(3.0 * round), Vec3::UnitZ()))
                      .toRotationMatrix();
  pose.translation() =
      Vec3(85.0 * std::cos(5.0 * round), 55.0 * std::sin(5.0 * round), 350.0 + 30.0 * std::sin(round));
  return pose;
}

GreyImage picture_of_board(const CameraModel& camera, const Pose& place, const Vec3& shift = Vec3::Zero()) {
  static const MarkerBody printed = CalibrationBoard{}.printed();
  FootageLook look;
  look.samples = 4;
  look.instants = 6;
  PlacedBody body{&printed, place};
  body.shift = shift;
  return render_picture(camera, look, {body}, 5);
}

CalibrationOptions single_pictures() {
  CalibrationOptions options;
  options.in_motion = false;
  return options;
}

TEST(CameraCalibration, finds_lens_tone_curve_and_blur_and_leaves_out_what_moved) {
  const CameraModel truth = true_camera();
  CameraCalibration calibration(CalibrationBoard{}, single_pictures());
  for (int n = 0; n < 12; ++n)
    ASSERT_EQ(calibration.add(picture_of_board(truth, board_place(n))), PictureUse::kept) << n;
  Pose between = board_place(3);
  between.translation() = Vec3(5.0, 10.0, 360.0);
  // 3 pixels during the exposure: the markers are still detected.
  ASSERT_EQ(calibration.add(picture_of_board(truth, between, Vec3(2.2, 0.0, 0.0))), PictureUse::kept);
  const CalibratedCamera made = calibration.solve();
  // The moving image, and at most one other, which happens to be the worst.
  EXPECT_GE(made.refused, 1);
  EXPECT_GE(made.pictures, 11);
  EXPECT_LT(made.residual, 0.3);
  EXPECT_NEAR(made.camera.fx, truth.fx, 0.002 * truth.fx);
  EXPECT_NEAR(made.camera.cx, truth.cx, 1.0);
  EXPECT_NEAR(made.camera.cy, truth.cy, 1.0);
  EXPECT_LT(std::abs(made.camera.fx - truth.fx), 4.0 * made.focal_deviation + 0.2);
  // The rays matter: within a pixel or two where the board was.
  for (const Vec3& at : {Vec3(0.0, 0.0, 1.0), Vec3(0.4, 0.25, 1.0), Vec3(-0.4, -0.25, 1.0)}) {
    const Eigen::Vector2d off = made.camera.project(at) - truth.project(at);
    EXPECT_LT(off.norm(), 1.2);
  }
  EXPECT_NEAR(made.camera.blur, truth.blur, 0.15);
  for (const double level : {0.3, 0.5, 0.7}) {
    // Up to gain and offset, which do not matter: the fraction between black and white.
    const auto share = [&](const ToneCurve& tone) {
      const double black = tone.light(0.15), white = tone.light(0.85);
      return (tone.light(level) - black) / (white - black);
    };
    EXPECT_NEAR(share(made.camera.tone), share(truth.tone), 0.03) << level;
  }
  // Its own images are not mistaken for those of another camera.
  Tracker tracker(made.camera, {CalibrationBoard{}.printed(), cube_body("needle", 12, 60.0, 150.0)});
  PlacedBody needle{&tracker.bodies()[1], Pose::Identity()};
  needle.camera_from_body.translation() = Vec3(20.0, 10.0, 400.0);
  needle.camera_from_body.linear() = Eigen::AngleAxisd(0.7, Vec3(1.0, 0.5, 0.0).normalized()).toRotationMatrix();
  for (const GreyImage& picture : {picture_of_board(truth, board_place(4)), render_picture(truth, {}, {needle}, 6)}) {
    for (const TrackedPose& pose : tracker.track(picture, 0.0)) {
      if (pose.status == TrackingStatus::lost) continue;
      EXPECT_EQ(pose.status, TrackingStatus::ok);
      EXPECT_LT(std::abs(pose.misfit.tone.value), 0.08);
      EXPECT_LT(std::abs(pose.misfit.blur.value), 0.15);
    }
  }
}

TEST(CameraCalibration, a_picture_counts_only_while_the_board_rests) {
  const CameraModel truth = true_camera();
  CameraCalibration calibration{CalibrationBoard{}};
  const GreyImage first = picture_of_board(truth, board_place(1));
  EXPECT_EQ(calibration.add(first), PictureUse::moving);  // nothing to compare with yet
  EXPECT_EQ(calibration.add(first), PictureUse::kept);
  EXPECT_EQ(calibration.add(first), PictureUse::seen_already);
  Pose moved = board_place(1);
  moved.translation().x() += 1.5;  // two pixels
  EXPECT_EQ(calibration.add(picture_of_board(truth, moved)), PictureUse::moving);
  EXPECT_EQ(calibration.add(GreyImage(640, 480)), PictureUse::few_corners);
  EXPECT_THROW(calibration.add(GreyImage(320, 240)), InputError);
  EXPECT_THROW(calibration.solve(), InputError);
  EXPECT_NE(calibration.advice(), "");
}

TEST(CalibrationBoard, corners_are_found_where_the_lens_puts_them) {
  const CameraModel truth = true_camera();
  const CalibrationBoard board;
  const GreyImage picture = picture_of_board(truth, board_place(2));
  const std::vector<FoundCorner> corners = find_corners(picture, board, search_markers(picture));
  ASSERT_GT(corners.size(), 30U);
  double squares = 0.0;
  for (const FoundCorner& corner : corners)
    squares += (corner.at - truth.project(board_place(2) * board.corner(corner.index))).squaredNorm();
  EXPECT_LT(std::sqrt(squares / static_cast<double>(corners.size())), 0.12);
}

TEST(CalibrationBoard, fits_on_a_page) {
  EXPECT_THAT(calibration_board_pdf(CalibrationBoard{}), HasSubstr("%PDF"));
  CalibrationBoard large;
  large.square = 40.0;
  EXPECT_THROW(calibration_board_pdf(large), InputError);
}

// At 30 images a second: a reason is reported once it has lasted half a second, then every three seconds.
TEST(CalibrationTexts, say_why_a_picture_is_not_kept_but_not_thirty_times_a_second) {
  CalibrationTexts words;
  std::vector<std::string> said;
  int n = 0;
  const auto show = [&](PictureUse use, double seconds) {
    said.clear();
    for (const int end = n + static_cast<int>(30.0 * seconds); n < end; ++n) {
      if (std::string sentence = words.of(use, n / 30.0); !sentence.empty()) said.push_back(std::move(sentence));
    }
  };
  show(PictureUse::kept, 1.0);
  EXPECT_TRUE(said.empty());
  show(PictureUse::moving, 0.4);
  EXPECT_TRUE(said.empty()) << "while the board is brought to another place";
  show(PictureUse::kept, 0.2);
  show(PictureUse::moving, 4.0);
  ASSERT_EQ(said.size(), 2U);
  EXPECT_EQ(said[0], "not kept: moving; hold the board still");
  EXPECT_EQ(said[1], said[0]);
  show(PictureUse::few_corners, 1.0);
  ASSERT_EQ(said.size(), 1U);
  EXPECT_THAT(said[0], testing::HasSubstr("not kept: too few corners; bring more of the board into the picture"));
  show(PictureUse::seen_already, 1.0);
  ASSERT_EQ(said.size(), 1U);
  EXPECT_THAT(said[0], testing::HasSubstr("not kept: seen already; hold the board elsewhere"));
}

}  // namespace
}  // namespace bodkin::tracking
