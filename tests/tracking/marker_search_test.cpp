// Markers found in parts of an image are those of the whole image.
#include "tracking/marker_search.h"

#include <algorithm>
#include <cmath>

#include "tracking/footage.h"
#include "tracking/tracker.h"
#include <gtest/gtest.h>

namespace bodkin::tracking {
namespace {

// Two bodies, each in a box as made by the tracker; another box reaches out of the image and contains nothing.
TEST(MarkerSearch, finds_in_boxes_the_same_corners_as_in_the_whole_picture) {
  const CameraModel camera = footage_camera(1280, 720);
  const std::vector<MarkerBody> bodies = {board_body("mannequin", 0, 4, 3, 46.0),
                                          cube_body("needle", 12, 60.0, 150.0)};
  std::vector<Pose> poses(2, Pose::Identity());
  poses[0].translation() = Vec3(90.0, 20.0, 650.0);
  poses[0].linear() = Eigen::AngleAxisd(0.5, Vec3(1.0, 0.3, 0.0).normalized()).toRotationMatrix();
  poses[1].translation() = Vec3(-150.0, -40.0, 550.0);
  poses[1].linear() = Eigen::AngleAxisd(0.7, Vec3(1.0, 1.0, 0.0).normalized()).toRotationMatrix();
  const GreyImage picture = render_picture(camera, {}, {{&bodies[0], poses[0]}, {&bodies[1], poses[1]}}, 11);
  const std::vector<FoundMarker> whole = search_markers(picture);
  ASSERT_GE(whole.size(), 12U + 2U);
  std::vector<PictureBox> boxes = {{-40, 600, 120, 400}};
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    const std::optional<PictureBox> box = search_box(bodies[body], poses[body], camera);
    ASSERT_TRUE(box);
    boxes.push_back(*box);
  }
  const std::vector<FoundMarker> in_boxes = search_markers(picture, boxes);
  ASSERT_EQ(in_boxes.size(), whole.size());
  for (const FoundMarker& marker : whole) {
    const auto same = std::find_if(in_boxes.begin(), in_boxes.end(),
                                   [&](const FoundMarker& other) { return other.id == marker.id; });
    ASSERT_NE(same, in_boxes.end()) << marker.id;
    for (std::size_t corner = 0; corner < 4; ++corner)
      EXPECT_LT((same->corners[corner] - marker.corners[corner]).norm(), 1e-3) << marker.id << ", " << corner;
  }
  // A marker in two boxes counts once; one in no box is not found.
  boxes.push_back(boxes[2]);
  EXPECT_EQ(search_markers(picture, boxes).size(), whole.size());
  const std::vector<FoundMarker> of_needle = search_markers(picture, {boxes[2]});
  EXPECT_TRUE(
      std::all_of(of_needle.begin(), of_needle.end(), [](const FoundMarker& found) { return found.id >= 12; }));
  EXPECT_EQ(of_needle.size(), whole.size() - 12);
  EXPECT_TRUE(search_markers(picture, {}).empty());
}

}  // namespace
}  // namespace bodkin::tracking
