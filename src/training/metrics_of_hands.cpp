#include <algorithm>
#include <cmath>
#include <vector>

#include "training/metric_groups.h"

namespace bodkin::training {

namespace {

constexpr double turn_span = 0.05;          // s over which a rotation is taken, so that noise does not add up
constexpr std::size_t fewest_samples = 10;  // of a correlation

std::size_t ticks_in(double seconds, const Attempt& attempt) {
  return static_cast<std::size_t>(std::max(1.0, std::round(seconds / attempt.dt())));
}

double count_of_actions(const std::vector<double>& speed, double interval, double fast, double lasting) {
  const std::vector<char> active = in_action(speed, interval, fast, lasting);
  double count = 0.0;
  for (std::size_t i = 0; i < active.size(); ++i)
    count += active[i] != 0 && (i == 0 || active[i - 1] == 0) ? 1.0 : 0.0;
  return count;
}

std::optional<double> translational_actions(const Measured& measured) {
  const Thresholds& least = measured.attempt.thresholds();
  return count_of_actions(speeds(measured.motion), measured.motion.interval, least.quick_speed, least.action_time);
}

std::optional<double> rotational_actions(const Measured& measured) {
  const Attempt& attempt = measured.attempt;
  const std::size_t stride = ticks_in(turn_span, attempt);
  const double interval = static_cast<double>(stride) * attempt.dt();
  const auto& ticks = attempt.session().ticks;
  std::vector<double> speed;
  for (std::size_t i = stride; i < attempt.size(); i += stride) {
    const Mat3 step = ticks[i - stride].input.needle.linear().transpose() * ticks[i].input.needle.linear();
    speed.push_back(std::abs(Eigen::AngleAxisd(step).angle()) / degree / interval);
  }
  return count_of_actions(speed, interval, attempt.thresholds().quick_turn, attempt.thresholds().action_time);
}

// Turning about the needle's own axis.
std::optional<double> spin(const Measured& measured) {
  return with_insertion(measured, [](const Attempt& attempt) {
    const std::size_t stride = ticks_in(turn_span, attempt);
    const auto& ticks = attempt.session().ticks;
    double sum = 0.0;
    for (std::size_t i = stride; i < attempt.size(); i += stride) {
      if (attempt.inside[i] == 0 || attempt.inside[i - stride] == 0) continue;
      const Eigen::Quaterniond turn(
          Mat3(ticks[i - stride].input.needle.linear().transpose() * ticks[i].input.needle.linear()));
      const double angle = 2.0 * std::abs(std::atan2(turn.z(), turn.w())) / degree;
      sum += std::min(angle, 360.0 - angle);
    }
    return sum;
  });
}

std::optional<double> sawing(const Measured& measured) {
  const Attempt& attempt = measured.attempt;
  if (attempt.insertions.empty()) return std::nullopt;
  const double deepest =
      std::max_element(attempt.insertions.begin(), attempt.insertions.end(),
                       [](const Insertion& a, const Insertion& b) { return a.deepest < b.deepest; })
          ->deepest;
  const auto travel = find_metric("travel_along_mm")->compute(measured);
  return travel && deepest > 0.0 ? std::optional(*travel / deepest) : std::nullopt;
}

// Pearson's correlation of the speeds of needle and second hand between the second hand's samples: each speed from
// the tool's own positions at the two times.
std::optional<double> hands_together(const Measured& measured) {
  const Attempt& attempt = measured.attempt;
  const session::Session& session = attempt.session();
  if (!session.header.second || session.second.size() <= fewest_samples) return std::nullopt;
  const double start = static_cast<double>(session.ticks.front().tick) * attempt.dt();
  const auto tip_at = [&](double time) {
    const auto place = std::lower_bound(attempt.time.begin(), attempt.time.end(), time - start);
    const auto i = static_cast<std::size_t>(place - attempt.time.begin());
    return attempt.hand[std::min(i, attempt.size() - 1)];
  };
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, yy = 0.0, xy = 0.0;
  for (std::size_t i = 1; i < session.second.size(); ++i) {
    const session::SecondSample &before = session.second[i - 1], &now = session.second[i];
    const double time = now.time - before.time;
    if (time <= 0.0) continue;
    const double hand = (now.position - before.position).norm() / time;
    const double needle = (tip_at(now.time) - tip_at(before.time)).norm() / time;
    n += 1.0;
    x += hand;
    y += needle;
    xx += hand * hand;
    yy += needle * needle;
    xy += hand * needle;
  }
  const double spread_x = n * xx - x * x, spread_y = n * yy - y * y;
  // A hand that did not move has no correlation; the bound is the rounding error of its variance.
  if (n < static_cast<double>(fewest_samples) || spread_x <= 1e-9 * n * xx || spread_y <= 1e-9 * n * yy)
    return std::nullopt;
  return (n * xy - x * y) / std::sqrt(spread_x * spread_y);
}

}  // namespace

std::vector<Metric> metrics_of_hands() {
  return {
      {"translational_actions", "", "quick movements of the tip",
       "times that the filtered tip was faster than 50 mm/s for over 0.2 s, with at least as long a rest in between",
       "PerkTutor, Translational Actions, by the speed of the tip", translational_actions},
      {"rotational_actions", "", "quick turns of the needle",
       "times that it turned by over 50 deg/s for over 0.2 s, over 50 ms, with at least as long a rest in between",
       "PerkTutor, Rotational Actions", rotational_actions},
      {"spin_deg", "deg", "turning about the shaft in the body",
       "sum of the turns about the needle's own axis, 50 ms apart", "PerkTutor, Rotation Total, the spin alone",
       spin},
      {"sawing", "", "travel along the shaft over the greatest depth",
       "1 for a needle that only goes in, 2 when it is drawn out too", "Bodkin", sawing},
      {"hands_together", "", "how the two hands move together",
       "Pearson's correlation of the speeds of needle and second hand, between the second hand's samples",
       "PerkTutor, Bimanual Dexterity", hands_together}};
}

}  // namespace bodkin::training
