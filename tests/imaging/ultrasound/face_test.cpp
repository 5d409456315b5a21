// Effects at the face: contact, gel, press, and reverberation between it and a strong surface.
#include "tests/imaging/ultrasound/hand_made_patient.h"
#include <gtest/gtest.h>

#include "imaging/ultrasound/reverberation.h"

namespace bodkin {

using namespace bodkin::imaging;
namespace {

std::shared_ptr<AcousticVolume> surface_at_depth(double depth, double impedance, double voxel = 0.25) {
  return checks::hand_made({.half_width = 24.0, .half_thickness = 1.0, .voxel = voxel},
                           {checks::clear_medium(), checks::clear_medium(impedance)},
                           [depth](const Vec3& p) { return p.y() < depth ? 1 : 2; });
}

UltrasoundSettings face_settings(bool gel = true) {
  UltrasoundSettings settings;
  settings.depth = 50.0;
  settings.dynamic_range = 80.0;
  settings.gel = gel;
  return settings;
}

// Of the brightest pixel of a column between two depths.
struct Brightest {
  double depth = 0.0, level = -1e3;
};
Brightest brightest_of(const UltrasoundFrame& frame, int column, double from, double to) {
  Brightest found;
  for (int row = static_cast<int>(from / frame.pixel); row <= static_cast<int>(to / frame.pixel); ++row) {
    const double level = checks::decibels(frame, 80.0, column, row);
    if (level > found.level) found = {row * frame.pixel, level};
  }
  return found;
}

TEST(Face, gel_fills_a_gap_and_without_it_there_is_no_image) {
  const auto volume = surface_at_depth(10.0, 1.8);
  Ultrasound machine(volume, checks::flat_probe(), face_settings(), checks::plain_detail(50.0));
  const Pose apart = checks::moved_to(Vec3(0.0, -3.0, 0.0));
  const UltrasoundFrame& frame = machine.image(apart);
  EXPECT_EQ(frame.why, NoImage::none);
  EXPECT_EQ(frame.contact, 1.0);
  EXPECT_EQ(frame.press, 0.0);
  const Brightest surface = brightest_of(frame, 80, 1.0, 49.0);
  EXPECT_NEAR(surface.depth, 13.0, 0.26);
  EXPECT_NEAR(surface.level, checks::in_decibels(0.2 / 3.4) + checks::compensation(5.0, 13.0), 0.4);
  machine.set(face_settings(false));
  EXPECT_EQ(machine.image(apart).why, NoImage::no_contact);
  EXPECT_EQ(machine.image(Pose::Identity()).why, NoImage::none);
  machine.set(face_settings());
  EXPECT_EQ(machine.image(checks::moved_to(Vec3(0.0, -4.5, 0.0))).why, NoImage::none);
}

// For any place of the skin in a voxel, gel and tissue begin without an echo of the air beside them.
TEST(Face, the_skins_voxel_takes_nothing_from_the_sound) {
  for (const double voxel : {0.5, 1.0}) {
    const auto volume = surface_at_depth(20.0, 1.8, voxel);
    Ultrasound machine(volume, checks::flat_probe(), face_settings(), checks::plain_detail(50.0));
    for (double y = -4.0; y < 0.3; y += 0.13) {
      const UltrasoundFrame& frame = machine.image(checks::moved_to(Vec3(0.0, y, 0.0)));
      ASSERT_EQ(frame.why, NoImage::none);
      EXPECT_LE(brightest_of(frame, 80, 0.0, 15.0).level, -55.0) << "skin at " << -y << " mm";
      // In all: the echo of a ramp is shared by some samples.
      double sum = 0.0;
      const int row = static_cast<int>((20.0 - y) / 0.25);
      for (int r = row - 6; r <= row + 6; ++r)
        if (checks::decibels(frame, 80.0, 80, r) > -79.0)
          sum += checks::amplitude(frame, 80.0, 80, r) * std::pow(10.0, -checks::compensation(5.0, r * 0.25) / 20.0);
      EXPECT_NEAR(sum, 0.2 / 3.4, 0.06 * 0.2 / 3.4) << "skin at " << -y << " mm";
    }
  }
}

TEST(Face, half_of_it_off_the_skin_shows_half_a_picture) {
  const auto volume = checks::hand_made({.half_width = 24.0, .half_thickness = 1.0, .voxel = 0.25},
                                        {checks::clear_medium(), checks::clear_medium(1.8)}, [](const Vec3& p) {
                                          return p.x() > 0.1 ? 0 : p.y() < 10.0 ? 1 : 2;
                                        });
  Ultrasound machine(volume, checks::flat_probe(), face_settings(), checks::plain_detail(50.0));
  const UltrasoundFrame& frame = machine.image(Pose::Identity());
  EXPECT_EQ(frame.why, NoImage::none);
  EXPECT_NEAR(frame.contact, 0.5, 1.5 / 161.0);
  EXPECT_GT(brightest_of(frame, 40, 5.0, 20.0).level, -30.0);
  EXPECT_LE(brightest_of(frame, 120, 0.0, 49.0).level, -79.0);
}

TEST(Face, pressed_in_it_says_how_far_and_what_lies_deep_comes_nearer) {
  auto volume = surface_at_depth(20.0, 1.8);
  for (const double press : {1.0, 4.0, 8.0}) {
    Ultrasound machine(volume, checks::flat_probe(), face_settings(), checks::plain_detail(50.0));
    const UltrasoundFrame& frame = machine.image(checks::moved_to(Vec3(0.0, press, 0.0)));
    EXPECT_NEAR(frame.press, press, 0.3);
    const double depth = brightest_of(frame, 80, 2.0, 49.0).depth;
    EXPECT_GE(depth, 20.0 - press - 0.3);
    EXPECT_LT(depth, 20.0 + 0.3);
  }
}

TEST(Face, its_clutter_is_the_probes_own_and_stays_near) {
  UltrasoundDetail detail = checks::plain_detail(50.0);
  detail.clutter = true;
  Ultrasound machine(surface_at_depth(45.0, 1.8), checks::flat_probe(), face_settings(), detail);
  const UltrasoundFrame here = machine.image(Pose::Identity());
  const UltrasoundFrame there = machine.image(checks::moved_to(Vec3(2.3, 0.0, 0.2)));
  const auto rows = [](const UltrasoundFrame& frame, int from, int to) {
    return std::vector<std::uint8_t>(frame.pixels.begin() + from * frame.width,
                                     frame.pixels.begin() + to * frame.width);
  };
  EXPECT_EQ(rows(here, 0, 150), rows(there, 0, 150)) << "it moves with the probe";
  double last = 1.0;
  for (const double depth : {0.0, 1.0, 3.0, 8.0, 20.0}) {
    const double level = brightest_of(here, 80, depth, depth + 0.7).level;
    EXPECT_LT(level, last) << depth;
    last = level;
  }
  EXPECT_GT(brightest_of(here, 80, 0.0, 0.5).level, -10.0);
  EXPECT_LT(last, -60.0);
}

TEST(Reverberation, echoes_come_again_at_multiples_of_the_depth) {
  // An echo of 0.4: strong, but not that of gas, behind which a haze would lie.
  const auto volume = surface_at_depth(10.0, 1.6 * 0.6 / 1.4);
  UltrasoundDetail detail = checks::plain_detail(50.0);
  detail.reverberation = true;
  UltrasoundSettings settings = face_settings();
  settings.gain = 6.0;
  Ultrasound machine(volume, checks::flat_probe(), settings, detail);
  const UltrasoundFrame& frame = machine.image(Pose::Identity());
  for (int n = 2; n <= 4; ++n) {
    const double depth = 10.0 * n;
    const double wanted = checks::in_decibels(std::pow(face_reflects, n - 1.0) * std::pow(0.4, n));
    EXPECT_NEAR(checks::decibels(frame, 80.0, 80, 40 * n), wanted + 6.0 + checks::compensation(5.0, depth), 0.4)
        << "echo " << n;
    EXPECT_EQ(checks::decibels(frame, 80.0, 80, 40 * n - 10), -80.0) << "between them";
  }
  detail.reverberation = false;
  Ultrasound without(volume, checks::flat_probe(), settings, detail);
  EXPECT_LE(brightest_of(without.image(Pose::Identity()), 80, 12.0, 50.0).level, -79.0);
}

TEST(Reverberation, behind_gas_lies_a_haze_that_fades) {
  const auto volume = surface_at_depth(9.0, 0.0004);
  UltrasoundDetail detail = checks::plain_detail(50.0);
  detail.reverberation = true;
  Ultrasound machine(volume, checks::flat_probe(), face_settings(), detail);
  const UltrasoundFrame& frame = machine.image(Pose::Identity());
  const auto mean_at = [&frame](double depth) {
    double sum = 0.0;
    int count = 0;
    for (int row = static_cast<int>(depth / 0.25) - 4; row <= static_cast<int>(depth / 0.25) + 4; ++row)
      for (int column = 0; column < frame.width; ++column, ++count)
        sum += checks::amplitude(frame, 80.0, column, row);
    return checks::in_decibels(sum / count) - checks::compensation(5.0, depth);
  };
  // 2 % of the echo, falling to 1/e in 15 mm; the mean of Rayleigh's distribution is 0.886 of its root mean square.
  for (const double depth : {13.0, 22.0, 31.0})
    EXPECT_NEAR(mean_at(depth), checks::in_decibels(0.02 * 0.886 * std::exp(-(depth - 9.0) / 15.0)), 0.5) << depth;
}

}  // namespace
}  // namespace bodkin
