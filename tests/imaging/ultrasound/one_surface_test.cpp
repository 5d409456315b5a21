// Only surfaces: their reflection, by angle, and their transmission.
#include "tests/imaging/ultrasound/marched_lines.h"
#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::imaging;
namespace {

using checks::march_one;

constexpr double surface_at = 10.0;  // mm below the skin

// Two media, the second from 10 mm on. The ramp between them is as wide as `ramp` voxels of 0.5 mm, centred there.
std::shared_ptr<AcousticVolume> two_media(double before, double behind, int ramp = 1) {
  const checks::Block block{.half_width = 30.0, .depth = 30.0, .half_thickness = 1.0};
  const auto volume = checks::hand_made(block, {checks::clear_medium(before), checks::clear_medium(behind)},
                                        [](const Vec3& p) { return p.y() < surface_at ? 1 : 2; });
  const Grid& grid = volume->grid;
  for (std::size_t at = 0; at < volume->voxels.size(); ++at) {
    if (volume->tissue(at) == tissue::air) continue;
    const auto row = static_cast<int>(at / static_cast<std::size_t>(grid.size[0])) % grid.size[1];
    const double y = grid.to_patient(Vec3(0, row, 0)).y();
    const double part = std::clamp((y - surface_at + 0.25) / (0.5 * ramp) + 0.5, 0.0, 1.0);
    volume->voxels[at] =
        AcousticVolume::voxel(checks::impedance_steps(before + part * (behind - before)), volume->tissue(at));
  }
  return volume;
}

// At an angle to the surface, so that the middle of the line's way to it is where it always is.
checks::LineStart slanted(double angle) {
  checks::LineStart start;
  start.direction = {std::sin(angle), std::cos(angle), 0.0};
  start.origin = {-surface_at * std::tan(angle), 0.0, 0.0};
  return start;
}

TEST(OneSurface, throws_back_what_the_impedances_say) {
  for (const auto& [before, behind] : {std::pair{1.6, 1.7}, std::pair{1.7, 1.38}, std::pair{1.38, 1.65},
                                       std::pair{1.65, 1.55}, std::pair{1.6, 0.9}, std::pair{1.6, 2.4}}) {
    const auto volume = two_media(before, behind);
    for (const double spacing : {0.07, 0.13, 0.25, 0.31, 0.5}) {
      for (const double phase : {0.0, 0.03, 0.11, 0.2}) {
        checks::LineStart start;
        start.origin.y() = phase;
        const auto samples = static_cast<int>(20.0 / spacing);
        const auto lines = march_one(*volume, start, {.spacing = spacing, .samples = samples, .matched = before});
        const double r = (behind - before) / (behind + before);
        EXPECT_NEAR(lines.sum(0, 0, samples), r, 0.002 * std::abs(r) + 2e-4)
            << before << " to " << behind << " MRayl, samples " << spacing << " mm apart from " << phase;
        EXPECT_NEAR(lines.reaches(0, samples - 1), 1.0 - r * r, 5e-4);
      }
    }
  }
}

TEST(OneSurface, sharp_or_a_ramp_it_is_the_same) {
  for (const auto& [before, behind] : {std::pair{1.6, 1.75}, std::pair{1.65, 1.35}}) {
    const double r = (behind - before) / (behind + before);
    for (const int ramp : {1, 2, 3, 5}) {
      const auto volume = two_media(before, behind, ramp);
      for (const double spacing : {0.13, 0.25, 0.4}) {
        const auto samples = static_cast<int>(20.0 / spacing);
        const auto lines = march_one(*volume, {}, {.spacing = spacing, .samples = samples, .matched = before});
        EXPECT_NEAR(lines.sum(0, 0, samples), r, 0.01 * std::abs(r))
            << ramp << " voxels, samples " << spacing << " mm apart";
        EXPECT_NEAR(lines.reaches(0, samples - 1), 1.0 - r * r, 2e-3);
      }
    }
  }
}

TEST(OneSurface, follows_fresnel_at_an_angle) {
  for (const auto& [before, behind] : {std::pair{1.6, 1.75}, std::pair{1.65, 1.35}, std::pair{1.5, 2.3}}) {
    const auto volume = two_media(before, behind);
    for (const double degrees : {0.0, 10.0, 20.0, 30.0, 45.0, 60.0}) {
      const double cosine = std::cos(degrees * degree);
      const double r = checks::fresnel(before, behind, cosine);
      for (const double spacing : {0.13, 0.25, 0.4}) {
        const auto samples = static_cast<int>(20.0 / spacing / cosine);
        const checks::MarchSettings settings{.spacing = spacing, .samples = samples, .matched = before};
        const auto lines = march_one(*volume, slanted(degrees * degree), settings);
        EXPECT_NEAR(lines.sum(0, 0, samples), r * checks::received(settings.mirror, cosine),
                    0.005 * std::abs(r) + 5e-4)
            << before << " to " << behind << " MRayl at " << degrees << " degrees, samples " << spacing
            << " mm apart";
        EXPECT_NEAR(lines.reaches(0, samples - 1), 1.0 - r * r, 1e-3);
      }
    }
  }
}

// Sound is faster in bone: beyond 26 degrees none of it enters.
TEST(OneSurface, bone_reflects_totally_beyond_its_critical_angle) {
  constexpr double soft = 1.6, bone = 7.8;
  const auto volume = two_media(soft, bone);
  const double critical = std::asin((1040.0 + 310.0 * soft) / (1040.0 + 310.0 * bone)) / degree;
  EXPECT_NEAR(critical, 26.4, 0.1);
  for (const double degrees : {0.0, 10.0, 20.0, 25.0, 28.0, 40.0, 60.0}) {
    const double cosine = std::cos(degrees * degree), r = checks::fresnel(soft, bone, cosine);
    for (const double spacing : {0.13, 0.25, 0.4, 0.55}) {
      const auto samples = static_cast<int>(20.0 / spacing / cosine);
      const checks::MarchSettings settings{.spacing = spacing, .samples = samples};
      const auto lines = march_one(*volume, slanted(degrees * degree), settings);
      const double left = lines.reaches(0, samples - 1);
      EXPECT_NEAR(left, 1.0 - r * r, 2e-3) << degrees << " degrees, samples " << spacing << " mm apart";
      if (degrees > critical) {
        EXPECT_LT(left, 1e-6);
      }
      // The lower end of a ramp is soft tissue still, and not as bright as an edge of bone.
      const double most = r * 1.8 * checks::received(settings.bone_mirror, cosine);
      const double least = r * checks::received(settings.mirror, cosine);
      EXPECT_LE(lines.sum(0, 0, samples), 1.001 * most) << degrees << " degrees";
      EXPECT_GE(lines.sum(0, 0, samples), 0.999 * least) << degrees << " degrees";
    }
  }
}

// Reverberation needs the whole echo of a strong surface, however many samples its ramp takes.
TEST(OneSurface, the_first_strong_one_is_known_with_all_its_echo) {
  for (const double behind : {0.0004, 0.5, 4.0}) {
    const auto volume = two_media(1.6, behind);
    const double r = checks::fresnel(1.6, behind);
    for (const double spacing : {0.07, 0.13, 0.25, 0.4}) {
      for (const double phase : {0.0, 0.05, 0.11}) {
        checks::LineStart start;
        start.origin.y() = phase;
        const auto lines =
            march_one(*volume, start, {.spacing = spacing, .samples = static_cast<int>(20.0 / spacing)});
        EXPECT_NEAR(static_cast<double>(lines.strong_echo[0]), std::abs(r), 0.01) << behind << " MRayl, " << spacing;
        EXPECT_NEAR(lines.strong_at[0] * spacing + phase, surface_at - 0.25, 0.25 + spacing);
      }
    }
  }
  const auto lines = march_one(*two_media(1.6, 1.8), {}, {});
  EXPECT_LT(lines.strong_at[0], 0.0F);
}

// For any media on its way, no line ends with more sound than it began with.
TEST(OneSurface, many_of_them_make_no_sound) {
  Random random(3);
  std::vector<AcousticTissue> media;
  for (const double impedance : {0.0004, 1.38, 1.6, 1.7, 1.9, 3.0, 7.8})
    media.push_back(checks::clear_medium(impedance));
  for (int round = 0; round < 10; ++round) {
    const auto volume =
        checks::hand_made({.half_width = 8.0, .depth = 30.0, .half_thickness = 8.0, .voxel = 1.0}, media,
                          [&random](const Vec3&) { return 1 + static_cast<int>(random.next() % 7); });
    std::array<checks::LineStart, scan::lanes> starts;
    for (checks::LineStart& start : starts) {
      start.origin = {random.uniform(-4.0, 4.0), 0.0, random.uniform(-4.0, 4.0)};
      start.direction = Vec3(0.15 * random.normal(), 1.0, 0.15 * random.normal()).normalized();
    }
    const auto lines = checks::march_lines(*volume, starts, {.spacing = 0.2, .samples = 140});
    for (int line = 0; line < scan::lanes; ++line) {
      for (int k = 0; k < 140; ++k) {
        ASSERT_GE(lines.reaches(line, k), 0.0);
        ASSERT_LE(lines.reaches(line, k), 1.0);
        ASSERT_LE(std::abs(lines.echo(line, k)), 3.6);  // at most from -1 to 1, on entering bone
      }
    }
  }
}

TEST(OneSurface, air_lets_nothing_through) {
  const auto volume = two_media(1.6, 0.0004);
  const auto lines = march_one(*volume, {}, {});
  EXPECT_NEAR(lines.sum(0, 0, lines.samples), -1.0, 2e-3);
  EXPECT_LT(lines.reaches(0, lines.samples - 1), 2e-3);
}

}  // namespace
}  // namespace bodkin
