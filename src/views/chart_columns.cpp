#include "views/chart_columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace bodkin::views {

ChartCurve::ChartCurve(double first_step, std::size_t most_steps)
    : first_step_(first_step), step_(first_step), most_steps_(std::max<std::size_t>(2, most_steps)) {}

void ChartCurve::clear() {
  columns_.clear();
  step_ = first_step_;
  range_ = {};
  joined_ = false;
}

void ChartCurve::join_pieces() {
  step_ *= 2.0;
  const std::size_t half = (columns_.size() + 1) / 2;
  for (std::size_t i = 0; i < half; ++i) {
    ChartColumn both = columns_[2 * i];
    if (2 * i + 1 < columns_.size()) both.add(columns_[2 * i + 1]);
    columns_[i] = both;
  }
  columns_.resize(half);
}

void ChartCurve::put(std::size_t piece, float value) {
  if (piece >= columns_.size()) columns_.resize(piece + 1);
  columns_[piece].add(value);
}

void ChartCurve::add(double place, double value) {
  if (!(place >= 0.0) || !std::isfinite(place) || !std::isfinite(value)) return;
  while (place >= step_ * static_cast<double>(most_steps_)) join_pieces();
  const auto piece_of = [&](double at) { return static_cast<std::size_t>(at / step_); };
  const std::size_t piece = piece_of(place);
  if (joined_) {
    // Each intermediate piece gets the line's value at its middle.
    const std::size_t before = piece_of(place_);
    const std::size_t low = std::min(piece, before), high = std::max(piece, before);
    for (std::size_t i = low + 1; i < high; ++i) {
      const double share = ((static_cast<double>(i) + 0.5) * step_ - place_) / (place - place_);
      put(i, static_cast<float>(value_ + share * (value - value_)));
    }
  }
  put(piece, static_cast<float>(value));
  range_.add(static_cast<float>(value));
  joined_ = true;
  place_ = place;
  value_ = value;
}

std::vector<ChartColumn> ChartCurve::columns(double from, double to, std::size_t count) const {
  std::vector<ChartColumn> found(count);
  if (count == 0 || !(to > from)) return found;
  const double wide = (to - from) / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double begin = from + wide * static_cast<double>(i), end = begin + wide;
    if (end <= 0.0) continue;
    const auto first = static_cast<std::size_t>(std::max(0.0, std::floor(begin / step_)));
    const auto last = static_cast<std::size_t>(std::max(0.0, std::ceil(end / step_)));
    for (std::size_t piece = first; piece < std::min(last, columns_.size()); ++piece) found[i].add(columns_[piece]);
  }
  return found;
}

double ChartCurve::usual_most(std::size_t spikes) const {
  constexpr std::size_t count = 512;
  std::vector<float> tops;
  for (const ChartColumn& column : columns(0.0, std::max(reach(), step_), count)) {
    if (!column.empty()) tops.push_back(column.most);
  }
  if (tops.empty()) return 0.0;
  std::sort(tops.begin(), tops.end(), std::greater<>());
  const double rest = tops[std::min(spikes, tops.size() - 1)];
  return tops.front() > 2.0 * rest && tops.size() > 10 * spikes ? rest : static_cast<double>(tops.front());
}

double axis_end(double most, double least) {
  const double needed = std::max(most, least);
  if (!(needed > 0.0) || !std::isfinite(needed)) return 1.0;
  const double decade = std::pow(10.0, std::floor(std::log10(needed)));
  constexpr std::array<double, 7> steps = {1.0, 2.0, 4.0, 5.0, 6.0, 8.0, 10.0};
  for (const double step : steps) {
    if (step * decade >= needed * (1.0 - 1e-12)) return step * decade;
  }
  return 10.0 * decade;
}

double axis_step(double end, int count) {
  const double rough = end / std::max(1, count);
  if (!(rough > 0.0)) return 1.0;
  const double decade = std::pow(10.0, std::floor(std::log10(rough)));
  constexpr std::array<double, 4> steps = {1.0, 2.0, 5.0, 10.0};
  for (const double step : steps) {
    if (step * decade >= rough * (1.0 - 1e-12)) return step * decade;
  }
  return 10.0 * decade;
}

}  // namespace bodkin::views
