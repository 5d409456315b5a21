#include "training/motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bodkin::training {

namespace {

constexpr double cut_off = 10.0;         // Hz
constexpr double rate = 100.0;           // Hz
constexpr double filter_width = 3.0;     // standard deviations to each side
constexpr double shortest_motion = 0.1;  // s
constexpr int window = 100;              // samples of a spectrum, at `rate`: 1 Hz between its lines
constexpr int lowest_line = 4;           // Hz
constexpr int highest_line = 12;         // Hz

// Means of the tip over 10 ms: the band of a spectrum at 100 Hz, with negligible aliasing.
struct Means {
  std::vector<Vec3> tip;
  std::vector<char> inside;  // all ticks of it
};

Means means_of(const Attempt& attempt) {
  const auto stride = static_cast<std::size_t>(std::max(1.0, std::round(1.0 / (rate * attempt.dt()))));
  Means means;
  for (std::size_t first = 0; first + stride <= attempt.size(); first += stride) {
    Vec3 sum = Vec3::Zero();
    bool inside = true;
    for (std::size_t i = first; i < first + stride; ++i) {
      sum += attempt.hand[i];
      inside = inside && attempt.inside[i] != 0;
    }
    means.tip.push_back(sum / static_cast<double>(stride));
    means.inside.push_back(inside ? 1 : 0);
  }
  return means;
}

// Adds the power of one window to `power` (mm^2, by line).
void add_window(const std::vector<Vec3>& tip, std::size_t first, std::array<double, highest_line + 1>& power) {
  static const std::array<double, window> weight = [] {
    std::array<double, window> hann{};
    for (int i = 0; i < window; ++i)
      hann[static_cast<std::size_t>(i)] = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * (i + 0.5) / window);
    return hann;
  }();
  // The trend: a line by least squares.
  Vec3 mean = Vec3::Zero(), slope = Vec3::Zero();
  double squares = 0.0;
  for (int i = 0; i < window; ++i) {
    const double x = i - 0.5 * (window - 1);
    mean += tip[first + static_cast<std::size_t>(i)] / window;
    slope += x * tip[first + static_cast<std::size_t>(i)];
    squares += x * x;
  }
  slope /= squares;
  double weights = 0.0;
  for (const double each : weight) weights += each * each;
  for (int line = lowest_line; line <= highest_line; ++line) {
    Vec3 cosine = Vec3::Zero(), sine = Vec3::Zero();
    for (int i = 0; i < window; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const double phase = 2.0 * std::numbers::pi * line * i / window, x = i - 0.5 * (window - 1);
      const Vec3 value = weight[at] * (tip[first + at] - mean - x * slope);
      cosine += std::cos(phase) * value;
      sine += std::sin(phase) * value;
    }
    // One-sided, so that the lines of a window add up to its mean square.
    power[static_cast<std::size_t>(line)] += 2.0 * (cosine.squaredNorm() + sine.squaredNorm()) / (weights * window);
  }
}

struct Jerk {
  double duration = 0.0;  // s
  double fastest = 0.0;   // mm/s
  double squares = 0.0;   // mm^2/s^5, integral of the squared jerk
};

// From the first point in the body to the one at `until`, by central differences; nothing for less than 0.1 s.
std::optional<Jerk> jerk_until(const Motion& motion, double until) {
  std::size_t first = 0;
  while (first < motion.tip.size() && motion.inside[first] == 0) ++first;
  std::size_t last = first;
  while (last + 1 < motion.tip.size() && motion.time[last + 1] <= until) ++last;
  const double h = motion.interval;
  Jerk found{.duration = static_cast<double>(last - first) * h};
  if (last <= first || found.duration < shortest_motion) return std::nullopt;
  for (std::size_t i = first + 2; i + 2 <= last; ++i) {
    const Vec3 third = (motion.tip[i + 2] - 2.0 * motion.tip[i + 1] + 2.0 * motion.tip[i - 1] - motion.tip[i - 2]) /
                       (2.0 * h * h * h);
    found.squares += third.squaredNorm() * h;
    found.fastest = std::max(found.fastest, (motion.tip[i + 1] - motion.tip[i - 1]).norm() / (2.0 * h));
  }
  return found;
}

}  // namespace

Motion filtered_motion(const Attempt& attempt) {
  const double sigma = std::sqrt(std::numbers::ln2) / (2.0 * std::numbers::pi * cut_off);  // s
  const auto half = static_cast<std::ptrdiff_t>(std::ceil(filter_width * sigma / attempt.dt()));
  std::vector<double> weights;
  for (std::ptrdiff_t k = -half; k <= half; ++k) {
    const double x = static_cast<double>(k) * attempt.dt() / sigma;
    weights.push_back(std::exp(-0.5 * x * x));
  }
  const auto stride = static_cast<std::size_t>(std::max(1.0, std::round(1.0 / (rate * attempt.dt()))));
  Motion motion;
  motion.interval = static_cast<double>(stride) * attempt.dt();
  const auto count = static_cast<std::ptrdiff_t>(attempt.size());
  for (std::size_t i = 0; i < attempt.size(); i += stride) {
    Vec3 sum = Vec3::Zero();
    double weight = 0.0;
    for (std::ptrdiff_t k = -half; k <= half; ++k) {
      const std::ptrdiff_t j = static_cast<std::ptrdiff_t>(i) + k;
      if (j < 0 || j >= count) continue;
      sum += weights[static_cast<std::size_t>(k + half)] * attempt.hand[static_cast<std::size_t>(j)];
      weight += weights[static_cast<std::size_t>(k + half)];
    }
    motion.time.push_back(attempt.time[i]);
    motion.tip.push_back(sum / weight);
    motion.inside.push_back(attempt.inside[i]);
  }
  return motion;
}

double path_length(const Motion& motion) {
  double length = 0.0;
  for (std::size_t i = 1; i < motion.tip.size(); ++i) {
    if (motion.inside[i] != 0 && motion.inside[i - 1] != 0) length += (motion.tip[i] - motion.tip[i - 1]).norm();
  }
  return length;
}

std::vector<double> speeds(const Motion& motion) {
  std::vector<double> found(motion.tip.size(), 0.0);
  for (std::size_t i = 1; i + 1 < motion.tip.size(); ++i)
    found[i] = (motion.tip[i + 1] - motion.tip[i - 1]).norm() / (2.0 * motion.interval);
  return found;
}

std::vector<double> turning_speeds(const Attempt& attempt, const Motion& motion) {
  constexpr double span = 0.05;  // s
  const auto& ticks = attempt.session().ticks;
  const auto half = static_cast<std::size_t>(std::max(1.0, std::round(0.5 * span / attempt.dt())));
  const auto stride = static_cast<std::size_t>(std::max(1.0, std::round(motion.interval / attempt.dt())));
  std::vector<double> found(motion.tip.size(), 0.0);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::size_t middle = std::min(i * stride, attempt.size() - 1);
    const std::size_t before = middle - std::min(middle, half), after = std::min(middle + half, attempt.size() - 1);
    if (after == before) continue;
    const Mat3 turn = ticks[before].input.needle.linear().transpose() * ticks[after].input.needle.linear();
    // The angle by its sine and cosine, both exact for a small rotation.
    const Vec3 sine(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0), turn(1, 0) - turn(0, 1));
    const double angle = std::atan2(sine.norm(), turn.trace() - 1.0) / degree;
    found[i] = angle / (static_cast<double>(after - before) * attempt.dt());
  }
  return found;
}

std::vector<char> in_action(const std::vector<double>& speed, double interval, double fast, double lasting) {
  std::vector<char> active(speed.size(), 0);
  char state = 0;
  std::size_t since = 0;  // where the speed last changed sides
  for (std::size_t i = 0; i < speed.size(); ++i) {
    const char side = speed[i] > fast ? 1 : 0;
    if (side == state) since = i + 1;
    active[i] = state;
    if (static_cast<double>(i + 1 - since) * interval <= lasting) continue;
    state = side;
    for (std::size_t k = since; k <= i; ++k) active[k] = state;
    since = i + 1;
  }
  return active;
}

std::vector<char> needle_in_action(const Attempt& attempt, const Motion& motion) {
  const Thresholds& least = attempt.thresholds();
  std::vector<char> active = in_action(speeds(motion), motion.interval, least.action_speed, least.action_time);
  const std::vector<char> turning =
      in_action(turning_speeds(attempt, motion), motion.interval, least.action_turn, least.action_time);
  for (std::size_t i = 0; i < active.size(); ++i) active[i] = active[i] != 0 || turning[i] != 0 ? 1 : 0;
  return active;
}

std::optional<double> smoothness(const Motion& motion, double until) {
  const std::optional<Jerk> found = jerk_until(motion, until);
  if (!found || !(found->fastest > 0.0) || !(found->squares > 0.0)) return std::nullopt;
  const double duration = found->duration;
  return -std::log(duration * duration * duration / (found->fastest * found->fastest) * found->squares);
}

std::optional<double> root_of_jerk(const Motion& motion, double until) {
  const std::optional<Jerk> found = jerk_until(motion, until);
  return found ? std::optional(std::sqrt(found->squares)) : std::nullopt;
}

std::optional<Tremor> tremor(const Attempt& attempt) {
  const Means means = means_of(attempt);
  std::array<double, highest_line + 1> power{};
  int windows = 0;
  for (std::size_t first = 0; first + window <= means.tip.size(); first += window / 2) {
    const auto begin = means.inside.begin() + static_cast<std::ptrdiff_t>(first);
    if (!std::all_of(begin, begin + window, [](char inside) { return inside != 0; })) continue;
    add_window(means.tip, first, power);
    ++windows;
  }
  if (windows == 0) return std::nullopt;
  Tremor found;
  double sum = 0.0, strongest = -1.0;
  for (int line = lowest_line; line <= highest_line; ++line) {
    const double here = power[static_cast<std::size_t>(line)] / windows;
    sum += here;
    if (here > strongest) {
      strongest = here;
      found.frequency = line;
    }
  }
  found.amplitude = std::sqrt(sum);
  return found;
}

}  // namespace bodkin::training
