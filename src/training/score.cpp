#include "training/score.h"

#include <algorithm>

#include "session/tick_codec.h"
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.h"
#include "training/interspace.h"
#include "training/metric_groups.h"
#include "training/scan_guide.h"
#include "training/sentences.h"

namespace bodkin::training {

namespace {

constexpr double longest_gap = 0.005;  // s of lost ticks in the body that can hide nothing

bool is_event_of(const session::SessionEvent& each, const std::string& name) {
  return session::event_kind_name(each.event.kind) == name;
}

// Whether a name is one of those in a blank-separated text.
bool is_among(std::string_view names, std::string_view name) {
  for (std::size_t at = names.find(name); at != std::string_view::npos; at = names.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    if ((at == 0 || names[at - 1] == ' ') && (end == names.size() || names[end] == ' ')) return true;
  }
  return false;
}

// Every tissue and structure that a procedure names.
std::vector<std::string> named_parts(const Procedure& procedure) {
  std::vector<std::string> names;
  for (const Step& step : procedure.steps) names.push_back(step.tissue);
  for (const Goal& goal : procedure.goals) names.push_back(goal.tissue);
  for (const Forbidden& each : procedure.forbidden)
    names.push_back(each.tissue.empty() ? each.structure : each.tissue);
  return names;
}

class Scorer {
 public:
  Scorer(const Attempt& attempt, const Procedure& procedure, const PatientVolumes& volumes, const ExpertSet* experts)
      : attempt_(attempt),
        procedure_(procedure),
        volumes_(volumes),
        experts_(experts),
        measured_(attempt, named_parts(procedure)) {}

  Score judge() {
    score_.procedure = procedure_.name;
    score_.title = procedure_.title;
    score_.expert = procedure_.expert;
    score_.tissues = measured_.tissues;
    score_.punctures = measured_.punctures;
    score_.final_tip = attempt_.final_tip;
    score_.thresholds = procedure_.thresholds;
    score_.experts = experts_ == nullptr ? 0 : experts_->size();
    const HarmReport harm = find_harm(attempt_, procedure_, volumes_);
    score_.harms = harm.harms;
    score_.distances = harm.distances;
    for (const ForbiddenDistance& each : harm.distances)
      if (each.closest)
        measured_.nearest_forbidden = std::min(*each.closest, measured_.nearest_forbidden.value_or(*each.closest));
    measure();
    follow_steps();
    for (const Harm& each : harm.harms) add(each.grade, "harm", harm_sentence(each));
    if (attempt_.insertions.empty()) {
      add(Grade::fail, "goal", "The needle never touched the body.");
    } else {
      if (!harm.unchecked.empty()) {
        add(Grade::borderline, "harm",
            fmt::format("The patient's segmentation is not available, so it could not be checked whether the tip "
                        "entered {}; name the case with --case.",
                        fmt::join(harm.unchecked, ", ")));
      }
      find_goal();
      add(Grade::pass, "goal", ending_sentence(*attempt_.final_tip, attempt_));
      report_loss();
      if (attempt_.session().header.ultrasound)
        add(Grade::pass, "structures_scanned", scanned_sentence(measured_.scanned));
      find_level();
      check_needle();
      report_thresholds();
      check_parts();
      rules();
    }
    check_recording();
    finish();
    return std::move(score_);
  }

 private:
  void add(Grade grade, const std::string& subject, std::string sentence) {
    score_.findings.push_back({grade, subject, std::move(sentence)});
  }

  void measure() {
    for (const Metric& metric : all_metrics()) {
      const std::optional<double> value = metric.compute(measured_);
      if (!value) continue;
      MetricResult result{.metric = &metric, .value = *value, .grade = {}, .experts = {}};
      if (experts_ != nullptr) result.experts = experts_->place(metric.name, *value);
      score_.metrics.push_back(result);
    }
  }

  std::optional<std::size_t> first_in(const std::string& tissue, std::size_t from = 0) const {
    const auto id = attempt_.find_tissue(tissue);
    if (!id) {
      require_known_tissue(tissue, procedure_);
      return std::nullopt;
    }
    std::optional<std::size_t> first;
    for (std::size_t i = from; i < attempt_.size() && !first; ++i)
      if (attempt_.inside[i] != 0 && attempt_.tissue[i] == *id) first = i;
    // A tip that jumps through a ligament is in it at no tick.
    for (const session::SessionEvent& each : attempt_.session().events) {
      if (each.event.kind != forces::EventKind::tissue_entered || each.event.tissue != *id) continue;
      const std::size_t at = attempt_.index_of(each);
      if (at >= from && (!first || at < *first)) first = at;
    }
    return first;
  }

  std::optional<std::size_t> first_event(const std::string& name, std::size_t from = 0) const {
    for (const session::SessionEvent& each : attempt_.session().events) {
      if (!is_event_of(each, name)) continue;
      const std::size_t at = attempt_.index_of(each);
      if (at >= from) return at;
    }
    return std::nullopt;
  }

  // Each step is searched after the one before: a needle that only touched the skin was not withdrawn.
  void follow_steps() {
    std::size_t from = 0;
    for (const Step& step : procedure_.steps) {
      StepResult result{.title = step.title, .text = step.text, .time = {}, .depth = {}};
      std::optional<std::size_t> at;
      if (!step.tissue.empty()) at = first_in(step.tissue, from);
      if (!step.event.empty()) at = first_event(step.event, from);
      if (at) {
        result.time = attempt_.time[*at];
        result.depth = attempt_.depth[*at];
        from = *at;
      }
      // A step of the other hand: its time does not delay the needle's steps.
      if (!step.shown.empty()) result.time = first_shown(attempt_, step.shown);
      score_.steps.push_back(std::move(result));
    }
  }

  // The tick at which a goal was reached.
  std::optional<std::size_t> reached_at(const Goal& goal) const {
    const FinalPosition& final_tip = *attempt_.final_tip;
    switch (goal.by) {
      case GoalKind::rest: {
        const auto first = first_in(goal.tissue);  // which refuses an unknown tissue
        const bool there = first && final_tip.is_rest && final_tip.tissue == *attempt_.find_tissue(goal.tissue);
        return there ? std::optional(final_tip.tick) : std::nullopt;
      }
      case GoalKind::touch:
        return first_in(goal.tissue);
      case GoalKind::event:
        return first_event(goal.event);
      case GoalKind::near_target:
        break;
    }
    const double within = goal.within > 0.0 ? goal.within : attempt_.description().procedure.target_tolerance;
    const bool there = target_error(final_tip.tip, attempt_.path()).distance <= within;
    return there ? std::optional(final_tip.tick) : std::nullopt;
  }

  void find_goal() {
    std::optional<std::size_t> first;
    for (const Goal& goal : procedure_.goals) {
      const auto at = reached_at(goal);
      if (!at || (first && *first <= *at)) continue;
      first = at;
      reached_words_ = goal_words(goal, attempt_, false);
    }
    score_.reached = first.has_value();
    if (first) {
      score_.reached_time = attempt_.time[*first];
      return;
    }
    std::vector<std::string> wanted;
    for (const Goal& goal : procedure_.goals) wanted.push_back(goal_words(goal, attempt_, true));
    add(Grade::fail, "goal", fmt::format("The aim was not reached: the tip must {}.", fmt::join(wanted, ", or ")));
  }

  void report_loss() {
    const Puncture* loss = measured_.loss();
    if (loss == nullptr) return;
    Grade grade = Grade::pass;
    std::string advice;
    for (const Rule& rule : procedure_.rules) {
      if (rule.metric != "loss_overshoot_mm") continue;
      grade = rule.grade_of(loss->overshoot);
      if (grade != Grade::pass && !rule.advice.empty()) advice = " " + rule.advice;
    }
    add(grade, "loss_overshoot_mm", loss_sentence(*loss, grade != Grade::pass) + advice);
  }

  void find_level() {
    const auto entry = skin_place(attempt_.tip[attempt_.insertions.back().first], attempt_.description());
    if (!entry) return;
    score_.level = entry->level;
    if (procedure_.levels.empty()) return;
    if (is_among(procedure_.levels, score_.level)) {
      add(Grade::pass, "level", fmt::format("You entered at {}.", spoken_level(score_.level)));
    } else {
      add(Grade::fail, "level",
          fmt::format("You entered at {}, expected {}.", spoken_level(score_.level),
                      spoken_level(procedure_.levels)));
    }
    report_palpation(*entry);
  }

  // The interspace palpated last is the chosen one.
  void report_palpation(const SkinPlace& entry) {
    const std::vector<Vec3> felt = felt_before_entry(attempt_);
    if (felt.empty()) return;
    const auto chosen = skin_place(felt.back(), attempt_.description());
    if (chosen->level == entry.level) {
      add(Grade::pass, "palpation", fmt::format("You felt {} before you entered.", spoken_level(chosen->level)));
    } else {
      add(Grade::borderline, "palpation",
          fmt::format("You felt {} last, but entered at {}.", spoken_level(chosen->level),
                      spoken_level(entry.level)));
    }
  }

  // Stated, because the definitions of the metrics give the usual ones.
  void report_thresholds() {
    std::vector<std::string> own;
    for (const auto& [name, value] : own_thresholds(attempt_.thresholds()))
      own.push_back(fmt::format("{} {:.6g}", name, value));
    if (own.empty()) return;
    add(Grade::pass, "thresholds",
        fmt::format("Measured with thresholds of the procedure's own: {}.", fmt::join(own, ", ")));
  }

  void check_needle() {
    const int gauge = attempt_.description().needle.gauge;
    if (gauge >= procedure_.thickest_gauge && gauge <= procedure_.thinnest_gauge) return;
    add(Grade::pass, "needle",
        fmt::format("A needle of {}G is unusual here; {}G to {}G is usual.", gauge, procedure_.thickest_gauge,
                    procedure_.thinnest_gauge));
  }

  // Items of the procedure without a place in this patient: stated, lest they seem judged.
  void check_parts() {
    const anatomy::ForceParts& parts = attempt_.session().header.haptics.parts;
    const auto asks = [&](std::initializer_list<std::string_view> metrics) {
      return std::any_of(procedure_.rules.begin(), procedure_.rules.end(), [&](const Rule& rule) {
        return std::find(metrics.begin(), metrics.end(), rule.metric) != metrics.end();
      });
    };
    const bool finger = !parts.fingertip && asks({"felt_places", "palpation_s", "felt_to_entry_mm"});
    const bool fluid =
        !parts.csf_flow && asks({"pressure_readings", "opening_pressure_cmH2O", "collected_mL", "withdrawn_open"});
    if (finger && fluid) {
      add(Grade::pass, "parts",
          "Feeling for the interspace, pressure, fluid and stylet were not judged: this patient has neither the part "
          "fingertip nor csf_flow.");
    } else if (finger) {
      add(Grade::pass, "parts", "Feeling for the interspace was not judged: this patient lacks the part fingertip.");
    } else if (fluid) {
      add(Grade::pass, "parts", "Pressure, fluid and stylet were not judged: this patient lacks the part csf_flow.");
    }
  }

  void rules() {
    for (const Rule& rule : procedure_.rules) {
      const auto result = std::find_if(score_.metrics.begin(), score_.metrics.end(),
                                       [&](const MetricResult& each) { return each.metric->name == rule.metric; });
      if (result == score_.metrics.end()) {
        if (rule.absent != Grade::pass) add(rule.absent, rule.metric, rule.absent_says);
        continue;
      }
      const Grade grade = rule.grade_of(result->value);
      result->grade = worse(grade, result->grade.value_or(Grade::pass));
      const bool reported = rule.metric == "loss_overshoot_mm";  // by report_loss()
      if (grade != Grade::pass && !reported)
        add(grade, rule.metric, rule_sentence(rule, *result->metric, result->value));
    }
  }

  void check_recording() {
    const session::Session& session = attempt_.session();
    if (!session.finished)
      add(Grade::borderline, "recording", "The recording broke off before its end; this is what was saved.");
    if (attempt_.missing > longest_gap) {
      add(Grade::borderline, "recording",
          fmt::format("{:.3f} s of the recording are missing while the needle was in the body.", attempt_.missing));
    }
    if (first_event("fault"))
      add(Grade::borderline, "recording", "A fault took the force away, so that you did not feel the tissue.");
  }

  void finish() {
    std::stable_sort(score_.findings.begin(), score_.findings.end(),
                     [](const Finding& a, const Finding& b) { return a.grade > b.grade; });
    score_.verdict = Grade::pass;
    for (const Finding& each : score_.findings) score_.verdict = worse(score_.verdict, each.grade);
    score_.headline = headline();
  }

  std::string headline() const {
    if (attempt_.insertions.empty()) return "Failed: the needle never touched the body";
    const std::string ending = score_.reached ? fmt::format("the tip {}", reached_words_) : "the aim was not reached";
    switch (score_.verdict) {
      case Grade::pass:
        return "Passed: " + ending;
      case Grade::borderline:
        return fmt::format("Borderline: {}, but not without fault", ending);
      case Grade::fail:
      case Grade::dangerous:
        break;
    }
    const char* word = score_.verdict == Grade::dangerous ? "Dangerous" : "Failed";
    if (!score_.harms.empty() && score_.harms.front().entered && score_.harms.front().grade == score_.verdict)
      return fmt::format("{}: the tip entered {}", word, score_.harms.front().title);
    if (!score_.reached) return fmt::format("{}: the aim was not reached", word);
    std::string reason = score_.findings.front().subject;
    if (const MetricResult* result = score_.find(reason)) reason = result->metric->title;
    return fmt::format("{}: {}, but with a fault of {}", word, ending, reason);
  }

  const Attempt& attempt_;
  const Procedure& procedure_;
  const PatientVolumes& volumes_;
  const ExpertSet* experts_;
  Measured measured_;
  Score score_;
  std::string reached_words_;
};

}  // namespace

const MetricResult* Score::find(std::string_view metric) const {
  const auto found = std::find_if(metrics.begin(), metrics.end(),
                                  [&](const MetricResult& each) { return each.metric->name == metric; });
  return found == metrics.end() ? nullptr : &*found;
}

Score score(const session::Session& session, const anatomy::CaseDescription& description, const Procedure& procedure,
            const PatientVolumes& volumes, const ExpertSet* experts) {
  const Attempt attempt(session, description, procedure.thresholds);
  return Scorer(attempt, procedure, volumes, experts).judge();
}

double score_points(const Score& score) {
  if (score.verdict == Grade::dangerous || !score.reached) return 0.0;
  double kept = 0.0, rules = 0.0;
  for (const MetricResult& each : score.metrics) {
    if (!each.grade) continue;
    rules += 1.0;
    kept += *each.grade == Grade::pass ? 1.0 : *each.grade == Grade::borderline ? 0.5 : 0.0;
  }
  if (rules > 0.0) return 100.0 * kept / rules;
  return score.verdict == Grade::pass ? 100.0 : score.verdict == Grade::borderline ? 50.0 : 0.0;
}

}  // namespace bodkin::training
