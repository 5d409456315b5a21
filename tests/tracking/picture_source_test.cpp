// Folders, videos, and paths that are neither.
#include "tracking/picture_source.h"

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tracking/footage.h"
#include "tracking/lens_watch.h"
#include "tracking/marker_body.h"
#include "tracking/tracker.h"
#include "tracking/video_file.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/files.h"
#include "core/random.h"

namespace bodkin::tracking {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class PictureSources : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("bodkin_sources_" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  static imaging::ImageRgb plain(int level) {
    imaging::ImageRgb picture(64, 48);
    for (imaging::Rgb& pixel : picture.pixels) {
      const auto value = static_cast<std::uint8_t>(level);
      pixel = {value, value, value};
    }
    return picture;
  }

  fs::path folder_;
};

TEST_F(PictureSources, a_video_comes_back_picture_by_picture_with_its_times) {
  const fs::path file = folder_ / "grey.avi";
  VideoWriter writer(file, 64, 48, 20.0);
  for (int n = 0; n < 5; ++n) writer.add(plain(40 * n + 20));
  writer.finish();
  const auto source = open_source(file.string());
  EXPECT_EQ(source->count(), 5);
  EXPECT_FALSE(source->live());
  EXPECT_NEAR(source->rate(), 20.0, 0.01);
  EXPECT_TRUE(source->notes().empty());
  for (int n = 0; n < 5; ++n) {
    const auto picture = source->next();
    ASSERT_TRUE(picture) << n;
    EXPECT_NEAR(picture->time, 0.05 * n, 1e-6);
    EXPECT_NEAR(picture->grey.at(30, 20), 40 * n + 20, 3) << n;
    EXPECT_EQ(picture->grey.width, 64);
  }
  EXPECT_FALSE(source->next());
}

TEST_F(PictureSources, a_video_whose_rate_varies_keeps_its_times_and_says_so) {
  const fs::path even = folder_ / "even.avi", uneven = folder_ / "uneven.mkv";
  VideoWriter writer(even, 64, 48, 25.0);
  for (int n = 0; n < 8; ++n) writer.add(plain(20 * n + 20));
  writer.finish();
  // From the fifth image on, at a third of the rate.
  const std::string command = "ffmpeg -v error -y -i '" + even.string() +
                              "' -vf \"setpts='if(lt(N,4),N,4+3*(N-4))*0.04/TB'\" -vsync passthrough -c:v mjpeg '" +
                              uneven.string() + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);  // NOLINT: a fixed command
  const auto source = open_source(uneven.string());
  ASSERT_EQ(source->notes().size(), 1U);
  EXPECT_THAT(source->notes().front(), HasSubstr("varies from 40 to 120 ms"));
  double last = 0.0;
  int count = 0;
  while (const auto picture = source->next()) {
    last = picture->time;
    ++count;
  }
  EXPECT_EQ(count, 8);
  EXPECT_NEAR(last, 0.04 * (4 + 9), 0.002);
}

TEST_F(PictureSources, what_is_no_source_is_refused) {
  EXPECT_THROW(open_source((folder_ / "nothing").string()), InputError);
  write_file(folder_ / "text.mp4", "no video");
  try {
    open_source((folder_ / "text.mp4").string());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("not a video"));
  }
  try {
    open_source("/dev/no_such_camera");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("no such camera"));
  }
  EXPECT_THROW(open_source(folder_.string()), InputError);  // without images
}

TrackedPose resting(TrackingStatus status, double x) {
  TrackedPose pose;
  pose.status = status;
  pose.camera_from_body.translation() = Vec3(x, 0.0, 500.0);
  return pose;
}

TEST(LensWatch, speaks_when_no_resting_body_fits_and_is_silent_else) {
  LensWatch moved, bent, moving;
  for (int n = 0; n < 40; ++n) {
    moved.add({resting(TrackingStatus::uncertain, 0.0), resting(TrackingStatus::uncertain, 90.0)});
    bent.add({resting(TrackingStatus::ok, 0.0), resting(TrackingStatus::uncertain, 90.0)});
    moving.add({resting(TrackingStatus::uncertain, 10.0 * n), resting(TrackingStatus::lost, 0.0)});
    if (n < 20) {
      EXPECT_EQ(moved.warning(), "") << n;
    }
  }
  EXPECT_THAT(moved.warning(), HasSubstr("calibrate it again"));
  EXPECT_EQ(bent.warning(), "");
  EXPECT_EQ(moving.warning(), "");
}

// With a focal length wrong by some per cent, a cube fits and a board does not.
TEST(LensWatch, names_a_board_that_does_not_fit_while_cubes_do) {
  CameraModel camera;
  camera.width = 640;
  camera.height = 480;
  camera.fx = camera.fy = 520.0;
  camera.cx = 319.5;
  camera.cy = 239.5;
  const std::vector<MarkerBody> bodies = station_bodies();
  std::vector<PlacedBody> placed;
  for (const MarkerBody& body : bodies) {
    PlacedBody one;
    one.body = &body;
    if (body.name == "mannequin") {
      one.camera_from_body.linear() = Eigen::AngleAxisd(0.5, Vec3::UnitX()).toRotationMatrix();
      one.camera_from_body.translation() = Vec3(-60.0, 30.0, 620.0);
    } else {
      one.camera_from_body.linear() =
          (Eigen::AngleAxisd(0.4, Vec3::UnitX()) * Eigen::AngleAxisd(0.5, Vec3::UnitY())).toRotationMatrix();
      one.camera_from_body.translation() = Vec3(body.name == "needle" ? 110.0 : 200.0, -60.0, 560.0);
    }
    placed.push_back(one);
  }
  const GreyImage picture = render_picture(camera, {}, placed, 5);
  for (const double share : {1.0, 0.9, 0.99, 1.01, 1.1}) {
    CameraModel other = camera;
    other.fx *= share;
    other.fy *= share;
    Tracker tracker(other, bodies);
    LensWatch watch;
    for (int n = 0; n < 32; ++n) watch.add(tracker.track(picture, n / 30.0));
    if (share != 1.0) {
      EXPECT_THAT(watch.warning(), HasSubstr("a board of markers does not fit")) << share;
    } else {
      EXPECT_EQ(watch.warning(), "");
    }
  }
}

// An error of 1 % is noticed, and the correct lens causes no warning; also when the board was moved meanwhile, as
// long as it is tilted in at least half of the images. The deviations are those estimated from the images of the
// test above.
TEST(LensWatch, notices_a_focal_length_that_is_another_by_a_percent) {
  const auto warning_of = [](double share, double deviation, int frontal) {
    Random random(3);
    LensWatch watch;
    for (int n = 0; n < 60; ++n) {
      TrackedPose board = resting(TrackingStatus::ok, n < 20 ? 0.0 : 40.0);
      board.markers = 9;
      // A board seen from the front gives no information.
      const double known = n % 10 < frontal ? 0.09 : deviation;
      board.misfit.focal = {n % 10 < frontal ? 0.0 : share + deviation * random.normal(), known};
      watch.add({board, resting(TrackingStatus::ok, 90.0)});
    }
    return watch.warning();
  };
  for (const double deviation : {0.001, 0.004}) {
    EXPECT_EQ(warning_of(0.0, deviation, 0), "") << deviation;
    EXPECT_EQ(warning_of(0.003, deviation, 0), "") << "less than calibrating tells";
    for (const double share : {0.01, -0.01}) {
      EXPECT_THAT(warning_of(share, deviation, 0), HasSubstr("does not fit")) << deviation;
      EXPECT_THAT(warning_of(share, deviation, 5), HasSubstr("does not fit")) << deviation;
    }
  }
  EXPECT_EQ(warning_of(0.01, 0.05, 0), "") << "it cannot be told";
}

}  // namespace
}  // namespace bodkin::tracking
