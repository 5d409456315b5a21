#include "study/needle_motion.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.h"
#include "core/parameter_value.h"

namespace bodkin::study {

namespace {

constexpr Range depths = {-10.0, 500.0};  // mm
constexpr Range speeds = {0.5, 500.0};    // mm/s
constexpr Range holds = {0.0, 600.0};     // s
constexpr std::size_t most_steps = 1000;
constexpr std::string_view blanks = " \t\n";

// The words of a step.
std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t from = text.find_first_not_of(blanks); from != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(blanks, from), text.size());
    words.push_back(text.substr(from, end - from));
    from = text.find_first_not_of(blanks, end);
  }
  return words;
}

class StepReader {
 public:
  StepReader(std::string_view text, std::size_t number, const std::string& option)
      : words_(words_of(text)), number_(number), option_(option) {}

  MotionStep read() const {
    const bool moves = words_.size() == 1 || (words_.size() == 3 && words_[1] == "at");
    const bool holds_still = words_.size() == 2 && words_[0] == "hold";
    if (!moves && !holds_still) fail("DEPTH, target or out, with 'at SPEED' if wished, or 'hold SECONDS'");
    MotionStep step;
    if (holds_still) {
      step.goal = MotionGoal::hold;
      step.time = number(words_[1], holds, "s");
      return step;
    }
    if (words_[0] == "out") {
      step.goal = MotionGoal::outside;
    } else if (words_[0] != "target") {
      step.goal = MotionGoal::depth;
      step.depth = number(words_[0], depths, "mm below the skin");
    }
    if (words_.size() == 3) step.speed = number(words_[2], speeds, "mm/s");
    return step;
  }

 private:
  [[noreturn]] void fail(const std::string& expected) const {
    throw InputError(
        fmt::format("{}: step {} is '{}', expected {}", option_, number_, fmt::join(words_, " "), expected));
  }
  double number(std::string_view word, const Range& range, const char* unit) const {
    double value = 0.0;
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool read = failure == std::errc() && end == word.data() + word.size();
    if (!read || !range.contains(value))
      fail(fmt::format("a number from {:g} to {:g} {} for '{}'", range.low, range.high, unit, word));
    return value;
  }

  std::vector<std::string_view> words_;
  std::size_t number_;
  const std::string& option_;
};

bool moves(const MotionStep& step) {
  return step.goal != MotionGoal::hold;
}

}  // namespace

NeedleMotion parse_motion(std::string_view text, const std::string& option) {
  NeedleMotion motion;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t end = std::min(text.find_first_of(",;", from), text.size());
    motion.push_back(StepReader(text.substr(from, end - from), motion.size() + 1, option).read());
    if (motion.size() > most_steps)
      throw InputError(fmt::format("{}: more than {} steps, expected at most so many", option, most_steps));
    from = end + 1;
  }
  const bool enters = std::any_of(motion.begin(), motion.end(), [](const MotionStep& step) {
    return step.goal == MotionGoal::target || (step.goal == MotionGoal::depth && step.depth > 0.0);
  });
  if (!enters)
    throw InputError(fmt::format("{}: no step goes below the skin, expected a depth above 0 mm or target", option));
  return motion;
}

StraightPath path_of_motion(const anatomy::Case& patient, const std::optional<Vec3>& entry,
                            const std::optional<Vec3>& target, const NeedleMotion& motion, double beyond) {
  StraightPath line = straight_path(patient, entry, target, beyond);
  double deepest = 0.0;
  bool to_target = motion.empty();
  for (const MotionStep& step : motion) {
    to_target = to_target || step.goal == MotionGoal::target;
    if (step.goal == MotionGoal::depth) deepest = std::max(deepest, line.surface + step.depth);
  }
  const double whole = line.path.length() + beyond;
  if (deepest > whole) return straight_path(patient, entry, target, deepest - line.path.length());
  if (!to_target) {
    // The hub meets the skin after the motion has turned, so nothing is reported.
    if (line.ends_at_hub && deepest <= line.end) {
      line.ends_at_hub = false;
      line.notes.pop_back();
    }
    line.end = std::min(line.end, deepest);
  }
  return line;
}

double end_of_step(const MotionStep& step, const StraightPath& line, double from) {
  switch (step.goal) {
    case MotionGoal::depth:
      return std::min(line.surface + step.depth, line.end);
    case MotionGoal::target:
      return line.end;
    case MotionGoal::outside:
      return line.outside;
    case MotionGoal::hold:
      break;
  }
  return from;
}

double duration_of(const NeedleMotion& motion, const StraightPath& line, double speed, double deepest) {
  double time = 0.0, here = line.start;
  for (const MotionStep& step : motion) {
    const double next = moves(step) ? std::min(end_of_step(step, line, here), deepest) : here;
    time += step.time + std::abs(next - here) / step.speed.value_or(speed);
    here = next;
  }
  return time;
}

MotionTicks ticks_of(const NeedleMotion& motion, const StraightPath& line, double speed, double dt, double deepest) {
  MotionTicks ticks;
  ticks.places = {line.start};
  double been = line.start;  // the deepest place so far
  const auto begin = [&](MotionPhase phase) {
    ticks.parts.push_back(phase);
    ticks.first.push_back(ticks.parts.size() == 1 ? 0 : ticks.places.size());
  };
  for (const MotionStep& step : motion) {
    const double here = ticks.places.back();
    if (!moves(step)) {
      begin(MotionPhase::stop);
      ticks.places.insert(ticks.places.end(), static_cast<std::size_t>(std::lround(step.time / dt)), here);
      continue;
    }
    const double end = std::min(end_of_step(step, line, here), deepest);
    if (end == here) continue;
    const std::vector<double> part = places_between(here, end, step.speed.value_or(speed) * dt);
    auto known = part.end();  // as far as the tip has been before
    if (end > here) known = std::find_if(part.begin(), part.end(), [&](double place) { return place > been; });
    if (known != part.begin()) begin(end > here ? MotionPhase::reinsertion : MotionPhase::withdrawal);
    ticks.places.insert(ticks.places.end(), part.begin(), known);
    if (known != part.end()) begin(MotionPhase::insertion);
    ticks.places.insert(ticks.places.end(), known, part.end());
    been = std::max(been, end);
  }
  ticks.first.push_back(ticks.places.size());
  return ticks;
}

}  // namespace bodkin::study
