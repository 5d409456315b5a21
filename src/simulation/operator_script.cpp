#include "simulation/operator_script.h"

#include <sstream>

#include "core/error.h"
#include "core/settings_check.h"

namespace bodkin::simulation {

namespace {

// The parts in turn, numbers as people write them.
template <typename... Parts>
std::string sentence(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

class Checker {
 public:
  explicit Checker(const std::string& origin) : origin_(origin) {}

  void range(const std::string& what, double value, const Range& allowed, const char* unit) const {
    check_range(origin_, what, value, allowed, unit);
  }
  [[noreturn]] void fail(const std::string& fault) const { throw InputError(origin_ + ": " + fault); }

 private:
  const std::string& origin_;
};

void check_condition(const OperatorCondition& condition, const std::string& phase, int phases,
                     const Checker& checker) {
  const std::string of = " of a condition of phase '" + phase + "'";
  if (condition.next != OperatorCondition::end && (condition.next < 0 || condition.next >= phases)) {
    checker.fail(
        sentence("phase '", phase, "' is followed by phase number ", condition.next, ", but there are ", phases));
  }
  bool any = false;
  const auto value = [&](const std::optional<double>& given, const char* name, const Range& range, const char* unit) {
    if (!given) return;
    any = true;
    checker.range(name + of, *given, range, unit);
  };
  value(condition.time, "time", {0.0, 3600.0}, "s");
  value(condition.travel, "travel", {0.0, 1000.0}, "mm");
  value(condition.depth_above, "depth", {-1000.0, 1000.0}, "mm");
  value(condition.depth_below, "depth", {-1000.0, 1000.0}, "mm");
  value(condition.remaining_below, "remaining distance", {-1000.0, 1000.0}, "mm");
  value(condition.force_above, "force", {-100.0, 100.0}, "N");
  value(condition.force_below, "force", {-100.0, 100.0}, "N");
  value(condition.force_drop, "drop of force", {0.01, 100.0}, "N");
  value(condition.hardness_above, "hardness", {0.001, 1000.0}, "N/mm");
  value(condition.drop_share, "share of the drop", {0.01, 100.0}, "");
  value(condition.force_above_share, "share of the force", {0.01, 100.0}, "");
  if (condition.has_share() == condition.share_of.empty())
    checker.fail(sentence("a condition of phase '", phase, "' has ",
                          condition.has_share() ? "a share, but of no tissue" : "a tissue, but no share of its force",
                          "; expected both or neither"));
  if (!any) checker.fail(sentence("a condition of phase '", phase, "' says nothing to wait for"));
}

void check_phase(const OperatorPhase& phase, int phases, const Checker& checker) {
  const std::string of = " of phase '" + phase.name + "'";
  checker.range("speed" + of, phase.speed, {-200.0, 200.0}, "mm/s");
  checker.range("acceleration" + of, phase.acceleration, {1.0, 1e5}, "mm/s^2");
  checker.range("step" + of, phase.step, {0.0, 100.0}, "mm");
  checker.range("pause" + of, phase.pause, {0.0, 60.0}, "s");
  checker.range("tilt" + of, phase.tilt, {-0.8, 0.8}, "rad");
  checker.range("shift" + of, phase.shift, {-100.0, 100.0}, "mm");
  checker.range("twirl" + of, phase.twirl, {0.0, 12.6}, "rad");
  checker.range("rate of the twirl" + of, phase.twirl_rate, {0.1, 5.0}, "Hz");
  checker.range("number of times" + of, phase.at_most, {0.0, 1000.0}, "");
  if (phase.until.empty()) checker.fail(sentence("phase '", phase.name, "' never ends, it has no condition"));
  for (const OperatorCondition& condition : phase.until) check_condition(condition, phase.name, phases, checker);
}

}  // namespace

void check(const OperatorScript& script, const std::string& origin) {
  const Checker checker(origin);
  try {
    haptics::check(script.hand);
  } catch (const InputError& error) {
    checker.fail(error.what());
  }
  checker.range("error of aim", script.aim_position, {0.0, 50.0}, "mm");
  checker.range("error of the angle", script.aim_angle, {0.0, 0.5}, "rad");
  checker.range("reaction time", script.reaction, {0.0, 5.0}, "s");
  checker.range("spread of the reaction time", script.reaction_spread, {0.0, 2.0}, "s");
  checker.range("unsteadiness", script.unsteadiness, {0.0, 2.0}, "");
  checker.range("wander", script.wander, {0.0, 20.0}, "mm");
  checker.range("wander of the angle", script.wander_angle, {0.0, 0.5}, "rad");
  checker.range("distance at the start", script.start_distance, {1.0, 200.0}, "mm");
  if (script.phases.empty()) checker.fail("there is no phase, expected at least one");
  const int phases = static_cast<int>(script.phases.size());
  for (const OperatorPhase& phase : script.phases) {
    check_phase(phase, phases, checker);
    const bool known =
        phase.otherwise == OperatorCondition::end || (phase.otherwise >= 0 && phase.otherwise < phases);
    if (!known) checker.fail(sentence("phase '", phase.name, "' gives way to a phase that does not exist"));
  }
}

}  // namespace bodkin::simulation
