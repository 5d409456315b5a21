#include "simulation/operator_script.h"

#include <sstream>

#include "core/error.h"

namespace bodkin::simulation {

namespace {

// The parts one after the other, numbers as people write them.
template <typename... Parts>
std::string sentence(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

class Checker {
 public:
  explicit Checker(const std::string& origin) : origin_(origin) {}

  void range(const std::string& what, double value, double low, double high) const {
    if (value >= low && value <= high) return;
    fail(sentence(what, " is ", value, ", expected ", low, " to ", high));
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
  const auto value = [&](const std::optional<double>& given, const char* name, double low, double high) {
    if (!given) return;
    any = true;
    checker.range(name + of, *given, low, high);
  };
  value(condition.time, "the time (s)", 0.0, 3600.0);
  value(condition.travel, "the travel (mm)", 0.0, 1000.0);
  value(condition.depth_above, "the depth (mm)", -1000.0, 1000.0);
  value(condition.depth_below, "the depth (mm)", -1000.0, 1000.0);
  value(condition.remaining_below, "the remaining distance (mm)", -1000.0, 1000.0);
  value(condition.force_above, "the force (N)", -100.0, 100.0);
  value(condition.force_below, "the force (N)", -100.0, 100.0);
  value(condition.force_drop, "the drop of force (N)", 0.01, 100.0);
  value(condition.hardness_above, "the hardness (N/mm)", 0.001, 1000.0);
  value(condition.drop_share, "the share of the drop", 0.01, 100.0);
  value(condition.force_above_share, "the share of the force", 0.01, 100.0);
  if (condition.has_share() == condition.share_of.empty())
    checker.fail(sentence("a condition of phase '", phase, "' has ",
                          condition.has_share() ? "a share, but of no tissue" : "a tissue, but no share of its force",
                          "; expected both or neither"));
  if (!any) checker.fail(sentence("a condition of phase '", phase, "' says nothing to wait for"));
}

void check_phase(const OperatorPhase& phase, int phases, const Checker& checker) {
  const std::string of = " of phase '" + phase.name + "'";
  checker.range("the speed (mm/s)" + of, phase.speed, -200.0, 200.0);
  checker.range("the acceleration (mm/s^2)" + of, phase.acceleration, 1.0, 1e5);
  checker.range("the step (mm)" + of, phase.step, 0.0, 100.0);
  checker.range("the pause (s)" + of, phase.pause, 0.0, 60.0);
  checker.range("the tilt (rad)" + of, phase.tilt, -0.8, 0.8);
  checker.range("the shift (mm)" + of, phase.shift, -100.0, 100.0);
  checker.range("the twirl (rad)" + of, phase.twirl, 0.0, 12.6);
  checker.range("the rate of the twirl (Hz)" + of, phase.twirl_rate, 0.1, 5.0);
  checker.range("the number of times" + of, phase.at_most, 0, 1000);
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
  checker.range("the error of aim (mm)", script.aim_position, 0.0, 50.0);
  checker.range("the error of the angle (rad)", script.aim_angle, 0.0, 0.5);
  checker.range("the reaction time (s)", script.reaction, 0.0, 5.0);
  checker.range("the spread of the reaction time (s)", script.reaction_spread, 0.0, 2.0);
  checker.range("the unsteadiness", script.unsteadiness, 0.0, 2.0);
  checker.range("the wander (mm)", script.wander, 0.0, 20.0);
  checker.range("the wander of the angle (rad)", script.wander_angle, 0.0, 0.5);
  checker.range("the distance at the start (mm)", script.start_distance, 1.0, 200.0);
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
