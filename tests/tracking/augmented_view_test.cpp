// The overlay on a camera image, for a patient whose parts the test has placed.
#include "tracking/augmented_view.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tracking/footage_scene.h"
#include <gtest/gtest.h>

#include "imaging/canvas.h"
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

imaging::TissueDisplacement moved_by(const std::function<Vec3(const Vec3&)>& law) {
  const imaging::PointLattice lattice =
      imaging::lattice_around({Vec3::Constant(-60.0), Vec3::Constant(60.0)}, 30.0, 1000);
  std::vector<float> displacements;
  for (const Vec3& point : lattice.points())
    for (const double part : law(point)) displacements.push_back(static_cast<float>(part));
  return {lattice, displacements};
}
imaging::TissueDisplacement moved_by(const Vec3& all) {
  return moved_by([&](const Vec3& /*rest*/) { return all; });
}

class AugmentedViewTest : public testing::Test {
 protected:
  AugmentedViewTest() : bodies_(station_bodies()) {
    for (const MarkerBody& body : bodies_) {
      if (body.name == "needle") needle_ = body;
    }
    mannequin_pose_.status = needle_pose_.status = TrackingStatus::ok;
    mannequin_pose_.camera_from_body.translation() = Vec3(0.0, 0.0, 500.0);
    // The mannequin's axes are the patient's, and the needle's tip is at the patient's centre.
    needle_pose_.camera_from_body.translation() = Vec3(0.0, 0.0, 500.0) - needle_.tip;
  }
  imaging::ImageRgb draw(const imaging::TissueDisplacement* moved) {
    imaging::ImageRgb picture(camera_.width, camera_.height);
    view_.draw(picture, &mannequin_pose_, {{&needle_, &needle_pose_}}, moved);
    return picture;
  }
  // Centre of the bright pixels in the front view, mm from its upper left corner.
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

// In the front view the patient's left (x) is on the right and the head (z) at the top.
TEST_F(AugmentedViewTest, the_view_from_the_front_shows_where_the_tissue_is_now) {
  const Eigen::Vector2d at_rest = bar_in(draw(nullptr));
  EXPECT_NEAR(at_rest.x(), 70.0 - 20.0, 2.0);
  EXPECT_NEAR(at_rest.y(), 70.0 - 10.0, 2.0);
  const imaging::TissueDisplacement moved = moved_by(Vec3(-12.0, 0.0, 8.0));
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
  const imaging::TissueDisplacement moved = moved_by(Vec3(-25.0, 0.0, 0.0));
  draw(&moved);
  EXPECT_TRUE(view_.needle()->bone) << view_.needle()->tissue;
}

// A needle lies across the image, from the left through air, fat and muscle into bone: each part of its shaft has
// the colour of the tissue around it, and a tip on bone has a red ring.
TEST_F(AugmentedViewTest, the_needle_has_the_colours_of_the_tissues_that_it_lies_in) {
  for (int k = 0; k < 100; ++k) {
    for (int j = 0; j < 100; ++j) {
      for (int i = 0; i < 100; ++i) {
        const double x = patient_.tissues.grid.to_patient(Vec3(i, j, k)).x();
        patient_.tissues.at(i, j, k) = x < -25.0  ? anatomy::tissue::fat
                                       : x < 10.0 ? anatomy::tissue::muscle
                                                  : anatomy::tissue::cortical_bone;
      }
    }
  }
  MarkerBody across;
  across.name = "needle";
  across.axis = Vec3::UnitX();
  across.tip = 120.0 * across.axis;
  AugmentedLook look;
  look.front_view = look.status = look.plan = false;
  AugmentedView view(patient_, camera_, Similarity(), look);
  struct Drawn {
    imaging::ImageRgb picture;
    Eigen::Vector2d tip;
  };
  const auto draw_to = [&](double x) {
    TrackedPose pose = mannequin_pose_;
    pose.camera_from_body.translation() = Vec3(x, 0.0, 500.0) - across.tip;
    Drawn drawn{{camera_.width, camera_.height}, camera_.project(Vec3(x, 0.0, 500.0))};
    view.draw(drawn.picture, &mannequin_pose_, {{&across, &pose}}, nullptr);
    return drawn;
  };
  const auto differs = [](const imaging::ImageRgb& picture, const Eigen::Vector2d& at, std::uint32_t colour) {
    const auto& pixel = picture.at(static_cast<int>(at.x()), static_cast<int>(at.y()));
    return std::abs(pixel.red - static_cast<int>(colour >> 16)) +
           std::abs(pixel.green - static_cast<int>((colour >> 8) & 255)) +
           std::abs(pixel.blue - static_cast<int>(colour & 255));
  };
  const auto colour_of_tissue = [&](anatomy::TissueId id) { return patient_.library.find(id)->colour; };
  const Drawn on_bone = draw_to(25.0);
  const auto shaft = [&](double x) { return camera_.project(Vec3(x, 0.0, 500.0)); };
  for (const double x : {-47.0, -40.0, -30.0, -27.0})
    EXPECT_LT(differs(on_bone.picture, shaft(x), colour_of_tissue(anatomy::tissue::fat)), 12) << x;
  for (const double x : {-23.0, -10.0, 0.0, 8.0})
    EXPECT_LT(differs(on_bone.picture, shaft(x), colour_of_tissue(anatomy::tissue::muscle)), 12) << x;
  for (const double x : {12.0, 18.0})
    EXPECT_LT(differs(on_bone.picture, shaft(x), colour_of_tissue(anatomy::tissue::cortical_bone)), 12) << x;
  EXPECT_GT(differs(on_bone.picture, shaft(-55.0), colour_of_tissue(anatomy::tissue::fat)), 100) << "air: steel";
  ASSERT_TRUE(view.needle().has_value());
  EXPECT_TRUE(view.needle()->bone);
  EXPECT_EQ(view.needle()->tissue, patient_.library.title(anatomy::tissue::cortical_bone));
  EXPECT_NEAR(view.needle()->depth, 25.0 + 50.0, 1.5) << "mm of the shaft inside the block";
  // The ring is red on bone, white elsewhere.
  constexpr double ring = 6.0;  // pixels
  const auto redness = [](const Drawn& drawn) {
    const auto& pixel = drawn.picture.at(static_cast<int>(drawn.tip.x()), static_cast<int>(drawn.tip.y() - ring));
    return static_cast<int>(pixel.red) - static_cast<int>(pixel.green);
  };
  EXPECT_GT(redness(on_bone), 100);
  const Drawn in_muscle = draw_to(0.0);
  EXPECT_FALSE(view.needle()->bone);
  EXPECT_NEAR(view.needle()->depth, 50.0, 1.5);
  EXPECT_LT(std::abs(redness(in_muscle)), 60);
  EXPECT_LT(differs(in_muscle.picture, shaft(-10.0), colour_of_tissue(anatomy::tissue::muscle)), 12);
}

// The body of muscle ends at x = 30 mm, in air. Its side is pressed in by 8 mm; tissue farther away moves less.
TEST_F(AugmentedViewTest, a_pressed_skin_is_seen_in_the_oval_where_it_is_now) {
  for (int k = 0; k < 100; ++k)
    for (int j = 0; j < 100; ++j)
      for (int i = 80; i < 100; ++i) patient_.ct.at(i, j, k) = -1000;
  AugmentedLook look;
  look.preset = imaging::TransferPreset::skin;
  look.needle = look.front_view = look.status = look.coarse_while_moving = false;
  AugmentedView view(patient_, camera_, Similarity(), look);
  const imaging::TissueDisplacement pressed = moved_by(
      [](const Vec3& rest) { return Vec3(-8.0 * std::clamp((rest.x() + 30.0) / 60.0, 0.0, 1.0), 0.0, 0.0); });
  // Position of the outline, px to the right of the optical axis, in the row through it.
  const auto outline = [&](const imaging::TissueDisplacement* moved) {
    imaging::ImageRgb picture(camera_.width, camera_.height);
    view.draw(picture, &mannequin_pose_, {}, moved);
    int right = 0;
    for (int x = 0; x < picture.width; ++x) {
      if (picture.at(x, static_cast<int>(camera_.cy)).red > 40) right = x;
    }
    return right - camera_.cx;
  };
  // The silhouette is the edge nearest to the camera, at z = 450 mm.
  const double at_rest = outline(nullptr), now = outline(&pressed);
  EXPECT_NEAR(at_rest, camera_.fx * 30.0 / 450.0, 2.0);
  EXPECT_NEAR(now, camera_.fx * 22.0 / 450.0, 2.0);
  EXPECT_EQ(outline(nullptr), at_rest);  // released
}

// A cube of 30 mm lies across the image, outside the patient: its shaft begins at its side, 15 mm from its centre.
TEST_F(AugmentedViewTest, the_shaft_begins_where_the_needle_s_own_hub_ends) {
  const MarkerBody small = cube_body("needle", 12, 30.0, 120.0);
  AugmentedLook look;
  look.front_view = look.status = look.plan = false;
  look.radii = {10.0, 10.0};
  AugmentedView view(patient_, camera_, Similarity(), look);
  TrackedPose pose = mannequin_pose_;
  pose.camera_from_body.linear() = Eigen::AngleAxisd(90.0 * degree, Vec3::UnitY()).toRotationMatrix();  // z to x
  pose.camera_from_body.translation() = Vec3(20.0, -120.0, 500.0);
  imaging::ImageRgb picture(camera_.width, camera_.height);
  view.draw(picture, &mannequin_pose_, {{&small, &pose}}, nullptr);
  const auto drawn = [&](double from_middle) {
    const Eigen::Vector2d at = camera_.project(Vec3(20.0 + from_middle, -120.0, 500.0));
    return picture.at(static_cast<int>(at.x() + 0.5), static_cast<int>(at.y() + 0.5)).green > 150;
  };
  for (const double from_middle : {18.0, 22.0, 27.0, 60.0, 100.0}) EXPECT_TRUE(drawn(from_middle)) << from_middle;
  for (const double from_middle : {0.0, 8.0, 13.0}) EXPECT_FALSE(drawn(from_middle)) << from_middle;
}

// A lost body is not drawn and its last pose is not used; its status is shown in words.
TEST_F(AugmentedViewTest, a_pose_that_is_lost_or_uncertain_draws_nothing_but_its_status) {
  imaging::ImageRgb camera_picture(camera_.width, camera_.height);
  for (int y = 0; y < camera_picture.height; ++y)
    for (int x = 0; x < camera_picture.width; ++x)
      camera_picture.at(x, y) = {static_cast<std::uint8_t>(x % 200), static_cast<std::uint8_t>(y % 180), 90};
  const std::vector<ShownBody> tools = {{&needle_, &needle_pose_}};
  AugmentedLook look;
  // The status of each pose as text, in its colour.
  const auto with_words = [&](const std::vector<std::pair<std::string, std::uint32_t>>& lines) {
    imaging::ImageRgb picture = camera_picture;
    imaging::Canvas canvas(picture.width, picture.height);
    double line = 24.0;
    for (const auto& [text, colour] : lines) {
      canvas.text({14.0, line}, text, {.size = 16.0, .ink = colour, .bold = true, .halo = true});
      line += 22.0;
    }
    canvas.draw_over(picture);
    return picture;
  };
  constexpr std::uint32_t red = 0xFF4B3E, yellow = 0xFFC84A;
  const auto drawn = [&](TrackingStatus mannequin, TrackingStatus needle, bool words) {
    mannequin_pose_.status = mannequin;
    needle_pose_.status = needle;
    look.status = words;
    AugmentedView view(patient_, camera_, Similarity(), look);
    imaging::ImageRgb picture = camera_picture;
    view.draw(picture, &mannequin_pose_, tools, nullptr);
    EXPECT_EQ(view.needle().has_value(), mannequin == TrackingStatus::ok && needle == TrackingStatus::ok);
    EXPECT_EQ(view.cutaway() != nullptr, mannequin == TrackingStatus::ok);
    return picture.pixels;
  };
  using enum TrackingStatus;
  for (const TrackingStatus needle : {ok, uncertain, lost}) {
    for (const TrackingStatus mannequin : {uncertain, lost})
      EXPECT_TRUE(drawn(mannequin, needle, false) == camera_picture.pixels) << "no patient, so no needle in him";
  }
  EXPECT_TRUE(drawn(lost, lost, true) == with_words({{"mannequin: lost", red}, {"needle: lost", red}}).pixels);
  EXPECT_TRUE(drawn(uncertain, lost, true) ==
              with_words({{"mannequin: uncertain", yellow}, {"needle: lost", red}}).pixels);
  EXPECT_TRUE(drawn(lost, uncertain, true) ==
              with_words({{"mannequin: lost", red}, {"needle: uncertain", yellow}}).pixels);
  // With a visible patient, a needle that is not ok gives the same image as no needle.
  const auto without_needle = [&] {
    mannequin_pose_.status = ok;
    look.status = false;
    AugmentedView view(patient_, camera_, Similarity(), look);
    imaging::ImageRgb picture = camera_picture;
    view.draw(picture, &mannequin_pose_, {}, nullptr);
    return picture.pixels;
  }();
  EXPECT_TRUE(drawn(ok, lost, false) == without_needle);
  EXPECT_TRUE(drawn(ok, uncertain, false) == without_needle);
  EXPECT_FALSE(drawn(ok, ok, false) == without_needle);
}

// A mannequin that is lost disappears from the image.
TEST_F(AugmentedViewTest, the_last_pose_is_never_drawn_for_one_that_is_lost) {
  draw(nullptr);
  EXPECT_NE(view_.cutaway(), nullptr);
  mannequin_pose_.status = TrackingStatus::lost;
  const imaging::ImageRgb empty(camera_.width, camera_.height);
  EXPECT_TRUE(draw(nullptr).pixels == empty.pixels);
  EXPECT_EQ(view_.cutaway(), nullptr);
  EXPECT_FALSE(view_.needle().has_value());
}

// Issue 19: an oval of four times the pixels is cast more coarsely and reports it: in the image if it shows text, by
// is_large() otherwise; also while the mannequin moves.
TEST_F(AugmentedViewTest, an_oval_of_four_times_the_pixels_is_cast_coarser_and_says_so) {
  AugmentedLook look;
  look.needle = look.front_view = look.plan = false;
  const auto warned = [&](AugmentedView& view) {
    imaging::ImageRgb picture(camera_.width, camera_.height);
    view.draw(picture, &mannequin_pose_, {}, nullptr);
    int yellow = 0;
    for (int y = 0; y < 120; ++y) {
      for (int x = 0; x < 420; ++x) {
        const auto& pixel = picture.at(x, y);
        yellow += pixel.red > 200 && pixel.green > 150 && pixel.blue < 120 ? 1 : 0;
      }
    }
    return yellow;
  };
  AugmentedView view(patient_, camera_, Similarity(), look);
  EXPECT_EQ(warned(view), 0);
  EXPECT_FALSE(view.is_large());
  EXPECT_EQ(view.cutaway()->step, 1);
  look.radii *= 2.0;
  view.set_look(look);
  EXPECT_GT(warned(view), 100);
  EXPECT_TRUE(view.is_large());
  EXPECT_EQ(view.cutaway()->step, 2);
  mannequin_pose_.camera_from_body.translation().x() += 5.0;
  EXPECT_GT(warned(view), 100) << "while it moves";
  look.status = false;
  view.set_look(look);
  EXPECT_EQ(warned(view), 0);
  EXPECT_TRUE(view.is_large());
}

// Rays are reused only for the same tissue; an invisibly small motion costs no rays.
TEST_F(AugmentedViewTest, rays_are_cast_anew_when_the_tissue_moves) {
  const imaging::TissueDisplacement one = moved_by(Vec3(-12.0, 0.0, 8.0)), same = moved_by(Vec3(-12.0, 0.0, 8.01)),
                                    other = moved_by(Vec3(-12.0, 0.0, 9.0));
  view_.set_look({.status = false, .coarse_while_moving = false});
  draw(&one);
  draw(&same);
  EXPECT_EQ(view_.cast_seconds(), 0.0);
  draw(&other);
  EXPECT_GT(view_.cast_seconds(), 0.0);
  draw(nullptr);
  EXPECT_GT(view_.cast_seconds(), 0.0);
  draw(nullptr);
  EXPECT_EQ(view_.cast_seconds(), 0.0);
}

}  // namespace
}  // namespace bodkin::tracking
