// Why bodies are lost: the reports on markers of another dictionary, and on those that are on no body.
#include "tracking/marker_watch.h"

#include "tests/tracking/foreign_markers.h"
#include "tracking/footage.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bodkin::tracking {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// A board and a needle, and markers that belong to neither.
class MarkerWatchTest : public testing::Test {
 protected:
  MarkerWatchTest() {
    for (Pose* pose : {&board_pose_, &needle_pose_, &strange_pose_})
      pose->linear() = Eigen::AngleAxisd(0.5, Vec3(1.0, 0.6, 0.0).normalized()).toRotationMatrix();
    board_pose_.translation() = Vec3(-110.0, 60.0, 600.0);
    needle_pose_.translation() = Vec3(-90.0, -80.0, 500.0);
    strange_pose_.translation() = Vec3(120.0, 0.0, 600.0);
  }
  std::string warning_after(const GreyImage& picture, int pictures) {
    Tracker tracker(camera_, {board_, needle_});
    MarkerWatch watch("film.mkv");
    for (int n = 0; n < pictures; ++n) {
      tracker.track(picture, n / 30.0);
      watch.add(tracker, picture);
    }
    of_all_ = watch.warning_of_all();
    any_body_ = watch.any_body();
    return watch.warning();
  }

  CameraModel camera_ = footage_camera(640, 480);
  MarkerBody board_ = board_body("mannequin", 0, 2, 2, 52.0), needle_ = cube_body("needle", 12, 60.0, 150.0),
             strange_ = board_body("strange", 22, 4, 2, 40.0);
  Pose board_pose_ = Pose::Identity(), needle_pose_ = Pose::Identity(), strange_pose_ = Pose::Identity();
  std::string of_all_;
  bool any_body_ = false;
};

TEST_F(MarkerWatchTest, markers_of_another_dictionary_are_none_and_that_is_said) {
  EXPECT_EQ(search_markers(foreign_markers(4, camera_.width, camera_.height)).size(), 6U)
      << "so drawn, ours are found";
  for (const int cells : {5, 6, 7}) {
    const GreyImage picture = foreign_markers(cells, camera_.width, camera_.height);
    Tracker tracker(camera_, {board_, needle_});
    for (const TrackedPose& pose : tracker.track(picture, 0.0)) EXPECT_EQ(pose.status, TrackingStatus::lost) << cells;
    EXPECT_TRUE(tracker.markers().empty()) << cells;
    EXPECT_EQ(warning_after(picture, 2), "") << "two pictures are no time";
    EXPECT_THAT(of_all_, AllOf(HasSubstr("film.mkv"), HasSubstr("no marker of the dictionary 4x4_50"))) << cells;
    EXPECT_FALSE(any_body_);
    EXPECT_EQ(warning_after(picture, 30), of_all_) << cells;
  }
}

TEST_F(MarkerWatchTest, markers_that_are_on_no_body_are_named) {
  const GreyImage alone = render_picture(camera_, {}, {{&strange_, strange_pose_}}, 3);
  EXPECT_THAT(warning_after(alone, 30),
              HasSubstr("markers are seen that are on no body (22, 23, 24, 25, 26, 27, ...)"));
  EXPECT_EQ(warning_after(alone, 1), "");
  EXPECT_THAT(of_all_, HasSubstr("are on no body (22, 23"));
  EXPECT_FALSE(any_body_);
  // The mannequin is seen, but not the needle's markers.
  const GreyImage beside = render_picture(camera_, {}, {{&board_, board_pose_}, {&strange_, strange_pose_}}, 4);
  EXPECT_THAT(warning_after(beside, 30), HasSubstr("are on no body (22, 23"));
  EXPECT_THAT(of_all_, HasSubstr("are on no body (22, 23"));
  EXPECT_TRUE(any_body_);
}

TEST_F(MarkerWatchTest, nothing_is_said_of_others_where_every_body_is_seen_nor_of_a_needle_that_is_hidden) {
  const GreyImage all =
      render_picture(camera_, {}, {{&board_, board_pose_}, {&needle_, needle_pose_}, {&strange_, strange_pose_}}, 5);
  EXPECT_EQ(warning_after(all, 30), "");
  EXPECT_EQ(of_all_, "");
  const GreyImage hidden = render_picture(camera_, {}, {{&board_, board_pose_}}, 6);
  EXPECT_EQ(warning_after(hidden, 30), "");
  EXPECT_EQ(of_all_, "");
  EXPECT_TRUE(any_body_);
}

TEST_F(MarkerWatchTest, what_has_passed_is_not_said_any_more) {
  const GreyImage empty(camera_.width, camera_.height);
  const GreyImage both = render_picture(camera_, {}, {{&board_, board_pose_}, {&needle_, needle_pose_}}, 7);
  Tracker tracker(camera_, {board_, needle_});
  MarkerWatch watch("/dev/video0");
  const auto show = [&](const GreyImage& picture) {
    tracker.track(picture, 0.0);
    watch.add(tracker, picture);
  };
  for (int n = 0; n < 30; ++n) show(empty);
  EXPECT_THAT(watch.warning(), HasSubstr("no marker of the dictionary"));
  show(both);
  EXPECT_EQ(watch.warning(), "");
  EXPECT_EQ(watch.warning_of_all(), "");
}

}  // namespace
}  // namespace bodkin::tracking
