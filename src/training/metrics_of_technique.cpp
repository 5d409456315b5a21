#include <algorithm>
#include <cmath>

#include "training/metric_groups.h"

namespace bodkin::training {

namespace {

constexpr std::size_t fewest_turns = 5;  // of a motion to and fro: two whole cycles

struct Oscillation {
  double amplitude = 0.0;  // from one end to the other, median
  double frequency = 0.0;  // Hz
  double scatter = 0.0;    // standard deviation of the way from one end to the other
  double far_end = 0.0;    // where the maxima lie, median
};

struct Turn {
  double time = 0.0, value = 0.0;
};

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Turning points of a curve by at least `least`: maxima and minima alternately. The parts before the first and after
// the last are the way in and out.
std::optional<Oscillation> oscillation(const std::vector<Turn>& curve, double least) {
  std::vector<Turn> turns;
  if (curve.empty()) return std::nullopt;
  Turn low = curve.front(), high = curve.front();
  int direction = 0;  // 1: rising
  for (const Turn& here : curve) {
    if (here.value > high.value) high = here;
    if (here.value < low.value) low = here;
    if (direction >= 0 && high.value - here.value >= least) {
      turns.push_back(high);
      direction = -1;
      low = here;
      high = here;
    } else if (direction <= 0 && here.value - low.value >= least) {
      if (direction < 0) turns.push_back(low);
      direction = 1;
      low = here;
      high = here;
    }
  }
  if (turns.size() < fewest_turns) return std::nullopt;
  std::vector<double> ways, times;
  for (std::size_t i = 1; i < turns.size(); ++i) {
    ways.push_back(std::abs(turns[i].value - turns[i - 1].value));
    times.push_back(turns[i].time - turns[i - 1].time);
  }
  double mean = 0.0, squares = 0.0;
  for (const double way : ways) mean += way / static_cast<double>(ways.size());
  for (const double way : ways) squares += (way - mean) * (way - mean);
  std::vector<double> maxima;
  const bool begins_high = turns[0].value > turns[1].value;
  for (std::size_t i = begins_high ? 0 : 1; i < turns.size(); i += 2) maxima.push_back(turns[i].value);
  return Oscillation{median_of(ways), 0.5 / median_of(times),
                     std::sqrt(squares / static_cast<double>(ways.size() - 1)), median_of(maxima)};
}

// Depth along the planned path, of the filtered motion.
std::optional<Oscillation> lifting(const Measured& measured) {
  const Attempt& attempt = measured.attempt;
  if (attempt.insertions.empty() || attempt.path().length() <= 0.0) return std::nullopt;
  const Vec3 along = attempt.path().direction();
  std::vector<Turn> curve;
  for (std::size_t i = 0; i < measured.motion.tip.size(); ++i) {
    if (measured.motion.inside[i] != 0)
      curve.push_back({measured.motion.time[i], (measured.motion.tip[i] - attempt.path().entry).dot(along)});
  }
  return oscillation(curve, attempt.thresholds().lift);
}

// Rotation about the needle's own axis, summed over 10 ms at a time.
std::optional<Oscillation> twirling(const Measured& measured) {
  const Attempt& attempt = measured.attempt;
  constexpr double interval = 0.01;  // s
  const auto stride = static_cast<std::size_t>(std::max(1.0, std::round(interval / attempt.dt())));
  std::vector<Turn> curve;
  double angle = 0.0;
  for (std::size_t i = stride; i < attempt.size(); i += stride) {
    if (attempt.inside[i] == 0 || attempt.inside[i - stride] == 0) continue;
    const auto& ticks = attempt.session().ticks;
    const Mat3 step = ticks[i - stride].input.needle.linear().transpose() * ticks[i].input.needle.linear();
    const Eigen::Quaterniond turn(step);
    angle += 2.0 * std::atan2(turn.z(), turn.w()) / degree;
    if (turn.w() < 0.0) angle -= turn.z() > 0.0 ? 360.0 : -360.0;
    curve.push_back({attempt.time[i], angle});
  }
  return oscillation(curve, attempt.thresholds().twirl);
}

std::optional<double> lift_amplitude(const Measured& measured) {
  const auto found = lifting(measured);
  return found ? std::optional(found->amplitude) : std::nullopt;
}
std::optional<double> lift_frequency(const Measured& measured) {
  const auto found = lifting(measured);
  return found ? std::optional(found->frequency) : std::nullopt;
}
std::optional<double> lift_scatter(const Measured& measured) {
  const auto found = lifting(measured);
  return found ? std::optional(found->scatter) : std::nullopt;
}
std::optional<double> thrust_depth(const Measured& measured) {
  const auto found = lifting(measured);
  return found ? std::optional(found->far_end - measured.attempt.path().length()) : std::nullopt;
}
std::optional<double> twirl_amplitude(const Measured& measured) {
  const auto found = twirling(measured);
  return found ? std::optional(found->amplitude) : std::nullopt;
}
std::optional<double> twirl_frequency(const Measured& measured) {
  const auto found = twirling(measured);
  return found ? std::optional(found->frequency) : std::nullopt;
}

}  // namespace

std::vector<Metric> metrics_of_technique() {
  return {
      {"lift_thrust_mm", "mm", "amplitude of lifting and thrusting",
       "median distance between neighbouring turns of at least 0.5 mm along the planned path, filtered motion; from "
       "two whole cycles on",
       "Evid.-Based Compl. Alt. Med. 2019, 1725936", lift_amplitude},
      {"lift_thrust_Hz", "Hz", "frequency of lifting and thrusting",
       "reciprocal of the median cycle, which is a thrust and a lift", "Evid.-Based Compl. Alt. Med. 2019, 1725936",
       lift_frequency},
      {"lift_thrust_scatter_mm", "mm", "unevenness of lifting and thrusting",
       "standard deviation of the distances between these turns", "Evid.-Based Compl. Alt. Med. 2019, 1725936",
       lift_scatter},
      {"thrust_depth_mm", "mm", "depth of the thrusts beyond the target",
       "median depth of the lower turns along the planned path, less that of the target; negative: too shallow",
       "PLoS ONE 2015, 0117992, depth error", thrust_depth},
      {"twirl_deg", "deg", "amplitude of twirling",
       "median angle between neighbouring turns of at least 10 deg about the needle's axis; from two whole cycles on",
       "Bodkin", twirl_amplitude},
      {"twirl_Hz", "Hz", "frequency of twirling", "reciprocal of the median cycle", "Bodkin", twirl_frequency}};
}

}  // namespace bodkin::training
