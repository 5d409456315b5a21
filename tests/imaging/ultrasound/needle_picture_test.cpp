// A needle in the picture: its brightness, place, and effect on deeper tissue.
#include "tests/imaging/ultrasound/hand_made_patient.h"
#include <gtest/gtest.h>

#include "imaging/ultrasound/needle_echo.h"
#include "imaging/ultrasound/ultrasound_beam.h"

namespace bodkin {

using namespace bodkin::imaging;
namespace {

constexpr double shaft_range = 80.0;  // dB

// A thick rod, whose inner echoes come one by one.
NeedleInUltrasound rod(const Vec3& tip, const Vec3& axis) {
  NeedleInUltrasound needle;
  needle.pose = needle_pose(tip, axis);
  needle.needle.outer_diameter = 5.0;
  return needle;
}

// A needle at an angle (degrees) to the beam that crosses the middle line 20 mm deep, its tip 10 mm further on.
NeedleInUltrasound crossing(double angle, double off_slice = 0.0) {
  const Vec3 axis(std::sin(angle * degree), std::cos(angle * degree), 0.0);
  return rod(Vec3(0.0, 20.0, off_slice) + 10.0 * axis, axis);
}

std::shared_ptr<AcousticVolume> plain_patient() {
  return checks::hand_made({.half_width = 22.0, .half_thickness = 4.0, .voxel = 0.25},
                           {checks::clear_medium(), checks::clear_medium(1.8)},
                           [](const Vec3& p) { return p.y() < 40.0 ? 1 : 2; });
}

UltrasoundSettings needle_settings() {
  UltrasoundSettings settings;
  settings.depth = 50.0;
  settings.dynamic_range = shaft_range;
  settings.gain = -14.0;
  return settings;
}

// Amplitude of the echo at a depth of the middle line, without gain.
double echo_at(const UltrasoundFrame& frame, double depth) {
  const int row = static_cast<int>(std::lround(depth / frame.pixel));
  double sum = 0.0;
  for (int r = row - 1; r <= row + 1; ++r) {
    if (checks::decibels(frame, shaft_range, frame.width / 2, r) > -shaft_range)
      sum += checks::amplitude(frame, shaft_range, frame.width / 2, r);
  }
  return sum * std::pow(10.0, (14.0 - checks::compensation(5.0, depth)) / 20.0);
}

TEST(NeedlePicture, is_bright_across_the_beam_and_dark_along_it) {
  Ultrasound machine(plain_patient(), checks::flat_probe(), needle_settings(), checks::plain_detail(50.0));
  double last = 2.0;
  for (const double angle : {90.0, 80.0, 70.0, 60.0, 45.0}) {
    const double sine = std::sin(angle * degree);
    const double echo = echo_at(machine.image(Pose::Identity(), crossing(angle)), 20.0);
    // A mirror's lobe about the right angle, and 12 % in all directions.
    EXPECT_NEAR(echo, 0.93 * (0.88 * std::pow(sine, 24.0) + 0.12), 0.03 * echo + 0.002) << angle << " degrees";
    EXPECT_NEAR(shaft_echo(sine * sine), 0.88 * std::pow(sine, 24.0) + 0.12, 1e-12);
    EXPECT_LT(echo, last);
    last = echo;
  }
  const UltrasoundFrame& along = machine.image(Pose::Identity(), crossing(0.0));
  for (double depth = 5.0; depth < 28.0; depth += 0.25) ASSERT_LT(echo_at(along, depth), 1e-3) << "along the beam";
}

TEST(NeedlePicture, fades_with_its_distance_from_the_slice) {
  Ultrasound machine(plain_patient(), checks::flat_probe(), needle_settings(), checks::plain_detail(50.0));
  const double width = ultrasound_beam(checks::flat_probe(), needle_settings()).elevation(20.0);
  const double middle = echo_at(machine.image(Pose::Identity(), crossing(90.0)), 20.0);
  for (const double off : {-0.8, -0.5, 0.25, 0.5, 1.0}) {
    const double echo = echo_at(machine.image(Pose::Identity(), crossing(90.0, off * width)), 20.0);
    EXPECT_NEAR(echo / middle, std::exp(-4.0 * std::log(2.0) * off * off), 0.02) << off << " widths";
  }
}

TEST(NeedlePicture, leaves_a_tail_and_a_shadow) {
  Ultrasound machine(plain_patient(), checks::flat_probe(), needle_settings(), checks::plain_detail(50.0));
  const double surface = echo_at(machine.image(Pose::Identity()), 40.0);
  EXPECT_NEAR(surface, 0.2 / 3.4, 0.001);
  const UltrasoundFrame& frame = machine.image(Pose::Identity(), crossing(90.0));
  const double first = echo_at(frame, 20.0);
  // Inner echoes: 5 mm of steel there and back seem 5 x 1540 / 5790 mm of tissue.
  double tail = 0.35 * first;
  for (int ring = 1; ring <= 8; ++ring, tail *= 0.75)
    EXPECT_NEAR(echo_at(frame, 20.0 + ring * 5.0 * 0.266), tail, 0.05 * tail + 0.001) << "ring " << ring;
  EXPECT_LT(echo_at(frame, 19.0), 1e-3) << "nothing before it";
  // Its shadow: the surface behind loses 45 %, a line that it does not cross nothing.
  EXPECT_NEAR(echo_at(frame, 40.0), 0.55 * surface, 0.02 * surface);
  const auto column = [&frame](int c) { return checks::decibels(frame, shaft_range, c, 160); };
  EXPECT_NEAR(column(20) - column(155), checks::in_decibels(0.55), 0.7);
}

TEST(NeedlePicture, ends_at_its_tip_and_its_tip_flashes) {
  UltrasoundDetail detail = checks::plain_detail(50.0);
  detail.speckle = true;  // and with it the beam's width, over which a point is spread
  UltrasoundSettings settings = needle_settings();
  settings.gain = -20.0;
  Ultrasound machine(plain_patient(), checks::flat_probe(), settings, detail);
  NeedleInUltrasound needle;
  const Vec3 axis = Vec3(1.0, 1.0, 0.0).normalized();
  needle.pose = needle_pose(Vec3(0.0, 20.0, 0.0), axis);
  const UltrasoundFrame frame = machine.image(Pose::Identity(), needle);
  const auto brightest = [&frame](int column) {
    double level = -shaft_range;
    for (int row = 20; row < 140; ++row) level = std::max(level, checks::decibels(frame, shaft_range, column, row));
    return level;
  };
  EXPECT_GT(brightest(80), brightest(60) + 6.0) << "the tip beside the shaft 5 mm behind it";
  EXPECT_GT(brightest(60), brightest(100) + 20.0) << "the shaft beside what is ahead of the tip";
  // Off the slice the tip is invisible too.
  needle.pose = needle_pose(Vec3(0.0, 20.0, 12.0), axis);
  const UltrasoundFrame& gone = machine.image(Pose::Identity(), needle);
  EXPECT_EQ(gone.pixels, UltrasoundFrame(machine.image(Pose::Identity())).pixels);
}

TEST(NeedlePicture, moves_with_the_probe) {
  Ultrasound machine(plain_patient(), checks::curved_probe(), needle_settings(), paper_detail());
  const Pose here = checks::moved_to(Vec3(0.0, 0.0, 0.5)), there = checks::moved_to(Vec3(-6.0, 0.0, -1.0));
  NeedleInUltrasound needle = crossing(75.0, 0.3);
  const Pose in_probe = needle.pose;
  needle.pose = here * in_probe;
  const UltrasoundFrame one = machine.image(here, needle);
  needle.pose = there * in_probe;
  const UltrasoundFrame& other = machine.image(there, needle);
  int brightest = 0, differ = 0;
  for (int row = 60; row < 130; ++row) {  // of 300, 22 to 47 mm: between skin and surface
    for (int column = 120; column < 180; ++column) {
      const auto at = static_cast<std::size_t>(row * one.width + column);
      brightest = std::max(brightest, int{one.pixels[at]});
      differ = std::max(differ, std::abs(one.pixels[at] - other.pixels[at]));
    }
  }
  EXPECT_GT(brightest, 150);
  EXPECT_LE(differ, 2);
}

}  // namespace
}  // namespace bodkin
