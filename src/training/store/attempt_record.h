#pragma once

#include <string>
#include <utility>
#include <vector>

#include "session/session_file.h"

#include "training/score.h"

namespace bodkin::training {

// The record of an attempt in the store.
struct AttemptRecord {
  std::string digest;      // of the session; no attempt is stored twice
  std::string trainee;     // a label without the person's name, see check_label()
  std::string procedure;   // its name
  std::string patient;     // name of the case
  std::string station;     // name of the computer
  std::string started_at;  // ISO 8601, UTC
  double duration = 0.0;   // s
  Grade verdict = Grade::fail;
  bool reached = false;                                 // the procedure's aim
  double score = 0.0;                                   // 0 to 100, see score_points()
  std::string headline;                                 // without a full stop
  std::vector<std::pair<std::string, double>> metrics;  // by name
  std::vector<Finding> findings;                        // the worst first
  std::string plan;                                     // its name; empty: none
  int stage = 0;                                        // of the plan, from 1
  std::string file;                                     // of the session, on its station
  bool owns_file = false;                               // deleting the trainee deletes it
};

// 128 bits, 32 hexadecimal digits, of a session's recorded data, time and recording: equal for a copy of the file,
// different for every other session.
std::string session_digest(const session::Session& session);

// The record of a scored session; `patient` is the name of its case. The caller sets trainee, plan and file.
AttemptRecord record_of(const session::Session& session, const std::string& patient, const Score& score);

// Throws InputError unless `label` is 1 to 64 characters, of letters, digits, blanks, '_', '-' and '.', and neither
// begins nor ends with a blank: a pseudonym, not an address. `what`: names it in the message.
void check_label(const std::string& label, const std::string& what);

// The grade of that name. Throws InputError.
Grade grade_of_name(std::string_view name, const std::string& origin);

// The name of this computer.
std::string station_name();

// The metrics and findings of a record as JSON, in the format of the store, and back. Throws InputError naming
// `origin` for invalid JSON.
std::string metrics_json(const AttemptRecord& record);
std::string findings_json(const AttemptRecord& record);
void read_metrics(AttemptRecord& record, std::string_view json, const std::string& origin);
void read_findings(AttemptRecord& record, std::string_view json, const std::string& origin);

}  // namespace bodkin::training
