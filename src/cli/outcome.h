#pragma once

#include <filesystem>

#include "session/session_file.h"
#include "session/session_run.h"
#include <nlohmann/json_fwd.hpp>

#include "cli/console.h"
#include "training/score.h"

namespace bodkin::cli {

// The summary of a session that has just ended.
struct Outcome {
  session::RunResult run;
  session::Session session;  // as it was saved
  training::Score score;
  std::filesystem::path file;

  double time() const;  // s of the session
  // N, the greatest force applied to the hand.
  double peak_applied() const;
  double speed() const;  // times real time
};

// Reads the session file that was just written and judges it by the case's procedure.
Outcome read_outcome(const std::filesystem::path& file, const anatomy::Case& patient, session::RunResult run);

// On one screen.
void print(const Console& console, const Outcome& outcome, const anatomy::Case& patient);

nlohmann::ordered_json json_of(const Outcome& outcome, const anatomy::Case& patient);

}  // namespace bodkin::cli
