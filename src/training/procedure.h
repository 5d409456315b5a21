#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/parameter.h"
#include "core/settings_check.h"
#include "training/thresholds.h"

namespace bodkin::training {

// The verdict on an attempt, from best to worst.
enum class Grade : std::uint8_t { pass, borderline, fail, dangerous };
constexpr std::array<std::string_view, 4> enumeration_names(Grade) {
  return {"pass", "borderline", "fail", "dangerous"};
}
constexpr std::string_view name_of(Grade grade) {
  return enumeration_names(grade)[static_cast<std::size_t>(grade)];
}
constexpr Grade worse(Grade one, Grade other) {
  return one > other ? one : other;
}

// The criterion for reaching a procedure's goal.
enum class GoalKind : std::uint8_t {
  rest,        // the tip's final position lies in a tissue
  touch,       // the tip was in a tissue
  event,       // something happened that defines success
  near_target  // the tip's final position lies near the planned target
};
constexpr std::array<std::string_view, 4> enumeration_names(GoalKind) {
  return {"rest", "touch", "event", "near_target"};
}

// Whether withdrawing the needle wholly from the body ends an attempt.
enum class WithdrawalEnds : std::uint8_t {
  after_goal,  // once the goal was reached; before, the needle may be inserted again
  always,
  never
};
constexpr std::array<std::string_view, 3> enumeration_names(WithdrawalEnds) {
  return {"after_goal", "always", "never"};
}

struct Goal {
  GoalKind by = GoalKind::rest;
  std::string tissue;
  std::string event;
  double within = 0.0;

  template <typename S = Goal>
  static constexpr auto parameters() {
    return std::tuple{Parameter{"by", &S::by, "what shows that the aim was reached", Origin::choice},
                      Parameter{"tissue", &S::tissue, "of rest and touch", Origin::choice},
                      Parameter{"event", &S::event, "of event, as sessions name it: fluid_returned", Origin::choice},
                      Parameter{"within_mm", &S::within, Range{0.0, 100.0}, "mm",
                                "of near_target; 0: the tolerance of the case", Origin::choice}};
  }
  template <typename S = Goal>
  static constexpr auto relations() {
    return std::tuple{
        Relation<S>{[](const S& goal) {
                      return (goal.by == GoalKind::rest || goal.by == GoalKind::touch) == !goal.tissue.empty();
                    },
                    "the tissue does not fit what the goal is known by, expected one with rest and touch alone"},
        Relation<S>{[](const S& goal) { return (goal.by == GoalKind::event) == !goal.event.empty(); },
                    "the event does not fit what the goal is known by, expected one with event alone"}};
  }
};

// A step of the procedure, and how a session shows that it was reached.
struct Step {
  std::string title;
  std::string tissue;
  std::string event;
  std::string shown;
  std::string text;

  template <typename S = Step>
  static constexpr auto parameters() {
    return std::tuple{Parameter{"title", &S::title, "as people read it", Origin::choice},
                      Parameter{"tissue", &S::tissue, "reached when the tip is first in it", Origin::choice},
                      Parameter{"event", &S::event, "reached when this first happens", Origin::choice},
                      Parameter{"shown", &S::shown,
                                "reached when the ultrasound first shows it: target, a landmark of the case, or "
                                "spinous_process_L3",
                                Origin::choice},
                      Parameter{"text", &S::text, "what to do and what to feel", Origin::choice}};
  }
  template <typename S = Step>
  static constexpr auto relations() {
    return std::tuple{Relation<S>{
        [](const S& step) {
          return (step.tissue.empty() ? 0 : 1) + (step.event.empty() ? 0 : 1) + (step.shown.empty() ? 0 : 1) <= 1;
        },
        "the step has more than one of tissue, event and shown, expected one of them or "
        "none"}};
  }
};

// A tissue, or a structure of the patient's segmentation, that the tip must not enter.
struct Forbidden {
  std::string tissue;
  std::string structure;
  std::string title;
  Grade grade = Grade::dangerous;
  double margin = 0.0;
  std::string consequence;

  template <typename S = Forbidden>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"tissue", &S::tissue, "that the tip must not be in", Origin::choice},
        Parameter{"structure", &S::structure, "name of a structure that the tip must not be in", Origin::choice},
        Parameter{"title", &S::title, "as people read it: the cord or a nerve root", Origin::choice},
        Parameter{"grade", &S::grade, "of an attempt that entered it", Origin::choice},
        Parameter{"margin_mm", &S::margin, Range{0.0, 10.0}, "mm", "a tip that came closer is borderline; 0: none",
                  Origin::choice},
        Parameter{"consequence", &S::consequence, "what it does to a patient", Origin::choice}};
  }
  template <typename S = Forbidden>
  static constexpr auto relations() {
    return std::tuple{Relation<S>{[](const S& one) { return one.tissue.empty() != one.structure.empty(); },
                                  "expected either a tissue or a structure"},
                      Relation<S>{[](const S& one) { return one.grade != Grade::pass; },
                                  "the grade is pass, expected borderline, fail or dangerous for what is forbidden"}};
  }
};

// The required range of a metric. Inside `pass_from` to `pass_to` the grade is a pass, else inside `borderline_from`
// to `borderline_to` borderline, else `beyond`. A session without the metric is graded `absent`.
struct Rule {
  std::string metric;
  double pass_from = -unbounded;
  double pass_to = unbounded;
  double borderline_from = -unbounded;
  double borderline_to = unbounded;
  Grade beyond = Grade::fail;
  std::string advice;
  Grade absent = Grade::pass;
  std::string absent_says;

  template <typename S = Rule>
  static constexpr auto parameters() {
    constexpr Range any = {-unbounded, unbounded};
    return std::tuple{
        Parameter{"metric", &S::metric, "name of the metric", Origin::choice},
        Parameter{"pass_from", &S::pass_from, any, "", "least value that passes", Origin::choice},
        Parameter{"pass_to", &S::pass_to, any, "", "greatest value that passes", Origin::choice},
        Parameter{"borderline_from", &S::borderline_from, any, "", "least value that is borderline", Origin::choice},
        Parameter{"borderline_to", &S::borderline_to, any, "", "greatest value that is borderline", Origin::choice},
        Parameter{"beyond", &S::beyond, "grade of any other value", Origin::choice},
        Parameter{"advice", &S::advice, "what to do better", Origin::choice},
        Parameter{"absent", &S::absent, "grade of a session that has no value of it", Origin::choice},
        Parameter{"absent_says", &S::absent_says, "what is said then", Origin::choice}};
  }
  template <typename S = Rule>
  static constexpr auto relations() {
    return std::tuple{
        Relation<S>{[](const S& rule) { return (rule.absent == Grade::pass) == rule.absent_says.empty(); },
                    "absent and absent_says do not fit, expected both or neither"},
        AtMost{&S::pass_from, &S::pass_to}, AtMost{&S::borderline_from, &S::pass_from},
        AtMost{&S::pass_to, &S::borderline_to}};
  }

  // The grade of a value; a value that is not a number is `beyond`.
  Grade grade_of(double value) const noexcept {
    if (value >= pass_from && value <= pass_to) return Grade::pass;
    return value >= borderline_from && value <= borderline_to ? Grade::borderline : beyond;
  }
};

// A procedure as described in its file (docs/training.md): its steps, its goal, what is forbidden, and the criteria
// for a pass. It is independent of a patient: the path, the target and the needle are the case's.
struct Procedure {
  std::string name = "procedure";
  std::string title;
  std::string description;
  std::string levels;  // interspaces that may be entered, names of landmarks separated by blanks; empty: any
  std::string expert = "expert";  // simulated expert operator, see session::load_operator
  std::string needle;             // usual one: "GAUGE,LENGTH,TIP"; empty: the case's
  int thickest_gauge = 10;
  int thinnest_gauge = 34;
  WithdrawalEnds withdrawal_ends = WithdrawalEnds::after_goal;
  std::vector<Step> steps;
  std::vector<Goal> goals;  // any one suffices
  std::vector<Forbidden> forbidden;
  std::vector<Rule> rules;
  Thresholds thresholds;

  template <typename S = Procedure>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"name", &S::name, "as cases name it", Origin::choice},
        Parameter{"title", &S::title, "as people read it", Origin::choice},
        Parameter{"description", &S::description, "what it is for", Origin::choice},
        Parameter{"levels", &S::levels, "interspaces that may be entered, as landmarks name them; empty: any place",
                  Origin::choice},
        Parameter{"expert", &S::expert, "simulated operator who is good at it", Origin::choice},
        Parameter{"needle", &S::needle, "that is usual: GAUGE,LENGTH,TIP; empty: the case chooses", Origin::choice},
        Parameter{"thickest_gauge", &S::thickest_gauge, Range{10.0, 34.0}, "", "of a needle that is usual",
                  Origin::choice},
        Parameter{"thinnest_gauge", &S::thinnest_gauge, Range{10.0, 34.0}, "", "of a needle that is usual",
                  Origin::choice},
        Parameter{"taken_out_ends", &S::withdrawal_ends,
                  "when a needle that is drawn wholly out ends the attempt: after_goal, always or never",
                  Origin::choice},
        ChildElements{"step", &S::steps, "a stage of it, in order", 50},
        ChildElements{"goal", &S::goals, "what reaches its aim", 10},
        ChildElements{"forbidden", &S::forbidden, "what the tip must not enter", 100},
        ChildElements{"rule", &S::rules, "what a metric must be", 100},
        ChildElement{"thresholds", &S::thresholds, "from where on something counts in its metrics"}};
  }
  template <typename S = Procedure>
  static constexpr auto relations() {
    return std::tuple{
        Relation<S>{
            [](const S& procedure) { return procedure.thickest_gauge <= procedure.thinnest_gauge; },
            "thickest_gauge is greater than thinnest_gauge, expected at most that: a thick needle has a small "
            "gauge"},
        Relation<S>{[](const S& procedure) { return !procedure.goals.empty(); },
                    "there is no goal, expected at least one"}};
  }
};

}  // namespace bodkin::training
