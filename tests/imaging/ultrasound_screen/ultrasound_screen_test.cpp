// The screen of an ultrasound machine: measurements, freezing, and the places of drawings.
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "imaging/markup.h"
#include "imaging/ultrasound_screen/scanner_image.h"
#include "imaging/ultrasound_screen/screen.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::imaging;
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::Not;

// 100 x 80 pixels of 0.5 mm, the face's middle above the middle of the top row, one white pixel at (10, 20).
ScanState a_moment() {
  ScanState moment;
  moment.frame.width = 100;
  moment.frame.height = 80;
  moment.frame.pixel = 0.5;
  moment.frame.corner = Vec3(-24.75, 0.25, 0.0);
  moment.frame.pixels.assign(8000, 0);
  moment.frame.pixels[20 * 100 + 10] = 255;
  moment.frame.contact = 0.9;
  moment.probe.name = "L1-1";
  moment.settings.depth = 40.0;
  moment.settings.focus = 20.0;
  return moment;
}

Eigen::Vector2d mm_of_pixel(double column, double row) {
  return Eigen::Vector2d(-24.75, 0.25) + 0.5 * Eigen::Vector2d(column, row);
}

TEST(UltrasoundScreen, a_caliper_over_a_known_distance_reads_it) {
  for (const OrientationMarkerSide side : {OrientationMarkerSide::left, OrientationMarkerSide::right}) {
    UltrasoundScreen screen(640, 480, side);
    screen.take(a_moment());
    // Clicked as a person does: pixels of the screen, 30 mm aside and 20 mm deeper.
    const Eigen::Vector2d from = screen.to_screen({-15.0, 5.0}), to = screen.to_screen({15.0, 25.0});
    screen.measure(screen.to_probe(from));
    EXPECT_TRUE(screen.measuring());
    EXPECT_TRUE(screen.calipers().empty());
    screen.measure(screen.to_probe(to));
    ASSERT_EQ(screen.calipers().size(), 1U);
    EXPECT_NEAR(screen.calipers()[0].length(), std::hypot(30.0, 20.0), 1e-9);
    EXPECT_THAT(screen.overlay().svg(), HasSubstr("36.1 mm"));
    screen.measure({0.0, 0.0});
    screen.measure({0.0, 10.0});
    ASSERT_EQ(screen.calipers().size(), 2U);
    EXPECT_NEAR(screen.calipers()[1].length(), 10.0, 1e-12);
    // The distance is one of pixels too: the screen is not stretched.
    const double scale = (screen.to_screen({0.0, 10.0}) - screen.to_screen({0.0, 0.0})).norm() / 10.0;
    EXPECT_NEAR((to - from).norm() / scale, std::hypot(30.0, 20.0), 1e-9);
  }
}

TEST(UltrasoundScreen, places_and_pixels_are_each_others_inverse_and_the_mark_says_which_side) {
  for (const OrientationMarkerSide side : {OrientationMarkerSide::left, OrientationMarkerSide::right}) {
    UltrasoundScreen screen(640, 480, side);
    screen.take(a_moment());
    for (const Eigen::Vector2d& place : {Eigen::Vector2d(-20, 3), Eigen::Vector2d(0, 0), Eigen::Vector2d(24, 39)}) {
      EXPECT_NEAR((screen.to_probe(screen.to_screen(place)) - place).norm(), 0.0, 1e-9);
      EXPECT_TRUE(screen.holds(screen.to_screen(place)) || place.y() == 0.0);
    }
    const double marked = screen.to_screen({20.0, 10.0}).x(), other = screen.to_screen({-20.0, 10.0}).x();
    EXPECT_EQ(marked < other, side == OrientationMarkerSide::left);
    EXPECT_FALSE(screen.holds({2.0, 2.0}));
  }
}

TEST(UltrasoundScreen, frozen_it_keeps_the_frame_while_the_probe_moves) {
  UltrasoundScreen screen(640, 480, OrientationMarkerSide::left);
  screen.take(a_moment());
  screen.freeze(true);
  screen.measure({0.0, 1.0});
  screen.measure({0.0, 2.0});
  screen.mark({3.0, 4.0}, "M1");
  const ImageRgb before = screen.compose();
  ScanState moved = a_moment();
  moved.pose.translation() = Vec3(10.0, 0.0, 0.0);
  moved.frame.pixels.assign(8000, 200);
  screen.take(moved);
  EXPECT_EQ(screen.moment().pose.translation(), Vec3::Zero());
  EXPECT_EQ(screen.compose().pixels, before.pixels);
  EXPECT_THAT(screen.overlay().svg(), HasSubstr("FROZEN"));
  screen.freeze(false);
  EXPECT_TRUE(screen.calipers().empty());
  EXPECT_TRUE(screen.markers().empty());
  screen.take(moved);
  EXPECT_EQ(screen.moment().pose.translation(), moved.pose.translation());
  EXPECT_NE(screen.compose().pixels, before.pixels);
}

TEST(UltrasoundScreen, speaks_as_its_translator_does) {
  UltrasoundScreen screen(640, 480, OrientationMarkerSide::left);
  screen.translate_by([](const std::string& words) {
    return words == "FROZEN" ? std::string("HALT") : words.starts_with("contact") ? std::string("Kontakt") : words;
  });
  screen.take(a_moment());
  screen.freeze(true);
  const std::string drawn = screen.overlay().svg();
  EXPECT_THAT(drawn, AllOf(HasSubstr("HALT"), HasSubstr("Kontakt"), HasSubstr("press ")));
  EXPECT_THAT(drawn, Not(AnyOf(HasSubstr("FROZEN"), HasSubstr("contact"))));
}

TEST(UltrasoundScreen, the_bright_pixel_is_where_its_place_says) {
  for (const OrientationMarkerSide side : {OrientationMarkerSide::left, OrientationMarkerSide::right}) {
    UltrasoundScreen screen(640, 480, side);
    screen.take(a_moment());
    const ImageRgb image = screen.compose();
    const Eigen::Vector2d at = screen.to_screen(mm_of_pixel(10, 20));
    const auto x = static_cast<int>(at.x()), y = static_cast<int>(at.y());
    EXPECT_GT(image.at(x, y).red, 200);
    EXPECT_EQ(image.at(x, y + 20).red, 0);
  }
}

TEST(UltrasoundScreen, an_empty_one_refuses_measurements_and_draws_nothing) {
  UltrasoundScreen screen(640, 480, OrientationMarkerSide::left);
  EXPECT_TRUE(screen.empty());
  EXPECT_THROW(screen.measure({1.0, 1.0}), InputError);
  EXPECT_THROW(screen.mark({1.0, 1.0}, "a"), InputError);
  EXPECT_EQ(screen.compose().pixels, ImageRgb(640, 480).pixels);
  screen.take(a_moment());
  EXPECT_THROW(screen.measure({std::numeric_limits<double>::quiet_NaN(), 1.0}), InputError);
}

TEST(UltrasoundScreen, a_black_picture_says_why_and_a_broken_pose_harms_nothing) {
  ScanState moment = a_moment();
  moment.frame.why = NoImage::broken_pose;
  moment.pose.translation().setConstant(std::numeric_limits<double>::quiet_NaN());
  moment.pose.linear().setConstant(std::numeric_limits<double>::quiet_NaN());
  UltrasoundScreen screen(640, 480, OrientationMarkerSide::left);
  screen.take(moment);
  EXPECT_THAT(screen.overlay().svg(), HasSubstr(escape_markup(reason(NoImage::broken_pose))));
  screen.compose();
  const Canvas drawn =
      draw_scanner_image({moment, OrientationMarkerSide::left, "", {}, {}, std::nullopt}, TissueLibrary());
  EXPECT_THAT(drawn.svg(), HasSubstr("pose"));
}

TEST(UltrasoundScreen, measurements_and_the_scale_are_drawn_where_their_places_are) {
  UltrasoundScreen screen(640, 480, OrientationMarkerSide::left);
  screen.take(a_moment());
  screen.measure({-15.0, 5.0});
  screen.mark({3.0, 30.0}, "M1");
  const ImageRgb image = screen.compose();
  EXPECT_EQ(image.at(0, 0), Rgb{});
  const Eigen::Vector2d end = screen.to_screen({-15.0, 5.0}), marker = screen.to_screen({3.0, 30.0});
  EXPECT_GT(image.at(static_cast<int>(end.x()), static_cast<int>(end.y())).red, 200);
  EXPECT_GT(image.at(static_cast<int>(marker.x()), static_cast<int>(marker.y())).blue, 200);
  // Right of the picture, a mark at every centimetre and none between.
  const double right = screen.to_screen({-25.0, 0.0}).x() + 10.0;
  const auto brightest = [&](double depth) {
    const auto y = static_cast<int>(screen.to_screen({0.0, depth}).y());
    return std::max(image.at(static_cast<int>(right), y - 1).green, image.at(static_cast<int>(right), y).green);
  };
  EXPECT_GT(brightest(10.0), 60);
  EXPECT_GT(brightest(30.0), 60);
  EXPECT_EQ(brightest(35.0), 0);
}

TEST(ScannerImage, says_what_a_machine_says) {
  ScannerImage picture;
  picture.moment = a_moment();
  picture.moment.settings.gain = -3.0;
  picture.moment.settings.sliders[2] = 6.0;
  picture.moment.needle = "22 G 40 mm";
  picture.patient = "Ada & Co";
  picture.calipers = {{{0.0, 0.0}, {0.0, 12.5}}};
  picture.markers = {{{1.0, 1.0}, "L3"}};
  const std::string drawn = draw_scanner_image(picture, TissueLibrary()).svg();
  for (const char* words : {"L1-1", "5.0 MHz", "D 4.0 cm", "G -3 dB", "DR 60 dB", "F 2.0 cm", "contact 90 %", "TGC",
                            "22 G 40 mm", "Ada &amp; Co", "12.5 mm", ">L3<", ">cm<"}) {
    EXPECT_THAT(drawn, HasSubstr(words));
  }
  // The frame is scaled to 600 px; its bright pixel and its dark neighbour are where they belong.
  const ImageRgb image = draw_scanner_image(picture, TissueLibrary()).pixels(1.0);
  const double scale = 600.0 / 80.0;
  const Eigen::Vector2d bright(124.0 + scale * (99 - 10 + 0.5), 58.0 + scale * (20 + 0.5));
  const auto x = static_cast<int>(bright.x()), y = static_cast<int>(bright.y());
  EXPECT_GT(image.at(x, y).red, 200);
  EXPECT_EQ(image.at(x + 15, y), Rgb{});
  picture.touch = false;
  EXPECT_THAT(draw_scanner_image(picture, TissueLibrary()).svg(), Not(HasSubstr("contact")));
}

TEST(ScanField, the_plane_of_a_frame_maps_its_pixels_as_the_frame_does) {
  const ScanState moment = a_moment();
  Pose pose = Pose::Identity();
  pose.rotate(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
  pose.translation() = Vec3(10, -20, 30);
  const SlicePlane right = plane_of(moment.frame, pose, OrientationMarkerSide::right);
  const SlicePlane left = plane_of(moment.frame, pose, OrientationMarkerSide::left);
  const Vec3 expected = moment.frame.image_to_patient(pose) * (0.5 * Vec3(10, 20, 0));
  EXPECT_NEAR((right.point(10, 20) - expected).norm(), 0.0, 1e-9);
  EXPECT_NEAR((left.point(89, 20) - expected).norm(), 0.0, 1e-9);
  EXPECT_EQ(grey_image(moment.frame, OrientationMarkerSide::left).at(89, 20).red, 255);
  EXPECT_EQ(grey_image(moment.frame, OrientationMarkerSide::right).at(10, 20).red, 255);
}

TEST(ScanField, the_border_of_the_field_is_as_wide_and_as_deep_as_the_probe) {
  UltrasoundProbe probe;
  probe.elements = 128;
  probe.pitch = 0.5;
  EXPECT_EQ(field_of_view(probe, 50.0).size(), 4U);
  probe.kind = ProbeKind::curvilinear;
  probe.radius = 60.0;
  for (const Eigen::Vector2d& corner : field_of_view(probe, 100.0)) {
    const double radius = (corner - Eigen::Vector2d(0.0, -60.0)).norm();
    EXPECT_TRUE(std::abs(radius - 60.0) < 1e-9 || std::abs(radius - 160.0) < 1e-9) << radius;
  }
  probe.kind = ProbeKind::phased;
  probe.sector = 90.0;
  double widest = 0.0;
  for (const Eigen::Vector2d& corner : field_of_view(probe, 100.0)) widest = std::max(widest, corner.x());
  EXPECT_NEAR(widest, 100.0 * std::sqrt(0.5), 1e-9);
}

}  // namespace
}  // namespace bodkin
