#pragma once

#include <optional>
#include <string>
#include <vector>

#include "training/expert_set.h"
#include "training/harm.h"
#include "training/measured.h"
#include "training/metric.h"
#include "training/procedure.h"

namespace bodkin::training {

// One reason for the verdict, as a teacher would say it.
struct Finding {
  Grade grade = Grade::pass;
  std::string subject;   // what it is about: the name of a metric, "goal", "harm", "level", "needle",
                         // "thresholds", "recording"
  std::string sentence;  // ends with a full stop
};

struct MetricResult {
  const Metric* metric = nullptr;
  double value = 0.0;
  std::optional<Grade> grade;               // where the procedure has a rule about it
  std::optional<ExpertSet::Place> experts;  // where there is an expert set that has it
};

struct StepResult {
  std::string title;
  std::string text;
  std::optional<double> time;   // s since the first tick; nothing: it was not reached, or nothing shows it
  std::optional<double> depth;  // mm
};

// What an attempt came to.
struct Score {
  std::string procedure;  // its name
  std::string title;      // of the procedure
  std::string expert;     // simulated operator who is good at it
  Grade verdict = Grade::fail;
  std::string headline;                // without a full stop
  bool reached = false;                // the procedure's aim, by one of its goals
  std::optional<double> reached_time;  // s since the first tick
  std::string level;                   // interspace that was entered, where the case has landmarks; else empty
  std::vector<Finding> findings;       // the worst first
  std::vector<MetricResult> metrics;
  std::vector<StepResult> steps;
  std::vector<Harm> harms;
  std::vector<ForbiddenDistance> distances;  // of all that must not be entered, the nearest first
  std::vector<TissueTotal> tissues;
  std::vector<Puncture> punctures;
  std::optional<FinalPosition> final_tip;
  Thresholds thresholds;    // that it was measured with
  std::size_t experts = 0;  // attempts in the expert set; 0: none was at hand

  // nullptr when the attempt does not have it.
  const MetricResult* find(std::string_view metric) const;
};

// Judges a session by a procedure. The verdict is the worst of its findings: an attempt that entered what the
// procedure or the case forbids is never a pass, whatever else it reached. Everything is computed from the session,
// whose patient's voxels are `volumes` (see training/recorded_patient.h); where they are not at hand and a critical
// structure could not be looked for, the verdict is borderline at best. `experts` may be null. Throws InputError for
// a session without ticks, and for a procedure that names a tissue that neither the session nor Bodkin knows.
Score score(const session::Session& session, const anatomy::CaseDescription& description, const Procedure& procedure,
            const PatientVolumes& volumes = {}, const ExpertSet* experts = nullptr);

// One number for a score: the share of the rules about it that the attempt keeps, in percent, a borderline one
// counted by half; 0 for an attempt that failed to reach its aim or was dangerous. Without rules 100 for a pass, 50
// for a borderline attempt.
double score_points(const Score& score);

}  // namespace bodkin::training
