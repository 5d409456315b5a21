#include "training/sentences.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace bodkin::training {

namespace {

constexpr double on_target = 0.05;     // mm
constexpr double warning_way = 5.0;    // mm before the expected depth from which slow advance is required
constexpr double careful_speed = 5.0;  // mm/s

std::string times(int count) {
  return count == 2 ? "twice" : fmt::format("{} times", count);
}

std::string event_words(const std::string& event, bool to_come) {
  struct Words {
    const char* event;
    const char* past;
    const char* to_come;
  };
  constexpr std::array<Words, 9> known = {
      {{"fluid_returned", "let cerebrospinal fluid return", "let cerebrospinal fluid return"},
       {"loss_of_resistance", "lost the resistance of the ligamentum flavum",
        "lose the resistance of the ligamentum flavum"},
       {"pressure_lost", "let the syringe's plunger give way", "let the syringe's plunger give way"},
       {"palpated", "felt a place on the skin", "feel a place on the skin"},
       {"pressure_read", "let the pressure be read", "let the pressure be read"},
       {"bone_contact", "met bone", "meet bone"},
       {"hub_contact", "pushed the needle in up to its hub", "push the needle in up to its hub"},
       {"needle_buckled", "pushed harder than the needle bears", "push less, so that the needle stays straight"},
       {"contact", "touched the body", "touch the body"}}};
  for (const Words& each : known)
    if (event == each.event) return to_come ? each.to_come : each.past;
  return fmt::format("{} to the event {}", to_come ? "come" : "came", event);
}

std::string number(const Metric& metric, double value) {
  return metric.unit.empty() ? fmt::format("{:g}", value) : fmt::format("{:g} {}", value, metric.unit);
}

std::string what_passes(const Rule& rule, const Metric& metric) {
  const bool low = std::isfinite(rule.pass_from), high = std::isfinite(rule.pass_to);
  if (low && high) {
    return rule.pass_from == rule.pass_to
               ? fmt::format("{} passes", number(metric, rule.pass_to))
               : fmt::format("{:g} to {} passes", rule.pass_from, number(metric, rule.pass_to));
  }
  return low ? fmt::format("at least {} passes", number(metric, rule.pass_from))
             : fmt::format("at most {} passes", number(metric, rule.pass_to));
}

std::string first_upper(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

std::string title_of_tissue(const std::string& name, const Attempt& attempt) {
  const auto id = attempt.find_tissue(name);
  return id ? attempt.title_of(*id) : name;
}

}  // namespace

std::string goal_words(const Goal& goal, const Attempt& attempt, bool to_come) {
  switch (goal.by) {
    case GoalKind::rest:
      return fmt::format("{} to rest in the {}", to_come ? "come" : "came", title_of_tissue(goal.tissue, attempt));
    case GoalKind::touch:
      return fmt::format("{} the {}", to_come ? "touch" : "touched", title_of_tissue(goal.tissue, attempt));
    case GoalKind::event:
      return event_words(goal.event, to_come);
    case GoalKind::near_target:
      break;
  }
  const double within = goal.within > 0.0 ? goal.within : attempt.description().procedure.target_tolerance;
  return fmt::format("{} within {:g} mm of the target", to_come ? "end" : "ended", within);
}

std::string harm_sentence(const Harm& harm) {
  if (!harm.entered) {
    return fmt::format("The tip came within {:.1f} mm of {} at {:.1f} s, {:.0f} mm deep.", harm.closest, harm.title,
                       harm.first_time, harm.first_depth);
  }
  std::string sentence =
      fmt::format("The tip entered {} at {:.1f} s, {:.0f} mm deep", harm.title, harm.first_time, harm.first_depth);
  if (harm.entries > 1) sentence += ", and " + times(harm.entries) + " in all";
  if (!harm.consequence.empty()) sentence += fmt::format(": {}", harm.consequence);
  return sentence + ".";
}

std::string rule_sentence(const Rule& rule, const Metric& metric, double value) {
  std::string sentence = fmt::format("{}: {}; {}.", first_upper(std::string(metric.title)),
                                     metric_text(metric, value), what_passes(rule, metric));
  if (!rule.advice.empty()) sentence += " " + rule.advice;
  return sentence;
}

std::string loss_sentence(const Puncture& loss, bool too_far) {
  const std::string what = loss.kind == forces::EventKind::loss_of_resistance ? "You crossed the ligamentum flavum"
                                                                              : "The plunger gave way";
  if (!too_far) {
    return fmt::format("{} at {:.1f} mm and stopped {:.1f} mm further, after {:.2f} s.", what, loss.depth,
                       loss.overshoot, loss.reaction);
  }
  return fmt::format(
      "{} at {:.1f} mm and went {:.1f} mm further before you stopped, at up to {:.0f} mm/s; below {:.0f} mm/s after "
      "{:.0f} "
      "mm you can stop in time.",
      what, loss.depth, loss.overshoot, loss.speed, careful_speed, std::max(0.0, loss.depth - warning_way));
}

std::string ending_sentence(const FinalPosition& final_tip, const Attempt& attempt) {
  const TargetError error = target_error(final_tip.tip, attempt.path());
  const std::string where = final_tip.tissue == anatomy::tissue::air
                                ? std::string()
                                : fmt::format(" in the {}", attempt.title_of(final_tip.tissue));
  const std::string ending = final_tip.is_rest
                                 ? fmt::format("The tip came to rest{}", where)
                                 : fmt::format("The tip never came to rest; its deepest point lies{}", where);
  if (error.distance < on_target) return ending + ", on the planned target.";
  return fmt::format("{}, {:.1f} mm from the planned target: {:.1f} mm {} and {:.1f} mm to the side.", ending,
                     error.distance, std::abs(error.axial), error.axial >= 0.0 ? "too deep" : "short of it",
                     error.lateral);
}

std::string scanned_sentence(const std::vector<session::ScannedPart>& parts) {
  if (parts.empty()) return "The ultrasound showed nothing that the procedure names.";
  std::string names;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::string name = parts[i].name;
    std::replace(name.begin(), name.end(), '_', ' ');
    names += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + name;
  }
  return fmt::format("The ultrasound showed {}.", names);
}

}  // namespace bodkin::training
