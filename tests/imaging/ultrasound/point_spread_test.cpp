// The width of a point along the line, across it and across the slice.
#include "tests/imaging/ultrasound/hand_made_patient.h"
#include "tests/sanitized.h"
#include <gtest/gtest.h>

#include "imaging/ultrasound/slice_rays.h"
#include "imaging/ultrasound/ultrasound_beam.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::imaging;
namespace {

// A point of the scan plane: a needle's tip whose shaft leaves the slice at a right angle.
NeedleInUltrasound point_at(const Vec3& point) {
  NeedleInUltrasound needle;
  needle.pose = needle_pose(point, Vec3::UnitZ());
  return needle;
}

// Full width at half maximum of the peak that is nearest to `at`, in pixels `step` apart in memory.
double width_of_peak(const UltrasoundFrame& frame, double dynamic_range, int column, int row, bool along_rows) {
  const auto level = [&](int off) {
    return along_rows ? checks::decibels(frame, dynamic_range, column + off, row)
                      : checks::decibels(frame, dynamic_range, column, row + off);
  };
  const double half = level(0) - 6.0206;
  const auto side = [&](int sign) {
    int off = 0;
    while (level(sign * (off + 1)) > half) ++off;
    const double inside = level(sign * off), outside = level(sign * (off + 1));
    return off + (inside - half) / (inside - outside);
  };
  return side(1) + side(-1);
}

struct PointCase {
  UltrasoundProbe probe;
  double depth, focus;
  std::vector<double> depths;
};

TEST(PointSpread, is_as_wide_as_the_probes_beam) {
  const auto volume = checks::hand_made({.half_width = 60.0, .depth = 90.0, .half_thickness = 2.0, .voxel = 1.0},
                                        checks::clear_medium());
  const std::vector<PointCase> cases = {{checks::flat_probe(), 60.0, 25.0, {8.0, 25.0, 50.0}},
                                        {checks::curved_probe(), 80.0, 40.0, {15.0, 40.0, 70.0}},
                                        {checks::phased_probe(), 80.0, 50.0, {20.0, 50.0, 70.0}}};
  for (const auto& [probe, depth, focus, depths] : cases) {
    UltrasoundSettings settings;
    settings.depth = depth;
    settings.focus = focus;
    settings.dynamic_range = 40.0;
    UltrasoundDetail detail = paper_detail();
    detail.speckle = true;
    detail.lines = 401;
    detail.samples = 801;
    detail.width = 901;
    detail.height = 901;
    Ultrasound machine(volume, probe, settings, detail);
    const UltrasoundBeam beam = ultrasound_beam(probe, settings);
    for (const double wanted : depths) {
      const double at = std::round(wanted / depth * 800.0) * depth / 800.0;
      settings.gain = -checks::compensation(probe.frequency, at);
      machine.set(settings);
      const UltrasoundFrame& frame = machine.image(Pose::Identity(), point_at(Vec3(0.0, at, 0.0)));
      ASSERT_EQ(frame.why, NoImage::none);
      const int row = static_cast<int>(std::lround((at - frame.corner.y()) / frame.pixel));
      const auto peak = checks::decibels(frame, 40.0, 450, row);
      ASSERT_LT(peak, 0.0);
      ASSERT_GT(peak, -25.0);
      const double axial = frame.pixel * width_of_peak(frame, 40.0, 450, row, false);
      const double lateral = frame.pixel * width_of_peak(frame, 40.0, 450, row, true);
      EXPECT_NEAR(axial, beam.pulse, std::max(0.05 * beam.pulse, frame.pixel)) << to_string(probe.kind) << ' ' << at;
      EXPECT_NEAR(lateral, beam.lateral(at), std::max(0.05 * beam.lateral(at), 0.5 * frame.pixel))
          << to_string(probe.kind) << " at " << at << " mm";
    }
  }
}

// image_to_patient gives a patient's point in the image for any pose of the probe.
TEST(PointSpread, a_point_is_where_the_pictures_pose_says) {
  const auto volume = checks::hand_made({.half_width = 60.0, .depth = 90.0, .half_thickness = 60.0, .voxel = 2.0},
                                        checks::clear_medium());
  Random random(21);
  for (const UltrasoundProbe& probe : {checks::flat_probe(), checks::curved_probe(), checks::phased_probe()}) {
    UltrasoundDetail detail = paper_detail();
    detail.speckle = true;
    UltrasoundSettings settings;
    settings.gain = -40.0;
    Ultrasound machine(volume, probe, settings, detail);
    for (int number = 0; number < 5; ++number) {
      const Pose pose = probe_pose(Vec3(random.uniform(-20.0, 20.0), 1.0, random.uniform(-20.0, 20.0)),
                                   Vec3(random.uniform(-0.05, 0.05), 1.0, random.uniform(-0.05, 0.05)),
                                   Vec3(random.normal(), 0.0, random.normal()));
      const Vec3 in_probe(random.uniform(-10.0, 10.0), random.uniform(25.0, 60.0), 0.0);
      NeedleInUltrasound needle = point_at(in_probe);
      needle.pose = pose * needle.pose;
      const UltrasoundFrame& frame = machine.image(pose, needle);
      ASSERT_EQ(frame.why, NoImage::none);
      const auto brightest = std::max_element(frame.pixels.begin(), frame.pixels.end());
      ASSERT_GT(*brightest, 30);
      ASSERT_LT(*brightest, 255);
      const auto at = static_cast<int>(brightest - frame.pixels.begin());
      const Vec3 pixel(at % frame.width, at / frame.width, 0.0);
      const Vec3 found = frame.image_to_patient(pose) * (frame.pixel * pixel);
      EXPECT_LT((found - pose * in_probe).norm(), 2.5 * frame.pixel) << to_string(probe.kind);
    }
  }
}

TEST(PointSpread, no_beam_is_narrower_at_a_depth_than_the_one_that_focuses_there) {
  for (const UltrasoundProbe& probe : {checks::flat_probe(), checks::curved_probe(), checks::phased_probe()}) {
    for (const double depth : {15.0, 30.0, 60.0}) {
      UltrasoundSettings settings;
      settings.focus = depth;
      const double focused = ultrasound_beam(probe, settings).lateral(depth);
      for (const double focus : {0.4 * depth, 2.5 * depth}) {
        settings.focus = focus;
        EXPECT_GT(ultrasound_beam(probe, settings).lateral(depth), focused) << to_string(probe.kind) << ' ' << depth;
      }
    }
    const UltrasoundBeam beam = ultrasound_beam(probe, {});
    EXPECT_LT(beam.elevation(beam.lens), beam.elevation(0.35 * beam.lens));
    EXPECT_LT(beam.elevation(beam.lens), beam.elevation(1.6 * beam.lens));
  }
}

// A strip 0.75 mm across the slice is moved through it; its brightness by position gives the slice's thickness.
TEST(PointSpread, the_slice_is_as_thick_as_the_probes_beam) {
  const checks::Block block{.half_width = 3.0, .above = 2.0, .depth = 46.0, .half_thickness = 10.0, .voxel = 0.25};
  for (const double strip_at : {15.0, 40.0}) {
    const auto volume =
        checks::hand_made(block, {checks::clear_medium(), checks::clear_medium(1.7)},
                          [&](const Vec3& p) { return p.y() >= strip_at && std::abs(p.z()) < 0.3 ? 2 : 1; });
    for (const int slices : {1, 3, 5, 7}) {
      if (sanitized && slices != 3) continue;
      UltrasoundSettings settings;
      settings.depth = 46.0;
      settings.gain = 20.0 - checks::compensation(3.5, strip_at);
      UltrasoundDetail detail = paper_detail();
      detail.slices = slices;
      detail.lines = detail.width = 17;
      detail.samples = detail.height = 461;
      UltrasoundProbe probe = checks::curved_probe();  // but for its face: 1 mm and flat
      probe.kind = ProbeKind::linear;
      probe.radius = 0.0;
      probe.elements = 16;
      probe.pitch = 0.0625;
      Ultrasound machine(volume, probe, settings, detail);
      double sum = 0.0, variance = 0.0;
      for (double z = -8.0; z < 8.05; z += 0.2) {
        const UltrasoundFrame& frame = machine.image(checks::moved_to(Vec3(0.0, 0.0, z)));
        ASSERT_EQ(frame.why, NoImage::none);
        double echo = 0.0;
        const int middle = static_cast<int>(std::lround((strip_at - frame.corner.y()) / frame.pixel));
        const int reach = static_cast<int>(0.6 / frame.pixel) + 1;
        for (int row = middle - reach; row <= middle + reach; ++row) {
          const double level = checks::decibels(frame, 60.0, 8, row);
          if (level > -60.0) echo = std::max(echo, std::pow(10.0, level / 20.0));
        }
        sum += echo;
        variance += echo * z * z;
      }
      const double strip = 0.75 * 0.75 / 12.0;
      const double wanted =
          slices == 1 ? 0.0 : std::pow(ultrasound_beam(probe, settings).elevation(strip_at) * deviation_of_width, 2);
      EXPECT_NEAR(std::sqrt(variance / sum), std::sqrt(wanted + strip), 0.05 * std::sqrt(wanted + strip) + 0.03)
          << slices << " rays at " << strip_at << " mm";
    }
  }
}

TEST(PointSpread, rays_of_a_slice_have_the_variance_of_the_beam) {
  for (const int count : {1, 3, 5, 7}) {
    double sum = 0.0, mean = 0.0, variance = 0.0;
    for (const SliceRay& ray : slice_rays(count)) {
      sum += ray.weight;
      mean += ray.weight * ray.off;
      variance += ray.weight * ray.off * ray.off;
    }
    EXPECT_EQ(slice_rays(count).size(), static_cast<std::size_t>(count));
    EXPECT_EQ(slice_rays(count).front().off, 0.0);
    EXPECT_NEAR(sum, 1.0, 1e-12);
    EXPECT_NEAR(mean, 0.0, 1e-12);
    EXPECT_NEAR(variance, count == 1 ? 0.0 : 1.0, 1e-12);
  }
}

// On average over two neighbouring lines, passes are the rays.
TEST(PointSpread, rays_that_take_turns_have_the_variance_of_the_beam) {
  for (const int count : {1, 3, 5, 7}) {
    const std::vector<SlicePass> passes = slice_passes(slice_rays(count), true);
    EXPECT_EQ(passes.size(), static_cast<std::size_t>(1 + count / 2));
    double sum = 0.0, variance = 0.0;
    for (const SlicePass& pass : passes) {
      EXPECT_EQ(pass.alternates, pass.off != 0.0);
      sum += pass.weight;
      variance += pass.weight * pass.off * pass.off;
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
    EXPECT_NEAR(variance, count == 1 ? 0.0 : 1.0, 1e-12);
    EXPECT_EQ(slice_passes(slice_rays(count), false).size(), static_cast<std::size_t>(count));
  }
}

}  // namespace
}  // namespace bodkin
