// Statistics of grey levels with known closed forms.
#include "imaging/ultrasound_screen/grey_statistics.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {

using namespace bodkin::imaging;
namespace {

GreyImage grey_image_of(int width, int height, double pixel) {
  GreyImage picture{width, height, pixel, 0.0, {}};
  picture.pixels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  return picture;
}

PixelWindow all_of(const GreyImage& picture) {
  return {0, 0, picture.width, picture.height};
}

std::vector<double> gaussian_weights(double sigma) {
  std::vector<double> weights;
  double squares = 0.0;
  for (int k = static_cast<int>(-4.0 * sigma); k <= 4.0 * sigma; ++k) {
    weights.push_back(std::exp(-0.5 * k * k / (sigma * sigma)));
    squares += weights.back() * weights.back();
  }
  for (double& weight : weights) weight /= std::sqrt(squares);
  return weights;
}

// Normal noise of mean 128 and standard deviation 30, smoothed by Gaussians of two widths (pixels).
GreyImage smoothed_noise(int width, int height, double pixel, double across, double down, std::uint64_t seed) {
  const std::vector<double> rows = gaussian_weights(down), columns = gaussian_weights(across);
  const int wide = width + static_cast<int>(columns.size()) - 1, high = height + static_cast<int>(rows.size()) - 1;
  Random random(seed);
  std::vector<double> noise(static_cast<std::size_t>(wide) * static_cast<std::size_t>(high));
  for (double& value : noise) value = random.normal();
  const auto at = [wide](int column, int row) { return static_cast<std::size_t>(row * wide + column); };
  std::vector<double> smooth(noise.size(), 0.0);
  for (int row = 0; row < high; ++row) {
    for (int column = 0; column < width; ++column) {
      for (int k = 0; k < static_cast<int>(columns.size()); ++k) {
        smooth[at(column, row)] += columns[static_cast<std::size_t>(k)] * noise[at(column + k, row)];
      }
    }
  }
  GreyImage picture = grey_image_of(width, height, pixel);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      double sum = 0.0;
      for (int k = 0; k < static_cast<int>(rows.size()); ++k) {
        sum += rows[static_cast<std::size_t>(k)] * smooth[at(column, row + k)];
      }
      picture.pixels[static_cast<std::size_t>(row * width + column)] =
          static_cast<std::uint8_t>(std::clamp(std::round(128.0 + 30.0 * sum), 0.0, 255.0));
    }
  }
  return picture;
}

TEST(GreyStatistics, smoothed_noise_is_as_wide_and_as_bright_as_it_was_made) {
  for (const auto& [across, down] : {std::pair(4.0, 2.5), std::pair(2.5, 6.0)}) {
    const double pixel = 0.08;
    const GreyImage picture = smoothed_noise(500, 500, pixel, across, down, 3);
    const GreyStatistics greys = grey_statistics(picture, all_of(picture));
    // The autocorrelation of white noise under a Gaussian is exp(-x^2 / (4 sigma^2)), a half at 2 sigma sqrt(ln 2).
    const double half = 2.0 * std::sqrt(std::numbers::ln2);
    ASSERT_TRUE(greys.across && greys.along);
    EXPECT_NEAR(*greys.across, half * across * pixel, 0.04 * half * across * pixel);
    EXPECT_NEAR(*greys.along, half * down * pixel, 0.04 * half * down * pixel);
    const std::array<double, 5> normal = {-1.6449, -0.6745, 0.0, 0.6745, 1.6449};  // of these shares
    for (std::size_t i = 0; i < normal.size(); ++i) EXPECT_NEAR(greys.percentiles[i], 128.0 + 30.0 * normal[i], 3.0);
  }
}

TEST(GreyStatistics, white_noise_correlates_with_nothing_but_itself) {
  GreyImage picture = grey_image_of(300, 200, 0.1);
  Random random(5);
  for (std::uint8_t& grey : picture.pixels) grey = static_cast<std::uint8_t>(random.uniform(0.0, 256.0));
  const GreyStatistics greys = grey_statistics(picture, all_of(picture));
  EXPECT_NEAR(greys.across.value(), 0.05, 0.002);  // linear from 1 to 0 in one pixel
  EXPECT_NEAR(greys.along.value(), 0.05, 0.002);
  const std::array<double, 5> uniform = {12.8, 64.0, 128.0, 192.0, 243.2};
  for (std::size_t i = 0; i < uniform.size(); ++i) EXPECT_NEAR(greys.percentiles[i], uniform[i], 4.0);
}

TEST(GreyStatistics, a_wave_falls_to_a_half_at_a_sixth_of_its_length) {
  // Long, because the overlap at a lag is not a whole number of waves: at 8 of 4800 columns that shifts the half by
  // about a hundredth of a column.
  constexpr int columns = 4800;
  GreyImage picture = grey_image_of(columns, 16, 0.25);
  for (int row = 0; row < 16; ++row) {
    for (int column = 0; column < columns; ++column) {
      picture.pixels[static_cast<std::size_t>(columns * row + column)] =
          static_cast<std::uint8_t>(std::lround(128.0 + 100.0 * std::cos(2.0 * std::numbers::pi * column / 48.0)));
    }
  }
  const GreyStatistics greys = grey_statistics(picture, all_of(picture));
  EXPECT_NEAR(greys.across.value(), 8.0 * 0.25, 0.01);
  EXPECT_FALSE(greys.along.has_value()) << "along the columns all are equal: the correlation stays 1";
}

TEST(GreyStatistics, one_grey_has_percentiles_and_no_width) {
  GreyImage picture = grey_image_of(40, 30, 0.1);
  std::fill(picture.pixels.begin(), picture.pixels.end(), std::uint8_t{77});
  const GreyStatistics greys = grey_statistics(picture, {5, 6, 20, 10});
  for (const int grey : greys.percentiles) EXPECT_EQ(grey, 77);
  EXPECT_FALSE(greys.across);
  EXPECT_FALSE(greys.along);
}

TEST(GreyStatistics, percentiles_are_the_least_grey_that_so_many_do_not_exceed) {
  GreyImage picture = grey_image_of(20, 20, 1.0);
  for (std::size_t i = 0; i < 400; ++i)
    picture.pixels[i] = i < 20 ? 0 : i < 100 ? 10 : i < 200 ? 20 : i < 301 ? 30 : 255;
  const std::array<int, 5> expected = {0, 10, 20, 30, 255};
  EXPECT_EQ(grey_statistics(picture, all_of(picture)).percentiles, expected);
}

TEST(GreyWindow, is_where_it_says_in_millimetres) {
  GreyImage picture = grey_image_of(101, 80, 0.5);
  picture.top = -5.0;
  // The middle of the picture is column 50, the face row 10.
  const auto window = pixels_in(picture, {10.0, 15.0, 10.0, 8.0});
  ASSERT_TRUE(window);
  EXPECT_EQ(window->left, 60);
  EXPECT_EQ(window->width, 21);
  EXPECT_EQ(window->top, 32);
  EXPECT_EQ(window->height, 17);
  for (const GreyWindow& bad :
       {GreyWindow{24.0, 15.0, 10.0, 8.0}, GreyWindow{-24.0, 15.0, 10.0, 8.0}, GreyWindow{0.0, 33.0, 10.0, 8.0},
        GreyWindow{0.0, -4.0, 10.0, 8.0}, GreyWindow{0.0, 15.0, 3.0, 8.0}, GreyWindow{0.0, 15.0, 10.0, 3.0},
        GreyWindow{std::nan(""), 15.0, 10.0, 8.0}, GreyWindow{0.0, 15.0, 1e300, 8.0}}) {
    EXPECT_FALSE(pixels_in(picture, bad)) << bad.across << ", " << bad.depth;
  }
}

TEST(GreyImage, of_a_frame_has_its_marked_side_where_it_is_wanted) {
  UltrasoundFrame frame;
  frame.width = 3;
  frame.height = 2;
  frame.pixel = 0.5;
  frame.corner = Vec3(-0.5, -1.0, 0.0);
  frame.pixels = {1, 2, 3, 4, 5, 6};  // columns go to the marked side
  const GreyImage right = grey_of(frame, OrientationMarkerSide::right),
                  left = grey_of(frame, OrientationMarkerSide::left);
  EXPECT_EQ(right.pixels, frame.pixels);
  EXPECT_EQ(left.pixels, (std::vector<std::uint8_t>{3, 2, 1, 6, 5, 4}));
  EXPECT_EQ(left.top, -1.0);
}

}  // namespace
}  // namespace bodkin
