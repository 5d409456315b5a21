#include "imaging/ultrasound_screen/grey_statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace bodkin::imaging {

namespace {

constexpr int least_side = 8;  // pixels of a window
constexpr std::array<double, 5> shares = {0.05, 0.25, 0.50, 0.75, 0.95};

// The grey levels of a window minus their mean, row by row.
struct Deviations {
  int width = 0, height = 0;
  std::vector<double> values;

  double at(int column, int row) const {
    return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
  }
  // Mean product of values at a distance in columns and rows.
  double covariance(int columns, int rows) const {
    double sum = 0.0;
    for (int row = 0; row + rows < height; ++row) {
      for (int column = 0; column + columns < width; ++column) {
        sum += at(column, row) * at(column + columns, row + rows);
      }
    }
    return sum / (static_cast<double>(width - columns) * (height - rows));
  }
};

// Pixels at which the correlation has fallen to a half, linear between whole ones.
std::optional<double> half_width(const Deviations& greys, int column_step, int row_step) {
  const double whole = greys.covariance(0, 0);
  if (!(whole > 0.0)) return std::nullopt;
  const int farthest = (column_step > 0 ? greys.width : greys.height) / 2;
  double before = 1.0;
  for (int lag = 1; lag <= farthest; ++lag) {
    const double here = greys.covariance(lag * column_step, lag * row_step) / whole;
    if (here <= 0.5) return lag - 1 + (before - 0.5) / (before - here);
    before = here;
  }
  return std::nullopt;
}

}  // namespace

GreyImage grey_of(const UltrasoundFrame& frame, OrientationMarkerSide mark) {
  GreyImage picture{frame.width, frame.height, frame.pixel, frame.corner.y(), frame.pixels};
  if (mark != OrientationMarkerSide::left) return picture;
  for (std::ptrdiff_t row = 0; row < frame.height; ++row) {
    const auto begin = picture.pixels.begin() + row * frame.width;
    std::reverse(begin, begin + frame.width);
  }
  return picture;
}

std::optional<PixelWindow> pixels_in(const GreyImage& picture, const GreyWindow& window) {
  const double left = picture.column(window.across - 0.5 * window.width);
  const double right = picture.column(window.across + 0.5 * window.width);
  const double top = picture.row(window.depth - 0.5 * window.height);
  const double bottom = picture.row(window.depth + 0.5 * window.height);
  const bool inside = left >= -1.0 && top >= -1.0 && right <= picture.width && bottom <= picture.height;
  if (!inside) return std::nullopt;  // NaN, too
  PixelWindow found;
  found.left = std::max(0, static_cast<int>(std::ceil(left)));
  found.top = std::max(0, static_cast<int>(std::ceil(top)));
  found.width = std::min(picture.width - 1, static_cast<int>(std::floor(right))) - found.left + 1;
  found.height = std::min(picture.height - 1, static_cast<int>(std::floor(bottom))) - found.top + 1;
  if (found.width < least_side || found.height < least_side) return std::nullopt;
  return found;
}

GreyStatistics grey_statistics(const GreyImage& picture, const PixelWindow& window) {
  std::array<std::size_t, 256> count{};
  Deviations greys{window.width, window.height, {}};
  double sum = 0.0;
  for (int row = window.top; row < window.top + window.height; ++row) {
    for (int column = window.left; column < window.left + window.width; ++column) {
      const std::uint8_t grey =
          picture.pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                         static_cast<std::size_t>(column)];
      ++count[grey];
      greys.values.push_back(grey);
      sum += grey;
    }
  }
  const auto all = static_cast<double>(greys.values.size());
  for (double& value : greys.values) value -= sum / all;
  GreyStatistics statistics;
  for (std::size_t share = 0; share < shares.size(); ++share) {
    std::size_t below = count[0];
    int grey = 0;
    while (static_cast<double>(below) < shares[share] * all && grey < 255) {
      below += count[static_cast<std::size_t>(++grey)];
    }
    statistics.percentiles[share] = grey;
  }
  const std::optional<double> across = half_width(greys, 1, 0), along = half_width(greys, 0, 1);
  if (across) statistics.across = *across * picture.pixel;
  if (along) statistics.along = *along * picture.pixel;
  return statistics;
}

}  // namespace bodkin::imaging
