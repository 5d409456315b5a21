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

// One reason for the verdict, as a teacher would word it.
struct Finding {
  Grade grade = Grade::pass;
  std::string subject;   // the name of a metric, "goal", "harm", "level", "needle", "thresholds", "recording"
  std::string sentence;  // ends with a full stop
};

struct MetricResult {
  const Metric* metric = nullptr;
  double value = 0.0;
  std::optional<Grade> grade;               // if the procedure has a rule about it
  std::optional<ExpertSet::Place> experts;  // if an expert set has it
};

struct StepResult {
  std::string title;
  std::string text;
  std::optional<double> time;   // s since the first tick; empty: not reached, or not detectable
  std::optional<double> depth;  // mm
};

// The result of an attempt.
struct Score {
  std::string procedure;  // its name
  std::string title;      // of the procedure
  std::string expert;     // simulated expert operator
  Grade verdict = Grade::fail;
  std::string headline;                // without a full stop
  bool reached = false;                // the procedure's goal, by any of its goals
  std::optional<double> reached_time;  // s since the first tick
  std::string level;                   // interspace that was entered, if the case has landmarks; else empty
  std::vector<Finding> findings;       // the worst first
  std::vector<MetricResult> metrics;
  std::vector<StepResult> steps;
  std::vector<Harm> harms;
  std::vector<ForbiddenDistance> distances;  // of everything that must not be entered, the nearest first
  std::vector<TissueTotal> tissues;
  std::vector<Puncture> punctures;
  std::optional<FinalPosition> final_tip;
  Thresholds thresholds;    // of its measurement
  std::size_t experts = 0;  // attempts in the expert set; 0: none available

  // nullptr if the attempt does not have it.
  const MetricResult* find(std::string_view metric) const;
};

// Scores a session by a procedure. The verdict is the worst of its findings: an attempt that entered a structure
// forbidden by the procedure or the case is never a pass, whatever else it reached. Everything is computed from the
// session, with its patient's voxels in `volumes` (see training/recorded_patient.h); if these are not available and a
// critical structure could not be checked, the verdict is at best borderline. `experts` may be null. Throws
// InputError for a session without ticks, and for a procedure with a tissue unknown to the session and to Bodkin.
Score score(const session::Session& session, const anatomy::CaseDescription& description, const Procedure& procedure,
            const PatientVolumes& volumes = {}, const ExpertSet* experts = nullptr);

// One number for a score: the percentage of the rules about it that the attempt fulfils, a borderline one counted by
// half; 0 for an attempt that failed to reach its goal or was dangerous. Without rules 100 for a pass, 50 for a
// borderline attempt.
double score_points(const Score& score);

}  // namespace bodkin::training
