// What stands over a camera's picture, of a patient whose parts are where the test has put them.
#include "tracking/augmented_view.h"

#include <cmath>

#include "tracking/footage_scene.h"
#include <gtest/gtest.h>

#include "io/tissue_library_file.h"

namespace bodkin::tracking {
namespace {

// A block of muscle with a bright bar along y at x = -20, z = 10 (LPS mm).
anatomy::Case block() {
  anatomy::Case made;
  made.library = io::default_tissue_library();
  anatomy::Grid grid;
  grid.size = {100, 100, 100};
  grid.origin = Vec3::Constant(-49.5);
  made.ct = anatomy::CtVolume(grid, 0);
  made.tissues = anatomy::TissueVolume(grid, anatomy::tissue::muscle);
  for (int k = 0; k < 100; ++k) {
    for (int j = 0; j < 100; ++j) {
      for (int i = 0; i < 100; ++i) {
        const Vec3 at = grid.to_patient(Vec3(i, j, k));
        if (std::hypot(at.x() + 20.0, at.z() - 10.0) < 4.0) made.ct.at(i, j, k) = 1500;
      }
    }
  }
  return made;
}

imaging::MovedTissue moved_by(const Vec3& all) {
  const imaging::PointLattice lattice =
      imaging::lattice_around({Vec3::Constant(-60.0), Vec3::Constant(60.0)}, 30.0, 1000);
  std::vector<float> displacements;
  for (std::size_t point = 0; point < lattice.points().size(); ++point)
    for (Eigen::Index axis = 0; axis < 3; ++axis) displacements.push_back(static_cast<float>(all[axis]));
  return {lattice, displacements};
}

class AugmentedViewTest : public testing::Test {
 protected:
  AugmentedViewTest() : bodies_(station_bodies()) {
    for (const MarkerBody& body : bodies_) {
      if (body.name == "needle") needle_ = body;
    }
    mannequin_pose_.status = needle_pose_.status = TrackingStatus::ok;
    mannequin_pose_.camera_from_body.translation() = Vec3(0.0, 0.0, 500.0);
    // The mannequin's axes are the patient's, and the needle's tip is in his middle.
    needle_pose_.camera_from_body.translation() = Vec3(0.0, 0.0, 500.0) - needle_.tip;
  }
  imaging::ImageRgb draw(const imaging::MovedTissue* moved) {
    imaging::ImageRgb picture(camera_.width, camera_.height);
    view_.draw(picture, &mannequin_pose_, {{&needle_, &needle_pose_}}, moved);
    return picture;
  }
  // Middle of what is bright in the view from the front, mm from its left upper corner.
  Eigen::Vector2d bar_in(const imaging::ImageRgb& picture) const {
    const int side = static_cast<int>(0.3 * camera_.height);
    const int left = camera_.width - side - 12, top = camera_.height - side - 12;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double count = 0.0;
    for (int y = top + 24; y < top + side - 3; ++y) {  // below its title
      for (int x = left + 3; x < left + side - 3; ++x) {
        const auto& pixel = picture.at(x, y);
        if (pixel.red < 180 || pixel.green < 180 || pixel.blue < 180) continue;
        sum += Eigen::Vector2d(x - left, y - top);
        count += 1.0;
      }
    }
    EXPECT_GT(count, 8.0);
    return 140.0 / side * sum / count;
  }

  CameraModel camera_ = footage_camera(1280, 720);
  std::vector<MarkerBody> bodies_;
  MarkerBody needle_;
  TrackedPose mannequin_pose_, needle_pose_;
  anatomy::Case patient_ = block();
  AugmentedView view_{patient_, camera_, Similarity(), {.status = false}};
};

// Seen from the front the patient's left (x) is on the right and his head (z) above.
TEST_F(AugmentedViewTest, the_view_from_the_front_shows_where_the_tissue_is_now) {
  const Eigen::Vector2d at_rest = bar_in(draw(nullptr));
  EXPECT_NEAR(at_rest.x(), 70.0 - 20.0, 2.0);
  EXPECT_NEAR(at_rest.y(), 70.0 - 10.0, 2.0);
  const imaging::MovedTissue moved = moved_by(Vec3(-12.0, 0.0, 8.0));
  const Eigen::Vector2d now = bar_in(draw(&moved));
  EXPECT_NEAR(now.x() - at_rest.x(), -12.0, 1.0);
  EXPECT_NEAR(now.y() - at_rest.y(), -8.0, 1.0);
}

TEST_F(AugmentedViewTest, the_needle_is_in_the_tissue_that_has_moved_to_its_tip) {
  for (int k = 0; k < 100; ++k)
    for (int j = 0; j < 100; ++j)
      for (int i = 65; i < 100; ++i) patient_.tissues.at(i, j, k) = anatomy::tissue::cortical_bone;  // from x = 15 mm
  draw(nullptr);
  ASSERT_TRUE(view_.needle().has_value());
  EXPECT_LT(view_.needle()->tip.norm(), 1e-6);
  EXPECT_FALSE(view_.needle()->bone);
  const imaging::MovedTissue moved = moved_by(Vec3(-25.0, 0.0, 0.0));
  draw(&moved);
  EXPECT_TRUE(view_.needle()->bone) << view_.needle()->tissue;
}

}  // namespace
}  // namespace bodkin::tracking
