// A slab: two surfaces, and attenuation between them on the way there and back.
#include "tests/imaging/ultrasound/marched_lines.h"
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::imaging;
namespace {

// From 10 to 20 mm.
std::shared_ptr<AcousticVolume> slab_of(const AcousticTissue& medium) {
  const checks::Block block{.half_width = 4.0, .depth = 40.0, .half_thickness = 1.0, .voxel = 0.25};
  return checks::hand_made(block, {checks::clear_medium(), medium},
                           [](const Vec3& p) { return p.y() < 10.0 || p.y() >= 20.0 ? 1 : 2; });
}

TEST(Slab, its_second_surface_gets_what_the_first_lets_through) {
  for (const double impedance : {0.8, 1.3, 1.8, 2.3}) {
    const auto volume = slab_of(checks::clear_medium(impedance));
    const double r = (impedance - 1.6) / (impedance + 1.6), through = 1.0 - r * r;
    for (const double spacing : {0.09, 0.2, 0.25}) {
      const auto samples = static_cast<int>(30.0 / spacing), middle = static_cast<int>(15.0 / spacing);
      const auto lines = checks::march_one(*volume, {}, {.spacing = spacing, .samples = samples});
      EXPECT_NEAR(lines.sum(0, 0, middle), r, 5e-4) << impedance << " MRayl, " << spacing << " mm";
      EXPECT_NEAR(lines.reaches(0, middle), through, 5e-4);
      EXPECT_NEAR(lines.sum(0, middle, samples), -r * through, 5e-4);
      EXPECT_NEAR(lines.reaches(0, samples - 1), through * through, 5e-4);
    }
  }
}

TEST(Slab, attenuation_acts_there_and_back) {
  for (const double attenuation : {0.1, 0.5, 1.5}) {
    for (const double power : {1.0, 1.3, 2.0}) {
      AcousticTissue medium = checks::clear_medium(1.8, attenuation);
      medium.power = power;
      const auto volume = slab_of(medium);
      const double r = (1.8 - 1.6) / (1.8 + 1.6);
      for (const double frequency : {2.0, 5.0}) {
        const checks::MarchSettings settings{.spacing = 0.1, .samples = 300, .frequency = frequency};
        const auto lines = checks::march_one(*volume, {}, settings);
        const double lost = 2.0 * attenuation * std::pow(frequency, power) * 1.0;  // dB, of 1 cm
        const double echo = lines.sum(0, 150, 300);
        // Where the slab begins and ends is known to a sample at each end.
        EXPECT_NEAR(checks::in_decibels(echo), checks::in_decibels(r * (1.0 - r * r)) - lost, 0.02 * lost + 0.02)
            << attenuation << " dB/cm/MHz^" << power << " at " << frequency << " MHz";
        EXPECT_NEAR(checks::in_decibels(lines.reaches(0, 299)),
                    checks::in_decibels((1.0 - r * r) * (1.0 - r * r)) - lost, 0.02 * lost + 0.02);
      }
    }
  }
}

// The same through the whole machine, read from pixels.
TEST(Slab, a_picture_shows_both_surfaces_at_their_levels) {
  const checks::Block block{.half_width = 22.0, .half_thickness = 1.0, .voxel = 0.25};
  const auto volume = checks::hand_made(block, {checks::clear_medium(), checks::clear_medium(1.8, 0.7)},
                                        [](const Vec3& p) { return p.y() < 10.0 || p.y() >= 30.0 ? 1 : 2; });
  UltrasoundSettings settings;
  settings.depth = 50.0;
  settings.dynamic_range = 40.0;
  settings.gain = 5.0;
  settings.frequency = 3.0;
  Ultrasound machine(volume, checks::flat_probe(), settings, checks::plain_detail(50.0));
  const UltrasoundFrame& frame = machine.image(Pose::Identity());
  ASSERT_EQ(frame.why, NoImage::none);
  EXPECT_EQ(frame.contact, 1.0);
  EXPECT_NEAR(frame.pixel, 0.25, 1e-9);
  const double r = (1.8 - 1.6) / (1.8 + 1.6);
  for (const int column : {0, 37, 80, 160}) {
    for (int row = 0; row < frame.height; ++row) {
      const double level = checks::decibels(frame, settings.dynamic_range, column, row);
      const double depth = row * frame.pixel;
      if (row == 40) {
        EXPECT_NEAR(level, checks::in_decibels(r) + 5.0 + checks::compensation(3.0, depth), 0.1);
      } else if (row == 120) {
        const double lost = 2.0 * 0.7 * 3.0 * 2.0;
        EXPECT_NEAR(level, checks::in_decibels(r * (1.0 - r * r)) - lost + 5.0 + checks::compensation(3.0, depth),
                    0.15);
      } else {
        ASSERT_EQ(level, -settings.dynamic_range) << "row " << row << ", column " << column;
      }
    }
  }
}

// The pulse and the beam widen a surface, but keep its level: also if its ramp takes several samples, or exceeds the
// pulse because of large voxels.
TEST(Slab, pulse_and_beam_leave_a_surface_its_level) {
  for (const double voxel : {0.1, 0.25, 0.5, 1.0}) {
    const auto volume = checks::hand_made({.half_width = 22.0, .depth = 32.0, .half_thickness = 0.5, .voxel = voxel},
                                          {checks::clear_medium(), checks::clear_medium(1.8)},
                                          [](const Vec3& p) { return p.y() < 15.0 ? 1 : 2; });
    UltrasoundSettings settings;
    settings.depth = 30.0;
    settings.frequency = 2.5;
    UltrasoundDetail detail = checks::plain_detail(30.0, 0.1);
    detail.speckle = true;
    Ultrasound machine(volume, checks::flat_probe(), settings, detail);
    for (const double gap : {0.0, 0.53, 1.08}) {
      const UltrasoundFrame& frame = machine.image(checks::moved_to(Vec3(0.0, -gap, 0.0)));
      double level = -60.0;
      for (int row = 130; row < 180; ++row) level = std::max(level, checks::decibels(frame, 60.0, 200, row));
      EXPECT_NEAR(level, checks::in_decibels(0.2 / 3.4) + checks::compensation(2.5, 15.0 + gap), 0.7)
          << voxel << " mm voxels, " << gap << " mm of gel";
    }
  }
}

}  // namespace
}  // namespace bodkin
