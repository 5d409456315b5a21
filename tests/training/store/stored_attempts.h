#pragma once

#include <filesystem>
#include <string>

#include "tests/io/scratch_folder.h"

#include "training/store/attempt_record.h"

namespace bodkin {

// An invented attempt; `number` makes it unique.
inline training::AttemptRecord attempt_record(const std::string& trainee, int number,
                                              training::Grade verdict = training::Grade::pass,
                                              const std::string& procedure = "lumbar_puncture") {
  training::AttemptRecord record;
  record.digest = trainee + "/" + procedure + "/" + std::to_string(number);
  record.trainee = trainee;
  record.procedure = procedure;
  record.patient = "slim";
  record.station = training::station_name();
  record.started_at = "2026-11-23T10:" + std::to_string(10 + number / 60 % 50) + ":" +
                      std::to_string(number % 60 / 10) + std::to_string(number % 10) + "Z";
  record.duration = 61.25;
  record.verdict = verdict;
  record.reached = verdict == training::Grade::pass;
  record.score = verdict == training::Grade::pass ? 87.5 : 0.0;
  record.headline = "Passed: the tip's \"rest\" was in the fluid";
  record.metrics = {{"final_distance_mm", 1.25}, {"peak_force_N", 7.1}};
  record.findings = {{training::Grade::borderline, "passes", "You needed 3 passes."}};
  return record;
}

}  // namespace bodkin
