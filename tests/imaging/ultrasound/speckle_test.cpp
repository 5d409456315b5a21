// The statistics of speckle: its distribution, level and size, and its attachment to the patient.
#include <array>

#include "tests/imaging/ultrasound/hand_made_patient.h"
#include "tests/sanitized.h"
#include <gtest/gtest.h>

#include "imaging/ultrasound/scan_kernel.h"
#include "imaging/ultrasound/ultrasound_beam.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::imaging;
namespace {

constexpr double speckle_range = 100.0;  // dB shown, to read levels from pixels

AcousticTissue scattering(double echo, double density = 1.0) {
  AcousticTissue medium = checks::clear_medium(1.6, checks::compensated);
  medium.echo = echo;
  medium.density = density;
  return medium;
}

std::shared_ptr<AcousticVolume> scattering_block(const AcousticTissue& medium) {
  return checks::hand_made({.half_width = 40.0, .depth = 56.0, .half_thickness = 40.0, .voxel = 1.0}, medium);
}

UltrasoundSettings speckle_settings() {
  UltrasoundSettings settings;
  settings.depth = 50.0;
  settings.focus = 25.0;
  settings.dynamic_range = speckle_range;
  return settings;
}

UltrasoundDetail speckle_detail(int slices, double spacing = 0.25) {
  UltrasoundDetail detail = checks::plain_detail(50.0, spacing);
  detail.speckle = true;
  detail.slices = slices;
  return detail;
}

// On the skin, turned about its normal and leaning a little, elsewhere every time.
Pose speckle_pose(int number) {
  Pose pose = checks::moved_to(Vec3(3.0 * number - 9.0, 0.0, 5.3 * number - 15.0));
  pose.linear() = Eigen::AngleAxisd(0.5 * number, Vec3::UnitY()).toRotationMatrix();
  return pose;
}

// Sums over the envelope in a band of depths.
struct Envelope {
  double count = 0.0, sum = 0.0, squares = 0.0;

  void add(const UltrasoundFrame& frame, double first_depth, double last_depth) {
    const int rows[] = {static_cast<int>(first_depth / frame.pixel), static_cast<int>(last_depth / frame.pixel)};
    const int margin = static_cast<int>(4.0 / frame.pixel);
    for (int row = rows[0]; row < rows[1]; ++row) {
      for (int column = margin; column < frame.width - margin; ++column) {
        const double a = checks::amplitude(frame, speckle_range, column, row);
        count += 1.0;
        sum += a;
        squares += a * a;
      }
    }
  }
  double mean() const { return sum / count; }
  double ratio() const { return mean() / std::sqrt(squares / count - mean() * mean()); }
  double mean_level() const { return checks::in_decibels(mean()); }
  double energy_level() const { return 0.5 * checks::in_decibels(squares / count); }
};

TEST(Speckle, is_fully_developed_and_as_bright_as_the_tissue_says) {
  for (const auto& [echo, slices] : {std::pair{-30.0, 1}, std::pair{-22.0, 3}, std::pair{-40.0, 5}}) {
    Ultrasound machine(scattering_block(scattering(echo)), checks::flat_probe(), speckle_settings(),
                       speckle_detail(slices));
    std::array<Envelope, 4> bands;
    Envelope all;
    for (int number = 0; number < 7; ++number) {
      const UltrasoundFrame& frame = machine.image(speckle_pose(number));
      ASSERT_EQ(frame.why, NoImage::none);
      all.add(frame, 5.0, 49.0);
      for (std::size_t band = 0; band < bands.size(); ++band)
        bands[band].add(frame, 5.0 + 11.0 * static_cast<double>(band), 16.0 + 11.0 * static_cast<double>(band));
    }
    EXPECT_NEAR(all.ratio(), 1.913, 0.02 * 1.913) << slices << " rays";
    for (const Envelope& band : bands) EXPECT_NEAR(band.mean_level(), echo, 0.5) << slices << " rays";
  }
}

TEST(Speckle, keeps_its_level_however_finely_it_is_sampled) {
  for (const double spacing : {0.1, 0.2, 0.4}) {
    Ultrasound machine(scattering_block(scattering(-30.0)), checks::flat_probe(), speckle_settings(),
                       speckle_detail(3, spacing));
    Envelope all;
    for (int number = 0; number < 4; ++number) all.add(machine.image(speckle_pose(number)), 5.0, 49.0);
    EXPECT_NEAR(all.mean_level(), -30.0, 0.5) << spacing << " mm";
    EXPECT_NEAR(all.ratio(), 1.913, 0.03 * 1.913) << spacing << " mm";
  }
}

// Cells of scatterers lie along the patient's lattice; lines may run aslant of it.
TEST(Speckle, is_the_same_whichever_way_the_lattice_lies) {
  if (sanitized) GTEST_SKIP() << "many pictures for one number";
  const Mat3 turns[] = {Eigen::AngleAxisd(0.7, Vec3::UnitZ()).toRotationMatrix(),
                        (Eigen::AngleAxisd(0.6, Vec3::UnitX()) * Eigen::AngleAxisd(0.6, Vec3::UnitZ()) *
                         Eigen::AngleAxisd(0.5, Vec3::UnitY()))
                            .toRotationMatrix()};
  for (const Mat3& turn : turns) {
    const auto patient = checks::hand_made(
        {.half_width = 60.0, .above = 45.0, .depth = 95.0, .half_thickness = 60.0, .voxel = 1.0, .direction = turn},
        scattering(-30.0));
    for (const double spacing : {0.1, 0.25}) {
      Ultrasound machine(patient, checks::flat_probe(), speckle_settings(), speckle_detail(3, spacing));
      Envelope all;
      for (int number = 2; number < 6; ++number) {
        const UltrasoundFrame& frame = machine.image(speckle_pose(number));
        ASSERT_EQ(frame.contact, 1.0);
        all.add(frame, 5.0, 45.0);
      }
      EXPECT_NEAR(all.mean_level(), -30.0, 0.7) << spacing << " mm";
      EXPECT_NEAR(all.ratio(), 1.913, 0.025 * 1.913) << spacing << " mm";
    }
  }
}

// Of the energies of patches, 12 mm across the lines and 0.5 mm along them: variance over squared mean.
double patchiness(const UltrasoundFrame& frame) {
  const int columns = static_cast<int>(12.0 / frame.pixel), rows = static_cast<int>(0.5 / frame.pixel);
  double count = 0.0, sum = 0.0, squares = 0.0;
  for (int row = 20; row + rows < frame.height; row += rows) {
    for (int column = 16; column + columns + 16 < frame.width; column += columns) {
      double energy = 0.0;
      for (int r = row; r < row + rows; ++r)
        for (int c = column; c < column + columns; ++c)
          energy += std::pow(checks::amplitude(frame, speckle_range, c, r), 2);
      count += 1.0, sum += energy, squares += energy * energy;
    }
  }
  return squares * count / (sum * sum) - 1.0;
}

TEST(Speckle, fibres_are_stripes_lengthwise_and_dots_across) {
  AcousticTissue muscle = scattering(-30.0);
  muscle.variation = 12.0;
  Ultrasound machine(scattering_block(muscle), checks::flat_probe(), speckle_settings(), speckle_detail(3));
  double lengthwise = 0.0, across = 0.0;
  Envelope all;
  for (int number = 0; number < 4; ++number) {
    const Vec3 face(4.0 * number - 7.0, 0.0, 7.0 * number - 10.0);
    const UltrasoundFrame transverse = machine.image(checks::moved_to(face));
    all.add(transverse, 5.0, 49.0);
    across += patchiness(transverse);
    lengthwise += patchiness(machine.image(probe_pose(face, Vec3::UnitY(), Vec3::UnitZ())));
  }
  EXPECT_GT(lengthwise, 2.0 * across);
  EXPECT_NEAR(all.mean_level(), -30.0, 1.0) << "on average as bright as without";
  EXPECT_LT(all.ratio(), 1.85);
}

TEST(Speckle, few_scatterers_make_it_uneven_and_leave_its_energy) {
  double last = 1.95;
  for (const double density : {1.0, 0.2, 0.05}) {
    Ultrasound machine(scattering_block(scattering(-30.0, density)), checks::flat_probe(), speckle_settings(),
                       speckle_detail(1));
    Envelope all;
    for (int number = 0; number < 4; ++number) all.add(machine.image(speckle_pose(number)), 15.0, 35.0);
    EXPECT_LT(all.ratio(), last) << "density " << density;
    last = all.ratio() - 0.1;
    EXPECT_NEAR(all.energy_level(), -30.0 + 1.05, 0.5) << "density " << density;
  }
}

// Full width at half maximum of the intensity's autocorrelation. A Gaussian spread function of width w gives speckle
// whose intensity correlates over the same w.
double correlation_width(const std::vector<double>& correlation) {
  std::size_t lag = 1;
  while (lag + 1 < correlation.size() && correlation[lag] > 0.5 * correlation[0]) ++lag;
  const double above = correlation[lag - 1], below = correlation[lag];
  return 2.0 * (static_cast<double>(lag) - 1.0 + (above - 0.5 * correlation[0]) / (above - below));
}

TEST(Speckle, is_as_large_as_the_point_spread_function) {
  if (sanitized) GTEST_SKIP() << "many pictures for one number";
  constexpr double spacing = 0.1;
  for (const int slices : {1, 3}) {
    const UltrasoundSettings settings = speckle_settings();
    Ultrasound machine(scattering_block(scattering(-30.0)), checks::flat_probe(), settings,
                       speckle_detail(slices, spacing));
    for (const double depth : {12.0, 25.0, 42.0}) {
      std::vector<double> lateral(30, 0.0), axial(12, 0.0);
      for (int number = 0; number < 5; ++number) {
        const UltrasoundFrame& frame = machine.image(speckle_pose(number));
        const auto rows = static_cast<int>(4.0 / spacing), columns = frame.width - 2 * 40;
        const int first_row = static_cast<int>(depth / spacing) - rows / 2;
        std::vector<double> energy;
        double mean = 0.0;
        for (int row = 0; row < rows; ++row) {
          for (int column = 0; column < columns; ++column) {
            energy.push_back(std::pow(checks::amplitude(frame, speckle_range, column + 40, row + first_row), 2));
            mean += energy.back();
          }
        }
        mean /= static_cast<double>(energy.size());
        const auto at = [&](int row, int column) {
          return energy[static_cast<std::size_t>(row * columns + column)] - mean;
        };
        for (int row = 0; row < rows; ++row) {
          for (int column = 0; column < columns; ++column) {
            for (int lag = 0; lag < 30 && column + lag < columns; ++lag)
              lateral[static_cast<std::size_t>(lag)] += at(row, column) * at(row, column + lag) / (columns - lag);
            for (int lag = 0; lag < 12 && row + lag < rows; ++lag)
              axial[static_cast<std::size_t>(lag)] += at(row, column) * at(row + lag, column) / (rows - lag);
          }
        }
      }
      const UltrasoundBeam beam = ultrasound_beam(checks::flat_probe(), settings);
      EXPECT_NEAR(spacing * correlation_width(axial), beam.pulse, 0.15 * beam.pulse) << depth << " mm";
      EXPECT_NEAR(spacing * correlation_width(lateral), beam.lateral(depth), 0.15 * beam.lateral(depth))
          << depth << " mm";
    }
  }
}

TEST(Speckle, stays_in_the_patient_when_the_probe_moves) {
  Ultrasound machine(scattering_block(scattering(-30.0)), checks::flat_probe(), speckle_settings(),
                     speckle_detail(3));
  const auto picture = [&](const Vec3& point) { return machine.image(checks::moved_to(point)); };
  const UltrasoundFrame here = picture(Vec3::Zero());
  const auto correlation = [&here](const UltrasoundFrame& there, int shift) {
    double n = 0.0, a = 0.0, b = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;
    for (int row = 20; row < here.height; ++row) {
      for (int column = 16; column + shift + 16 < here.width; ++column) {
        const double x = checks::amplitude(here, speckle_range, column + shift, row),
                     y = checks::amplitude(there, speckle_range, column, row);
        n += 1.0, a += x, b += y, aa += x * x, bb += y * y, ab += x * y;
      }
    }
    return (ab / n - a * b / n / n) / std::sqrt((aa / n - a * a / n / n) * (bb / n - b * b / n / n));
  };
  for (const int lines : {1, 8, 50})
    EXPECT_GT(correlation(picture(Vec3(0.25 * lines, 0.0, 0.0)), lines), 0.9) << lines << " lines";
  EXPECT_LT(correlation(picture(Vec3(12.5, 0.0, 0.0)), 0), 0.2) << "and only there";
  // Across the slice it changes with the slice's thickness, and does not repeat where the scatterers do.
  const UltrasoundBeam beam = ultrasound_beam(checks::flat_probe(), speckle_settings());
  const double block = scan::cells * 0.5 * beam.pulse;
  for (const double off : {2.0 * beam.elevation(30.0), block, 2.0 * block, 3.0 * block})
    EXPECT_LT(correlation(picture(Vec3(0.0, 0.0, off)), 0), 0.3) << off << " mm across the slice";
}

}  // namespace
}  // namespace bodkin
