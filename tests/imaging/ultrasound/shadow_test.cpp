// Shadows behind bone and air, brightness behind fluid, and the time-gain compensation.
#include "tests/imaging/ultrasound/hand_made_patient.h"
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::imaging;
namespace {

constexpr double target_at = 35.0;  // mm: a surface behind everything, which shadows fall on

// A wedge of bone or gas whose edge is at x = 2.1 mm, 12 mm deep; its upper side falls away to +x.
bool in_wedge(const Vec3& p) {
  return p.x() > 2.1 && p.y() > 12.0 + 0.2 * (p.x() - 2.1) && p.y() < 22.0;
}

std::shared_ptr<AcousticVolume> with_wedge(const AcousticTissue& medium) {
  const checks::Block block{.half_width = 30.0, .half_thickness = 1.0, .voxel = 0.25};
  return checks::hand_made(block, {checks::clear_medium(), checks::clear_medium(1.8), medium}, [](const Vec3& p) {
    return in_wedge(p) ? 3 : p.y() < target_at ? 1 : 2;
  });
}

// The beginning of light along the target: the x of the last black pixel's far side, in mm, from lit pixels to the
// left. A curved probe's target pixels are searched within 1 mm of its depth.
double shadow_edge(const UltrasoundFrame& frame, double right_most) {
  const auto lit = [&frame](int column) {
    const double y = target_at - frame.corner.y();
    const int row = static_cast<int>(std::lround(y / frame.pixel)), reach = static_cast<int>(1.0 / frame.pixel);
    for (int r = std::max(0, row - reach); r <= std::min(frame.height - 1, row + reach); ++r)
      if (frame.pixels[static_cast<std::size_t>(r * frame.width + column)] > 0) return true;
    return false;
  };
  const auto column_at = [&frame](double x) {
    return static_cast<int>(std::lround((x - frame.corner.x()) / frame.pixel));
  };
  int last_lit = column_at(-3.0);
  EXPECT_TRUE(lit(last_lit));
  while (last_lit + 1 < frame.width && lit(last_lit + 1)) ++last_lit;
  for (int dark = last_lit + 1; dark <= column_at(right_most); ++dark) EXPECT_FALSE(lit(dark)) << "column " << dark;
  return frame.corner.x() + frame.pixel * (last_lit + 0.5);
}

TEST(Shadow, its_edge_is_where_geometry_says) {
  UltrasoundSettings settings;
  settings.depth = 45.0;
  settings.dynamic_range = 60.0;
  for (const AcousticTissue& medium : {checks::clear_medium(7.8, 15.0), checks::clear_medium(0.0004, 12.0)}) {
    const auto volume = with_wedge(medium);
    Ultrasound linear(volume, checks::flat_probe(), settings, checks::plain_detail(45.0));
    const UltrasoundFrame& flat = linear.image(Pose::Identity());
    EXPECT_NEAR(shadow_edge(flat, 18.0), 2.1, flat.pixel);

    UltrasoundDetail detail = checks::plain_detail(45.0);
    detail.lines = 400;
    detail.width = detail.height = 300;
    const UltrasoundProbe curved = checks::curved_probe();
    Ultrasound convex(volume, curved, settings, detail);
    const UltrasoundFrame& fan = convex.image(checks::moved_to(Vec3(0.0, -0.01, 0.0)));
    ASSERT_EQ(fan.why, NoImage::none);
    // Rays come from the middle of the face's circle: the wedge's top is the last to be passed on the left.
    const double grows = (target_at + curved.radius) / (12.0 + curved.radius);
    EXPECT_NEAR(shadow_edge(fan, 10.0), 2.1 * grows, 1.5 * fan.pixel);
  }
}

TEST(Shadow, behind_bone_and_air_all_is_black) {
  UltrasoundSettings settings;
  settings.depth = 45.0;
  for (const AcousticTissue& medium : {checks::clear_medium(7.8, 15.0), checks::clear_medium(0.0004, 12.0)}) {
    AcousticTissue bright = checks::clear_medium(1.6);
    bright.echo = -10.0;
    const checks::Block block{.half_width = 22.0, .half_thickness = 3.0};
    const auto volume = checks::hand_made(block, {bright, medium}, [](const Vec3& p) {
      return p.y() > 15.0 && p.y() < 20.0 && std::abs(p.x()) < 8.0 ? 2 : 1;
    });
    UltrasoundDetail detail = checks::plain_detail(45.0);
    detail.speckle = true;
    Ultrasound machine(volume, checks::flat_probe(), settings, detail);
    const UltrasoundFrame& frame = machine.image(Pose::Identity());
    double shaded = 0.0, beside = 0.0;
    int count = 0;
    for (int row = 92; row < 170; ++row) {
      for (int column = 60; column <= 100; ++column, ++count)
        shaded += frame.pixels[static_cast<std::size_t>(row * frame.width + column)];
      for (int column = 0; column <= 40; ++column)
        beside += frame.pixels[static_cast<std::size_t>(row * frame.width + column)];
    }
    EXPECT_LT(shaded / count, 5.0) << medium.impedance << " MRayl";
    EXPECT_GT(beside / count, 150.0);
  }
}

// A cyst: deeper tissue is brighter by the missing attenuation.
TEST(Shadow, behind_fluid_it_is_brighter_by_what_the_fluid_did_not_take) {
  AcousticTissue tissue = checks::clear_medium(1.6, 0.6), fluid = checks::clear_medium(1.6, 0.05);
  tissue.power = 1.1;
  const checks::Block block{.half_width = 22.0, .half_thickness = 1.0, .voxel = 0.25};
  const auto volume = checks::hand_made(block, {tissue, fluid, checks::clear_medium(1.8)}, [](const Vec3& p) {
    return p.y() >= target_at ? 3 : p.y() >= 10.0 && p.y() < 25.0 && std::abs(p.x()) < 6.0 ? 2 : 1;
  });
  UltrasoundSettings settings;
  settings.depth = 45.0;
  settings.dynamic_range = 60.0;
  settings.frequency = 4.0;
  Ultrasound machine(volume, checks::flat_probe(), settings, checks::plain_detail(45.0));
  const UltrasoundFrame& frame = machine.image(Pose::Identity());
  const int row = static_cast<int>(target_at / frame.pixel);
  const double behind = checks::decibels(frame, 60.0, 80, row), beside = checks::decibels(frame, 60.0, 20, row);
  const double spared = 2.0 * 1.5 * (0.6 * std::pow(4.0, 1.1) - 0.05 * 4.0);
  EXPECT_NEAR(behind - beside, spared, 0.25);
}

// Mean level in dB of the envelope in a band of depths, over the inner columns.
double band_level(const UltrasoundFrame& frame, double dynamic_range, int first_row, int last_row) {
  double sum = 0.0;
  int count = 0;
  for (int row = first_row; row < last_row; ++row)
    for (int column = 16; column < frame.width - 16; ++column, ++count)
      sum += checks::amplitude(frame, dynamic_range, column, row);
  return checks::in_decibels(sum / count);
}

TEST(TimeGain, soft_tissue_is_equally_bright_at_all_depths) {
  AcousticTissue soft = checks::clear_medium(1.6, checks::compensated);
  soft.echo = -30.0;
  const checks::Block block{.half_width = 40.0, .half_thickness = 9.0};
  const auto volume = checks::hand_made(block, soft);
  UltrasoundSettings settings;
  settings.depth = 50.0;
  settings.dynamic_range = 100.0;
  UltrasoundDetail detail = checks::plain_detail(50.0);
  detail.speckle = true;
  Ultrasound machine(volume, checks::flat_probe(), settings, detail);
  constexpr int bands = 8, poses = 6;
  std::array<double, bands> level{}, slid{};
  for (int pose = 0; pose < poses; ++pose) {
    const Pose place = checks::moved_to(Vec3(-12.5 + 5.0 * pose, 0.0, 1.5 * pose - 3.7));
    const UltrasoundFrame& frame = machine.image(place);
    for (int band = 0; band < bands; ++band)
      level[static_cast<std::size_t>(band)] += band_level(frame, 100.0, 4 + 24 * band, 28 + 24 * band) / poses;
  }
  for (const double mean : level) EXPECT_NEAR(mean, -30.0, 0.5);

  settings.sliders = {-12.0, -8.0, 0.0, 5.0, 10.0, 10.0, 0.0, -6.0};
  machine.set(settings);
  for (int pose = 0; pose < poses; ++pose) {
    const Pose place = checks::moved_to(Vec3(-12.5 + 5.0 * pose, 0.0, 1.5 * pose - 3.7));
    const UltrasoundFrame& frame = machine.image(place);
    for (int band = 0; band < bands; ++band)
      slid[static_cast<std::size_t>(band)] += band_level(frame, 100.0, 4 + 24 * band, 28 + 24 * band) / poses;
  }
  for (int band = 0; band < bands; ++band) {
    const double at = (4 + 24 * band + 11.5) / 200.0 * 7.0;
    const auto slider = static_cast<std::size_t>(at);
    const double wanted = settings.sliders[slider] + (at - static_cast<double>(slider)) *
                                                         (settings.sliders[slider + 1] - settings.sliders[slider]);
    const auto i = static_cast<std::size_t>(band);
    EXPECT_NEAR(slid[i] - level[i], wanted, 1.0) << "band " << band;  // sliders bend within a band
  }
}

TEST(TimeGain, gain_adds_its_decibels) {
  const checks::Block block{.half_width = 22.0, .depth = 30.0, .half_thickness = 1.0, .voxel = 0.25};
  const auto volume = checks::hand_made(block, {checks::clear_medium(), checks::clear_medium(1.8)},
                                        [](const Vec3& p) { return p.y() < 10.0 ? 1 : 2; });
  UltrasoundSettings settings;
  settings.depth = 20.0;
  settings.frequency = 2.0;
  Ultrasound machine(volume, checks::flat_probe(), settings, checks::plain_detail(20.0));
  for (const double gain : {-20.0, 0.0, 7.0}) {
    settings.gain = gain;
    machine.set(settings);
    const double r = 0.2 / 3.4;
    EXPECT_NEAR(checks::decibels(machine.image(Pose::Identity()), 60.0, 80, 40),
                checks::in_decibels(r) + gain + checks::compensation(2.0, 10.0), 0.15);
  }
}

}  // namespace
}  // namespace bodkin
